// Conflicts with an id that two bees seem to have: the line from one of them to the other is flown
// by neither, so that such conflicts are possible, not certain.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <vector>

namespace beespace::analysis {

// Of the first few such ids, which are named.
bool is_shared(const io::Recording& recording, PointId bee);
bool is_with_shared_id(const io::Recording& recording, const Conflict& conflict);

std::size_t count_with_shared_id(const io::Recording& recording,
                                 const std::vector<Conflict>& conflicts);

// These are not certain.
void doubt_with_shared_id(const io::Recording& recording, std::vector<Conflict>& conflicts);

}  // namespace beespace::analysis
