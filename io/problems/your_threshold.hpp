// The threshold in a line that a message says to type: a recipe does not know it, and one of its
// own would be an all-clear of another question. The command puts what was typed in its place.
#pragma once

#include <string_view>

namespace beespace::io {

inline constexpr std::string_view kYourThreshold = "--threshold YOUR_THRESHOLD";

}  // namespace beespace::io
