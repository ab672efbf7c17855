#include "analysis/recorded/coverage.hpp"

#include "analysis/recorded/airborne.hpp"
#include "analysis/recorded/begins_in_air.hpp"
#include "analysis/recorded/ends.hpp"
#include "analysis/recorded/jump_spans.hpp"
#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr double kLoggedTolerance_m = 1.0;  // logs are less exact than shows
// What takes off or lands goes up and down; robots that are parked go nowhere.
constexpr double kMostAtRest_mps = 0.5;
constexpr double kMostParked_mps = 0.02;

// What has heights takes off and lands where others do, or it is not known where it stands.
bool may_be_cut_off(const io::Recording& recording) {
  if (recording.show) return true;
  if (recording.flat) return false;
  return std::any_of(recording.bees.begin(), recording.bees.end(), [](const auto& bee) {
    return !bee.fixes.empty() &&
           (bee.fixes.front().position.z != 0.0 || bee.fixes.back().position.z != 0.0);
  });
}

bool is_in_a_plane(const io::Recording& recording) {
  return recording.frame == io::Frame::kMetres && !may_be_cut_off(recording);
}

// Where all are that are seen from above: who comes or goes does so at its border.
class Surroundings {
 public:
  explicit Surroundings(const io::Recording& recording) {
    if (!recording.flat) return;
    if (recording.reach) {
      low_x_ = recording.reach->least.x;
      low_y_ = recording.reach->least.y;
      high_x_ = recording.reach->greatest.x;
      high_y_ = recording.reach->greatest.y;
    }
    for (const io::RecordedBee& bee : recording.bees) {
      for (const Fix& fix : bee.fixes) {
        low_x_ = std::min(low_x_, fix.position.x);
        low_y_ = std::min(low_y_, fix.position.y);
        high_x_ = std::max(high_x_, fix.position.x);
        high_y_ = std::max(high_y_, fix.position.y);
      }
    }
  }

  // Whether who is there, and goes on as it did beside that, does not reach the border in a time.
  [[nodiscard]] bool in_the_midst(const Fix& end, const Fix& beside, double time_s,
                                  io::Frame frame) const {
    const double step_s = std::abs(end.time_s - beside.time_s);
    const double step_m = across_m(end.position, beside.position, frame);
    const double way_m = step_s > 0.0 ? step_m / step_s * time_s : 0.0;
    const Point& at = end.position;
    const bool inside = at.x >= low_x_ && at.x <= high_x_ && at.y >= low_y_ && at.y <= high_y_;
    const double to_border_m = std::min(
        std::min(across_m(at, {low_x_, at.y, 0}, frame), across_m(at, {high_x_, at.y, 0}, frame)),
        std::min(across_m(at, {at.x, low_y_, 0}, frame), across_m(at, {at.x, high_y_, 0}, frame)));
    return inside && to_border_m > way_m;  // never where nothing was added
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  static double across_m(const Point& a, const Point& b, io::Frame frame) {
    const Point apart = io::flat_offset_m(a, b, frame);
    return std::hypot(apart.x, apart.y);
  }

  double low_x_ = kInfinity;
  double low_y_ = kInfinity;
  double high_x_ = -kInfinity;
  double high_y_ = -kInfinity;
};

// Whether it goes nowhere over ground from one fix to the next, or the other way round.
bool rests(const Fix& from, const Fix& to, io::Frame frame, double most_mps) {
  const Point apart = io::flat_offset_m(to.position, from.position, frame);
  return std::hypot(apart.x, apart.y) <= most_mps * std::abs(to.time_s - from.time_s);
}

// From the first fix of all to the last one, and as far as some are there without a place.
std::pair<double, double> whole_time(const io::Recording& recording) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> time{kInfinity, -kInfinity};
  for (const io::RecordedBee& bee : recording.bees) {
    const auto ends = ends_of(bee);
    if (!ends) continue;
    const double first_s = bee.unplaced_from_s.value_or(ends->first.time_s);
    const double last_s = bee.unplaced_until_s.value_or(ends->last.time_s);
    time.first = std::min({time.first, ends->first.time_s, first_s});
    time.second = std::max({time.second, ends->last.time_s, last_s});
  }
  return time;
}

