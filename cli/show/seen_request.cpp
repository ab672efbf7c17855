#include "cli/show/seen_request.hpp"

#include "cli/analysis/gaps.hpp"
#include "cli/command_line/option_values.hpp"

#include <utility>

namespace beespace::cli {

void add_seen_options(Command& command, SeenOptions& options) {
  command.arguments("FILES", options.moving.inputs,
                    "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(command, options.moving);
  add_gap_options(command, options.max_gap, options.tolerance);
  add_threshold_options(command, options.moving);
}

Result<SeenRequest> seen_request(const char* command, const SeenOptions& options) {
  auto moving = moving_request(command, options.moving);
  if (!moving) return std::move(moving).error();
  const auto max_gap = read_max_gap(command, options.max_gap);
  if (!max_gap) return max_gap.error();
  const auto tolerance =
      read_amount(command, "--tolerance", options.tolerance, "metres", {0.0, false});
  if (!tolerance) return tolerance.error();
  SeenRequest request;
  request.moving = *std::move(moving);
  request.max_gap_s = *max_gap;
  request.tolerance_m = *tolerance;
  return request;
}

}  // namespace beespace::cli
