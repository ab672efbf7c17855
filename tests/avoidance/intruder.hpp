// Intruders that fly straight on, whatever the bees do.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <vector>

namespace beespace::test {

inline Point moved(const Point& p, const Velocity& v, double by) {
  return {p.x + v.x * by, p.y + v.y * by, p.z + v.z * by};
}

inline void fly_on(std::vector<Mover>& intruders, double step_s) {
  for (Mover& intruder : intruders) {
    intruder.position = moved(intruder.position, intruder.velocity, step_s);
  }
}

}  // namespace beespace::test
