// Ids in ascending order.
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <vector>

namespace beespace::core {

// Sorts ids with the help of as many spare places; returns which of the two holds the result. Cost:
// a few nanoseconds an id, however many.
PointId* sort_ids(PointId* ids, PointId* spare, std::size_t count);

// Sorts the first `count` of the ids and cuts off the others. Needs up to 2 * count places, and
// makes them where there are fewer. Cost: a few nanoseconds an id, however many.
void sort_ids(std::vector<PointId>& ids, std::size_t count);

}  // namespace beespace::core
