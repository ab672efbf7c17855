// The check of a recording, step after step, of what is known of it: a step that is longer than the
// greatest gap was not seen, and nothing is said of it.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/verify.hpp>

#include <vector>

namespace beespace::cli {

// The steps that are longer, of every bee: in ascending order of (track, begins_s).
std::vector<Gap> gaps_of_all(const io::Recording& recording, const std::vector<double>& times_s,
                             double max_gap_s);

// `times_s` are those of the fixes of every bee. Errors: as Verifier::add, with the bee's id.
Result<Verdict> verify_steps(const io::Recording& recording, const std::vector<double>& times_s,
                             const VerifyOptions& options, double max_gap_s, ProgressBar& progress);

}  // namespace beespace::cli
