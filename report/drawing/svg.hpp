// A drawing as SVG 1.1: text, with no fonts, scripts or links in it.
#pragma once

#include "report/drawing/drawing.hpp"

#include <string>

namespace beespace::report {

// So many pixels wide where a program asks; it can be shown at any size.
std::string svg(const Drawing& drawing, unsigned width);

}  // namespace beespace::report
