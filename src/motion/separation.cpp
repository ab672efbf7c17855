#include "motion/separation.hpp"

#include "motion/encounter.hpp"

#include <algorithm>

namespace beespace::motion {

namespace {

template <class Number>
std::optional<bool> decide(const State& a, const State& b, const Separation& separation,
                           double horizon_s) {
  std::array<Number, 4> r;
  std::array<Number, 4> w;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    r[axis] = Number(b.position[axis]) - Number(a.position[axis]);
    w[axis] = Number(b.velocity[axis]) - Number(a.velocity[axis]);
  }
  return comes_close<Number>(r, w, Number(1.0), {Number(horizon_s), Number(1.0)}, separation);
}

TimeSpan conflict_span(const RelativeMotion<4>& motion, const Separation& separation,
                       double horizon_s) {
  if (!separation.vertical_m) return time_closer(motion, separation.threshold_m, horizon_s);
  RelativeMotion<4> level = motion;
  const std::size_t up = separation.vertical_axis();
  level.r[up] = 0.0;
  level.w[up] = 0.0;
  const TimeSpan near = time_closer(level, separation.threshold_m, horizon_s);
  const TimeSpan in_height = time_closer(RelativeMotion<1>{{motion.r[up]}, {motion.w[up]}},
                                         *separation.vertical_m, horizon_s);
  const double begins = std::max(near.begins_s, in_height.begins_s);
  const double ends = std::min(near.ends_s, in_height.ends_s);
  if (begins <= ends) return {begins, ends};
  // Rounding has split an instant. Where the horizontal threshold is only just grazed, a last bit
  // of it is half the digits of the time; where heights hardly change, a last bit of the height
  // threshold is. So it is the one at which the two exceed the threshold least.
  const auto excess = [&](double time) {
    const double apart = closest_within(level, {time, time}).distance_m;
    const double height = std::abs(motion.r[up] + motion.w[up] * time);
    return std::max(apart - separation.threshold_m, height - *separation.vertical_m);
  };
  const double of_heights = std::clamp(near.begins_s, in_height.begins_s, in_height.ends_s);
  const double of_level = std::clamp(in_height.begins_s, near.begins_s, near.ends_s);
  const double instant = excess(of_heights) < excess(of_level) ? of_heights : of_level;
  return {instant, instant};
}

}  // namespace

bool in_conflict(const State& a, const State& b, const Separation& separation, double horizon_s) {
  if (const auto sure = decide<BoundedNumber>(a, b, separation, horizon_s)) return *sure;
  return *decide<ExactNumber>(a, b, separation, horizon_s);
}

RelativeMotion<4> relative_motion(const State& a, const State& b) {
  RelativeMotion<4> motion;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    motion.r[axis] = b.position[axis] - a.position[axis];
    motion.w[axis] = b.velocity[axis] - a.velocity[axis];
  }
  return motion;
}

RelativeMotion<4> in_metres(RelativeMotion<4> motion, const Separation& separation) {
  motion.r[3] *= separation.height_unit_m;
  motion.w[3] *= separation.height_unit_m;
  return motion;
}

namespace {

ConflictReport report_of(const TimeSpan& span, const Nearness& nearest) {
  // The closest instant is one of conflict, whatever the rounding of the ends.
  return {{std::min(span.begins_s, nearest.time_s), std::max(span.ends_s, nearest.time_s)},
          nearest.time_s,
          nearest.distance_m};
}

}  // namespace

ConflictReport report_conflict(const RelativeMotion<4>& motion, const Separation& separation,
                               double horizon_s) {
  const TimeSpan span = conflict_span(motion, separation, horizon_s);
  const TimeSpan whole{0.0, horizon_s};
  return report_of(
      span, closest_within(in_metres(motion, separation), separation.vertical_m ? span : whole));
}

}  // namespace beespace::motion
