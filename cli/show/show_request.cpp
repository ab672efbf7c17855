#include "cli/show/show_request.hpp"

#include "cli/command_line/command.hpp"
#include "cli/command_line/option_values.hpp"

namespace beespace::cli {

analysis::SceneRequest scene_request(const ShowRequest& request) {
  analysis::SceneRequest scene;
  scene.load = request.moving.load;
  scene.threshold_m = request.moving.threshold_m;
  if (request.moving.threshold) {
    scene.threshold_unit = request.moving.threshold->unit;
    scene.threshold_is_bare = request.moving.threshold->bare;
  }
  scene.vertical = request.moving.vertical;
  scene.inclusive = request.moving.inclusive;
  scene.ignore_below_m = request.moving.ignore_below_m;
  scene.max_gap_s = request.max_gap_s;
  scene.tolerance_m = request.tolerance_m;
  scene.horizon_s = request.horizon_s;
  scene.threads = request.moving.threads;
  return scene;
}

void add_scene_options(Command& command, ShowRequest& request) {
  command.arguments("FILES", request.moving.inputs,
                    "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(command, request.moving);
  add_gap_options(command, request.max_gap_s, request.tolerance_m);
  add_sector_option(command, request.moving.load);
  add_threshold_options(command, request.moving);
  add_low_option(command, request.moving);
  command.option("--horizon", "SECONDS", request.horizon_s, amount("seconds", kFromZero),
                 "Of one moment: how far to look ahead (default: 60;\nof aircraft: 300)");
}

void add_error_json_option(Command& command, MovingRequest& moving) {
  command.flag("--json", moving.json, "Say errors as JSON too");
}

void add_scene_risk_option(Command& command, MovingRequest& moving) {
  command.flag("--fail-on-risk", moving.fail_on_risk,
               "Exit with 1 when a bee is at risk (of one moment: or\nwill be, flying straight "
               "on), or a gap or records\nthat were left out may hide it");
}

}  // namespace beespace::cli
