// When two are worst in conflict, where a horizontal and a vertical threshold count: at the instant
// at which the greater of their shares of both is the least; where it is as bad for a while but for
// the rounding of places, at the one of these at which the other share is the least. By the
// straight line, who only climbs through the height of another would be closest as the conflict
// begins or ends, with the vertical threshold between them, which says nothing of how close they
// get.
#pragma once

#include "analysis/geometry/apart.hpp"
#include "analysis/recorded/last_snapshot.hpp"

#include <beespace/conflict.hpp>
#include <beespace/track.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace beespace::analysis {

// Both in metres.
struct Minima {
  double threshold_m = 0.0;
  double vertical_m = 0.0;
};

// How far shares may differ that count as equally bad: what the rounding of places makes of them.
inline constexpr double kAsBad = 1e-3;

struct WorstMoment {
  double time_s = 0.0;
  double share = 0.0;  // the greater one, of its threshold: less than 1 in a conflict
  Apart apart = {};
};

// Within the time of the conflict. Nothing where that is not known.
using WorstOf = std::function<std::optional<WorstMoment>(const Conflict&)>;

// Of tracks, between whose fixes bees fly straight, and of bees that fly on as a snapshot has them.
// What they are of must outlive them.
WorstOf worst_of(const std::vector<Track>& tracks, double height_unit_m, const Minima& minima);
WorstOf worst_of(const Snapshot& snapshot, double height_unit_m, const Minima& minima);

// What conflicts are ordered by, the worst first: that share, behind all others where it is not
// known; without `worst` how close the two come.
double rank_of(const Conflict& conflict, const WorstOf& worst);
// Into that order; those of one rank stay in theirs.
void sort_worst_first(const WorstOf& worst, std::vector<Conflict>& conflicts);

}  // namespace beespace::analysis
