// Whether bytes are characters.
#pragma once

#include <cstddef>
#include <string_view>

namespace beespace::io {

// The length of the well-formed UTF-8 sequence at the start of `text` (Unicode 15, table 3-7);
// 0 when there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace beespace::io
