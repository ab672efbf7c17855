#include "cli/watch/live_advice_options.hpp"

#include "cli/command_line/flight_values.hpp"
#include "cli/command_line/option_values.hpp"
#include "io/bytes/number_text.hpp"

#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kDefaultMaxSpeed = "30";
constexpr const char* kDefaultMaxAcceleration = "5";
constexpr const char* kDefaultUncertainty = "0.1";

}  // namespace

void add_live_advice_options(Command& command, LiveAdviceOptions& options, const char* group) {
  command.group(group);
  command.flag("--advise", options.wanted,
               "Every --step, also tell who should not fly on as it\ndoes, and how instead");
  command.option("--max-speed", "SPEED", options.max_speed,
                 "No bee is ever faster, in m/s: then events say whom a\nsilent one may meet. In "
                 "advice, the greatest\n(default: 30); who is faster already may stay so");
  command.option(
      "--max-acceleration", "A|none", options.max_acceleration,
      "In advice, the greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  command.option("--uncertainty", "LENGTH", options.uncertainty,
                 "In advice, how far from where it leads a bee may be\nand still be certified "
                 "(default: 0.1)");
  command.option("--step", "SECONDS", options.step,
                 "In advice, how long until the next (default: that of\n--look-every)");
}

Result<std::optional<LiveAdviceRequest>> live_advice_request(const char* command,
                                                             const LiveAdviceOptions& options,
                                                             const LiveLooks& looks) {
  if (!options.wanted) {
    for (const auto& [option, value] : {std::pair<const char*, const std::string&>{
                                            "--max-acceleration", options.max_acceleration},
                                        {"--uncertainty", options.uncertainty},
                                        {"--step", options.step}}) {
      if (value.empty()) continue;
      return usage_error(command, std::string(option) + " is of advice; add --advise");
    }
    return std::optional<LiveAdviceRequest>();
  }
  if (looks.vertical) {
    return usage_error(command,
                       "--advise knows distances in space only; leave --vertical out, or watch "
                       "twice");
  }
  LiveAdviceRequest request;
  const auto or_default = [](const std::string& given, const char* otherwise) {
    return given.empty() ? otherwise : given;
  };
  const auto speed =
      read_speed(command, "--max-speed", or_default(options.max_speed, kDefaultMaxSpeed));
  if (!speed) return speed.error();
  const auto acceleration = read_acceleration(
      command, "--max-acceleration", or_default(options.max_acceleration, kDefaultMaxAcceleration));
  if (!acceleration) return acceleration.error();
  const auto uncertainty = read_length(command, "--uncertainty",
                                       or_default(options.uncertainty, kDefaultUncertainty), 0.0);
  if (!uncertainty) return uncertainty.error();
  request.limits = {*speed, *acceleration};
  request.options.uncertainty_m = *uncertainty;
  request.options.threshold_m = looks.threshold_m;
  request.max_age_s = looks.max_age_s;
  request.options.threads = looks.threads;
  request.options.step_s = looks.look_every_s;
  if (!options.step.empty()) {
    const auto step = read_span(command, "--step", options.step);
    if (!step) return step.error();
    request.options.step_s = *step;
  } else if (!(looks.look_every_s >= 1e-6 && looks.look_every_s <= 1e6)) {
    return usage_error(command, "--look-every is no step of advice; say --step");
  }
  // In this time all come to a stop, whatever they are told.
  request.options.unknown_horizon_s = request.options.step_s + *speed / *acceleration;
  return std::optional<LiveAdviceRequest>(request);
}

}  // namespace beespace::cli
