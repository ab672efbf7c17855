// What a JSON document is about, by the keys near its beginning: for those who handed it to a
// reader of something else.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// What it is and which command reads it: "JSON with obstacles; give it with --obstacles to ...".
// `text` begins with { or [; it may be cut off.
std::string json_words(std::string_view text);

}  // namespace beespace::io
