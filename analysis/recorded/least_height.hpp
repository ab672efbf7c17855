// The least difference in height of two while they are in conflict: whether it is by little that
// they break a vertical threshold.
#pragma once

#include "analysis/geometry/apart.hpp"
#include "analysis/recorded/apart.hpp"

#include <beespace/conflict.hpp>
#include <beespace/track.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace beespace::analysis {

struct LeastHeight {
  double time_s = 0.0;
  Apart apart = {};
};

// Nothing where it is not known.
using LeastHeightOf = std::function<std::optional<LeastHeight>(const Conflict&)>;

// Of tracks, which must outlive it.
LeastHeightOf least_height_of(const std::vector<Track>& tracks, double height_unit_m);

}  // namespace beespace::analysis