// Of who leaves a sector the last records often have no place, or the last one again.
bool is_beside_sector(const io::Recording& recording, const TimeSpan& unplaced, double max_gap_s) {
  return recording.sector && unplaced.ends_s - unplaced.begins_s <= max_gap_s;
}

// Records that are missing, but for those.
io::MissingRecords missing_within(const io::Recording& recording, double max_gap_s) {
  io::MissingRecords missing = recording.missing;
  if (!recording.sector) return missing;
  std::uint64_t beside = 0;
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.beside_s.empty()) continue;
    const TimeSpan fixes{bee.fixes.front().time_s, bee.fixes.back().time_s};
    const auto [first, last] = std::minmax_element(bee.beside_s.begin(), bee.beside_s.end());
    for (const double time_s : bee.beside_s) {
      const bool before = time_s < fixes.begins_s;
      const TimeSpan end =
          before ? TimeSpan{*first, fixes.begins_s} : TimeSpan{fixes.ends_s, *last};
      if (is_beside_sector(recording, end, max_gap_s)) ++beside;
    }
  }
  missing.count -= std::min(missing.count, beside);
  missing.bees = std::min(missing.bees, missing.count);
  return missing;
}

// How long a bee is not known before its first fix and after its last one, and whether it was in
// the air then, or there without a place, or never seen in the air while others fly: `hidden` is
// when a conflict may be, `away` all of that time.
struct Outside {
  double seconds = 0.0;
  bool cut_off = false;
  bool unplaced = false;
  bool unseen = false;
  std::vector<TimeSpan> hidden = {};
  std::vector<TimeSpan> away = {};
};

// From when, or until when, an aircraft is in the air beyond `end_s`, its first or last fix: the
// end of all, unless it is on the ground in between. What is as short as is usual is known.
double grounded(const std::optional<double>& ground_s, double end_s, double whole_s,
                double usual_s) {
  if (!ground_s) return whole_s;
  return std::abs(*ground_s - end_s) <= usual_s ? end_s : *ground_s;
}

