#include <beespace/track.hpp>

#include "motion/passing/step_balls.hpp"

#include <algorithm>

namespace beespace {

std::optional<Point> position_at(const Track& track, double time_s, double max_gap_s) {
  const auto& fixes = track.fixes;
  const auto after =
      std::lower_bound(fixes.begin(), fixes.end(), time_s,
                       [](const Fix& fix, double time) { return fix.time_s < time; });
  if (after == fixes.end()) return std::nullopt;
  if (after->time_s == time_s) return after->position;
  if (after == fixes.begin()) return std::nullopt;
  const Fix& before = *std::prev(after);
  if (after->time_s - before.time_s > max_gap_s) return std::nullopt;
  return motion::position_on({before, *after}, time_s);
}

}  // namespace beespace
