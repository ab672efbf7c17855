// What `beespace verify` found along curves, as rows and as JSON.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/verify_paths.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/output/rows.hpp"
#include "cli/recorded/path_limits.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

struct PathFindings {
  const io::Recording& recording;
  const analysis::PathQuestion& question;
  const SettledLimits& limits;
  const analysis::PathVerdict& verdict;
  const analysis::Coverage& coverage;
  std::string motion;  // along which lines bees fly
  double read_s = 0.0;
  double check_s = 0.0;

  [[nodiscard]] bool compares() const { return analysis::compares(recording, verdict, question); }
  // What was not seen is not certified.
  [[nodiscard]] bool holds() const {
    return verdict.holds() && !coverage.may_hide_conflicts() && compares();
  }
};

// finding, first, second, begins_s, ends_s, value, limit, at_s.
Rows finding_rows(const PathFindings& findings);

// The members of the JSON document before them.
void write_verdict(io::JsonWriter& json, const PathFindings& findings,
                   const MovingRequest& request);

}  // namespace beespace::cli
