// The paths of a recording in a view: each by itself, or as shades where there are many.
#pragma once

#include "report/facts.hpp"
#include "report/figure/sheet.hpp"
#include "report/figure/view.hpp"

#include <vector>

namespace beespace::report {

void draw_paths(const RecordingFacts& facts, const View& view, Drawing& drawing);

std::vector<KeyEntry> key_of_paths(const RecordingFacts& facts, const View& from_above);

}  // namespace beespace::report
