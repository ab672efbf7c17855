// What no search can go below: reading its input and writing its output, in the plainest way.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>
#include <span>

namespace beespace::compare {

// All of these are milliseconds of processor time.

// One pass that reads everything: a scalar sum of all doubles, in order. What it costs depends on
// where the points are: one that comes after a search finds them as the next search would.
double read_pass_ms(std::span<const Point> points);

// The median of many such passes in a row: they find in the caches what those before them read.
double warm_read_floor_ms(std::span<const Point> points);

double copy_floor_ms(std::span<const Point> points);  // memcpy to memory that is there already

// Filling a fresh vector with that many pairs, and giving it back.
double write_pairs_floor_ms(std::uint64_t pairs);

}  // namespace beespace::compare
