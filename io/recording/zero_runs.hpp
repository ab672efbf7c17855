// Places at 0, 0, 0 in metres that a bee could only jump to: robots that do not know yet where they
// are, and trackers that have lost an animal, write them. In degrees see zero_places.hpp.
#pragma once

#include "io/problems/left_out.hpp"

#include <beespace/track.hpp>

#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kZeroRun = {
    "at 0, 0, 0 exactly, which is written where no place is known (the bee would get there more "
    "than three times as fast as it ever moves elsewhere),",
    "the bee was somewhere else then"};

// Which of the fixes of a bee, in the order of time, are such; empty where none is. Of a few fixes
// it is not said.
std::vector<bool> zero_runs(const std::vector<Fix>& fixes);

}  // namespace beespace::io
