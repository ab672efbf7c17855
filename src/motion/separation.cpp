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
  return {begins, std::max(begins, std::min(near.ends_s, in_height.ends_s))};
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

ConflictReport report_conflict(const RelativeMotion<4>& motion, const Separation& separation,
                               double horizon_s) {
  TimeSpan span = conflict_span(motion, separation, horizon_s);
  const bool sphere = !separation.vertical_m;
  const Nearness nearest =
      closest_within(motion, sphere ? TimeSpan{0.0, horizon_s} : span);
  // The closest instant is one of conflict, whatever rounding has made of the ends.
  span.begins_s = std::min(span.begins_s, nearest.time_s);
  span.ends_s = std::max(span.ends_s, nearest.time_s);
  return {span, nearest.time_s, nearest.distance_m};
}

}  // namespace beespace::motion
