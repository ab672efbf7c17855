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
#include <map>
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

using TimeOfPairs = std::map<std::pair<PointId, PointId>, double>;

TimeOfPairs time_in_conflict(const std::vector<Conflict>& conflicts) {
  TimeOfPairs times_s;
  for (const Conflict& conflict : conflicts) {
    times_s[pair_of(conflict)] += conflict.ends_s - conflict.begins_s;
  }
  return times_s;
}

// Whether the same two are so close while they are low.
bool is_of_low(const Conflict& over_ground, const std::vector<Conflict>& low) {
  return std::any_of(low.begin(), low.end(), [&over_ground](const Conflict& in_space) {
    return pair_of(in_space) == pair_of(over_ground) && in_space.begins_s <= over_ground.ends_s &&
           over_ground.begins_s <= in_space.ends_s;
  });
}

// " (Wolf1 and Wolf2: 2 h, not 53 min 37 s)".
std::string longest_text(const KeptByHeight& kept, const io::Recording& recording) {
  if (!kept.longest) return {};
  const KeptByHeight::Longer& longest = *kept.longest;
  return " (" + text_of(name_of(longest.first, recording)) + " and " +
         text_of(name_of(longest.second, recording)) + ": " + io::time_span(longest.over_ground_s) +
         ", not " + io::time_span(longest.in_space_s) + ")";
}

std::string longer_text(const KeptByHeight& kept, const io::Recording& recording,
                        double threshold_m) {
  if (kept.longer == 0) return {};
  return io::counted(kept.longer, "pair is", "pairs are") + " closer than " +
         io::exact(threshold_m) + " m over ground for longer than with heights" +
         longest_text(kept, recording);
}

}  // namespace

Result<std::optional<KeptByHeight>> kept_by_height(const io::Recording& recording,
                                                   const ConflictOptions& options,
                                                   double tolerance_m,
                                                   const std::vector<Conflict>& conflicts,
                                                   const std::vector<Conflict>& low) {
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
  const auto says_little = [&](const io::RecordedBee& bee) {
    return recording.of_animals || bee.on_surface;
  };
  KeptByHeight kept;
  kept.of_animals = recording.of_animals;
  kept.vertical_m = power_of_ten_above(difference_m);
  auto found = find_conflicts(*tracks, over_ground);
  if (!found && found.error().code == ErrorCode::kTooManyResults) {
    kept.pairs = kMostOverGround;
    kept.more = true;
    // Which ones they are is not known: two of these may be among them.
    const auto some = std::count_if(recording.bees.begin(), recording.bees.end(), says_little);
    kept.unsure = some > 1 ? 1 : 0;
    return std::optional(kept);
  }
  if (!found) return std::move(found).error();
  const auto left_out = leave_out_standing(recording, *tracks, over_ground, found->conflicts);
  if (!left_out) return left_out.error();
  std::erase_if(found->conflicts,
                [&low](const Conflict& conflict) { return is_of_low(conflict, low); });
  constexpr double kLonger = 1.01;  // than what rounding makes of it
  const TimeOfPairs in_space_s = time_in_conflict(conflicts);
  const auto is_in_space = [&](const Conflict& conflict) {
    return in_space_s.contains(pair_of(conflict));
  };
  for (const auto& [pair, seconds] : time_in_conflict(found->conflicts)) {
    const bool unsure =
        says_little(recording.bees[pair.first]) && says_little(recording.bees[pair.second]);
    const auto in_space = in_space_s.find(pair);
    if (in_space == in_space_s.end()) {
      ++kept.pairs;
      kept.unsure += unsure ? 1 : 0;
    } else if (unsure && seconds > kLonger * in_space->second) {
      ++kept.longer;
      const KeptByHeight::Longer longer{pair.first, pair.second, seconds, in_space->second};
      if (!kept.longest || longer.by_s() > kept.longest->by_s()) kept.longest = longer;
    }
  }
  for (const Conflict& conflict : found->conflicts) {
    if (is_in_space(conflict)) continue;
    if (!kept.closest || conflict.closest_m < kept.closest->closest_m) kept.closest = conflict;
  }
  return std::optional(kept);
}

std::string kept_by_height_text(const KeptByHeight& kept, const io::Recording& recording,
                                double threshold_m) {
  const std::string longer = longer_text(kept, recording, threshold_m);
  if (kept.pairs == 0 && longer.empty()) return {};
  const std::string but = " over ground, and only their heights keep them apart";
  const std::string option = "--vertical " + io::exact(kept.vertical_m);
  if (kept.more) {
    return "more than " + io::grouped(kept.pairs) + " times two come closer than " +
           io::exact(threshold_m) + " m" + but + "; " + option + " counts them";
  }
  if (kept.pairs == 0) return longer + "; " + option + " tells for how long";
  std::string text = io::counted(kept.pairs, "pair comes", "pairs come") + " closer than " +
                     io::exact(threshold_m) + " m" + but;
  if (kept.closest) {
    const Conflict& closest = *kept.closest;
    text += " (" + text_of(name_of(closest.first, recording)) + " and " +
            text_of(name_of(closest.second, recording)) + ": " +
            io::length_below(threshold_m, closest.closest_m) + " at " +
            io::moment_text(closest.closest_s, recording) + ")";
  }
  if (!longer.empty()) text += ", and " + longer;
  return text + "; " + option + (kept.pairs + kept.longer == 1 ? " counts it" : " counts them");
}

std::string unsure_heights_text(const KeptByHeight& kept) {
  if (kept.unsure == 0) return {};
  const std::string who = kept.of_animals ? "animals" : "rovers or boats";
  if (kept.more) return "pairs of " + who + " may be kept apart by heights alone";
  return io::counted(kept.unsure, "pair of " + who + " is", "pairs of " + who + " are") +
         " kept apart by heights alone";
}

Status judge_heights(const io::Recording& recording, const ConflictOptions& options,
                     const std::vector<Conflict>& conflicts, const std::vector<Conflict>& low,
                     Coverage& coverage) {
  const bool any = recording.of_animals ||
                   std::any_of(recording.bees.begin(), recording.bees.end(),
                               [](const io::RecordedBee& bee) { return bee.on_surface; });
  if (!any) return std::monostate{};
  // No curves are brought to lines: shows are not looked at.
  const auto kept = kept_by_height(recording, options, 0.0, conflicts, low);
  if (!kept) return kept.error();
  if (*kept) coverage.heights = unsure_heights_text(**kept);
  return std::monostate{};
}

}  // namespace beespace::analysis
