// Answers a query on whole grids: runs the kernels over all rows, with all threads.
#pragma once

#include "base/resources.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/point.hpp>

#include <cstdint>

namespace beespace::cpu {

// Writes to at_risk[id] of every asked point 1 if it is near another one, else 0. Working memory: 1
// byte a point and worker's reach.
void mark_all(const SweepQuery& question, const core::Resources& with, std::uint8_t* at_risk);

// Writes how many others are near to counts[id] of every asked point. Working memory: 4 bytes a
// point and worker's reach.
void count_all(const SweepQuery& question, const core::Resources& with, std::uint32_t* counts);

}  // namespace beespace::cpu