// A drone of a show is known while it stands on the ground. Those in degrees report each at times
// of its own: one is cut off where it is not heard of for longer than that is usual.
// What is shorter than the typical time between two fixes is no part of the recording of its own:
// each is heard at times of its own; but one fix alone is joined to nothing. While others fly for
// longer than a gap, it is not known whether a drone still stands that is never seen in the air.
std::vector<Outside> outside_of(const io::Recording& recording, double max_gap_s,
                                const MaxGap& max_gap) {
  constexpr double kNearly = 0.99;  // as intervals are rounded, and who lacks one lacks all of it
  const double interval_s = kNearly * max_gap.typical_s.value_or(max_gap.interval_s);
  const double usual_s = recording.frame == io::Frame::kWgs84 ? max_gap_s : 0.0;
  const auto whole = whole_time(recording);
  const double ground_m = ground_of(recording);
  const bool flies = may_be_cut_off(recording);
  const bool in_a_plane = is_in_a_plane(recording);
  const Surroundings surroundings(recording);
  const Airborne airborne(recording);
  std::vector<Outside> outside(recording.bees.size());
  // `away` is when it is not known; of that it is there without a place in `unplaced`.
  const auto add = [&](Outside& of, const TimeSpan& away, const TimeSpan& unplaced, const Fix& end,
                       const Fix& beside) {
    const double seconds = away.ends_s - away.begins_s;
    if (unplaced.begins_s < unplaced.ends_s && !is_beside_sector(recording, unplaced, max_gap_s)) {
      of.unplaced = true;
      of.hidden.push_back(unplaced);
    }
    if (recording.sector) {
      of.seconds += std::max(seconds, 0.0);
      return;
    }
    if (!(seconds > 0.0)) return;
    const double known_s = end == beside ? 0.0 : std::max(usual_s, interval_s);
    const double height_m = end.position.z - ground_m;
    if (recording.show && height_m <= kStandsWithin_m) return;
    const double before_s = of.seconds;
    of.seconds += seconds;
    of.away.push_back(away);
    const bool stands =
        height_m <= kLoggedTolerance_m && rests(end, beside, recording.frame, kMostAtRest_mps);
    // Who is seen from above leaves the picture; a robot, or who is on the Earth, stops or goes on.
    const bool moves = !rests(end, beside, recording.frame, kMostParked_mps);
    // The collar of an animal that rests may fail, too.
    const bool is_wild = recording.of_animals && recording.frame == io::Frame::kWgs84;
    const bool may_leave = recording.flat && !is_wild &&
                           !surroundings.in_the_midst(end, beside, max_gap_s, recording.frame);
    const bool must_move = !recording.flat || recording.frame == io::Frame::kWgs84;
    const bool lost = (in_a_plane || recording.flat || is_wild) && seconds > max_gap_s &&
                      !may_leave && (moves || !must_move || is_wild);
    if (!recording.show && !lost && !(flies && !stands && seconds > known_s)) {
      if (end != beside && seconds < interval_s) {
        of.seconds = before_s;
        of.away.pop_back();
      }
      return;
    }
    of.cut_off = true;
    of.hidden.push_back(away);
  };
  for (std::size_t i = 0; i < outside.size(); ++i) {
    const auto ends = ends_of(recording.bees[i]);
    if (!ends) continue;
    const io::RecordedBee& bee = recording.bees[i];
    const double from_s = grounded(bee.on_ground_until_s, ends->first.time_s, whole.first, usual_s);
    const double until_s = grounded(bee.on_ground_from_s, ends->last.time_s, whole.second, usual_s);
    const double first_s = ends->first.time_s;
    const double last_s = ends->last.time_s;
    add(outside[i], {from_s, first_s}, {bee.unplaced_from_s.value_or(first_s), first_s},
        ends->first, ends->second);
    add(outside[i], {last_s, until_s}, {last_s, bee.unplaced_until_s.value_or(last_s)}, ends->last,
        ends->last_but_one);
    if (outside[i].cut_off) continue;
    double seen_by_none_s = 0.0;
    for (const TimeSpan& span : airborne.unseen(static_cast<PointId>(i), max_gap.seconds)) {
      outside[i].unseen = true;
      outside[i].hidden.push_back(span);
      outside[i].away.push_back(span);
      seen_by_none_s += span.ends_s - span.begins_s;
    }
    outside[i].seconds = std::max(outside[i].seconds, seen_by_none_s);
  }
  return outside;
}

bool is_of_instants(const io::Recording& recording) {
  const auto whole = whole_time(recording);
  return whole.first < whole.second &&
         std::all_of(recording.bees.begin(), recording.bees.end(), [](const io::RecordedBee& bee) {
           const auto ends = ends_of(bee);
           return ends && ends->first.time_s == ends->last.time_s;
         });
}

// Those that overlap put together, in ascending order of (track, begins_s).
std::vector<Gap> apart_from_each_other(std::vector<Gap> all) {
  std::sort(all.begin(), all.end(), [](const Gap& a, const Gap& b) {
    return std::tuple(a.track, a.begins_s, -a.ends_s) < std::tuple(b.track, b.begins_s, -b.ends_s);
  });
  std::vector<Gap> apart;
  for (const Gap& next : all) {
    if (!apart.empty() && apart.back().track == next.track && next.begins_s < apart.back().ends_s) {
      apart.back().ends_s = std::max(apart.back().ends_s, next.ends_s);
    } else {
      apart.push_back(next);
    }
  }
  return apart;
}

// So many as are named, the longest first.
std::vector<Gap> longest_of(std::vector<Gap> gaps) {
  const auto named =
      gaps.begin() + static_cast<std::ptrdiff_t>(std::min(Coverage::kMostNamed, gaps.size()));
  std::partial_sort(gaps.begin(), named, gaps.end(), [](const Gap& a, const Gap& b) {
    if (length_of(a) != length_of(b)) return length_of(a) > length_of(b);
    return a.track != b.track ? a.track < b.track : a.begins_s < b.begins_s;
  });
  gaps.erase(named, gaps.end());
  return gaps;
}

