// How long things take: the middle one of several runs.
#pragma once

#include <beespace/point.hpp>

#include <functional>
#include <vector>

namespace beespace::cli {

// Seconds of wall time: the median of at least three runs after one to warm up, and of more as long
// as they are short.
double median_seconds(const std::function<void()>& run);

// The floor that everything is compared with: reading all coordinates in order, which is summing
// them one after the other.
double read_floor_seconds(const std::vector<Point>& points);

}  // namespace beespace::cli
