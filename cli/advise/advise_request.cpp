#include "cli/advise/advise_request.hpp"

#include "cli/command_line/flight_values.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kName = "advise";
constexpr const char* kDefaultSpeed = "10";
constexpr const char* kDefaultAcceleration = "5";
constexpr const char* kDefaultClearance = "1";
constexpr const char* kDefaultHorizon = "10";

std::string or_default(const std::string& given, const char* otherwise) {
  return given.empty() ? otherwise : given;
}

// An option that would be ignored is a misunderstanding.
std::optional<Error> check_fit(const AdviseCommandOptions& options) {
  if (options.input.empty() && input_is_terminal()) {
    return advise_error("say which file to read, or pipe the swarm in");
  }
  const std::array<std::string, 3> inputs = {or_default(options.input, "-"), options.obstacles,
                                             options.intruders};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    return advise_error("standard input can be read once; give the others as files");
  }
  if (!options.clearance.empty() && options.obstacles.empty()) {
    return advise_error("--clearance is of obstacles, and there are none; add --obstacles");
  }
  if (!options.intruder_horizon.empty() && options.intruders.empty()) {
    return advise_error("--intruder-horizon is of intruders, and there are none; add --intruders");
  }
  if (options.method == "certified") return std::nullopt;
  if (!options.obstacles.empty() || !options.intruders.empty()) {
    return advise_error("--method " + options.method +
                        " knows nothing of obstacles and intruders; leave them out, or let it be "
                        "certified");
  }
  if (options.fail_on_risk) {
    return advise_error("--method " + options.method +
                        " certifies nobody, so --fail-on-risk would always fail; leave it out");
  }
  return std::nullopt;
}

Result<FlightLimits> read_limits(const AdviseCommandOptions& options) {
  const auto speed = read_speed(kName, "--speed", or_default(options.speed, kDefaultSpeed));
  if (!speed) return speed.error();
  const auto acceleration = read_acceleration(
      kName, "--acceleration", or_default(options.acceleration, kDefaultAcceleration));
  if (!acceleration) return acceleration.error();
  return FlightLimits{*speed, *acceleration};
}

AdviseMethod read_method(const std::string& word) {
  if (word == "orca") return AdviseMethod::kOrca;
  return word == "mvp" ? AdviseMethod::kMvp : AdviseMethod::kCertified;
}

Result<AdviseOptions> read_advice(const AdviseCommandOptions& options) {
  AdviseOptions advice;
  const auto threshold = read_threshold_in_motion(options.threshold);
  if (!threshold) return threshold.error();
  advice.threshold_m = *threshold;
  const auto step = read_span(kName, "--step", options.step);
  if (!step) return step.error();
  advice.step_s = *step;
  const auto uncertainty = read_length(kName, "--uncertainty", options.uncertainty, 0.0);
  if (!uncertainty) return uncertainty.error();
  advice.uncertainty_m = *uncertainty;
  const auto clearance = read_length(
      kName, "--clearance", or_default(options.clearance, kDefaultClearance), kLeastLength_m);
  if (!clearance) return clearance.error();
  advice.clearance_m = *clearance;
  const auto horizon =
      read_span(kName, "--intruder-horizon", or_default(options.intruder_horizon, kDefaultHorizon));
  if (!horizon) return horizon.error();
  advice.intruder_horizon_s = *horizon;
  advice.method = read_method(options.method);
  const auto threads = read_threads(kName, options.threads);
  if (!threads) return threads.error();
  advice.threads = *threads;
  return advice;
}

}  // namespace

Error advise_error(std::string message) {
  return usage_error(kName, std::move(message));
}

Result<AdviseRequest> advise_request(const AdviseCommandOptions& options) {
  if (auto error = check_fit(options)) return *std::move(error);
  AdviseRequest request;
  request.input = or_default(options.input, "-");
  request.obstacles = options.obstacles;
  request.intruders = options.intruders;
  const auto limits = read_limits(options);
  if (!limits) return limits.error();
  request.limits = *limits;
  request.speed_given = !options.speed.empty();
  request.acceleration_given = !options.acceleration.empty();
  const auto advice = read_advice(options);
  if (!advice) return advice.error();
  request.advice = *advice;
  request.output = options.output;
  const auto form =
      output_form(kName, {options.output, false, options.json}, {{Form::kCsv, Form::kJson}});
  if (!form) return form.error();
  request.form = *form;
  request.fail_on_risk = options.fail_on_risk;
  request.quiet = options.quiet;
  return request;
}

}  // namespace beespace::cli
