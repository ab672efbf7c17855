// Flies the loop that keeps an agent near its nominal path, physically, in long double: what
// carries it off acts in between, measurements are late, own corrections since are known. Only the
// law of correction is that of the library; no formula of its bounds is used.
#pragma once

#include "fleet/correction_loop.hpp"

#include <beespace/fleet.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace beespace::test {

struct Long3 {
  long double x = 0.0L;
  long double y = 0.0L;
  long double z = 0.0L;
};
inline Long3 operator+(const Long3& a, const Long3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Long3 operator-(const Long3& a, const Long3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Long3 operator*(const Long3& a, long double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline long double length_of(const Long3& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

// Each period of the loop is flown in so many parts; delays are whole parts.
inline constexpr std::size_t kParts = 10;

// What the loop of some figures is, in periods and parts.
struct LoopCase {
  FleetFigures figures;
  LinkFigures link;
  FlightLimits limits{10.0, 5.0};
  double period_s = 0.0;
  double measured_error_m = 0.0;
  std::size_t delay_parts = 0;
};

// What happened: deviations at each part, velocities of the correction at each period, and
// accelerations within it.
struct Flown {
  std::vector<Long3> deviations;
  std::vector<Long3> velocities;
  std::vector<Long3> accelerations;
};

// `gusts`: a velocity for each part; `errors`: one for each measurement.
inline Flown fly(const LoopCase& loop_case, const Tube& tube, const std::vector<Long3>& gusts,
                 const std::vector<Long3>& errors) {
  const fleet::CorrectionLoop loop(tube, loop_case.figures, loop_case.period_s);
  const long double part_s = static_cast<long double>(loop_case.period_s) / kParts;
  Flown flown;
  std::vector<Long3> ways;  // that the corrections have led
  Long3 deviation;
  Long3 velocity;
  Long3 way;
  for (std::size_t period = 0; period * kParts < gusts.size(); ++period) {
    const std::size_t now = period * kParts;
    flown.deviations.resize(now);  // the last of a period is the first of the next
    ways.resize(now);
    flown.deviations.push_back(deviation);
    ways.push_back(way);
    const bool before = now < loop_case.delay_parts;
    const std::size_t at = before ? 0 : now - loop_case.delay_parts;
    const Long3 known = flown.deviations[at] + errors[period] + way - ways[at];
    const core::Vector3 next = loop.next(
        {static_cast<double>(known.x), static_cast<double>(known.y), static_cast<double>(known.z)},
        {static_cast<double>(velocity.x), static_cast<double>(velocity.y),
         static_cast<double>(velocity.z)});
    const Long3 acceleration = (Long3{next.x, next.y, next.z} - velocity) *
                               (1.0L / static_cast<long double>(loop_case.period_s));
    flown.velocities.push_back(velocity);
    flown.accelerations.push_back(acceleration);
    for (std::size_t part = 0; part < kParts; ++part) {
      const Long3 moved = velocity * part_s + acceleration * (0.5L * part_s * part_s);
      way = way + moved;
      deviation = deviation + moved + gusts[now + part] * part_s;
      velocity = velocity + acceleration * part_s;
      flown.deviations.push_back(deviation);
      ways.push_back(way);
    }
    velocity = {next.x, next.y, next.z};
  }
  return flown;
}

}  // namespace beespace::test
