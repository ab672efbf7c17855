// A drawing as pixels: PNG, drawn by cairo where the build has it.
#pragma once

#include "report/figure/drawing.hpp"

#include <optional>
#include <string>

namespace beespace::report {

// Whether png() can draw; it cannot in a build without cairo.
bool can_draw_png();

struct Png {
  std::string bytes;
  bool has_fonts = true;  // without, letters are strokes, and those beyond ASCII are missing
};

// So many pixels wide; nothing where there is no memory for them, or no cairo.
std::optional<Png> png(const Drawing& drawing, unsigned width);

}  // namespace beespace::report
