// `beespace watch`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/input/live_options.hpp"
#include "cli/watch/live_advice_options.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct WatchOptions {
  std::string input;
  std::string frame = "auto";
  std::string columns;
  std::string time_unit = "auto";
  std::string units;
  std::string heights = "auto";
  std::string threshold = "100";
  std::string vertical;
  std::string max_age = "5";
  std::string clock = "report";
  std::string max_skew;
  std::string max_bees;
  std::string max_pairs;
  std::string threads = "1";
  std::string speed;
  std::string rate;
  LiveOptions live;
  LiveAdviceOptions advice;
  bool fail_on_risk = false;
  bool quiet = false;
};

// `options` must outlive it.
Command watch_command(WatchOptions& options);

ExitCode run_watch(const WatchOptions& options);

}  // namespace beespace::cli