// How far apart the bursts of fixes are of which its track is made, as collars take them by a
// schedule, or the fixes of an aircraft that flies straight on: much of its time lies between them,
// and nearly all gaps are of one length; of aircraft none that is longer than those may differ. An
// outage of a drone is none.
using GapIterator = std::vector<Gap>::const_iterator;
std::optional<double> interval_of_bursts(const io::RecordedBee& bee, GapIterator first,
                                         GapIterator last, bool of_aircraft) {
  constexpr double kMuch = 0.3;
  constexpr double kNearlyAll = 0.8;
  constexpr double kDiffer = 0.1;
  std::vector<double> lengths_s;
  lengths_s.reserve(static_cast<std::size_t>(last - first));
  for (auto gap = first; gap != last; ++gap) lengths_s.push_back(length_of(*gap));
  if (lengths_s.size() < kFixesToTell || bee.fixes.empty()) return std::nullopt;
  const double all_s = bee.fixes.back().time_s - bee.fixes.front().time_s;
  if (std::accumulate(lengths_s.begin(), lengths_s.end(), 0.0) < kMuch * all_s) {
    return std::nullopt;
  }
  std::sort(lengths_s.begin(), lengths_s.end());
  const double usual_s = lengths_s[(lengths_s.size() - 1) / 2];
  const auto alike = std::count_if(lengths_s.begin(), lengths_s.end(), [usual_s](double length_s) {
    return std::abs(length_s - usual_s) <= kDiffer * usual_s;
  });
  const bool regular =
      static_cast<double>(alike) >= kNearlyAll * static_cast<double>(lengths_s.size());
  if (regular) return usual_s;
  constexpr double kOfAircraft_s = 120.0;  // a minute or so in cruise
  const std::size_t nearly_last =
      static_cast<std::size_t>(kNearlyAll * static_cast<double>(lengths_s.size() - 1));
  const double nearly_all_s = lengths_s[nearly_last];
  return of_aircraft && nearly_all_s <= kOfAircraft_s ? std::optional(nearly_all_s) : std::nullopt;
}

}  // namespace

std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps,
                                    const MaxGap& max_gap) {
  std::vector<double> unknown_s;
  constexpr double kAny = std::numeric_limits<double>::infinity();
  for (const Outside& outside : outside_of(recording, kAny, max_gap)) {
    double of_this_s = recording.sector ? 0.0 : outside.seconds;
    if (recording.sector) {
      for (const TimeSpan& span : outside.hidden) of_this_s += span.ends_s - span.begins_s;
    }
    unknown_s.push_back(of_this_s);
  }
  // A long gap may be within a doubtful span, or across its ends.
  const auto within = apart_from_each_other(joined_gaps(gaps, doubtful_spans(recording, max_gap)));
  for (const Gap& gap : within) unknown_s[gap.track] += length_of(gap);
  return unknown_s;
}

std::vector<Gap> unknown_spans(const io::Recording& recording, const std::vector<Gap>& gaps,
                               const MaxGap& max_gap) {
  std::vector<Gap> all = joined_gaps(gaps, doubtful_spans(recording, max_gap));
  for (std::size_t track = 0; track < recording.bees.size(); ++track) {
    const io::RecordedBee& bee = recording.bees[track];
    if (bee.fixes.empty() || !bee.shared) continue;
    all.push_back({static_cast<PointId>(track), bee.fixes.front().time_s, bee.fixes.back().time_s});
  }
  const auto outside = outside_of(recording, max_gap.seconds, max_gap);
  for (std::size_t track = 0; track < outside.size(); ++track) {
    for (const TimeSpan& span : outside[track].hidden) {
      all.push_back({static_cast<PointId>(track), span.begins_s, span.ends_s});
    }
  }
  return apart_from_each_other(std::move(all));
}

