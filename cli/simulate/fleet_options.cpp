#include "cli/simulate/fleet_options.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/input/shape_value.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

namespace beespace::cli {

namespace {

constexpr const char* kOptions[] = {
    "--loop",      "--noise",    "--noise-kind",  "--gust",  "--drift",  "--latency",
    "--loss",      "--loss-run", "--clock-error", "--weak",  "--silent", "--joins",
    "--intruders", "--radius",   "--shape",       "--fence", "--plane",  "--command-delay",
    "--reserve",   "--nominal",  "--fleet-log"};

Error not_that(const Typed& typed, const char* what) {
  return usage_error(typed.command,
                     std::string(typed.option) + " '" + typed.text + "' is not " + what);
}

// "10%", or a share of 1.
std::optional<double> share_in(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const auto value = io::parse_number(text);
  if (!value) return std::nullopt;
  const double share = percent ? *value / 100.0 : *value;
  return share >= 0.0 && share < 1.0 ? std::optional(share) : std::nullopt;
}

Result<double> read_share(const Typed& typed) {
  if (const auto share = share_in(typed.text)) return *share;
  return not_that(typed, "a share from 0% to below 100%");
}

struct TwoNumbers {
  double first = 0.0;
  double second = 0.0;
};

// Two numbers with a sign between them.
std::optional<TwoNumbers> two_in(std::string_view text, char between) {
  const std::size_t at = text.find(between, 1);
  if (at == std::string_view::npos) return std::nullopt;
  const auto first = io::parse_number(text.substr(0, at));
  const auto second = io::parse_number(text.substr(at + 1));
  if (!first || !second) return std::nullopt;
  return TwoNumbers{*first, *second};
}

Result<TwoNumbers> read_weak(const Typed& typed) {
  const std::size_t at = typed.text.find(':');
  const auto share = share_in(std::string_view(typed.text).substr(0, at));
  const auto strength = at == std::string::npos
                            ? std::nullopt
                            : io::parse_number(std::string_view(typed.text).substr(at + 1));
  if (share && strength && *strength > 0.0 && *strength <= 1.0)
    return TwoNumbers{*share, *strength};
  return not_that(typed, "a share of the bees and what is left of their acceleration, as 10%:0.5");
}

Result<TwoNumbers> read_radii(const Typed& typed) {
  const auto radii = two_in(typed.text, '-');
  if (radii && radii->first >= 0.0 && radii->second >= radii->first && radii->second <= 1e6) {
    return *radii;
  }
  return not_that(typed, "two radii in metres, as 1-4");
}

Result<TwoNumbers> read_reserve(const Typed& typed) {
  const auto reserve = two_in(typed.text, ':');
  if (reserve && reserve->first > 0.0 && reserve->second > 0.0) return *reserve;
  return not_that(typed, "an acceleration and a speed above zero, as 1:1");
}

Result<std::vector<Fence>> read_band(const Typed& typed) {
  const auto band = two_in(typed.text, ':');
  if (band && band->first < band->second) {
    return std::vector<Fence>{{{0.0, 0.0, 1.0}, band->first}, {{0.0, 0.0, -1.0}, -band->second}};
  }
  return not_that(typed, "two heights in metres, the lower one first, as 0:120");
}

template <class Into>
auto two(Result<TwoNumbers> (*read)(const Typed&), Into into) {
  return [read, into](const Typed& typed) {
    return read(typed).transform([&](const TwoNumbers& numbers) {
      into(numbers);
      return numbers.first;
    });
  };
}

void add_errors(Command& simulate, SimulateRequest& request) {
  sim::FleetOptions& fleet = request.fleet;
  sim::DisturbanceBounds& wind = fleet.errors.disturbance;
  const auto length = amount_in_motion("metres", kFromZero);
  const auto speed = amount_in_motion("metres per second", kFromZero);
  simulate.option(
      "--noise", "LENGTH", request.noise_m, length,
      "How wrong measured places are at most, on board and\nin reports (default: 0.05)");
  simulate.choice(
      "--noise-kind", wind.kind,
      {{"uniform", sim::ErrorKind::kUniform}, {"adversarial", sim::ErrorKind::kAdversarial}},
      "At random (the default), or always so as to bring a\nbee closer to its "
      "neighbour: noise, gusts and drift");
  simulate.option("--gust", "SPEED", wind.gust_mps, speed, "Gusts, in m/s: they flip their signs");
  simulate.option("--drift", "SPEED", wind.drift_mps, speed, "A drift, in m/s (default: 0.1)");
  simulate.option("--latency", "TICKS", request.latency, whole(0, 30),
                  "How many steps late messages come, both ways");
  simulate.option(
      "--loss", "SHARE", fleet.commands.loss, read_share,
      "Which share of all messages is lost, as 10%; some\nthen come twice, or in another "
      "order");
  simulate.option("--loss-run", "N", request.longest_loss, whole(1, 1000),
                  "How many are lost in a row at most (default: 8)");
  simulate.option("--clock-error", "SECONDS", fleet.errors.clock.bound_s,
                  amount_in_motion("seconds", kFromZero), "How far clocks wander at most");
}

void add_agents(Command& simulate, SimulateRequest& request) {
  sim::FleetOptions& fleet = request.fleet;
  simulate.option(
      "--weak", "SHARE:STRENGTH", fleet.weak_share,
      two(read_weak, [&fleet](const TwoNumbers& weak) { fleet.weak_strength = weak.second; }),
      "Bees that have less acceleration than is stated, as\n10%:0.5");
  simulate.option("--silent", "SHARE", fleet.silent_share, read_share,
                  "Bees that fall silent in flight, as 20%");
  simulate.option("--joins", "N", fleet.joins_per_s, amount("bees a second", kAboveZero),
                  "So many bees ask to join a second, instead of all\nat the start");
  simulate.option("--intruders", "N", request.intruders, whole(0, 10'000),
                  "Strangers that fly straight through");
  simulate.option(
      "--radius", "LEAST-MOST", fleet.least_radius_m,
      two(read_radii, [&fleet](const TwoNumbers& radii) { fleet.most_radius_m = radii.second; }),
      "Radii of bees in metres, as 1-4");
}

void add_rules(Command& simulate, SimulateRequest& request) {
  sim::FleetOptions& fleet = request.fleet;
  simulate.choice("--loop", fleet.place,
                  {{"onboard", LoopPlace::kOnboard}, {"ground", LoopPlace::kGround}},
                  "Who corrects deviations: bees themselves (the\ndefault), or the planner");
  simulate.option(
      "--reserve", "A:SPEED", fleet.correction_mps2,
      two(read_reserve,
          [&fleet](const TwoNumbers& reserve) { fleet.correction_mps = reserve.second; }),
      "What is kept for corrections, in m/s^2 and m/s\n(default: 1:1)");
  simulate.option("--command-delay", "TICKS", request.command_delay, whole(1, 32),
                  "After how many steps commands take effect (default:\n2 more than the latency, "
                  "and one more with losses)");
  simulate.option(
      "--shape", kShapes, fleet.separation, read_shape,
      "What must stay free: a sphere (the default), one\nstretched in height, or a cylinder");
  simulate.option("--fence", "LOW:HIGH", fleet.fences, read_band,
                  "Heights in metres that no bee leaves");
  simulate.flag("--plane", fleet.planar, "Bees keep their heights, which are all the same");
  simulate.option("--nominal", "FILE", request.nominal,
                  "Where the nominal flight goes; --output has the\ntrue one");
  simulate.option("--fleet-log", "FILE", request.fleet_log,
                  "Where commands and statuses go, as 'beespace guide'\nwrites them; for 'beespace "
                  "report --fleet-log'");
}

}  // namespace

void add_fleet_options(Command& simulate, SimulateRequest& request) {
  simulate.group("A fleet that is not exact (any of these: flown by commands)");
  request.fleet.errors.disturbance.drift_mps = 0.1;
  add_errors(simulate, request);
  add_agents(simulate, request);
  add_rules(simulate, request);
}

namespace {

// Of the options of a fleet; null: none.
const char* first_given(const Command& command) {
  const auto given = [&](const char* option) { return command.is_given(option); };
  const auto* const first = std::find_if(std::begin(kOptions), std::end(kOptions), given);
  return first == std::end(kOptions) ? nullptr : *first;
}

void settle_messages(const Command& command, SimulateRequest& request) {
  sim::FleetOptions& fleet = request.fleet;
  const auto latency = static_cast<std::int64_t>(request.latency);
  fleet.commands.least_latency = latency;
  fleet.commands.most_latency = latency;
  fleet.link.command_delay = static_cast<int>(
      command.is_given("--command-delay") ? request.command_delay : request.latency + 2);
  if (fleet.commands.loss > 0.0) {
    fleet.link.longest_loss = static_cast<int>(request.longest_loss);
    fleet.commands.longest_run = fleet.link.longest_loss;
    fleet.commands.duplicates = 0.1;
    ++fleet.commands.most_latency;
    if (!command.is_given("--command-delay")) fleet.link.command_delay += 1;
  }
  fleet.reports = fleet.commands;
}

}  // namespace

bool asks_for_fleet(const Command& command) {
  return first_given(command) != nullptr;
}

Result<bool> settle_fleet(const Command& command, SimulateRequest& request) {
  const char* const first = first_given(command);
  if (first == nullptr) return false;
  const auto refused = [&](const std::string& why) {
    return simulate_error(std::string(first) + " is of a fleet that is flown by commands, " + why);
  };
  const FlightLimits& limits = request.loop.limits;
  if (request.loop.method != sim::Method::kCertified) {
    return refused("which are certified; leave --method out");
  }
  if (std::isinf(limits.max_acceleration_mps2)) {
    return refused("which needs a greatest acceleration; give another --acceleration");
  }
  if (request.scenario == "density-sweep") {
    return refused("and density-sweep flies several missions; choose another scenario");
  }
  sim::FleetOptions& fleet = request.fleet;
  fleet.threshold_m = request.loop.advice.threshold_m;
  fleet.limits = limits;
  fleet.link.period_s = request.loop.advice.step_s;
  fleet.clearance_m = request.loop.advice.clearance_m;
  fleet.threads = request.loop.advice.threads;
  fleet.arrived_m = std::min(1.0, request.loop.arrived_m);
  fleet.seed = request.seed;
  fleet.intruders = static_cast<std::size_t>(request.intruders);
  fleet.errors.sensing_error_m = request.noise_m;
  fleet.errors.report_error_m = request.noise_m;
  fleet.errors.clock.wanders = true;
  settle_messages(command, request);
  return true;
}

}  // namespace beespace::cli
