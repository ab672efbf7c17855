#include "out_of_core/plan.hpp"

#include "out_of_core/cells.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/pairs.hpp>

#include <algorithm>
#include <string>

namespace beespace::out_of_core {

namespace {

// The working memory of a search in memory, a point, and its answer; where points spread widely
// (docs of find_at_risk).
constexpr std::uint64_t kBytesOfSearch = 124;

// Unused blocks go back to the system beyond this share of what a search takes at most. Cells are
// never quite alike, so that blocks of one seldom fit the next; and each thread has some.
constexpr std::uint64_t kKeptNumerator = 3;
constexpr std::uint64_t kKeptDenominator = 4;

// What the program, its threads and the segments take besides.
constexpr std::uint64_t kShareOfTheRest = 8;

constexpr std::uint64_t kLargestBatch = std::uint64_t{1} << 22U;
constexpr std::uint64_t kLargestSample = std::uint64_t{1} << 20U;
constexpr std::uint64_t kBytesInSample = 48;

}  // namespace

std::optional<Error> too_little_memory(std::uint64_t memory_bytes, unsigned workers) {
  const std::uint64_t least = OutOfCoreOptions::kLeastMemoryBytes * workers;
  if (memory_bytes >= least) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "a search out of core with " + std::to_string(workers) +
                   (workers == 1 ? " thread" : " threads") + " needs " +
                   std::to_string(least >> 20U) + " MiB of memory or more, not " +
                   std::to_string(memory_bytes) + " bytes",
               {}};
}

Result<Plan> plan_for(std::uint64_t memory_bytes, unsigned workers, bool heights) {
  if (auto error = too_little_memory(memory_bytes, workers)) return *std::move(error);
  const std::uint64_t used = memory_bytes - memory_bytes / kShareOfTheRest;
  // Cells are read while the one before is searched, so there are two.
  const std::uint64_t in_cell = 2 * CellPoints::bytes_a_point(heights) + kBytesOfSearch;
  Plan plan;
  plan.cell =
      static_cast<std::size_t>(std::min<std::uint64_t>(used / in_cell, std::uint64_t{1} << 31U));
  plan.kept = plan.cell * kBytesOfSearch * kKeptNumerator / kKeptDenominator;
  // So that a segment is never more than a part of a cell.
  plan.batch =
      static_cast<std::size_t>(std::min({used / (Cells::bytes_a_batch_point(heights) * workers),
                                         kLargestBatch, std::uint64_t{plan.cell} / 4}));
  plan.sample = static_cast<std::size_t>(std::min(used / (2 * kBytesInSample), kLargestSample));
  plan.pairs = static_cast<std::size_t>(used / 8 / sizeof(Pair));
  return plan;
}

}  // namespace beespace::out_of_core
