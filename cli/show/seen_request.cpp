#include "cli/show/seen_request.hpp"

#include "cli/command_line/command.hpp"

namespace beespace::cli {

void add_seen_options(Command& command, SeenRequest& request) {
  command.arguments("FILES", request.moving.inputs,
                    "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(command, request.moving);
  add_gap_options(command, request.max_gap_s, request.tolerance_m);
  add_threshold_options(command, request.moving);
}

void add_error_json_option(Command& command, MovingRequest& moving) {
  command.flag("--json", moving.json, "Say errors as JSON too");
}

void add_seen_risk_option(Command& command, MovingRequest& moving) {
  command.flag("--fail-on-risk", moving.fail_on_risk,
               "Exit with 1 when somebody is at risk, or a gap or\nrecords that were left out may "
               "hide it");
}

}  // namespace beespace::cli
