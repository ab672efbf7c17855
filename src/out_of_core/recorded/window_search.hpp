// A recording is searched, one window of time after the other.
#pragma once

#include "out_of_core/recorded/recording_plan.hpp"
#include "out_of_core/recorded/stored_fixes.hpp"

#include <beespace/crew.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/result.hpp>

#include <functional>
#include <stop_token>
#include <string>

namespace beespace::out_of_core {

// What a search works with.
struct RecordingWorkplace {
  RecordingPlan plan;
  const std::string& folder;
  Crew& crew;
  const std::stop_token& stop;
  const std::function<void(const OutOfCoreProgress&)>& progress;
};

// The fixes are settled, the options valid. Errors: as RecordingOutOfCore::find_conflicts.
Status search_windows(const StoredFixes& fixes, const ConflictOptions& options,
                      bool repeats_allowed, const RecordingWorkplace& at,
                      const LargeConflictVisitor& conflicts, const LargeGapVisitor& gaps,
                      RecordingOutOfCoreFacts& facts);

}  // namespace beespace::out_of_core
