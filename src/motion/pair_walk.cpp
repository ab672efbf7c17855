#include "motion/pair_walk.hpp"

#include "motion/piece_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::motion {

namespace {

// Widened by a tolerance, or narrowed by it, and rounded to the safe side.
Separation changed(const Separation& separation, double by_m) {
  if (by_m == 0.0) return separation;
  const double towards = by_m > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
  Separation other = separation;
  other.threshold_m = std::nextafter(separation.threshold_m + by_m, towards);
  if (separation.vertical_m) {
    other.vertical_m = std::nextafter(*separation.vertical_m + by_m, towards);
  }
  return other;
}

double largest_coordinate(const Piece& piece) {
  const Point& p = piece.from.position;
  const Point& q = piece.to.position;
  return std::max(
      {std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
}

// For nearly all windows, faster than the exact decision: what was rounded is a few units in the
// last place of the coordinates. Heights that are apart only make distances longer than those of
// positions, which the reach is about.
bool surely_apart(const Piece& first, const Piece& second, RelativeMotion<4> motion, double lasts,
                  double reach_m) {
  motion.r[3] = motion.w[3] = 0.0;
  const double blur_m = 0x1p-44 * std::max(largest_coordinate(first), largest_coordinate(second));
  return closest_within(motion, {0.0, lasts}).distance_m > reach_m * (1.0 + 0x1p-40) + blur_m;
}

double sum_rounded_up(double a, double b) {
  const double sum = a + b;
  return sum == 0.0 ? 0.0 : std::nextafter(sum, std::numeric_limits<double>::infinity());
}

}  // namespace

WalkSeparation WalkSeparation::within(const Separation& separation, const TrackSegment& first,
                                      const TrackSegment& second) {
  const double tolerance_m = sum_rounded_up(first.tolerance_m, second.tolerance_m);
  if (tolerance_m == 0.0) return {separation, separation, true};
  return {changed(separation, tolerance_m), changed(separation, -tolerance_m), false};
}

std::optional<PairWalk::Stretch> PairWalk::walk_window(const Piece& first, const Piece& second,
                                                       const TimeSpan& window, State& state) const {
  state.walked_until = window.ends_s;
  const Separation& outer = separation_.outer;
  const double lasts = window.ends_s - window.begins_s;
  const RelativeMotion<4> motion = relative_motion(first, second, window.begins_s);
  if (surely_apart(first, second, motion, lasts, reach_m_)) return std::nullopt;
  if (!in_conflict(first, second, window, outer)) return std::nullopt;
  const ConflictReport report = report_conflict(motion, outer, lasts);
  const auto clock = [&](double since) { return std::min(window.begins_s + since, window.ends_s); };
  const auto distance = [&](double since) {
    return closest_within(in_metres(motion, outer), {since, since}).distance_m;
  };
  if (!state.open) {
    state.open.emplace();
    state.open->conflict = {
        first_.track,     second_.track, clock(report.span.begins_s), clock(report.closest_s), 0.0,
        report.closest_m, false};
  }
  Stretch& open = *state.open;
  if (report.closest_m < open.conflict.closest_m) {
    open.conflict.closest_s = clock(report.closest_s);
    open.conflict.closest_m = report.closest_m;
  }
  if (!open.conflict.certain &&
      (separation_.same || in_conflict(first, second, window, separation_.inner))) {
    const double since = report_conflict(motion, separation_.inner, lasts).span.begins_s;
    open.conflict.certain = true;
    open.certain_s = clock(since);
    open.certain_m = distance(since);
  }
  const bool goes_on = in_conflict(first, second, {window.ends_s, window.ends_s}, outer);
  const double end = goes_on ? lasts : report.span.ends_s;
  open.conflict.ends_s = goes_on ? window.ends_s : clock(end);
  open.end_m = distance(end);
  return goes_on ? std::nullopt : std::exchange(state.open, std::nullopt);
}

}  // namespace beespace::motion
