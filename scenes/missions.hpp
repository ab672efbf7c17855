// Generated missions: where everybody starts, and where everybody wants to go.
//
// The same arguments give the same doubles on every machine (where its sine does, for the sphere).
// Units: metres. Starts, and goals, are
// at least `clear_m` apart.
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::scenes {

struct Mission {
  std::vector<Point> starts;
  std::vector<Point> goals;  // of each bee
};

// A cube of bees, one about every `spacing_m` along each axis, who change places at random.
// `spacing_m` is at least `clear_m`.
Mission random_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// Bees all over a sphere, `spacing_m` apart or a little more, who fly to the opposite point: all
// ways lead through the middle. `spacing_m` is at least `clear_m`.
Mission antipodal_swap(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed);

// Two who fly straight at each other, `distance_m` apart: nothing says who shall give way.
Mission head_on(double distance_m);

}  // namespace beespace::scenes
