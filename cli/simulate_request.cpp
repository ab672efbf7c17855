#include "cli/simulate_request.hpp"

#include "cli/number_text.hpp"
#include "cli/option_values.hpp"

#include <beespace/nearest.hpp>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kName = "simulate";
constexpr const char* kDefaultBees = "1000";
constexpr const char* kDefaultSeed = "1";

// Metres and seconds. Within these nothing is lost to rounding that the checker does not allow for.
constexpr double kSmallest = 1e-6;
constexpr double kFastest = 1e6;
constexpr double kHardest = 1e9;
constexpr double kLongest = 1e6;
constexpr double kWidest = 1e9;

// Rounding may take a little from a distance: who begins at exactly the threshold would lose it.
constexpr double kRoom = 1.0 + 1e-6;

Error simulate_error(std::string message) {
  return usage_error(kName, std::move(message));
}

Result<double> read_within(const char* option, const std::string& text, const char* unit,
                           double most) {
  const auto value = parse_number(text);
  if (value && *value >= kSmallest && *value <= most) return *value;
  return simulate_error(std::string(option) + " '" + text + "' is not a number of " + unit +
                        " from 0.000001 to " + grouped(most, 0));
}

Result<std::uint64_t> read_count(const char* option, const std::string& text, std::uint64_t most) {
  const auto count = parse_whole(text);
  if (count && *count >= 1 && *count <= most) return *count;
  return simulate_error(std::string(option) + " '" + text + "' is not a whole number from 1 to " +
                        grouped(most));
}

std::string or_default(const std::string& given, const char* otherwise) {
  return given.empty() ? otherwise : given;
}

// An option that the scenario would ignore is a misunderstanding.
Status check_fit(const SimulateOptions& options) {
  if (options.json && options.output == "-") {
    return simulate_error("--json and --output - would both write to standard output");
  }
  if (options.scenario != "head-on") return std::monostate{};
  if (!options.bees.empty()) {
    return simulate_error("--bees does not apply to head-on, which is of two; leave it out");
  }
  if (!options.seed.empty()) {
    return simulate_error("--seed does not apply to head-on, which is always the same");
  }
  return std::monostate{};
}

Result<FlightLimits> read_limits(const SimulateOptions& options) {
  FlightLimits limits;
  const auto speed = read_within("--speed", options.speed, "metres per second", kFastest);
  if (!speed) return speed.error();
  limits.max_speed_mps = *speed;
  if (options.acceleration == "none") return limits;
  const auto acceleration =
      read_within("--acceleration", options.acceleration, "metres per second squared", kHardest);
  if (!acceleration) return acceleration.error();
  limits.max_acceleration_mps2 = *acceleration;
  return limits;
}

Result<AdviseOptions> read_advice(const SimulateOptions& options) {
  AdviseOptions advice;
  const auto threshold = read_threshold(options.threshold);
  if (!threshold) return threshold.error();
  advice.threshold_m = *threshold;
  const auto step = read_within("--step", options.step, "seconds", kLongest);
  if (!step) return step.error();
  advice.step_s = *step;
  const auto threads = read_threads(kName, options.threads);
  if (!threads) return threads.error();
  advice.threads = *threads;
  return advice;
}

Result<double> read_spacing(const SimulateOptions& options, double threshold_m) {
  const double usual = options.scenario == "head-on" ? 20.0 : 3.0;
  if (options.spacing.empty()) return usual * threshold_m;
  const auto spacing = read_within("--spacing", options.spacing, "metres", kWidest);
  if (!spacing) return spacing.error();
  if (*spacing >= threshold_m * kRoom) return *spacing;
  return simulate_error("--spacing " + options.spacing + " is not above the threshold of " +
                        exact(threshold_m) + " m; bees would begin too close to each other");
}

