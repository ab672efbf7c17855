// Who is who among a few paths, or among those in conflict: the name of each beside its end, where
// nothing is in its way.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/facts.hpp"
#include "report/figure/view.hpp"

#include <cstddef>
#include <vector>

namespace beespace::report {

inline constexpr std::size_t kMostNamedPaths = 12;

// Those that are named: all of a few; of more those in conflict, where these are few. Those in
// conflict come first.
std::vector<std::size_t> named_paths(const RecordingFacts& facts);

// After all else that is drawn in the view, whose texts it keeps clear of. Of many paths those have
// names that are in a conflict, where these are few; none has where there is no room for one.
void draw_path_labels(const RecordingFacts& facts, const View& view, Drawing& drawing);

}  // namespace beespace::report
