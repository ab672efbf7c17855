// How much room text takes: an upper bound for the fonts that figures are drawn in, as it is
// unknown which one a reader has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace beespace::report {

// In units of the drawing, at a font of `size`.
double text_width(std::string_view text, double size);

// The text, or what of it fits, with an ellipsis.
std::string fitted(std::string_view text, double size, double width);

// Broken between words into lines that fit.
std::vector<std::string> wrapped(std::string_view text, double size, double width);

}  // namespace beespace::report
