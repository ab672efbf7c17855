// A recording as what all bees did at one time after the other: for checks that need to know all
// bees at the same times.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

// The times at which every bee has a fix, ascending; two at least. Errors: kUnsupportedFormat where
// a bee lacks one that others have, where there is only one time, and for a show.
Result<std::vector<double>> common_times(const io::Recording& recording);

// Where there is no velocity; nothing where all fixes have one.
struct MissingVelocity {
  std::size_t bee = 0;  // the first, and the first of its fixes
  std::size_t fix = 0;
  std::size_t count = 0;  // of all fixes without one
};
std::optional<MissingVelocity> missing_velocity(const io::Recording& recording);

// All bees at fix `fix`, in metres; unknown velocities are zero. Errors: those of the conversion.
Result<std::vector<Mover>> movers_at(const io::Recording& recording, std::size_t fix);

}  // namespace beespace::analysis
