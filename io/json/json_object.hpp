// JSON objects and lists, written member by member.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

// With a blank behind colons and commas, or without.
enum class JsonStyle : std::uint8_t { kTight, kSpaced };

class JsonObject {
 public:
  explicit JsonObject(JsonStyle style = JsonStyle::kTight) : style_(style) {}

  void add_text(std::string_view name, std::string_view value);
  // null where it is not finite.
  void add_number(std::string_view name, double value);
  void add_count(std::string_view name, std::uint64_t value);
  void add_flag(std::string_view name, bool value);
  // What is JSON already.
  void add_json(std::string_view name, std::string_view value);

  [[nodiscard]] std::string text() const { return text_ + '}'; }

 private:
  void begin(std::string_view name);

  JsonStyle style_;
  std::string text_ = "{";
};

class JsonList {
 public:
  explicit JsonList(JsonStyle style = JsonStyle::kTight) : style_(style) {}

  void add_number(double value);
  void add_json(std::string_view value);

  [[nodiscard]] std::string text() const { return text_ + ']'; }

 private:
  JsonStyle style_;
  std::string text_ = "[";
};

// Like a member of that type, by itself.
std::string json_number(double value);

}  // namespace beespace::io
