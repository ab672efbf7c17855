#include "analysis/recorded/landed_times.hpp"

#include "analysis/recorded/apart.hpp"
#include "analysis/recorded/closest_of_each.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace beespace::analysis {
namespace {

bool stands_during(const io::RecordedBee& bee, double begins_s, double ends_s) {
  return std::any_of(bee.landed.begin(), bee.landed.end(), [&](const TimeSpan& span) {
    return span.begins_s <= begins_s && ends_s <= span.ends_s;
  });
}

// When both stand; spans of both are in ascending order, and those of one do not overlap.
std::vector<TimeSpan> common_spans(const std::vector<TimeSpan>& some,
                                   const std::vector<TimeSpan>& others) {
  std::vector<TimeSpan> common;
  auto a = some.begin();
  auto b = others.begin();
  while (a != some.end() && b != others.end()) {
    const TimeSpan both{std::max(a->begins_s, b->begins_s), std::min(a->ends_s, b->ends_s)};
    if (both.begins_s < both.ends_s) common.push_back(both);
    ++(a->ends_s < b->ends_s ? a : b);
  }
  return common;
}

// What is left of a time without others, which are in ascending order; instants take nothing away.
std::vector<TimeSpan> time_without(TimeSpan whole, const std::vector<TimeSpan>& others) {
  std::vector<TimeSpan> rest;
  for (const TimeSpan& other : others) {
    if (!(other.begins_s < other.ends_s)) continue;
    if (other.ends_s <= whole.begins_s || other.begins_s >= whole.ends_s) continue;
    if (whole.begins_s < other.begins_s) rest.push_back({whole.begins_s, other.begins_s});
    whole.begins_s = other.ends_s;
  }
  if (whole.begins_s < whole.ends_s) rest.push_back(whole);
  return rest;
}

// What a track is in a time; nothing where it is not there at both its ends.
std::optional<Track> part_of(const Track& track, const TimeSpan& time) {
  const auto from = whereabouts_at(track, time.begins_s);
  const auto to = whereabouts_at(track, time.ends_s);
  if (!from || !to) return std::nullopt;
  Track part;
  part.tolerance_m = track.tolerance_m;
  const auto add = [&part](double time_s, const Whereabouts& at) {
    part.fixes.push_back({time_s, at.place});
    if (at.height) part.heights_m.push_back(*at.height);
  };
  add(time.begins_s, *from);
  auto fix = std::upper_bound(track.fixes.begin(), track.fixes.end(), time.begins_s,
                              [](double time_s, const Fix& of) { return time_s < of.time_s; });
  for (; fix != track.fixes.end() && fix->time_s < time.ends_s; ++fix) {
    part.fixes.push_back(*fix);
    if (track.heights_m.empty()) continue;
    part.heights_m.push_back(track.heights_m[static_cast<std::size_t>(fix - track.fixes.begin())]);
  }
  add(time.ends_s, *to);
  return part;
}

// Of a conflict that lasts longer, what is in a time. Where rounding hides it in so short a time,
// it is told to be as close as the whole was.
Result<Conflict> cut_to(const TimeSpan& time, const Conflict& whole,
                        const std::vector<Track>& tracks, ConflictOptions options) {
  Conflict cut = whole;
  cut.begins_s = time.begins_s;
  cut.ends_s = time.ends_s;
  cut.closest_s = std::clamp(whole.closest_s, time.begins_s, time.ends_s);
  if (cut.closest_s == whole.closest_s) return cut;
  auto first = part_of(tracks[whole.first], time);
  auto second = part_of(tracks[whole.second], time);
  if (!first || !second) return cut;
  options.threads = 1;
  options.max_results = std::numeric_limits<std::uint64_t>::max();
  const std::vector<Track> two{*std::move(first), *std::move(second)};
  const auto found = find_conflicts(two, options);
  if (!found) return found.error();
  const auto least = std::min_element(
      found->conflicts.begin(), found->conflicts.end(),
      [](const Conflict& a, const Conflict& b) { return a.closest_m < b.closest_m; });
  if (least == found->conflicts.end()) return cut;
  cut.closest_m = least->closest_m;
  cut.closest_s = std::clamp(least->closest_s, time.begins_s, time.ends_s);
  return cut;
}

// Where bees fly: each stretch between two times on the ground is a track of its own.
struct FlyingTracks {
  std::vector<Track> tracks;
  std::vector<PointId> bees;  // whose each is, in ascending order
};

FlyingTracks flying_in(const io::Recording& recording, const std::vector<Track>& tracks) {
  FlyingTracks flying;
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    const Track& track = tracks[bee];
    if (track.fixes.empty()) continue;
    const TimeSpan whole{track.fixes.front().time_s, track.fixes.back().time_s};
    for (const TimeSpan& time : time_without(whole, recording.bees[bee].landed)) {
      auto part = part_of(track, time);
      if (!part) continue;
      flying.tracks.push_back(*std::move(part));
      flying.bees.push_back(bee);
    }
  }
  return flying;
}

}  // namespace

