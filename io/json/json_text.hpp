// Strings as JSON wants them.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// `text` in quotes, escaped. Bytes that are not UTF-8 become U+FFFD, the replacement character.
void append_json_string(std::string& out, std::string_view text);

}  // namespace beespace::io
