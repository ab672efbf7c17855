// `beespace simulate`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct SimulateOptions {
  std::string scenario;
  std::string bees;
  std::string spacing;
  std::string threshold = "5";
  std::string speed;
  std::string acceleration;
  std::string step = "0.1";
  std::string steps = "1000";
  std::string seed;
  std::string threads = "0";
  std::string method = "certified";
  std::string obstacles;
  std::string clearance;
  std::string output;  // empty: the recording is not written
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

// `options` must outlive it.
Command simulate_command(SimulateOptions& options);

ExitCode run_simulate(const SimulateOptions& options);

}  // namespace beespace::cli
