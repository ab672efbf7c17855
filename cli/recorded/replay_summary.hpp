// A recording at a glance: does it keep its distance, and if not, who does not, and when?
#pragma once

#include "analysis/recorded/findings.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/input/moving_output.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

struct ReplayFigures {
  double threshold_m;
  double read_s;
  double search_s;
  // How much the recording may take of memory, and in how many windows of time it was searched,
  // where it is not in memory as a whole.
  std::optional<std::uint64_t> memory_bytes = {};
  std::uint64_t windows = 0;
};

std::string replay_summary(const analysis::Findings& findings, const MovingRequest& request,
                           const ReplayFigures& figures, const Distances& distances);

}  // namespace beespace::cli
