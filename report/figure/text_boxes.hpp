// What texts of a drawing cover, so that none is written over another one.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/figure/panel.hpp"

#include <vector>

namespace beespace::report {

// What a text covers, without a margin.
Box box_of_text(const Text& text);

bool covers_part_of(const Box& a, const Box& b);

// Of all texts that are drawn already.
std::vector<Box> boxes_of_texts(const Drawing& drawing);

}  // namespace beespace::report
