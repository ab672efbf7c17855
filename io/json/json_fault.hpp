// Where a text stops being JSON: what a fast parser does not say, found out afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

struct JsonFault {
  bool found = false;
  bool at_end = false;       // the text ends where more must follow
  std::uint64_t line = 0;    // 1-based
  std::uint64_t column = 0;  // 1-based, in bytes
  std::string what = {};     // a phrase: "a comma or ] is expected, not 'x'"
};

// The first fault of RFC 8259's grammar; of the escapes in a string only that they end.
JsonFault find_json_fault(std::string_view text);

}  // namespace beespace::io
