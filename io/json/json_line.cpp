#include "io/json/json_line.hpp"

#include "io/problems/excerpt.hpp"

#include <array>
#include <bitset>
#include <charconv>
#include <cstdint>
#include <optional>

namespace beespace::io {
namespace {

// Of a few keys most differ in what this adds up, so that few are compared.
std::optional<std::string_view> repeated_key(JsonMap object) {
  std::bitset<256> seen;
  for (auto at = object.begin(); at != object.end(); ++at) {
    const std::string_view key = (*at).key;
    std::size_t sum = key.size();
    for (const char c : key.substr(0, 16)) sum = 31 * sum + static_cast<unsigned char>(c);
    if (!seen.test(sum % seen.size())) {
      seen.set(sum % seen.size());
      continue;
    }
    for (auto before = object.begin(); before != at; ++before) {
      if ((*before).key == key) return key;
    }
  }
  return std::nullopt;
}

}  // namespace

Result<JsonMap> JsonLine::parse(std::string_view line) {
  // The parser reads beyond the end; what lies there does not matter.
  padded_.reserve(line.size() + JsonParser::kPadding);
  padded_.assign(line);
  JsonElement root;
  const std::string_view problem = parser_.parse_padded(padded_, root);
  if (!problem.empty()) {
    Error error = json_syntax_error(line, problem,
                                    "each object must be whole in one line (a document of many "
                                    "lines is for 'beespace replay')");
    error.location.line.reset();
    return error;
  }
  JsonMap object;
  if (root.get(object)) {
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
  if (element.get(text)) return true;
  std::array<char, 24> digits = {};
  char* end = nullptr;
  if (std::int64_t number = 0; element.get(number)) {
    end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  } else if (std::uint64_t large = 0; element.get(large)) {
    end = std::to_chars(digits.data(), digits.data() + digits.size(), large).ptr;
  } else {
    return false;
  }
  number_.assign(digits.data(), end);
  text = number_;
  return true;
}

}  // namespace beespace::io
