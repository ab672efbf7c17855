// Ids in ascending order.
#pragma once

#include <beespace/point.hpp>

#include <vector>

namespace beespace::core {

// Sorts the first `count` of the ids and cuts off the others. Needs up to 2 * count places, and
// makes them where there are fewer. Cost: a few nanoseconds an id, however many.
void sort_ids(std::vector<PointId>& ids, std::size_t count);

}  // namespace beespace::core