bool says_who_has_landed(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return !bee.landed.empty(); });
}

bool has_landed(const io::Recording& recording, PointId track, double time_s) {
  return track < recording.bees.size() && stands_during(recording.bees[track], time_s, time_s);
}

bool both_stand(const io::Recording& recording, const Conflict& encounter) {
  return has_landed(recording, encounter.first, encounter.closest_s) &&
         has_landed(recording, encounter.second, encounter.closest_s);
}

Result<std::size_t> leave_out_standing(const io::Recording& recording,
                                       const std::vector<Track>& tracks,
                                       const ConflictOptions& options,
                                       std::vector<Conflict>& conflicts) {
  if (!says_who_has_landed(recording)) return std::size_t{0};
  std::size_t left_out = 0;
  std::vector<Conflict> kept;
  for (const Conflict& conflict : conflicts) {
    const io::RecordedBee& first = recording.bees[conflict.first];
    const io::RecordedBee& second = recording.bees[conflict.second];
    if (stands_during(first, conflict.begins_s, conflict.ends_s) &&
        stands_during(second, conflict.begins_s, conflict.ends_s)) {
      ++left_out;
      continue;
    }
    const auto standing =
        conflict.certain ? common_spans(first.landed, second.landed) : std::vector<TimeSpan>();
    const TimeSpan whole{conflict.begins_s, conflict.ends_s};
    const auto times = time_without(whole, standing);
    if (times.empty() || (times.size() == 1 && times.front() == whole)) {
      kept.push_back(conflict);
      continue;
    }
    for (const TimeSpan& time : times) {
      const auto cut = cut_to(time, conflict, tracks, options);
      if (!cut) return cut.error();
      kept.push_back(*cut);
    }
  }
  conflicts = std::move(kept);
  return left_out;
}

std::vector<Conflict> beside_landed(const io::Recording& recording,
                                    const std::vector<Conflict>& conflicts) {
  std::vector<Conflict> beside;
  std::copy_if(conflicts.begin(), conflicts.end(), std::back_inserter(beside),
               [&](const Conflict& conflict) {
                 const auto stands = [&](PointId bee) {
                   return stands_during(recording.bees[bee], conflict.begins_s, conflict.ends_s);
                 };
                 return stands(conflict.first) || stands(conflict.second);
               });
  return beside;
}

Result<std::optional<Conflict>> closest_of_flying(const io::Recording& recording,
                                                  const std::vector<Track>& tracks,
                                                  double max_gap_s, const RunOptions& run) {
  const FlyingTracks flying = flying_in(recording, tracks);
  auto closest = find_closest_encounter(flying.tracks, max_gap_s, run);
  if (!closest || !*closest) return closest;
  // In ascending order of bees, as the tracks are.
  (*closest)->first = flying.bees[(*closest)->first];
  (*closest)->second = flying.bees[(*closest)->second];
  return closest;
}

Result<std::vector<std::optional<Conflict>>> closest_of_each_flying(
    const io::Recording& recording, const std::vector<Track>& tracks, double threshold_m,
    double max_gap_s, unsigned threads) {
  if (!says_who_has_landed(recording)) {
    return closest_of_each(tracks, threshold_m, max_gap_s, threads);
  }
  const FlyingTracks flying = flying_in(recording, tracks);
  const auto of_flights = closest_of_each(flying.tracks, threshold_m, max_gap_s, threads);
  if (!of_flights) return of_flights.error();
  std::vector<std::optional<Conflict>> closest(tracks.size());
  for (std::size_t flight = 0; flight < of_flights->size(); ++flight) {
    std::optional<Conflict> found = (*of_flights)[flight];
    if (!found) continue;
    found->first = flying.bees[found->first];
    found->second = flying.bees[found->second];
    auto& of = closest[flying.bees[flight]];
    if (!of || found->closest_m < of->closest_m) of = found;
  }
  return closest;
}

}  // namespace beespace::analysis
