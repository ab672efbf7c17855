// `beespace advise`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked; empty where the default holds.
struct AdviseCommandOptions {
  std::string input;
  std::string threshold = "5";
  std::string uncertainty = "0";
  std::string speed;
  std::string acceleration;
  std::string step = "0.1";
  std::string obstacles;
  std::string clearance;
  std::string intruders;
  std::string intruder_horizon;
  std::string method = "certified";
  std::string threads = "0";
  std::string output = "-";
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

// `options` must outlive it.
Command advise_command(AdviseCommandOptions& options);

ExitCode run_advise(const AdviseCommandOptions& options);

}  // namespace beespace::cli
