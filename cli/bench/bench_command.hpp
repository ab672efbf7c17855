// `beespace bench`: a quick look at how fast the searches are on this machine.
#pragma once

#include "cli/console/exit_code.hpp"

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace beespace::cli {

// As typed, before it is checked.
struct BenchOptions {
  std::string points = "200000";
  std::string threads = "0";
  bool json = false;
  bool quiet = false;
};

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_bench_command(CLI::App& command, BenchOptions& options);

ExitCode run_bench(const BenchOptions& options);

}  // namespace beespace::cli
