// JSON objects one after the other, each in one line, parsed in memory that is used again.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>

namespace beespace::io {

class JsonLine {
 public:
  // What it returns holds until the next call. Errors: kTruncated, kCorrupt, with a column counted
  // in bytes; kUnsupportedFormat where it is no object; kMalformedRecord where it has a key twice.
  Result<JsonMap> parse(std::string_view line);

  // A text, or a whole number as one; false when it is neither. Holds until the next call of
  // either; at most one number of a line can be held.
  bool read_text(JsonElement element, std::string_view& text);

 private:
  JsonParser parser_;
  std::string padded_;
  std::string number_;
};

}  // namespace beespace::io
