// A recording at a glance: does it keep its distance, and if not, who does not, and when?
#pragma once

#include "analysis/recorded/findings.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/input/moving_output.hpp"

#include <string>

namespace beespace::cli {

struct ReplayFigures {
  double threshold_m;
  double read_s;
  double search_s;
};

std::string replay_summary(const analysis::Findings& findings, const MovingRequest& request,
                           const ReplayFigures& figures, const Distances& distances);

}  // namespace beespace::cli
