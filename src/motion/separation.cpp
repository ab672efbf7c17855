#include "motion/separation.hpp"

#include "motion/encounter.hpp"

#include <algorithm>

namespace beespace::motion {

namespace {

template <class Number>
Passage<Number> passage_of(const Mover& a, const Mover& b, double threshold, double horizon_s) {
  const auto difference = [](double from, double to) { return Number(to) - Number(from); };
  return {{difference(a.position.x, b.position.x), difference(a.position.y, b.position.y),
           difference(a.position.z, b.position.z)},
          {difference(a.velocity.x, b.velocity.x), difference(a.velocity.y, b.velocity.y),
           difference(a.velocity.z, b.velocity.z)},
          Number(threshold),
          {Number(horizon_s), Number(1.0)}};
}

template <class Number>
std::optional<bool> decide(const Mover& a, const Mover& b, const Separation& separation,
                           double horizon_s) {
  Passage<Number> passage = passage_of<Number>(a, b, separation.threshold_m, horizon_s);
  if (!separation.vertical_m) return comes_close(passage, separation.inclusive);
  const HeightPassage<Number> height{passage.r[2], passage.w[2], Number(*separation.vertical_m)};
  passage.r[2] = Number(0.0);
  passage.w[2] = Number(0.0);
  return comes_close(passage, height, separation.inclusive);
}

TimeSpan conflict_span(const RelativeMotion<3>& motion, const Separation& separation,
                       double horizon_s) {
  if (!separation.vertical_m) return time_closer(motion, separation.threshold_m, horizon_s);
  RelativeMotion<3> level = motion;
  level.r[2] = 0.0;
  level.w[2] = 0.0;
  const TimeSpan near = time_closer(level, separation.threshold_m, horizon_s);
  const TimeSpan in_height = time_closer(RelativeMotion<1>{{motion.r[2]}, {motion.w[2]}},
                                         *separation.vertical_m, horizon_s);
  const double begins = std::max(near.begins_s, in_height.begins_s);
  return {begins, std::max(begins, std::min(near.ends_s, in_height.ends_s))};
}

}  // namespace

bool in_conflict(const Mover& a, const Mover& b, const Separation& separation, double horizon_s) {
  if (const auto sure = decide<BoundedNumber>(a, b, separation, horizon_s)) return *sure;
  return *decide<ExactNumber>(a, b, separation, horizon_s);
}

RelativeMotion<3> relative_motion(const Mover& a, const Mover& b) {
  return {{b.position.x - a.position.x, b.position.y - a.position.y, b.position.z - a.position.z},
          {b.velocity.x - a.velocity.x, b.velocity.y - a.velocity.y, b.velocity.z - a.velocity.z}};
}

ConflictReport report_conflict(const RelativeMotion<3>& motion, const Separation& separation,
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