// Text, by the ending; a name without one, as that of a device or a pipe, is as good as any.
Result<SwarmFormat> format_of(const std::string& name) {
  if (name.empty() || name == "-") return SwarmFormat{};
  using Kind = SwarmFormat::Kind;
  if (const auto format = swarm_format(name)) {
    if (format->kind == Kind::kCsv || format->kind == Kind::kTsv) return *format;
    return simulate_error("npy and bin hold positions only; let '" + name +
                          "' end in .csv or .tsv, perhaps with .gz");
  }
  const std::size_t slash = name.rfind('/');
  const std::size_t last = slash == std::string::npos ? 0 : slash + 1;
  if (name.find('.', last) == std::string::npos) return SwarmFormat{};
  return simulate_error("the ending of '" + name +
                        "' tells no format of a recording; let it end in .csv or .tsv, perhaps "
                        "with .gz");
}

// Of starts, or of goals. Nearly never, as the scenes see to it; for two on a sphere they cannot.
Status check_apart(const std::vector<Point>& places, double threshold_m, const char* what) {
  if (places.size() < 2) return std::monostate{};
  const auto closest = find_closest_pair(places);
  if (!closest) return closest.error();
  if (!*closest || (*closest)->distance_m >= threshold_m * (1.0 + 1e-7)) return std::monostate{};
  return simulate_error("two bees " + std::string(what) + " " + length((*closest)->distance_m) +
                        " apart, and the threshold is " + exact(threshold_m) +
                        " m; give a larger --spacing");
}

}  // namespace

bool SimulateRequest::at_once() const {
  return std::isinf(loop.limits.max_acceleration_mps2);
}

Result<SimulateRequest> simulate_request(const SimulateOptions& options) {
  if (const Status fit = check_fit(options); !fit) return fit.error();
  SimulateRequest request;
  request.scenario = options.scenario;
  request.loop.method = options.method == "none" ? sim::Method::kNone : sim::Method::kCertified;
  const auto limits = read_limits(options);
  if (!limits) return limits.error();
  request.loop.limits = *limits;
  const auto advice = read_advice(options);
  if (!advice) return advice.error();
  request.loop.advice = *advice;
  request.loop.arrived_m = 0.5 * advice->threshold_m;
  const auto spacing = read_spacing(options, advice->threshold_m);
  if (!spacing) return spacing.error();
  request.spacing_m = *spacing;
  const auto bees =
      read_count("--bees", or_default(options.bees, kDefaultBees), std::uint64_t{kMaxPoints});
  if (!bees) return bees.error();
  request.bees = options.scenario == "head-on" ? 2 : *bees;
  const auto steps = read_count("--steps", options.steps, 1'000'000'000);
  if (!steps) return steps.error();
  request.most_steps = *steps;
  const auto seed = parse_whole(or_default(options.seed, kDefaultSeed));
  if (!seed) {
    return simulate_error("--seed '" + options.seed + "' is not a whole number from 0 to " +
                          std::to_string(std::numeric_limits<std::uint64_t>::max()));
  }
  request.seed = *seed;
  const auto format = format_of(options.output);
  if (!format) return format.error();
  request.output = options.output;
  request.format = *format;
  request.json = options.json;
  request.fail_on_risk = options.fail_on_risk;
  request.quiet = options.quiet;
  return request;
}

Result<scenes::Mission> mission_of(const SimulateRequest& request) {
  if (request.scenario == "head-on") return scenes::head_on(request.spacing_m);
  const double threshold_m = request.loop.advice.threshold_m;
  const auto make =
      request.scenario == "sphere-swap" ? scenes::antipodal_swap : scenes::random_swap;
  auto mission = make(request.bees, request.spacing_m, threshold_m * kRoom, request.seed);
  if (const Status apart = check_apart(mission.starts, threshold_m, "begin"); !apart) {
    return apart.error();
  }
  if (const Status apart = check_apart(mission.goals, threshold_m, "want to stop"); !apart) {
    return apart.error();
  }
  return mission;
}

}  // namespace beespace::cli
