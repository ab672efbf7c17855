// `beespace bench`: a quick look at how fast the searches are on this machine.
#pragma once

#include "cli/command_line/command.hpp"

#include <cstdint>

namespace beespace::cli {

struct BenchRequest {
  std::uint64_t points = 200'000;
  std::uint64_t threads = 0;  // all
  bool json = false;
  bool quiet = false;
};

Command bench_command();

Result<ExitCode> run_bench(const BenchRequest& request);

}  // namespace beespace::cli
