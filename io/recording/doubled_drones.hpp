// A drone of a show that a table beside it tells of, too: by its name, or by standing where the
// drone begins, as a take-off grid has them. Each would be a bee of its own, and in conflict with
// itself.
#pragma once

#include "io/recording/track_gathering.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace beespace::io {

struct DoubledDrone {
  std::string problem;
  std::size_t fix = 0;  // the first of the bee of the table, as TrackGathering::origin counts them
};

// The first; nothing where there are none.
std::optional<DoubledDrone> doubled_drone(const TrackGathering& tracks);

}  // namespace beespace::io
