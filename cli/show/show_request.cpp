#include "cli/show/show_request.hpp"

#include "cli/command_line/option_values.hpp"

#include <utility>

namespace beespace::cli {

void add_scene_options(Command& command, SceneOptions& options) {
  command.arguments("FILES", options.moving.inputs,
                    "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(command, options.moving);
  add_gap_options(command, options.max_gap, options.tolerance);
  add_threshold_options(command, options.moving);
}

Result<ShowRequest> show_request(const char* command, const SceneOptions& options) {
  auto moving = moving_request(command, options.moving);
  if (!moving) return std::move(moving).error();
  const auto max_gap = read_max_gap(command, options.max_gap);
  if (!max_gap) return max_gap.error();
  const auto tolerance =
      read_amount(command, "--tolerance", options.tolerance, "metres", {0.0, false});
  if (!tolerance) return tolerance.error();
  ShowRequest request;
  request.inputs = std::move(moving->inputs);
  request.scene.load = std::move(moving->load);
  request.scene.threshold_m = moving->threshold_m;
  request.scene.vertical = moving->vertical;
  request.scene.inclusive = moving->inclusive;
  request.scene.max_gap_s = *max_gap;
  request.scene.tolerance_m = *tolerance;
  request.scene.threads = moving->threads;
  request.output = std::move(moving->output);
  request.fail_on_risk = moving->fail_on_risk;
  request.quiet = moving->quiet;
  return request;
}

}  // namespace beespace::cli
