// Ids that two bees or more seem to share: their fixes are those of both in turn, and straight
// lines from one to the other are flown by none. A conflict on such a line is possible, not
// certain.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>

#include <cstddef>
#include <vector>

namespace beespace::analysis {

bool is_of_shared_id(const Conflict& conflict, const io::Recording& recording);

// Makes those conflicts possible ones.
void doubt_shared_ids(const io::Recording& recording, std::vector<Conflict>& conflicts);

// How many there are.
std::size_t count_of_shared_ids(const std::vector<Conflict>& conflicts,
                                const io::Recording& recording);

}  // namespace beespace::analysis
