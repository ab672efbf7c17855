// Where a recording is cut in time, so that each window fits into the memory.
#pragma once

#include "out_of_core/recorded/stored_fixes.hpp"
#include "out_of_core/recorded/time_cells.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace beespace::out_of_core {

struct TimeCut {
  TimeBorders borders;            // between the windows
  std::vector<WindowSize> sizes;  // of each window

  [[nodiscard]] WindowSize largest(const WindowCost& cost) const;
};

struct CutRules {
  double max_gap_s;
  WindowCost cost;
  std::uint64_t limit;  // of the cost of a window
};

// Called with each fix that was looked at; false ends it.
using FixWatcher = std::function<bool()>;

// Counts exactly what each window has; windows are as few as borders allow, which are times of
// fixes. What is in a window that costs more than the limit cannot be cut further, or hardly. Reads
// all fixes, and in rare cases several times. Errors: those of reading; kStopped where the watcher
// ends it.
Result<TimeCut> find_cut(const StoredFixes& fixes, const CutRules& rules, RepeatedFixes& repeated,
                         const FixWatcher& watch);

}  // namespace beespace::out_of_core
