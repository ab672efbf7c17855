#include "cli/command_line/option_values.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/output/output_form.hpp"
#include "cli/simulate/fleet_options.hpp"
#include "cli/simulate/simulate_command.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "cli/simulate/simulate_scenarios.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/point.hpp>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <system_error>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kName = "simulate";

constexpr const char* kDescription =
    "Fly a swarm that keeps its distance, step by step, and check what it flew";

constexpr const char* kDetails =
    "Each bee would like to fly straight to its goal, as fast as it can, and to stop there. In "
    "every\n"
    "step each is told a velocity with which no bee comes too close to another, nor to an "
    "obstacle: the\n"
    "one that is closest to its preferred one. All that is flown is checked by the checker of "
    "'beespace\n"
    "verify', which knows nothing of how velocities are found; of a fleet that is not exact, true\n"
    "distances between bees and from fences are checked by another one, which knows as little. "
    "Ends when\n"
    "all have arrived (within half of the threshold of their goals; a fleet that is not exact, "
    "within a\n"
    "metre at most) and stand, or after --steps. The summary goes to standard error; the recording "
    "is\n"
    "written with --output only: a table of time_s, id, x, y, z, vx, vy, vz (with --acceleration "
    "none\n"
    "without velocities, as these jump), which 'beespace verify' and 'beespace replay' read.\n"
    "\n"
    "Scenarios:\n"
    "  random-swap       a cube of bees who change places at random\n"
    "  sphere-swap       all bees on a sphere, through its middle to the opposite point\n"
    "  crossing-streams  two cubes of bees who fly through each other at right angles\n"
    "  funnel            a wide field of bees who all fly into a narrow column\n"
    "  pillars           a cube of bees who fly through a forest of pillars\n"
    "  head-on           two who fly straight at each other\n"
    "  density-sweep     random swaps at 3, 2.5, 2, 1.75 and 1.5 thresholds, a line for each\n"
    "Or a file (with a '.' or '/' in its name, or - for standard input): a table with the columns "
    "x, y,\n"
    "z, goal_x, goal_y, goal_z, and perhaps id, max_speed_mps and max_acceleration_mps2.\n"
    "\n"
    "Obstacles are a JSON document, metres, z up; without low_m or high_m they have no end there:\n"
    "  {\"obstacles\": [{\"kind\": \"sphere\", \"center\": [0, 0, 50], \"radius_m\": 10},\n"
    "    {\"kind\": \"box\", \"low\": [0, 0, 0], \"high\": [20, 30, 40]},\n"
    "    {\"kind\": \"ground\", \"height_m\": 0},\n"
    "    {\"kind\": \"cylinder\", \"center\": [50, 0], \"radius_m\": 2, \"high_m\": 60},\n"
    "    {\"kind\": \"prism\", \"outline\": [[0, 50], [40, 50], [0, 90]], \"high_m\": 25}]}\n"
    "\n"
    "Examples:\n"
    "  beespace simulate random-swap --bees 1000 --output swap.csv\n"
    "  beespace verify swap.csv --threshold 5 --max-speed 10 --max-acceleration 5\n"
    "  beespace simulate random-swap --bees 1000 --method none\n"
    "  beespace simulate sphere-swap --bees 200 --threshold 2 --speed 15 --acceleration none\n"
    "  beespace simulate mission.csv --obstacles city.json --clearance 2\n"
    "  beespace simulate density-sweep --method orca\n"
    "  beespace simulate random-swap --bees 100 --noise 0.1 --gust 0.3 --latency 1 --loss 10%\n"
    "  beespace simulate head-on --output - | beespace replay --threshold 5\n"
    "  beespace simulate random-swap --json --quiet --fail-on-risk\n"
    "\n"
    "Exit status: 0 fine, 1 a bee came too close (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_flight_options(Command& simulate, SimulateRequest& request) {
  FlightLimits& limits = request.loop.limits;
  simulate.group("Scenario");
  simulate.option("--bees", "N", request.bees, whole(1, kMaxPoints),
                  "How many (default: 1000; head-on is always of two)");
  simulate.option(
      "--spacing", "LENGTH", request.spacing_m, length_from(kLeastLength_m),
      "About how far apart they begin (default: three\ntimes the threshold, of head-on 20 times); "
      "farther\nwhere tubes need it");
  simulate.option("--seed", "N", request.seed, read_seed,
                  "Another number, another swarm (default: 1)");
  simulate.group("Flight");
  simulate.option("--speed", "SPEED", limits.max_speed_mps, read_speed,
                  "The greatest, in m/s (default: 10)");
  simulate.option("--acceleration", "A|none", limits.max_acceleration_mps2, read_acceleration,
                  "The greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  simulate.option("--step", "SECONDS", request.loop.advice.step_s, read_span,
                  "How long a step is (default: 0.1)");
  simulate.option("--steps", "N", request.most_steps, whole(1, 1'000'000'000),
                  "The most steps to fly (default: 1000)");
}

