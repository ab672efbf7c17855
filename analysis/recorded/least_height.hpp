// The least difference in height of two while they are in conflict. Where they come closest
// horizontally when the conflict begins or ends by their heights, the difference then is the limit
// itself, and says nothing of how close they get.
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

// Of tracks, which must outlive it; and of bees that fly straight on.
LeastHeightOf least_height_of(const std::vector<Track>& tracks, double height_unit_m);
LeastHeightOf least_height_of(ApartOf straight);

}  // namespace beespace::analysis
