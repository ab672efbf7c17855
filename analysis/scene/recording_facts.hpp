// What there is to see of a recording.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::analysis {

// Errors: those of the searches.
Result<report::RecordingFacts> recording_facts(const io::Recording& recording,
                                               const std::string& title,
                                               const SceneRequest& request);

}  // namespace beespace::analysis
