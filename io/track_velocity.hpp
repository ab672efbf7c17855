// Which columns of a table of fixes hold the velocity, and whether they fit the position.
#pragma once

#include "io/column_choice.hpp"
#include "io/track_layout.hpp"
#include "io/track_wishes.hpp"
#include "io/track_words.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

struct VelocityQuestion {
  const ColumnsSeen& seen;
  const TrackWishes& wishes;
  const std::vector<TrackWord>& words;
  const ColumnChoice& position;
  Frame frame;
};

// Velocities are read where they are along the axes of the position: x, y, z in metres; east,
// north, up (or down) beside degrees, or beside metres that are named so. Others are left out, and
// `notes` says why: they are no part of a track.
std::optional<VelocityChoice> choose_velocity(const VelocityQuestion& question,
                                              std::vector<std::string>& notes);

}  // namespace beespace::io
