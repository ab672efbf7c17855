// The bees of a snapshot in a view: each by itself, or as shades where there are many.
#pragma once

#include "report/facts.hpp"
#include "report/figure/sheet.hpp"
#include "report/figure/view.hpp"

#include <vector>

namespace beespace::report {

void draw_bees(const SnapshotFacts& facts, const View& view, Drawing& drawing);

// What the marks mean.
std::vector<KeyEntry> key_of_bees(const SnapshotFacts& facts, const View& from_above);

}  // namespace beespace::report
