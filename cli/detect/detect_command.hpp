// `beespace detect`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct DetectOptions {
  std::string input;
  std::string others;
  std::string report = "at-risk";
  std::string output = "-";
  std::string threshold;  // empty: the default
  std::string vertical;
  std::string frame = "auto";
  std::string format = "auto";
  std::string columns;
  std::string units;
  std::string heights = "auto";
  std::string threads = "0";
  std::string max_results;
  bool inclusive = false;
  bool csv = false;
  bool json = false;
  bool geojson = false;
  bool at_risk_only = false;
  bool skip_bad = false;
  bool unique_ids = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

// `options` must outlive it.
Command detect_command(DetectOptions& options);

ExitCode run_detect(const DetectOptions& options);

}  // namespace beespace::cli
