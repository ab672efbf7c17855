// Where a bee jumps (see jumps.hpp), and whether it jumps back to where it can have got meanwhile:
// then the places between are the wrong ones, as a height that a receiver has taken from another
// message. What only leaps away and back (see excursions.hpp) does so, too. Such a stretch that
// lasts no longer than kLongestSpike_s is a spike: its places are left out, and where the bee was
// from the fix before to the one behind is not known. What is longer is kept: which of both is
// wrong is less sure.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"
#include "io/recording/recording.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kSpike = {
    "to which its bee jumps, and back from there to where it can have got meanwhile,",
    "where such a bee was is not known, from the record before to the one behind"};

struct JumpedStretch {
  std::size_t before = 0;  // the fix from which the bee jumps
  std::size_t behind = 0;  // the first one known again: to which it jumps, or jumps back
  bool comes_back = false;
};

// Of whom jumps are looked for: in which frame its places are, and whether it is an aircraft.
struct JumpsOf {
  Frame frame = Frame::kMetres;
  bool aircraft = false;
};

// Of fixes in the order of time; in that order, none within another one.
std::vector<JumpedStretch> jumped_stretches(const RecordedBee& bee, const JumpsOf& of);

// The first fix to which it jumps; nothing where it does not.
std::optional<std::size_t> first_jump(const RecordedBee& bee, const JumpsOf& of);

// The times between two fixes in which it jumps, also those within a stretch.
std::vector<TimeSpan> jumping_legs(const RecordedBee& bee, const JumpsOf& of);

bool is_spike(const RecordedBee& bee, const JumpedStretch& stretch);

// Of each fix whether it is in a spike; empty where there is none.
std::vector<bool> fixes_in_spikes(const RecordedBee& bee, const JumpsOf& of);

}  // namespace beespace::io
