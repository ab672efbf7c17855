// Tables of poses, several places of a body for each animal and picture: as DeepLabCut writes them
// (rows of scorer, perhaps individuals, bodyparts and coords before the data), and SLEAP (track,
// frame_idx, then NAME.x, NAME.y, NAME.score).
//
// One place of the body is where the animal is. Where there are several, it must be said:
// --columns x=nose.x,y=nose.y.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// `text` has no byte-order mark.
bool is_pose_table(std::string_view text);

// Into the source that `assembly` has begun. `stem` is the animal where none is named. Errors have
// the line, and say the coordinate.
std::optional<Error> read_pose_table(std::string_view text, const std::string& stem,
                                     RecordingAssembly& assembly);

}  // namespace beespace::io
