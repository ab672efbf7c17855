// The search behind find_conflicts: steps of time through the recording, candidates of each step,
// and for each candidate a walk along both tracks.
#pragma once

#include "base/resources.hpp"
#include "motion/separation.hpp"
#include "motion/track_segments.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <vector>

namespace beespace::motion {

// Chosen from the data unless a test or a benchmark forces it.
struct RecordingTuning {
  search::TuningOverrides search = {};
  std::optional<double> step_s = {};
};

// In canonical order. Error: kTooManyResults.
Result<std::vector<Conflict>> search_recording(const std::vector<TrackSegment>& segments,
                                               const Separation& separation,
                                               std::uint64_t max_results,
                                               const core::Resources& with,
                                               const RecordingTuning& tuning = {});

// The order of find_conflicts.
void order_conflicts(std::vector<Conflict>& conflicts);

}  // namespace beespace::motion
