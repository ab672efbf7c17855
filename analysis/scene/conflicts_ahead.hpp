// What lies ahead of a snapshot, if all fly straight on from it: a picture of one moment is no
// all-clear where two meet half a minute later.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <vector>

namespace beespace::analysis {

// A bee that was last heard of longer ago than that before the others is not shown: as `predict`
// has it.
inline constexpr double kMaxAgeShown_s = 30.0;

// Sets facts.ahead, where velocities are known. `bees` are those of the positions of `facts`, as
// ascending places in the recording. Errors: those of predict_conflicts, but for too many.
Status look_ahead(const io::Recording& recording, const std::vector<std::uint32_t>& bees,
                  const SceneRequest& request, report::SnapshotFacts& facts);

}  // namespace beespace::analysis
