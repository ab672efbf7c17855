// A clock that begins again in one recording, as of a simulation that was started twice into one
// log: all bees go back in time at once, and then go through times again that they have been at.
// Brought into the order of time, two runs would be mixed, and each hide the other.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/track_gathering.hpp"

#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace beespace::io {

// The fixes of one bee in the order of the input.
struct InInputOrder {
  std::span<const Fix> fixes;
  std::span<const Origin> origins;
};

struct RestartedClock {
  Origin before;  // the last record before they went back
  Origin begins;  // the first one after that
  double from_s = 0.0;
  double to_s = 0.0;
  std::size_t bees = 0;
};

// The first one; nothing where there is none. Files that tell the same of their bees, as two logs
// of one run, are none, nor is what was written twice, or in no order.
std::optional<RestartedClock> restarted_clock(const std::vector<InInputOrder>& bees, Frame frame);

}  // namespace beespace::io
