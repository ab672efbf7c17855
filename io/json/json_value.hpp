// The values of a JSON text that was parsed. simdjson parses it, and only json_value.cpp knows of
// that: its header takes seconds to compile.
//
// Values are places in the text's parser: small to copy, and valid until it parses another text or
// goes away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace beespace::io {

enum class JsonKind : std::uint8_t { kNull, kFlag, kNumber, kText, kArray, kObject };

class JsonArray;
class JsonMap;

struct JsonPlace {
  const void* document = nullptr;
  std::size_t index = 0;

  friend bool operator==(const JsonPlace&, const JsonPlace&) = default;
};

class JsonElement {
 public:
  JsonElement() = default;
  explicit JsonElement(JsonPlace place) : place_(place) {}

  [[nodiscard]] JsonKind kind() const;
  [[nodiscard]] bool is_null() const { return kind() == JsonKind::kNull; }
  [[nodiscard]] bool is_number() const { return kind() == JsonKind::kNumber; }
  [[nodiscard]] bool is_object() const { return kind() == JsonKind::kObject; }

  // False, and `value` as it was, where the element is of another kind, or is no such number.
  bool get(double& value) const;
  bool get(std::int64_t& value) const;
  bool get(std::uint64_t& value) const;
  bool get(bool& value) const;
  bool get(std::string_view& value) const;
  bool get(JsonArray& value) const;
  bool get(JsonMap& value) const;
  // What a JSON pointer (RFC 6901) leads to from here.
  bool follow(std::string_view pointer, JsonElement& value) const;

 private:
  JsonPlace place_;
};

class JsonArray {
 public:
  class Iterator {
   public:
    explicit Iterator(JsonPlace place) : place_(place) {}
    JsonElement operator*() const { return JsonElement(place_); }
    Iterator& operator++();
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    JsonPlace place_;
  };

  JsonArray() = default;
  explicit JsonArray(JsonPlace place) : place_(place) {}

  [[nodiscard]] Iterator begin() const;
  [[nodiscard]] Iterator end() const;
  [[nodiscard]] std::size_t size() const;

 private:
  JsonPlace place_;
};

// The members of an object, in their order.
class JsonMap {
 public:
  struct Member {
    std::string_view key;
    JsonElement value;
  };

  class Iterator {
   public:
    explicit Iterator(JsonPlace place) : place_(place) {}
    Member operator*() const;
    Iterator& operator++();
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    JsonPlace place_;
  };

  JsonMap() = default;
  explicit JsonMap(JsonPlace place) : place_(place) {}

  [[nodiscard]] Iterator begin() const;
  [[nodiscard]] Iterator end() const;
  [[nodiscard]] std::size_t size() const;
  // The first member of that key; false where there is none.
  bool get(std::string_view key, JsonElement& value) const;

 private:
  JsonPlace place_;
};

// Parses one text after the other, in memory that it uses again.
class JsonParser {
 public:
  // How many bytes behind a text that is not copied must be readable.
  static constexpr std::size_t kPadding = 64;

  JsonParser();
  JsonParser(const JsonParser&) = delete;
  JsonParser& operator=(const JsonParser&) = delete;
  JsonParser(JsonParser&&) noexcept;
  JsonParser& operator=(JsonParser&&) noexcept;
  ~JsonParser();

  // Empty, or what is wrong with the text, in a phrase that tells no place.
  std::string_view parse(std::string_view text, JsonElement& root);         // copies it
  std::string_view parse_padded(std::string_view text, JsonElement& root);  // leaves it where it is

 private:
  struct State;

  std::unique_ptr<State> state_;
};

}  // namespace beespace::io
