// From files to scenes: a snapshot or a recording, whichever they hold.
#pragma once

#include "analysis/scene/scene.hpp"
#include "analysis/scene/scene_request.hpp"
#include "io/bytes/progress.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace beespace::analysis {

// How far the work has come, for a caller who shows it; both may be absent.
enum class SceneStage : std::uint8_t { kReading, kSearching };
struct SceneProgress {
  io::Progress* reading = nullptr;                     // of the bytes of the stage kReading
  std::function<void(SceneStage stage)> entered = {};  // called by the caller's thread
};

// One file may hold a snapshot; a folder or several files are one recording, and so is a table with
// more than one time in it, also where each bee has one fix. Aircraft that are each at one instant
// are brought to the last of them, as by `beespace predict`. "-" is standard input. Errors: those
// of reading and searching; kInvalidArgument for a log of a fleet beside a snapshot.
Result<Scene> load_scene(const std::vector<std::string>& inputs, const SceneRequest& request,
                         const SceneProgress& progress = {});

// Scenes to be compared, each of some files: those after the first have its origin, and the log of
// a fleet is that of the first.
Result<std::vector<Scene>> load_scenes(const std::vector<std::vector<std::string>>& inputs,
                                       const SceneRequest& request,
                                       const SceneProgress& progress = {});

}  // namespace beespace::analysis
