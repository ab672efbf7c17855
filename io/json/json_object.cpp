#include "io/json/json_object.hpp"

#include "io/json/json_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace beespace::io {

void JsonObject::add_text(std::string_view name, std::string_view value) {
  begin(name);
  append_json_string(text_, value);
}

void JsonObject::add_number(std::string_view name, double value) {
  add_json(name, json_number(value));
}

void JsonObject::add_count(std::string_view name, std::uint64_t value) {
  add_json(name, std::to_string(value));
}

void JsonObject::add_flag(std::string_view name, bool value) {
  add_json(name, value ? "true" : "false");
}

void JsonObject::add_json(std::string_view name, std::string_view value) {
  begin(name);
  text_ += value;
}

void JsonObject::begin(std::string_view name) {
  const bool spaced = style_ == JsonStyle::kSpaced;
  if (text_.size() > 1) text_ += spaced ? ", " : ",";
  append_json_string(text_, name);
  text_ += spaced ? ": " : ":";
}

void JsonList::add_number(double value) {
  add_json(json_number(value));
}

void JsonList::add_json(std::string_view value) {
  if (text_.size() > 1) text_ += style_ == JsonStyle::kSpaced ? ", " : ",";
  text_ += value;
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace beespace::io
