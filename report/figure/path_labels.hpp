// Who is who among a few paths: the name of each beside its end, where nothing is in its way.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/facts.hpp"
#include "report/figure/view.hpp"

#include <cstddef>

namespace beespace::report {

inline constexpr std::size_t kMostNamedPaths = 12;

// After all else that is drawn in the view, whose texts it keeps clear of. Of many paths there are
// no names, nor where there is no room for one.
void draw_path_labels(const RecordingFacts& facts, const View& view, Drawing& drawing);

}  // namespace beespace::report
