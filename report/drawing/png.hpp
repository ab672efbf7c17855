// A drawing as pixels: PNG, drawn by cairo, where that is installed and the build knew its headers.
#pragma once

#include "report/drawing/drawing.hpp"

#include <optional>
#include <string>

namespace beespace::report {

// Empty where png() can draw; otherwise a phrase that says what it lacks, and how to get it.
std::string why_no_png();

struct Png {
  std::string bytes;
  bool has_fonts = true;  // without, letters are strokes, and those beyond ASCII are missing
};

// So many pixels wide; nothing where there is no memory for them. Nothing is lacking (above).
std::optional<Png> png(const Drawing& drawing, unsigned width);

}  // namespace beespace::report
