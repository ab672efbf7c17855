// What the memory of a search in a recording is used for.
#pragma once

#include "out_of_core/recorded/time_cells.hpp"
#include "out_of_core/sorted_rows.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>

namespace beespace::out_of_core {

struct RecordingPlan {
  SortMemory fixes;           // while fixes come, and while they are read in order
  std::size_t waiting = 0;    // bytes of what waits to be written to windows
  WindowCost cost;            // of what a window has
  std::uint64_t window = 0;   // the most that a window may cost
  std::uint64_t cut_for = 0;  // windows are made to cost at most this: the same, but in tests
  SortMemory conflicts;
  std::size_t intervals = 0;  // of an agent, in memory
};

// Errors: kInvalidArgument where the memory is too little for so many workers.
Result<RecordingPlan> recording_plan_for(std::uint64_t memory_bytes, unsigned workers);

// How much memory a window of that cost takes.
std::uint64_t memory_for(std::uint64_t cost);

}  // namespace beespace::out_of_core
