// Writes JSON into a text, value after value: commas, nesting and layout are its own.
//
// It only appends, so the owner of the text may pass on what is there and clear it between values.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>

namespace beespace::io {

// Where the values of an object or array stand.
enum class JsonLayout : std::uint8_t {
  kTight,    // {"a":1,"b":2}
  kLine,     // {"a": 1, "b": 2}
  kWrapped,  // the same, but for new_line()
  kRows,     // each on a line of its own, two blanks further in; the end behind the last
  kLines,    // the same, the end on a line of its own
  kFlush,    // each on a line of its own, and the end, all at the margin
};

class JsonWriter {
 public:
  // Tight: so is all that has no layout of its own.
  explicit JsonWriter(std::string& out, JsonLayout layout = JsonLayout::kLine) : out_(out) {
    levels_[0].layout = layout;
  }
  ~JsonWriter();
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  // Without a layout: tight within what is tight, or else on one line.
  JsonWriter& begin_object() { return begin_object(inner_layout()); }
  JsonWriter& begin_array() { return begin_array(inner_layout()); }
  JsonWriter& begin_object(JsonLayout layout) { return begin(layout, true); }
  JsonWriter& begin_array(JsonLayout layout) { return begin(layout, false); }
  // As a member.
  template <class... Layout>
  JsonWriter& begin_object(std::string_view name, Layout... layout) {
    return key(name).begin_object(layout...);
  }
  template <class... Layout>
  JsonWriter& begin_array(std::string_view name, Layout... layout) {
    return key(name).begin_array(layout...);
  }
  JsonWriter& end();

  // What comes next, a value or the end, begins a line, in the indentation of the values.
  void new_line() { starts_line_ = true; }

  JsonWriter& key(std::string_view name);

  void null() { write("null"); }
  JsonWriter& value(double number);  // null where it is not finite
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(std::same_as<bool> auto yes) { return write(yes ? "true" : "false"); }
  template <std::unsigned_integral Number>
  requires(!std::same_as<Number, bool>) JsonWriter& value(Number number) {
    return write_count(number);
  }
  template <std::signed_integral Number>
  requires(!std::same_as<Number, char>) JsonWriter& value(Number number) {
    return write_signed(number);
  }
  // null where there is none.
  template <class Value>
  JsonWriter& value(const std::optional<Value>& held) {
    return held ? value(*held) : write("null");
  }
  // An array.
  template <std::ranges::range Values>
  requires(!std::convertible_to<const Values&, std::string_view>)
      JsonWriter& value(const Values& values) {
    begin_array();
    for (const auto& each : values) value(each);
    return end();
  }

  template <class Value>
  JsonWriter& member(std::string_view name, const Value& held) {
    return key(name).value(held);
  }

 private:
  // The deepest, CZML, has seven.
  static constexpr std::size_t kMostNested = 16;

  struct Level {
    JsonLayout layout = JsonLayout::kLine;
    bool is_object = false;
    bool empty = true;
    std::uint8_t indent = 0;  // of its values, where they begin a line
  };

  [[nodiscard]] JsonLayout inner_layout() const {
    return level().layout == JsonLayout::kTight ? JsonLayout::kTight : JsonLayout::kLine;
  }
  // levels_[0] is around the document.
  [[nodiscard]] const Level& level() const { return levels_[depth_]; }
  JsonWriter& begin(JsonLayout layout, bool is_object);
  void begin_value();
  void separate();
  void break_line(std::size_t indent);
  JsonWriter& write(std::string_view word);
  JsonWriter& write_count(std::uint64_t number);
  JsonWriter& write_signed(std::int64_t number);

  std::string& out_;
  std::array<Level, kMostNested> levels_{};
  std::size_t depth_ = 0;
  bool has_key_ = false;
  bool starts_line_ = false;
};

// The value where it is known, to be written as null where not.
template <class Value>
std::optional<Value> known_if(bool known, Value value) {
  return known ? std::optional<Value>(value) : std::nullopt;
}

}  // namespace beespace::io
