// What the memory of a search is used for.
#pragma once

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace beespace::out_of_core {

struct Plan {
  std::size_t batch = 0;   // points that are distributed at a time, by each worker
  std::size_t cell = 0;    // points of a cell with its halo that are searched at a time
  std::size_t sample = 0;  // points that say where to cut
  std::size_t kept = 0;    // bytes of working memory that are kept from one cell to the next
  std::size_t pairs = 0;   // pairs that are found at a time between two pieces of a crowded cell
};

// What is wrong where the memory is too little for so many workers.
std::optional<Error> too_little_memory(std::uint64_t memory_bytes, unsigned workers);

// For points with heights apart from their positions, or without. Errors: kInvalidArgument where
// the memory is too little for so many workers.
Result<Plan> plan_for(std::uint64_t memory_bytes, unsigned workers, bool heights);

}  // namespace beespace::out_of_core
