// Building blocks of missions: places on a jittered grid, and a random order of them.
#pragma once

#include "scenes/random_stream.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::scenes {

// The number of cells along each axis; filled along x first, then y, then z.
struct GridShape {
  std::size_t x = 1;
  std::size_t y = 1;
  std::size_t z = 1;
};

// The first cell, counted from the origin.
struct GridCell {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
};

// The smallest cube with room for so many.
GridShape cube_for(std::size_t count);

// A place in each of the first `count` cells of `spacing_m`: its centre, moved at random by at most
// half of `spacing_m` - `clear_m` along each axis, so that any two stay clear.
std::vector<Point> jittered_grid(std::size_t count, const GridShape& shape, const GridCell& first,
                                 double spacing_m, double clear_m, RandomStream& random);

// A random permutation of 0 ... count - 1.
std::vector<std::size_t> shuffled(std::size_t count, RandomStream& random);

}  // namespace beespace::scenes