std::vector<Gap> all_unknown_spans(const io::Recording& recording, const std::vector<Gap>& gaps,
                                   const MaxGap& max_gap) {
  std::vector<Gap> all = joined_gaps(gaps, doubtful_spans(recording, max_gap));
  constexpr double kAny = std::numeric_limits<double>::infinity();
  PointId bee = 0;
  for (const Outside& outside : outside_of(recording, kAny, max_gap)) {
    for (const TimeSpan& span : recording.sector ? outside.hidden : outside.away) {
      all.push_back({bee, span.begins_s, span.ends_s});
    }
    ++bee;
  }
  return apart_from_each_other(std::move(all));
}

Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& gaps,
                     const MaxGap& max_gap) {
  std::vector<BeeInterval> intervals(recording.bees.size());
  for (const Gap& gap : gaps) {
    BeeInterval& interval = intervals[gap.track];
    if (interval.fixes == 0) interval = interval_of(recording.bees[gap.track]);
  }
  return coverage_of(recording, gaps, max_gap, intervals);
}

Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& long_gaps,
                     const MaxGap& max_gap, const std::vector<BeeInterval>& intervals) {
  const std::vector<Gap> gaps = joined_gaps(long_gaps, lost_spans(recording, max_gap));
  Coverage coverage;
  coverage.max_gap = max_gap;
  coverage.gaps = gaps.size();
  for (auto first = gaps.cbegin(); first != gaps.cend();) {
    const PointId track = first->track;
    const auto last =
        std::find_if(first, gaps.cend(), [track](const Gap& gap) { return gap.track != track; });
    for (auto gap = first; gap != last; ++gap) coverage.in_gaps_s += length_of(*gap);
    ++coverage.bees_with_gaps;
    const auto& [fixes, median_s] = intervals[track];
    const auto apart_s =
        fixes >= kFixesToTell && median_s > max_gap.seconds
            ? std::optional(median_s)
            : interval_of_bursts(recording.bees[track], first, last, recording.of_aircraft);
    // Shorter ones are of records without a place, which a longer --max-gap does not join.
    if (apart_s && *apart_s > max_gap.seconds) {
      coverage.bursts = coverage.bursts || apart_s != median_s;
      coverage.slow.push_back(track);
      coverage.slowest_interval_s = std::max(coverage.slowest_interval_s, *apart_s);
    }
    first = last;
  }
  coverage.of_aircraft = recording.of_aircraft;
  if (!coverage.slow.empty()) {
    coverage.joins_slow_s = recording.of_aircraft ? max_gap_just_for(coverage.slowest_interval_s)
                                                  : max_gap_for(coverage.slowest_interval_s);
  }
  coverage.longest = longest_of(gaps);
  std::vector<Gap> hidden;
  PointId bee = 0;
  for (const Outside& outside : outside_of(recording, max_gap.seconds, max_gap)) {
    coverage.outside_s += outside.seconds;
    if (outside.seconds > 0.0) ++coverage.bees_partly;
    if (outside.cut_off) ++coverage.bees_cut_off;
    if (outside.unplaced) ++coverage.bees_unplaced;
    if (outside.unseen) coverage.unseen.push_back(bee);
    for (const TimeSpan& span : outside.hidden) {
      hidden.push_back({bee, span.begins_s, span.ends_s});
    }
    ++bee;
  }
  coverage.longest_outside = longest_of(std::move(hidden));
  coverage.in_a_plane = is_in_a_plane(recording) || recording.flat || recording.of_animals;
  coverage.sector = recording.sector;
  coverage.begins_in_air = begins_in_air(recording, max_gap);
  coverage.instants_only = is_of_instants(recording);
  coverage.alone = recorded_alone(recording);
  coverage.alone_is_known = !recording.of_drones && !recording.called_drones;
  if (!coverage.alone_is_known) coverage.alone_begins_s = alone_begins_s(recording, coverage.alone);
  coverage.bridged = longest_bridged(recording, max_gap);
  coverage.missing = missing_within(recording, max_gap.seconds);
  return coverage;
}

}  // namespace beespace::analysis
