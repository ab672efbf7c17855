// Lower limits of any search: reading its input and writing its output, in the simplest way.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>
#include <span>

namespace beespace::compare {

// All of these are milliseconds of processor time.

// One pass that reads everything: a scalar sum of all doubles, in order. Its cost depends on where
// the points are: after a search it finds them as the next search would.
double read_pass_ms(std::span<const Point> points);

// The median of many such passes in a row: each finds in the caches what the one before it read.
double warm_read_floor_ms(std::span<const Point> points);

double copy_floor_ms(std::span<const Point> points);  // memcpy to memory that is there already

// Filling a fresh vector with that many pairs, and giving it back.
double write_pairs_floor_ms(std::uint64_t pairs);

}  // namespace beespace::compare
