// What `beespace verify` found, as rows and as the lines of a summary.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/output/rows.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <beespace/verify.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct Verification {
  const io::Recording& recording;
  const std::vector<double>& times_s;
  const VerifyOptions& options;
  const Verdict& verdict;  // of the known steps
  const analysis::Coverage& coverage;
  std::string motion;  // how bees fly from fix to fix, and why
  double read_s = 0.0;
  double check_s = 0.0;

  [[nodiscard]] bool has_limits() const;
  // One bee alone is compared with its limits, or with obstacles.
  [[nodiscard]] bool compares() const {
    return recording.bees.size() != 1 || has_limits() || options.obstacles != nullptr;
  }
  // What was not seen, or compared, is not certified.
  [[nodiscard]] bool holds() const {
    return verdict.holds() && !coverage.may_hide_conflicts() && compares();
  }
};

// finding, first, second, begins_s, ends_s, value: losses, those of clearance (the second is
// the obstacle), then breaches.
Rows finding_rows(const Verification& verification);

// The members of the JSON document before them.
void write_verdict(io::JsonWriter& json, const Verification& verification,
                   const MovingRequest& request);

std::string verify_summary(const Verification& verification, const MovingRequest& request);

}  // namespace beespace::cli
