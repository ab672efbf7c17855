#include "scenes/moving_scenes.hpp"

#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"

#include <cmath>

namespace beespace::scenes {
namespace {

Point random_place(const Point& size, RandomStream& random) {
  const double x = size.x * random.uniform();
  const double y = size.y * random.uniform();
  const double z = size.z * random.uniform();
  return {x, y, z};
}

Point scaled(const Point& p, double factor) {
  return {p.x * factor, p.y * factor, p.z * factor};
}

Point apart_of(const Velocity& first, const Velocity& second) {
  return {second.x - first.x, second.y - first.y, second.z - first.z};
}

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Of length 1, in any of the directions at right angles to `axis`, which is not zero.
Point random_normal(const Point& axis, RandomStream& random) {
  // A direction nearly along the axis leaves almost only rounding errors.
  constexpr double kLeast = 0x1p-4;
  const double axis_length = std::sqrt(dot(axis, axis));
  const Point unit{axis.x / axis_length, axis.y / axis_length, axis.z / axis_length};
  while (true) {
    const Point other = random_direction(random);
    const Point normal{unit.y * other.z - unit.z * other.y, unit.z * other.x - unit.x * other.z,
                       unit.x * other.y - unit.y * other.x};
    const double length = std::sqrt(dot(normal, normal));
    if (length < kLeast) continue;
    return {normal.x / length, normal.y / length, normal.z / length};
  }
}

// The closest approach of two: their motion, the place and the time.
struct Pass {
  Point place;
  Point aside;  // from the first to the second
  double time_s;
  Velocity first;
  Velocity second;
};

// A bee that is `share` of `aside` from the place when they pass, at time 0.
Mover mover_before(const Pass& pass, double share, const Velocity& v) {
  const Point& p = pass.place;
  const Point& aside = pass.aside;
  return {{p.x + share * aside.x - v.x * pass.time_s, p.y + share * aside.y - v.y * pass.time_s,
           p.z + share * aside.z - v.z * pass.time_s},
          v};
}

void append(Encounters& scene, const Pass& pass, double closest_m) {
  const auto first = static_cast<PointId>(scene.movers.size());
  scene.encounters.push_back({first, first + 1, pass.time_s, closest_m});
  scene.movers.push_back(mover_before(pass, -0.5, pass.first));
  scene.movers.push_back(mover_before(pass, 0.5, pass.second));
}

// Velocities of a pair that are clearly different: if the pair hardly moved apart, the time of its
// closest approach would be left to rounding errors.
void draw_velocities(Pass& pass, const Speeds& speeds, RandomStream& random) {
  const double least_mps = 0.25 * speeds.fastest_mps;
  while (true) {
    pass.first = random_velocity(speeds, random);
    pass.second = random_velocity(speeds, random);
    const Point apart = apart_of(pass.first, pass.second);
    if (dot(apart, apart) >= least_mps * least_mps) return;
  }
}

}  // namespace

std::vector<Mover> random_flight(std::size_t count, const Point& size, const Speeds& speeds,
                                 std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Mover> movers(count);
  for (Mover& mover : movers) {
    mover.position = random_place(size, random);
    mover.velocity = random_velocity(speeds, random);
  }
  return movers;
}

std::vector<Mover> crossing_streams(std::size_t count, const Point& size, const Speeds& speeds,
                                    std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Mover> movers(count);
  for (std::size_t i = 0; i < count; ++i) {
    movers[i].position = random_place(size, random);
    const double speed_mps = random_speed(speeds, random);
    movers[i].velocity = i % 2 == 0 ? Velocity{speed_mps, 0.0, 0.0} : Velocity{0.0, speed_mps, 0.0};
  }
  return movers;
}

std::vector<Mover> sphere_swap(std::size_t count, double radius_m, const Speeds& speeds,
                               std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Mover> movers(count);
  for (Mover& mover : movers) {
    const Point outwards = random_direction(random);
    mover.position = {radius_m + radius_m * outwards.x, radius_m + radius_m * outwards.y,
                      radius_m + radius_m * outwards.z};
    mover.velocity = along(outwards, -random_speed(speeds, random));
  }
  return movers;
}

Encounters head_on_pairs(std::size_t pairs, const Point& size, const Speeds& speeds, double miss_m,
                         double within_s, std::uint64_t seed) {
  RandomStream random(seed);
  Encounters scene;
  scene.movers.reserve(2 * pairs);
  scene.encounters.reserve(pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    Pass pass{};
    pass.place = random_place(size, random);
    pass.time_s = random.uniform(0.0, within_s);
    const Point direction = random_direction(random);
    pass.first = along(direction, random_speed(speeds, random));
    pass.second = along(direction, -random_speed(speeds, random));
    pass.aside = scaled(random_normal(direction, random), miss_m);
    append(scene, pass, miss_m);
  }
  return scene;
}

Encounters known_encounters(std::size_t pairs, const EncounterPlan& plan, std::uint64_t seed) {
  RandomStream random(seed);
  // Until within_s no mover is farther from the centre of its cell than this, on any axis.
  const double reach_m = plan.speeds.fastest_mps * plan.within_s + 0.5 * plan.farthest_m;
  // A little more than the reach, so that rounding does not use up the room between cells.
  const double cell_m = 2.125 * reach_m + 1.125 * plan.clear_m;
  std::size_t cells_in_a_row = 1;
  while (cells_in_a_row * cells_in_a_row * cells_in_a_row < pairs) ++cells_in_a_row;
  const auto middle_of = [cell_m](std::size_t cell) {
    return cell_m * (static_cast<double>(cell) + 0.5);
  };
  Encounters scene;
  scene.movers.reserve(2 * pairs);
  scene.encounters.reserve(pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    Pass pass{};
    pass.place = {middle_of(i % cells_in_a_row), middle_of(i / cells_in_a_row % cells_in_a_row),
                  middle_of(i / cells_in_a_row / cells_in_a_row)};
    pass.time_s = random.uniform(0.0, plan.within_s);
    draw_velocities(pass, plan.speeds, random);
    const double closest_m = random.uniform(0.0, plan.farthest_m);
    pass.aside = scaled(random_normal(apart_of(pass.first, pass.second), random), closest_m);
    append(scene, pass, closest_m);
  }
  return scene;
}

}  // namespace beespace::scenes
