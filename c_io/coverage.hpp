// Of how much of a recording it is known where its agents were, as a structure of C.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "io/recording/recording.hpp"

#include <beespace_io.h>
#include <beespace/find_conflicts.hpp>

#include <vector>

namespace beespace::c_io {

beespace_io_coverage as_struct(const analysis::Coverage& coverage);

// Where fixes are farther apart in time than that, in ascending order of (track, begins_s).
std::vector<Gap> gaps_of(const io::Recording& recording, double max_gap_s);

}  // namespace beespace::c_io
