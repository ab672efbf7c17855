// What `beespace advise` is asked for.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/output/output_form.hpp"

#include <beespace/advise.hpp>
#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

struct AdviseRequest {
  std::string input;      // a file, or "-"
  std::string obstacles;  // the same, or empty: none
  std::string intruders;
  // But for obstacles and intruders.
  AdviseOptions advice{.threshold_m = 5.0, .clearance_m = 1.0, .threads = 0};
  FlightLimits limits{10.0, 5.0};  // of each that has none of its own
  bool speed_given = false;
  bool acceleration_given = false;
  std::string output = "-";
  bool json = false;
  OutputForm form;
  bool fail_on_risk = false;
  bool quiet = false;
};

Result<ExitCode> run_advise(const AdviseRequest& request);

// kInvalidArgument, with the way to the help of advise.
Error advise_error(std::string message);

}  // namespace beespace::cli
