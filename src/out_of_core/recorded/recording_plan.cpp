#include "out_of_core/recorded/recording_plan.hpp"

#include "out_of_core/plan.hpp"

namespace beespace::out_of_core {

namespace {

// A fix of a window in memory, and its height.
constexpr std::uint64_t kBytesOfFix = 40;
// A segment, its agent, and what the search in memory needs for it in a step of time, with those
// that are near.
constexpr std::uint64_t kBytesOfSegment = 600;

// Sixteenths of the memory.
constexpr std::uint64_t kWindow = 13;
constexpr std::uint64_t kConflicts = 2;

}  // namespace

Result<RecordingPlan> recording_plan_for(std::uint64_t memory_bytes, unsigned workers) {
  if (auto error = too_little_memory(memory_bytes, workers)) return *std::move(error);
  const std::uint64_t part = memory_bytes / 16;
  const auto parts = [part](std::uint64_t count) { return static_cast<std::size_t>(count * part); };
  RecordingPlan plan{};
  plan.fixes = {parts(13), parts(4)};
  plan.waiting = parts(6);
  plan.cost = {kBytesOfFix, kBytesOfSegment};
  plan.window = kWindow * part;
  plan.cut_for = plan.window;
  plan.conflicts = {parts(kConflicts), parts(4)};
  plan.intervals = parts(4) / sizeof(double);
  return plan;
}

std::uint64_t memory_for(std::uint64_t cost) {
  return cost / kWindow * 16 + 16;
}

}  // namespace beespace::out_of_core
