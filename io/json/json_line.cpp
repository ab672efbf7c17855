#include "io/json/json_line.hpp"

#include "io/json/json_fault.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <bitset>
#include <charconv>
#include <cstdint>
#include <new>
#include <optional>

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

// Of a few keys most differ in what this adds up, so that few are compared.
std::optional<std::string_view> repeated_key(simdjson::dom::object object) {
  std::bitset<256> seen;
  for (auto at = object.begin(); at != object.end(); ++at) {
    const std::string_view key = at.key();
    std::size_t sum = key.size();
    for (const char c : key.substr(0, 16)) sum = 31 * sum + static_cast<unsigned char>(c);
    if (!seen.test(sum % seen.size())) {
      seen.set(sum % seen.size());
      continue;
    }
    for (auto before = object.begin(); before != at; ++before) {
      if (before.key() == key) return key;
    }
  }
  return std::nullopt;
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
  if (root.get(object) == simdjson::SUCCESS) {
    if (const auto key = repeated_key(object)) {
      return Error{ErrorCode::kMalformedRecord,
                   excerpt(*key) + " is there twice in this object; leave one out",
                   {}};
    }
    return object;
  }
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
