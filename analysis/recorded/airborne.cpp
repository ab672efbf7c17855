#include "analysis/recorded/airborne.hpp"

#include "analysis/recorded/ends.hpp"
#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/landed_times.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

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
  std::sort(bees.begin(), bees.end(),
            [&times](PointId a, PointId b) { return times[a].begins_s < times[b].begins_s; });
  std::vector<PointId> alone;
  double latest_s = -std::numeric_limits<double>::infinity();  // of those before
  for (std::size_t i = 0; i < bees.size(); ++i) {
    const TimeSpan& time = times[bees[i]];
    const bool meets_next = i + 1 < bees.size() && times[bees[i + 1]].begins_s <= time.ends_s;
    if (latest_s < time.begins_s && !meets_next) alone.push_back(bees[i]);
    latest_s = std::max(latest_s, time.ends_s);
  }
  if (alone.size() == bees.size()) return {};
  std::sort(alone.begin(), alone.end());
  return alone;
}

}  // namespace beespace::analysis
