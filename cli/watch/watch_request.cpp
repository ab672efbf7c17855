#include "cli/watch/watch_request.hpp"

#include "cli/command_line/flight_values.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/live_options.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/watch/live_advice_options.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/mover.hpp>

#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kName = "watch";

// A whole number of bees or pairs, 1 or more.
Result<std::size_t> read_bound(const std::string& option, const std::string& text,
                               std::size_t otherwise) {
  if (text.empty()) return otherwise;
  const auto value = io::parse_whole(text);
  constexpr std::uint64_t kMost = 4'000'000'000;
  if (value && *value >= 1 && *value <= kMost) return static_cast<std::size_t>(*value);
  return usage_error(
      kName, option + " '" + text + "' is not a whole number from 1 to " + std::to_string(kMost));
}

// What the engine can compute with, so that no report is refused for the options. A vertical
// threshold may be compared as typed, or in metres.
Status domain_problem(const WatchOptions& typed, const SwarmOptions& swarm,
                      const std::optional<io::StatedLength>& vertical) {
  if (auto good = in_motion_domain(kName, "--max-age", typed.max_age, swarm.max_age_s); !good) {
    return good;
  }
  if (auto good = in_motion_domain(kName, "--max-speed", typed.advice.max_speed,
                                   swarm.max_speed_mps.value_or(0.0));
      !good) {
    return good;
  }
  std::vector<std::optional<double>> heights = {swarm.vertical_m};
  if (vertical) heights.emplace_back(vertical->value);
  for (const auto& height : heights) {
    if (auto good = in_motion_domain(kName, "--vertical", typed.vertical, height.value_or(0.0));
        !good) {
      return good;
    }
    for (const double threshold : {swarm.threshold_m, height.value_or(swarm.threshold_m)}) {
      if (threshold * swarm.leave_factor <= kLargestInMotion) continue;
      return usage_error(kName, "--leave-factor '" + typed.live.leave_factor +
                                    "' times the threshold cannot be computed with; give less");
    }
  }
  return std::monostate{};
}

}  // namespace

Result<WatchRequest> watch_request(const WatchOptions& options) {
  if (options.input.empty() && input_is_terminal()) {
    return usage_error(kName, "say which file to read, or pipe the reports in");
  }
  if (!options.speed.empty() && !options.rate.empty()) {
    return usage_error(kName, "--speed and --rate exclude each other");
  }
  const auto threshold = read_threshold_in_motion(options.threshold);
  if (!threshold) return threshold.error();
  const auto vertical = read_vertical(kName, options.vertical);
  if (!vertical) return vertical.error();
  const auto reading = recording_options(
      kName, {options.frame, options.time_unit, options.columns, options.heights, options.units});
  if (!reading) return reading.error();
  std::optional<double> vertical_m;
  if (*vertical) vertical_m = (*vertical)->metric;
  const auto max_age = read_amount(kName, "--max-age", options.max_age, "seconds", {0.0, false});
  if (!max_age) return max_age.error();
  const auto skew =
      read_optional_amount(kName, "--max-skew", options.max_skew, "seconds", {0.0, false});
  if (!skew) return skew.error();
  const auto threads = read_threads(kName, options.threads);
  if (!threads) return threads.error();
  const auto live = live_request(kName, options.live);
  if (!live) return live.error();
  const auto speed = read_optional_amount(kName, "--speed", options.speed, "times", {0.0, false});
  if (!speed) return speed.error();
  const auto rate =
      read_optional_amount(kName, "--rate", options.rate, "reports a second", {0.0, false});
  if (!rate) return rate.error();
  std::optional<double> max_speed;
  if (!options.advice.max_speed.empty()) {
    const auto stated = read_speed(kName, "--max-speed", options.advice.max_speed);
    if (!stated) return stated.error();
    max_speed = *stated;
  }
  const auto max_bees = read_bound("--max-bees", options.max_bees, SwarmOptions{}.max_bees);
  if (!max_bees) return max_bees.error();
  const auto max_pairs = read_bound("--max-pairs", options.max_pairs, SwarmOptions{}.max_pairs);
  if (!max_pairs) return max_pairs.error();
  if (options.clock == "arrival" && (speed->has_value() || rate->has_value())) {
    return usage_error(kName, "--clock arrival is for reports that come as things happen; leave " +
                                  std::string(*speed ? "--speed" : "--rate") + " out");
  }
  const auto advice = live_advice_request(
      kName, options.advice,
      {*threshold, vertical->has_value(), live->look_every_s, *max_age, *threads});
  if (!advice) return advice.error();
  const SwarmOptions swarm{.threshold_m = *threshold,
                           .vertical_m = vertical_m,
                           .leave_factor = live->leave_factor,
                           .horizon_s = live->horizon_s,
                           .max_age_s = *max_age,
                           .threads = *threads,
                           .max_speed_mps = max_speed,
                           .max_bees = *max_bees,
                           .max_pairs = *max_pairs};
  if (auto good = domain_problem(options, swarm, *vertical); !good) return good.error();
  return WatchRequest{options.input.empty() ? "-" : options.input,
                      *reading,
                      swarm,
                      *vertical,
                      {live->look_every_s, skew->value_or(default_max_skew_s(*max_age))},
                      options.clock == "arrival",
                      *speed,
                      *rate,
                      *advice,
                      options.fail_on_risk,
                      options.quiet};
}

}  // namespace beespace::cli
