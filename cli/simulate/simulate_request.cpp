#include "cli/simulate/simulate_request.hpp"

#include "cli/command_line/flight_values.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/output/output_form.hpp"
#include "cli/simulate/simulate_scenarios.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/point.hpp>

#include <initializer_list>
#include <limits>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kName = "simulate";
constexpr const char* kDefaultBees = "1000";
constexpr const char* kDefaultSeed = "1";
constexpr const char* kDefaultSpeed = "10";
constexpr const char* kDefaultAcceleration = "5";
constexpr const char* kDefaultClearance = "1";

Result<std::uint64_t> read_count(const char* option, const std::string& text, std::uint64_t most) {
  const auto count = io::parse_whole(text);
  if (count && *count >= 1 && *count <= most) return *count;
  return simulate_error(std::string(option) + " '" + text + "' is not a whole number from 1 to " +
                        io::grouped(most));
}

std::string or_default(const std::string& given, const char* otherwise) {
  return given.empty() ? otherwise : given;
}

// An option that would be ignored is a misunderstanding.
Status check_fit(const SimulateOptions& options, bool from_file) {
  if (options.json && options.output == "-") {
    return simulate_error("--json and --output - would both write to standard output");
  }
  if (options.scenario == "-" && options.obstacles == "-") {
    return simulate_error("the mission and --obstacles cannot both be standard input");
  }
  if (!options.clearance.empty() && options.obstacles.empty() && options.scenario != kPillars) {
    return simulate_error("--clearance is of obstacles, and there are none; add --obstacles");
  }
  struct Given {
    const char* option;
    const std::string& value;
  };
  const auto none_of = [&](std::initializer_list<Given> given, const char* because) -> Status {
    for (const auto& [option, value] : given) {
      if (value.empty()) continue;
      return simulate_error(std::string(option) + " does not apply to " + because +
                            "; leave it out");
    }
    return std::monostate{};
  };
  if (from_file) {
    return none_of(
        {{"--bees", options.bees}, {"--spacing", options.spacing}, {"--seed", options.seed}},
        "a file, which tells who begins where");
  }
  if (options.scenario == kHeadOn) {
    Status of_two = none_of({{"--bees", options.bees}}, "head-on, which is of two");
    if (!of_two) return of_two;
    return none_of({{"--seed", options.seed}}, "head-on, which is always the same");
  }
  if (options.scenario == kDensitySweep) {
    return none_of({{"--spacing", options.spacing}, {"--output", options.output}},
                   "density-sweep, which flies several missions");
  }
  return std::monostate{};
}

sim::Method read_method(const std::string& word) {
  if (word == "none") return sim::Method::kNone;
  if (word == "orca") return sim::Method::kOrca;
  return word == "mvp" ? sim::Method::kMvp : sim::Method::kCertified;
}

Result<FlightLimits> read_limits(const SimulateOptions& options) {
  const auto speed = read_speed(kName, "--speed", or_default(options.speed, kDefaultSpeed));
  if (!speed) return speed.error();
  const auto acceleration = read_acceleration(
      kName, "--acceleration", or_default(options.acceleration, kDefaultAcceleration));
  if (!acceleration) return acceleration.error();
  return FlightLimits{*speed, *acceleration};
}

Result<AdviseOptions> read_advice(const SimulateOptions& options) {
  AdviseOptions advice;
  const auto threshold = read_threshold_in_motion(options.threshold);
  if (!threshold) return threshold.error();
  advice.threshold_m = *threshold;
  const auto step = read_span(kName, "--step", options.step);
  if (!step) return step.error();
  advice.step_s = *step;
  const auto clearance = read_length(
      kName, "--clearance", or_default(options.clearance, kDefaultClearance), kLeastLength_m);
  if (!clearance) return clearance.error();
  advice.clearance_m = *clearance;
  const auto threads = read_threads(kName, options.threads);
  if (!threads) return threads.error();
  advice.threads = *threads;
  return advice;
}

Result<double> read_spacing(const SimulateOptions& options, double threshold_m) {
  const double usual = options.scenario == kHeadOn ? 20.0 : 3.0;
  if (options.spacing.empty()) return usual * threshold_m;
  const auto spacing = read_length(kName, "--spacing", options.spacing, kLeastLength_m);
  if (!spacing) return spacing.error();
  if (*spacing >= threshold_m * kRoom) return *spacing;
  return simulate_error("--spacing " + options.spacing + " is not above the threshold of " +
                        io::exact(threshold_m) + " m; bees would begin too close to each other");
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
  const FileEnding of = file_ending(name);
  if (of.ending.empty()) return SwarmFormat{SwarmFormat::Kind::kCsv, of.compressed};
  return simulate_error("the ending of '" + name +
                        "' tells no format of a recording; let it end in .csv or .tsv, perhaps "
                        "with .gz" +
                        written_elsewhere(kName, of.ending));
}

}  // namespace

Error simulate_error(std::string message) {
  return usage_error(kName, std::move(message));
}

Result<SimulateRequest> simulate_request(const SimulateOptions& options) {
  SimulateRequest request;
  request.scenario = options.scenario;
  request.from_file = names_a_file(options.scenario);
  if (const Status fit = check_fit(options, request.from_file); !fit) return fit.error();
  request.loop.method = read_method(options.method);
  const auto limits = read_limits(options);
  if (!limits) return limits.error();
  request.loop.limits = *limits;
  request.speed_given = !options.speed.empty();
  request.acceleration_given = !options.acceleration.empty();
  request.obstacles = options.obstacles;
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
  request.bees = options.scenario == kHeadOn ? 2 : *bees;
  const auto steps = read_count("--steps", options.steps, 1'000'000'000);
  if (!steps) return steps.error();
  request.most_steps = *steps;
  const auto seed = io::parse_whole(or_default(options.seed, kDefaultSeed));
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

}  // namespace beespace::cli
