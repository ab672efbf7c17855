#include "cli/input/live_options.hpp"

#include "cli/command_line/option_values.hpp"

#include <optional>
#include <tuple>

namespace beespace::cli {

void add_live_options(Command& command, LiveOptions& options, const char* group) {
  command.group(group);
  command.option("--horizon", "SECONDS", options.horizon,
                 "How far to look ahead (default: 10; 0: not at all)");
  command.option("--leave-factor", "FACTOR", options.leave_factor,
                 "Bees leave a conflict at the threshold times this\n(default: 1.1)");
  command.option("--look-every", "SECONDS", options.look_every,
                 "How often to look, by the reports' clock\n(default: 0.1)");
}

Result<LiveRequest> live_request(const char* command, const LiveOptions& options) {
  const auto horizon =
      read_optional_amount(command, "--horizon", options.horizon, "seconds", {0.0, true});
  if (!horizon) return horizon.error();
  const auto leave =
      read_optional_amount(command, "--leave-factor", options.leave_factor, "times", {1.0, true});
  if (!leave) return leave.error();
  const auto every =
      read_optional_amount(command, "--look-every", options.look_every, "seconds", {0.0, false});
  if (!every) return every.error();
  for (const auto& [option, text, value] :
       {std::tuple<const char*, const std::string&, std::optional<double>>{
            "--horizon", options.horizon, *horizon},
        {"--leave-factor", options.leave_factor, *leave}}) {
    if (auto good = in_motion_domain(command, option, text, value.value_or(0.0)); !good) {
      return good.error();
    }
  }
  return LiveRequest{horizon->value_or(10.0), leave->value_or(1.1), every->value_or(0.1)};
}

}  // namespace beespace::cli
