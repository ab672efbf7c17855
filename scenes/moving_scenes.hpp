// Generated bees that fly: one set of moving scenes for the generate command, tests and benchmarks.
//
// The same arguments give the same doubles on every machine. Values are returned; nothing is kept.
// Units: metres, seconds, metres per second. Each bee is given at time 0, and flies on from there
// in a straight line; recorded_flights.hpp makes tracks of it. Cost: about 100 nanoseconds a bee.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::scenes {

// How fast bees fly: each has a speed of its own, uniform between these, which it keeps.
// 0 <= slowest <= fastest. The length of a velocity may differ from the speed by rounding.
struct Speeds {
  double slowest_mps;
  double fastest_mps;
};

// Uniform in the box from the origin to `size`, in random directions.
std::vector<Mover> random_flight(std::size_t count, const Point& size, const Speeds& speeds,
                                 std::uint64_t seed);

// Two streams through the box from the origin to `size`, at right angles: bees of even number fly
// along x, those of odd number along y, at all heights of the box.
std::vector<Mover> crossing_streams(std::size_t count, const Point& size, const Speeds& speeds,
                                    std::uint64_t seed);

// Bees on a sphere that fly through its centre, which is at (radius, radius, radius), to the
// opposite point. With one speed for all, all are there at the same time.
std::vector<Mover> sphere_swap(std::size_t count, double radius_m, const Speeds& speeds,
                               std::uint64_t seed);

// The time and distance of the closest approach of two.
struct Encounter {
  PointId first;
  PointId second;
  double closest_s;
  double closest_m;
};

// Movers and their encounters: encounters[i] is that of movers 2i and 2i + 1.
struct Encounters {
  std::vector<Mover> movers;
  std::vector<Encounter> encounters;
};

// Pairs that fly straight at each other, and pass each other at the distance `miss_m`: at a place
// that is uniform in the box from the origin to `size`, and a time uniform in [0, within_s]. Pairs
// are independent of each other. The fastest speed is above zero.
Encounters head_on_pairs(std::size_t pairs, const Point& size, const Speeds& speeds, double miss_m,
                         double within_s, std::uint64_t seed);

struct EncounterPlan {
  Speeds speeds;      // the fastest above zero
  double farthest_m;  // each pair passes at a distance that is uniform from 0 to this
  double within_s;    // when it does is uniform from 0 to this
  double clear_m;     // all others are farther away than this, from 0 to within_s
};

// Encounters constructed from the closest approach: its time and distance and both velocities are
// drawn, and the places at time 0 follow. Each pair has a cell of a cubic grid to itself. The
// stated values are exact except for the rounding of the positions, a few ulps of the grid's
// extent.
Encounters known_encounters(std::size_t pairs, const EncounterPlan& plan, std::uint64_t seed);

}  // namespace beespace::scenes
