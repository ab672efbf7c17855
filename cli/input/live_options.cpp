#include "cli/input/live_options.hpp"

#include "cli/command_line/option_values.hpp"

namespace beespace::cli {

void add_live_options(Command& command, LiveRequest& request) {
  command.option("--horizon", "SECONDS", request.horizon_s, amount_in_motion("seconds", kFromZero),
                 "How far to look ahead (default: 10; 0: not at all)");
  command.option("--leave-factor", "FACTOR", request.leave_factor,
                 amount_in_motion("times", {1.0, true}),
                 "Bees leave a conflict at the threshold times this\n(default: 1.1)");
  command.option("--look-every", "SECONDS", request.look_every_s, amount("seconds", kAboveZero),
                 "How often to look, by the reports' clock\n(default: 0.1)");
}

}  // namespace beespace::cli
