#include "analysis/recorded/airborne.hpp"

#include "analysis/recorded/ends.hpp"
#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/landed_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr double kWavers_m = 1.0;  // so far heights of who stands do, in a log

// From the first fix in the air to the last one.
std::optional<TimeSpan> flight_time(const io::Recording& recording, PointId bee, double above_m) {
  const io::RecordedBee& of = recording.bees[bee];
  if (of.path) return TimeSpan{of.path->begins_s, path_end_s(*of.path)};
  const auto is_up = [&](const Fix& fix) {
    return fix.position.z > above_m && !has_landed(recording, bee, fix.time_s);
  };
  const auto first = std::find_if(of.fixes.begin(), of.fixes.end(), is_up);
  if (first == of.fixes.end()) return std::nullopt;
  const auto last = std::find_if(of.fixes.rbegin(), of.fixes.rend(), is_up);
  return TimeSpan{first->time_s, last->time_s};
}

double median_begin_s(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Those of one group overlap in time, if one after the other; those of two never do.
std::vector<std::vector<PointId>> recorded_together(std::vector<PointId> bees,
                                                    const std::vector<TimeSpan>& times) {
  std::sort(bees.begin(), bees.end(),
            [&times](PointId a, PointId b) { return times[a].begins_s < times[b].begins_s; });
  std::vector<std::vector<PointId>> groups;
  double latest_s = -std::numeric_limits<double>::infinity();  // of those before
  for (const PointId bee : bees) {
    if (latest_s < times[bee].begins_s) groups.emplace_back();
    groups.back().push_back(bee);
    latest_s = std::max(latest_s, times[bee].ends_s);
  }
  return groups;
}

// Those of a smaller group that begins as much earlier or later than the greatest as two zones are
// apart. Of two that are as great it is the earlier one.
void add_of_other_zone(const std::vector<std::vector<PointId>>& groups,
                       const std::vector<TimeSpan>& times, std::vector<PointId>& alone) {
  const auto begins_s = [&times](const std::vector<PointId>& group) {
    return times[group.front()].begins_s;
  };
  const auto& most =
      *std::max_element(groups.begin(), groups.end(),
                        [](const auto& a, const auto& b) { return a.size() <= b.size(); });
  for (const std::vector<PointId>& group : groups) {
    if (&group == &most || group.size() == 1) continue;
    if (zones_apart_s(begins_s(group) - begins_s(most))) {
      alone.insert(alone.end(), group.begin(), group.end());
    }
  }
}

}  // namespace

Airborne::Airborne(const io::Recording& recording)
    : recording_(recording),
      tells_((recording.of_drones || recording.show) && !recording.flat && !recording.reach) {
  if (!tells_) return;
  const double above_m = ground_of(recording) + (recording.show ? kStandsWithin_m : kWavers_m);
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const auto time = flight_time(recording, bee, above_m);
    flies_.push_back(time.has_value());
    if (!time) continue;
    const TimeSpan so_far = flight_.value_or(*time);
    flight_ =
        TimeSpan{std::min(so_far.begins_s, time->begins_s), std::max(so_far.ends_s, time->ends_s)};
  }
}

std::vector<TimeSpan> Airborne::unseen(PointId bee, double max_gap_s) const {
  const auto ends = ends_of(recording_.bees[bee]);
  if (!tells_ || !flight_ || flies_[bee] || !ends) return {};
  std::vector<TimeSpan> spans;
  const auto add = [&](const TimeSpan& span) {
    if (span.ends_s - span.begins_s > max_gap_s) spans.push_back(span);
  };
  add({flight_->begins_s, std::min(ends->first.time_s, flight_->ends_s)});
  add({std::max(ends->last.time_s, flight_->begins_s), flight_->ends_s});
  return spans;
}

std::vector<PointId> recorded_alone(const io::Recording& recording) {
  if (recording.show) return {};
  std::vector<PointId> bees;
  std::vector<TimeSpan> times(recording.bees.size());
  bool any_lasts = false;
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const auto ends = ends_of(recording.bees[bee]);
    if (!ends) continue;
    times[bee] = {ends->first.time_s, ends->last.time_s};
    any_lasts = any_lasts || times[bee].begins_s < times[bee].ends_s;
    bees.push_back(bee);
  }
  if (!any_lasts) return {};
  const std::vector<std::vector<PointId>> groups = recorded_together(std::move(bees), times);
  std::vector<PointId> alone;
  for (const std::vector<PointId>& group : groups) {
    if (group.size() == 1) alone.push_back(group.front());
  }
  if (alone.size() == groups.size()) return {};
  if (recording.called_drones && recording.clock) add_of_other_zone(groups, times, alone);
  std::sort(alone.begin(), alone.end());
  return alone;
}

std::optional<double> alone_begins_s(const io::Recording& recording,
                                     const std::vector<PointId>& alone) {
  std::vector<double> begins_s;
  std::vector<double> others_begin_s;
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const auto ends = ends_of(recording.bees[bee]);
    if (!ends) continue;
    const bool is_alone = std::binary_search(alone.begin(), alone.end(), bee);
    (is_alone ? begins_s : others_begin_s).push_back(ends->first.time_s);
  }
  if (begins_s.empty() || others_begin_s.empty()) return std::nullopt;
  return median_begin_s(std::move(begins_s)) - median_begin_s(std::move(others_begin_s));
}

std::optional<double> zones_apart_s(double apart_s) {
  constexpr double kQuarter_s = 900.0;
  constexpr double kFarthest_s = 14.0 * 3600.0;  // from UTC
  constexpr double kBeginWithin_s = 120.0;  // who flies together is switched on one after the other
  const double whole_s = std::round(apart_s / kQuarter_s) * kQuarter_s;
  const bool is_whole = std::abs(apart_s - whole_s) <= kBeginWithin_s;
  if (!is_whole || whole_s == 0.0 || std::abs(whole_s) > kFarthest_s) return std::nullopt;
  return whole_s;
}

}  // namespace beespace::analysis