void add_prevention_options(Command& simulate, SimulateRequest& request) {
  AdviseOptions& advice = request.loop.advice;
  simulate.group("Separation");
  simulate.option("--threshold", "LENGTH", advice.threshold_m, read_threshold_in_motion,
                  "Closer than this is too close (default: 5)");
  simulate.choice("--method", request.loop.method,
                  {{"certified", sim::Method::kCertified},
                   {"orca", sim::Method::kOrca},
                   {"mvp", sim::Method::kMvp},
                   {"none", sim::Method::kNone}},
                  "Who keeps them apart (default: certified); with\nnone each bee flies as it "
                  "likes; orca and mvp, to\ncompare with, promise nothing and know of no "
                  "obstacles");
  simulate.option("--obstacles", "FILE", request.obstacles,
                  "What stands in the way, beside the scenario's own:\nJSON, see below; - for "
                  "standard input");
  simulate.option("--clearance", "LENGTH", advice.clearance_m, length_from(kLeastLength_m),
                  "Closer than this to an obstacle or a fence is too\nclose (default: 1)");
  simulate.option("--threads", "N", advice.threads, read_threads,
                  "How many threads work (default: 0, all)");
}

void add_output_options(Command& simulate, SimulateRequest& request) {
  simulate.group("Output");
  simulate.option("-o,--output", "FILE", request.output,
                  "Where the recording goes: .csv or .tsv, perhaps\nwith .gz; - for standard "
                  "output");
  simulate.flag("--json", request.json, "The summary as JSON on standard output");
  simulate.flag("--fail-on-risk", request.fail_on_risk, "Exit with 1 when a bee came too close");
  add_quiet_option(simulate, request.quiet);
}

// By their names: neither needs to be there yet.
bool are_same_file(const std::string& one, const std::string& other) {
  const auto path = [](const std::string& name) {
    std::error_code failed;
    const auto full = std::filesystem::weakly_canonical(name, failed);
    return failed ? std::filesystem::path(name) : full;
  };
  return one == other || (one != "-" && other != "-" && !other.empty() && path(one) == path(other));
}

