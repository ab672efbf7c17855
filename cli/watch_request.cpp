#include "cli/watch_request.hpp"

#include "cli/moving/live_advice_options.hpp"
#include "cli/moving/live_options.hpp"
#include "cli/moving/moving_options.hpp"
#include "cli/option_values.hpp"
#include "cli/terminal.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kName = "watch";

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
  const auto vertical =
      read_optional_amount(kName, "--vertical", options.vertical, "metres", {0.0, false});
  if (!vertical) return vertical.error();
  const auto max_age = read_amount(kName, "--max-age", options.max_age, "seconds", {0.0, false});
  if (!max_age) return max_age.error();
  const auto threads = read_threads(kName, options.threads);
  if (!threads) return threads.error();
  const auto live = live_request(kName, options.live);
  if (!live) return live.error();
  const auto speed = read_optional_amount(kName, "--speed", options.speed, "times", {0.0, false});
  if (!speed) return speed.error();
  const auto rate =
      read_optional_amount(kName, "--rate", options.rate, "reports a second", {0.0, false});
  if (!rate) return rate.error();
  const auto advice = live_advice_request(
      kName, options.advice,
      {*threshold, vertical->has_value(), live->look_every_s, *max_age, *threads});
  if (!advice) return advice.error();
  return WatchRequest{
      options.input.empty() ? "-" : options.input,
      recording_options({options.frame, options.time_unit, options.columns, options.heights}),
      {.threshold_m = *threshold,
       .vertical_m = *vertical,
       .leave_factor = live->leave_factor,
       .horizon_s = live->horizon_s,
       .max_age_s = *max_age,
       .threads = *threads},
      live->look_every_s,
      *speed,
      *rate,
      *advice,
      options.fail_on_risk,
      options.quiet};
}

}  // namespace beespace::cli
