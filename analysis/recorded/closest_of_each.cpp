#include "analysis/recorded/closest_of_each.hpp"

#include <beespace/find_conflicts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace beespace::analysis {
namespace {

using ClosestOfEach = std::vector<std::optional<Conflict>>;

void take(ClosestOfEach& closest, const Conflict& found) {
  for (const PointId bee : {found.first, found.second}) {
    if (!closest[bee] || found.closest_m < closest[bee]->closest_m) closest[bee] = found;
  }
}

// Whether it is known of a bee, or never will be, as it never flies.
bool is_found(PointId bee, const ClosestOfEach& closest, const std::vector<Track>& tracks) {
  return closest[bee] || tracks[bee].fixes.empty();
}

bool all_are_found(const ClosestOfEach& closest, const std::vector<Track>& tracks) {
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    if (!is_found(bee, closest, tracks)) return false;
  }
  return true;
}

// No two can be farther apart.
double extent_of(const std::vector<Track>& tracks) {
  double farthest_m = 0.0;
  for (const Track& track : tracks) {
    for (const Fix& fix : track.fixes) {
      farthest_m = std::max(farthest_m, std::hypot(fix.position.x, fix.position.y, fix.position.z));
    }
  }
  return 2.0 * farthest_m;
}

// Of one of which those around do not tell.
std::optional<Error> look_at_all(PointId bee, const std::vector<Track>& tracks, double max_gap_s,
                                 ClosestOfEach& closest) {
  for (PointId other = 0; other < tracks.size(); ++other) {
    if (other == bee) continue;
    const std::vector<Track> two{tracks[bee], tracks[other]};
    const auto found = find_closest_encounter(two, max_gap_s);
    if (!found) return found.error();
    if (!*found) continue;
    Conflict conflict = **found;
    conflict.first = std::min(bee, other);
    conflict.second = std::max(bee, other);
    if (!closest[bee] || conflict.closest_m < closest[bee]->closest_m) closest[bee] = conflict;
  }
  return std::nullopt;
}

}  // namespace

Result<ClosestOfEach> closest_of_each(const std::vector<Track>& tracks, double threshold_m,
                                      double max_gap_s, unsigned threads) {
  constexpr std::uint64_t kMostOfEach = 200;
  const double extent_m = extent_of(tracks);
  ClosestOfEach closest(tracks.size());
  double within_m = threshold_m;
  for (;;) {
    const auto found =
        find_conflicts(tracks, {.threshold_m = within_m,
                                .max_gap_s = max_gap_s,
                                .threads = threads,
                                .max_results = 100'000 + kMostOfEach * tracks.size()});
    if (!found && found.error().code != ErrorCode::kTooManyResults) return found.error();
    if (!found) break;
    // A bee that was found before keeps its pair: none other is closer.
    for (const Conflict& conflict : found->conflicts) take(closest, conflict);
    if (all_are_found(closest, tracks) || within_m > extent_m) return closest;
    within_m *= 2.0;
  }
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    if (is_found(bee, closest, tracks)) continue;
    if (auto error = look_at_all(bee, tracks, max_gap_s, closest)) return *std::move(error);
  }
  return closest;
}

}  // namespace beespace::analysis
