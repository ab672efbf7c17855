#include "analysis/recorded/ends.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace beespace::analysis {

std::optional<Ends> ends_of(const io::RecordedBee& bee) {
  if (bee.path) {
    const BezierPath& path = *bee.path;
    const Fix first{path.begins_s, path.begin};
    const Fix last =
        path.pieces.empty() ? first : Fix{path.pieces.back().ends_s, path.pieces.back().end};
    return Ends{first, first, last, last};
  }
  const std::vector<Fix>& fixes = bee.fixes;
  if (fixes.empty()) return std::nullopt;
  const std::size_t beside = fixes.size() > 1 ? 1 : 0;
  return Ends{fixes.front(), fixes[beside], fixes[fixes.size() - 1 - beside], fixes.back()};
}

double ground_of(const io::Recording& recording) {
  double lowest_m = std::numeric_limits<double>::infinity();
  if (recording.show) lowest_m = recording.show->ground_m.value_or(lowest_m);
  for (const io::RecordedBee& bee : recording.bees) {
    const auto ends = ends_of(bee);
    if (ends) lowest_m = std::min({lowest_m, ends->first.position.z, ends->last.position.z});
  }
  if (!recording.show || lowest_m <= io::kHighestShowGround_m) return lowest_m;
  const bool said = recording.show->ground_m.value_or(0.0) > io::kHighestShowGround_m;
  return said ? lowest_m : 0.0;
}

}  // namespace beespace::analysis