// An option that would be ignored is a misunderstanding.
Status check_fit(const Command& command, const SimulateRequest& request) {
  if (request.json && request.output == "-") {
    return simulate_error("--json and --output - would both write to standard output");
  }
  if (request.json && request.nominal == "-") {
    return simulate_error("--json and --nominal - would both write to standard output");
  }
  if (request.json && request.fleet_log == "-") {
    return simulate_error("--json and --fleet-log - would both write to standard output");
  }
  const std::pair<const char*, const std::string&> outputs[] = {{"--fleet-log", request.fleet_log},
                                                                {"--nominal", request.nominal},
                                                                {"--output", request.output}};
  for (std::size_t i = 0; i < std::size(outputs); ++i) {
    for (std::size_t k = i + 1; k < std::size(outputs); ++k) {
      const auto& [option, file] = outputs[i];
      const auto& [other, other_file] = outputs[k];
      if (file.empty() || !are_same_file(file, other_file)) continue;
      return simulate_error(std::string(option) + " and " + other +
                            " are the same; name two files");
    }
  }
  if (request.scenario == "-" && request.obstacles == "-") {
    return simulate_error("the mission and --obstacles cannot both be standard input");
  }
  if (command.is_given("--clearance") && request.obstacles.empty() &&
      request.scenario != kPillars && request.fleet.fences.empty()) {
    return simulate_error(
        "--clearance is of obstacles and fences, and there are none; add --obstacles or --fence");
  }
  const auto none_of = [&](std::initializer_list<const char*> options,
                           const char* because) -> Status {
    for (const char* option : options) {
      if (!command.is_given(option)) continue;
      return simulate_error(std::string(option) + " does not apply to " + because +
                            "; leave it out");
    }
    return std::monostate{};
  };
  // Of a fleet noise, wind and losses differ from seed to seed.
  const auto seed_does_not_apply = [&](const char* because) {
    return asks_for_fleet(command) ? Status(std::monostate{}) : none_of({"--seed"}, because);
  };
  if (request.from_file) {
    constexpr const char* kTells = "a file, which tells who begins where";
    return none_of({"--bees", "--spacing"}, kTells).and_then([&] {
      return seed_does_not_apply(kTells);
    });
  }
  if (request.scenario == kHeadOn) {
    return none_of({"--bees"}, "head-on, which is of two").and_then([&] {
      return seed_does_not_apply("head-on, which is always the same");
    });
  }
  if (request.scenario == kDensitySweep) {
    return none_of({"--spacing", "--output"}, "density-sweep, which flies several missions");
  }
  return std::monostate{};
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

Status settle(const Command& command, SimulateRequest& request) {
  request.from_file = names_a_file(request.scenario);
  if (Status fit = check_fit(command, request); !fit) return fit;
  const bool head_on = request.scenario == kHeadOn;
  const double threshold_m = request.loop.advice.threshold_m;
  if (head_on) request.bees = 2;
  request.speed_given = command.is_given("--speed");
  request.acceleration_given = command.is_given("--acceleration");
  request.loop.arrived_m = 0.5 * threshold_m;
  if (!command.is_given("--spacing")) {
    request.spacing_m = (head_on ? 20.0 : 3.0) * threshold_m;
  } else if (request.spacing_m < threshold_m * kRoom) {
    return simulate_error(std::string("--spacing ").append(command.typed("--spacing")) +
                          " is not above the threshold of " + io::exact(threshold_m) +
                          " m; bees would begin too close to each other");
  }
  const auto has_fleet = settle_fleet(command, request);
  if (!has_fleet) return has_fleet.error();
  request.has_fleet = *has_fleet;
  const auto nominal_format = format_of(request.nominal);
  if (!nominal_format) return nominal_format.error();
  request.nominal_format = *nominal_format;
  return format_of(request.output).transform([&](const SwarmFormat& format) {
    request.format = format;
  });
}

}  // namespace

Error simulate_error(std::string message) {
  return usage_error(kName, std::move(message));
}

Command simulate_command() {
  const auto request = std::make_shared<SimulateRequest>();
  Command simulate(kName, kDescription, kDetails, [request](const Command& command) {
    return settle(command, *request).and_then([&] { return run_simulate(*request); });
  });
  Option& scenario =
      simulate.argument("SCENARIO", request->scenario, "What to fly, or a file, see below");
  scenario.required = true;
  scenario.files = true;
  allow_only(scenario, scenario_names(), names_a_file,
             ", and no file (which would have a '.' or '/' in its name)");
  add_flight_options(simulate, *request);
  add_prevention_options(simulate, *request);
  add_fleet_options(simulate, *request);
  add_output_options(simulate, *request);
  return simulate;
}

}  // namespace beespace::cli
