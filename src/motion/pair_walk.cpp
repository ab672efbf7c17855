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
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y),
                   std::abs(q.z)});
}

// For nearly all windows, faster than the exact decision: what was rounded is a few units in the
// last place of the coordinates.
bool surely_apart(const Piece& first, const Piece& second, const RelativeMotion<3>& motion,
                  double lasts, double reach_m) {
  const double blur_m = 0x1p-44 * std::max(largest_coordinate(first), largest_coordinate(second));
  return closest_within(motion, {0.0, lasts}).distance_m > reach_m * (1.0 + 0x1p-40) + blur_m;
}

double sum_rounded_up(double a, double b) {
  const double sum = a + b;
  return sum == 0.0 ? 0.0 : std::nextafter(sum, std::numeric_limits<double>::infinity());
}

}  // namespace

PairWalk::PairWalk(const Run& first, const Run& second, const Separation& separation)
    : first_(first),
      second_(second),
      possible_(changed(separation, sum_rounded_up(first.tolerance_m, second.tolerance_m))),
      certain_(changed(separation, -sum_rounded_up(first.tolerance_m, second.tolerance_m))),
      reach_m_(std::hypot(possible_.threshold_m, possible_.vertical_m.value_or(0.0))),
      exact_(first.tolerance_m == 0.0 && second.tolerance_m == 0.0) {
}

void PairWalk::walk(const TimeSpan& time, State& state, std::vector<Conflict>& ended) const {
  while (state.first_piece < first_.pieces() && state.second_piece < second_.pieces()) {
    const Piece first = piece_of(first_, state.first_piece);
    const Piece second = piece_of(second_, state.second_piece);
    const TimeSpan window{std::max(first.from.time_s, second.from.time_s),
                          std::min(first.to.time_s, second.to.time_s)};
    if (window.begins_s > time.ends_s) return;
    if (window.begins_s <= window.ends_s && window.ends_s >= time.begins_s) {
      walk_window(first, second, window, state, ended);
    }
    if (first.to.time_s <= window.ends_s) ++state.first_piece;
    if (second.to.time_s <= window.ends_s) ++state.second_piece;
  }
  if (state.open) ended.push_back(*std::exchange(state.open, std::nullopt));
}

void PairWalk::walk_window(const Piece& first, const Piece& second, const TimeSpan& window,
                           State& state, std::vector<Conflict>& ended) const {
  state.walked_until = window.ends_s;
  const double lasts = window.ends_s - window.begins_s;
  const RelativeMotion<3> motion = relative_motion(first, second, window.begins_s);
  if (surely_apart(first, second, motion, lasts, reach_m_)) return;
  if (!in_conflict(first, second, window, possible_)) return;
  const ConflictReport report = report_conflict(motion, possible_, lasts);
  const auto clock = [&](double since) { return std::min(window.begins_s + since, window.ends_s); };
  const double begins_s = clock(report.span.begins_s);
  const double closest_s = clock(report.closest_s);
  if (!state.open) {
    state.open = Conflict{first_.track, second_.track, begins_s, closest_s, 0.0, report.closest_m,
                          exact_};
  } else if (report.closest_m < state.open->closest_m) {
    state.open->closest_s = closest_s;
    state.open->closest_m = report.closest_m;
  }
  Conflict& open = *state.open;
  if (!open.certain) open.certain = in_conflict(first, second, window, certain_);
  const TimeSpan last{window.ends_s, window.ends_s};
  const bool goes_on = in_conflict(first, second, last, possible_);
  open.ends_s = goes_on ? window.ends_s : clock(report.span.ends_s);
  if (!goes_on) ended.push_back(*std::exchange(state.open, std::nullopt));
}

}  // namespace beespace::motion
