#include "io/json/json_line.hpp"

#include "io/json/json_fault.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <new>

namespace beespace::io {
namespace {

Error syntax_error(std::string_view line, simdjson::error_code code) {
  const JsonFault fault = find_json_fault(line);
  if (!fault.found) {
    return {
        ErrorCode::kCorrupt,
        "this JSON cannot be read: " + std::string(simdjson::error_message(code)) + "; correct it",
        {}};
  }
  Error error{fault.at_end ? ErrorCode::kTruncated : ErrorCode::kCorrupt,
              fault.at_end ? "the JSON ends too early (" + fault.what +
                                 "); each object must be whole in one line (a document of "
                                 "many lines is for 'beespace replay')"
                           : "this is no JSON: " + fault.what + "; correct it",
              {}};
  error.place.column = fault.column;
  return error;
}

}  // namespace

Result<simdjson::dom::object> JsonLine::parse(std::string_view line) {
  // The parser reads beyond the end; what lies there does not matter.
  padded_.reserve(line.size() + simdjson::SIMDJSON_PADDING);
  padded_.assign(line);
  JsonElement root;
  const auto code = parser_.parse(padded_.data(), padded_.size(), false).get(root);
  if (code == simdjson::MEMALLOC) throw std::bad_alloc();
  if (code != simdjson::SUCCESS) return syntax_error(line, code);
  simdjson::dom::object object;
  if (root.get(object) == simdjson::SUCCESS) return object;
  return Error{
      ErrorCode::kUnsupportedFormat,
      "this line is " + std::string(json_kind(root)) + ", not an object; write one object a line",
      {}};
}

bool JsonLine::read_text(JsonElement element, std::string_view& text) {
  if (element.get(text) == simdjson::SUCCESS) return true;
  std::array<char, 24> digits = {};
  char* end = nullptr;
  if (std::int64_t number = 0; element.get(number) == simdjson::SUCCESS) {
    end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  } else if (std::uint64_t large = 0; element.get(large) == simdjson::SUCCESS) {
    end = std::to_chars(digits.data(), digits.data() + digits.size(), large).ptr;
  } else {
    return false;
  }
  number_.assign(digits.data(), end);
  text = number_;
  return true;
}

}  // namespace beespace::io
