// While a drone says that it has landed it stands on the ground. It is compared with those that
// fly, as others may come close to it; two that both stand are no conflict.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <vector>

namespace beespace::analysis {

// Whether this bee surely stands on the ground then, by its own records.
bool has_landed(const io::Recording& recording, PointId track, double time_s);

// Takes out the conflicts of two that both stand as long as it lasts; returns how many.
std::size_t leave_out_standing(const io::Recording& recording, std::vector<Conflict>& conflicts);

}  // namespace beespace::analysis
