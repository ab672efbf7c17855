// A clock that begins again in one recording, as of a simulation that was started twice into one
// log: bees go back in time, and then go through times again that they have been at. Brought into
// the order of time, two runs would be mixed, and each hide the other.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/track_gathering.hpp"

#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace beespace::io {

constexpr std::size_t kFewestOfBothRuns = 3;  // fixes of either run within the times of both
constexpr std::uint64_t kLongRuns = 8;        // fixes a run, on average: else they are in no order

// How a fix goes with the run before, of which there are fixes at and around its time.
enum class GoesWithRun : std::uint8_t { kIsTheSame, kIsNear, kIsApart };
GoesWithRun goes_with(const Fix& from, const Fix& to, const Fix& fix, Frame frame);

// Where the times of one bee go back, and then through times once more.
struct ClockCut {
  Origin before;  // the last record before it went back
  Origin begins;  // the first one after that
  double from_s = 0.0;
  double to_s = 0.0;
  bool repeated = false;  // most of it was there before, just the same
  bool apart = false;     // most places after it do not go with those before
};

// The records of one bee, in the order of the input.
struct BeeClock {
  Origin first;
  Origin last;
  std::uint64_t fixes = 0;
  std::optional<ClockCut> cut = {};  // the first one
};

// Of fixes in the order of the input, one or more.
BeeClock clock_of(std::span<const Fix> fixes, std::span<const Origin> origins, Frame frame);

struct RestartedClock {
  Origin before;
  Origin begins;
  double from_s = 0.0;
  double to_s = 0.0;
  std::size_t bee = 0;   // the one that these are of
  std::size_t bees = 0;  // how many go back
  bool at_once = false;  // all of the recording, and not each within its own records
  bool alone = false;    // no other one is in that file
};

// The first one; nothing where there is none. Files that tell the same of their bees, as two logs
// of one run, are none, nor is what was written twice, or in no order.
std::optional<RestartedClock> restarted_clock(const std::vector<BeeClock>& bees);

}  // namespace beespace::io
