// What `beespace guide` is asked for.
#pragma once

#include "cli/console/exit_code.hpp"

#include <beespace/guide.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::cli {

// Of which agents a line tells in each tick: of those of which something has changed, or of all.
enum class StatusLines : std::uint8_t { kChanges, kAll, kNone };

struct GuideRequest {
  GuideOptions options{.clearance_m = 1.0};  // without what refers to others
  std::vector<Fence> fences;
  std::string obstacles;  // a file; empty: none
  std::string store;      // a file; empty: nothing is remembered
  bool ticks_from_input = false;
  StatusLines status = StatusLines::kChanges;
  bool mavlink = false;
  std::string log;  // with MAVLink on standard output: where the lines go; empty: nowhere
  bool quiet = false;
};

Result<ExitCode> run_guide(const GuideRequest& request);

}  // namespace beespace::cli
