// What `beespace advise` is asked for, once its options are known to make sense.
#pragma once

#include "cli/advise/advise_command.hpp"
#include "cli/output/output_form.hpp"

#include <beespace/advise.hpp>
#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

struct AdviseRequest {
  std::string input;      // a file, or "-"
  std::string obstacles;  // the same, or empty: none
  std::string intruders;
  AdviseOptions advice;  // but for obstacles and intruders
  FlightLimits limits;   // of who has none of its own
  bool speed_given = false;
  bool acceleration_given = false;
  std::string output;
  OutputForm form;
  bool fail_on_risk = false;
  bool quiet = false;
};

// Errors: kInvalidThreshold, kInvalidArgument.
Result<AdviseRequest> advise_request(const AdviseCommandOptions& options);

// kInvalidArgument, with the way to the help of advise.
Error advise_error(std::string message);

}  // namespace beespace::cli
