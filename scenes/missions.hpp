// Generated missions: the starts and the goals of all bees.
//
// The same arguments give the same doubles on every machine (where its sine does, for the sphere).
// Units: metres; z is up. Starts, and goals, are at least `clear_m` apart, and farther from
// obstacles than that. `spacing_m` is at least `clear_m`.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::scenes {

struct Mission {
  std::vector<Point> starts;
  std::vector<Point> goals;  // of each bee
  // Of each bee; empty where all are the same, and not known here.
  std::vector<FlightLimits> limits = {};
  std::vector<Obstacle> obstacles = {};
};

// A cube of bees, one about every `spacing_m` along each axis; the goals are the starts in random
// order.
Mission random_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// Bees all over a sphere, `spacing_m` apart or a little more, that fly to the opposite point: all
// ways lead through the centre.
Mission antipodal_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// Two bees that fly straight at each other, `distance_m` apart: the problem is symmetric.
Mission head_on(double distance_m);

// Two streams that cross at right angles: the first half of the bees is a cube that flies east
// (along x), the other half, of the same size, flies north (along y), and both get to the crossing
// at the same time. Each bee keeps its place among those it flies with.
Mission crossing_streams(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// A wide field of bees, two layers of them, that all fly into a column at least five times
// narrower. The bee that is nearest to it flies in the farthest, so that bees that have arrived do
// not block others. In the column they stop closer together, but at least 1.5 times `clear_m` apart
// where `spacing_m` is.
Mission funnel(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// A cube of bees that fly through a forest of pillars, which have no top and leave gaps of at least
// three times `spacing_m`, to places on the other side, in another order; there is a ground below.
Mission pillars(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

}  // namespace beespace::scenes
