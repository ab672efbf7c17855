#include "scenes/missions.hpp"

#include "scenes/jittered_grid.hpp"
#include "scenes/random_stream.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::scenes {

Mission random_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed) {
  RandomStream random(seed);
  Mission mission;
  mission.starts = jittered_grid(count, cube_for(count), {}, spacing_m, clear_m, random);
  for (const std::size_t other : shuffled(count, random)) {
    mission.goals.push_back(mission.starts[other]);
  }
  return mission;
}

Mission antipodal_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed) {
  RandomStream random(seed);
  // Turns of the golden angle, from pole to pole (a Fibonacci lattice): points on a unit sphere are
  // at least 2.68 / sqrt(count) apart, two of them; many, 3.09.
  constexpr double kGoldenAngle = 2.399963229728653;
  constexpr double kApart = 2.68;
  const double bees = static_cast<double>(count);
  const double radius_m = std::max(spacing_m, clear_m) * std::sqrt(bees) / kApart;
  const double turn = random.uniform(0.0, 6.283185307179586);
  Mission mission;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / bees;
    const double around = std::sqrt(1.0 - z * z);
    const double angle = turn + kGoldenAngle * static_cast<double>(i);
    const Point p{radius_m * around * std::cos(angle), radius_m * around * std::sin(angle),
                  radius_m * z};
    mission.starts.push_back(p);
    mission.goals.push_back({-p.x, -p.y, -p.z});
  }
  return mission;
}

Mission head_on(double distance_m) {
  return {{{0.0, 0.0, 0.0}, {distance_m, 0.0, 0.0}}, {{distance_m, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
}

}  // namespace beespace::scenes
