// `beespace bench`: a quick look at how fast the searches are on this machine.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct BenchOptions {
  std::string points = "200000";
  std::string threads = "0";
  bool json = false;
  bool quiet = false;
};

// `options` must outlive it.
Command bench_command(BenchOptions& options);

ExitCode run_bench(const BenchOptions& options);

}  // namespace beespace::cli
