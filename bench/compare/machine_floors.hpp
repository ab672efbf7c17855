// What no search can go below: reading its input and writing its output, in the plainest way.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>
#include <span>

namespace beespace::compare {

// Milliseconds of processor time, medians of many runs.
double read_floor_ms(std::span<const Point> points);  // a scalar sum of all doubles, in order
double copy_floor_ms(std::span<const Point> points);  // memcpy to memory that is there already

// Filling a fresh vector with that many pairs, and giving it back.
double write_pairs_floor_ms(std::uint64_t pairs);

}  // namespace beespace::compare
