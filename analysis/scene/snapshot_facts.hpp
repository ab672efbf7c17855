// What there is to see of a snapshot.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "io/points/loaded_points.hpp"
#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::analysis {

// Errors: those of the searches.
Result<report::SnapshotFacts> snapshot_facts(const io::LoadedPoints& loaded,
                                             const std::string& title, const SceneRequest& request);

// The bees of a recording at its last instant, as `beespace predict` has it.
Result<report::SnapshotFacts> snapshot_facts(const io::Recording& recording,
                                             const std::string& title, const SceneRequest& request);

}  // namespace beespace::analysis
