#include "analysis/recorded/kept_by_height.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/text/bee_name.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace beespace::analysis {
namespace {

// More are not counted: of layers upon layers there may be any number.
constexpr std::uint64_t kMostOverGround = 100'000;

// How far the highest is above the lowest.
double height_difference_m(const io::Recording& recording) {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -lowest_m;
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) {
      lowest_m = std::min(lowest_m, fix.position.z);
      highest_m = std::max(highest_m, fix.position.z);
    }
  }
  return highest_m - lowest_m;
}

Result<std::vector<Track>> tracks_over_ground(const io::Recording& recording, double tolerance_m) {
  const bool metres = recording.frame == io::Frame::kMetres;
  auto tracks =
      tracks_of(recording, metres ? Geometry::kSpace : Geometry::kGroundAndHeight, tolerance_m);
  if (!tracks) return tracks;
  for (Track& track : *tracks) {
    track.heights_m.clear();
    if (!metres) continue;
    for (Fix& fix : track.fixes) fix.position.z = 0.0;
  }
  return tracks;
}

std::pair<PointId, PointId> pair_of(const Conflict& conflict) {
  return {conflict.first, conflict.second};
}

double power_of_ten_above(double metres) {
  double power = 10.0;
  while (power <= metres) power *= 10.0;
  return power;
}

}  // namespace

Result<std::optional<KeptByHeight>> kept_by_height(const io::Recording& recording,
                                                   const ConflictOptions& options,
                                                   double tolerance_m,
                                                   const std::vector<Conflict>& conflicts) {
  if (recording.flat || recording.show || options.vertical_m || recording.bees.size() < 2) {
    return std::optional<KeptByHeight>();
  }
  // In metres heights are no worse than places, and a swarm has its layers: it is said where an
  // all-clear rests on them.
  if (recording.frame == io::Frame::kMetres && !conflicts.empty()) {
    return std::optional<KeptByHeight>();
  }
  const double difference_m = height_difference_m(recording);
  if (!(difference_m > 0.0)) return std::optional<KeptByHeight>();
  const auto tracks = tracks_over_ground(recording, tolerance_m);
  if (!tracks) return tracks.error();
  ConflictOptions over_ground = options;
  over_ground.max_results = kMostOverGround;
  KeptByHeight kept;
  kept.vertical_m = power_of_ten_above(difference_m);
  auto found = find_conflicts(*tracks, over_ground);
  if (!found && found.error().code == ErrorCode::kTooManyResults) {
    kept.pairs = kMostOverGround;
    kept.more = true;
    // Which ones they are is not known: two of these may be among them.
    const auto on_surface =
        std::count_if(recording.bees.begin(), recording.bees.end(),
                      [](const io::RecordedBee& bee) { return bee.on_surface; });
    kept.on_surface = on_surface > 1 ? 1 : 0;
    return std::optional(kept);
  }
  if (!found) return std::move(found).error();
  const auto left_out = leave_out_standing(recording, *tracks, over_ground, found->conflicts);
  if (!left_out) return left_out.error();
  // Both are in the order of pairs.
  auto in_space = conflicts.begin();
  std::optional<std::pair<PointId, PointId>> last;
  for (const Conflict& conflict : found->conflicts) {
    const auto pair = pair_of(conflict);
    while (in_space != conflicts.end() && pair_of(*in_space) < pair) ++in_space;
    if (in_space != conflicts.end() && pair_of(*in_space) == pair) continue;
    if (!kept.closest || conflict.closest_m < kept.closest->closest_m) kept.closest = conflict;
    if (last == pair) continue;
    last = pair;
    ++kept.pairs;
    const auto on_surface = [&](PointId bee) { return recording.bees[bee].on_surface; };
    if (on_surface(pair.first) && on_surface(pair.second)) ++kept.on_surface;
  }
  return std::optional(kept);
}

std::string kept_by_height_text(const KeptByHeight& kept, const io::Recording& recording,
                                double threshold_m) {
  if (kept.pairs == 0) return {};
  const std::string but = " over ground, and only their heights keep them apart";
  const std::string option = "--vertical " + io::exact(kept.vertical_m);
  if (kept.more) {
    return "more than " + io::grouped(kept.pairs) + " times two come closer than " +
           io::exact(threshold_m) + " m" + but + "; " + option + " counts them";
  }
  std::string text = io::counted(kept.pairs, "pair comes", "pairs come") + " closer than " +
                     io::exact(threshold_m) + " m" + but;
  if (kept.closest) {
    const Conflict& closest = *kept.closest;
    text += " (" + text_of(name_of(closest.first, recording)) + " and " +
            text_of(name_of(closest.second, recording)) + ": " + io::length(closest.closest_m) +
            " at " + io::moment_text(closest.closest_s, recording) + ")";
  }
  return text + "; " + option + (kept.pairs == 1 ? " counts it" : " counts them");
}

std::string kept_on_surface_text(const KeptByHeight& kept) {
  if (kept.on_surface == 0) return {};
  if (kept.more) return "pairs of rovers or boats may be kept apart by heights alone";
  return io::counted(kept.on_surface, "pair of rovers or boats is",
                     "pairs of rovers or boats are") +
         " kept apart by heights alone";
}

}  // namespace beespace::analysis
