// What pictures and pages of a recording say below of when all are known, and when not.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <string>

namespace beespace::analysis {

// `unknown` is what is not known, in words.
void note_coverage(const Coverage& coverage, const io::Recording& recording,
                   const std::string& unknown, report::SwarmFacts& swarm);

}  // namespace beespace::analysis
