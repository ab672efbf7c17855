// The table of prevention that holds in the air: fleets that are not exact, flown by a Guide, their
// true positions checked; beside each the same fleet with nothing wrong. Prints Markdown.
//
//   prevention_table [--seeds N] [--agents N] [--rows PART_OF_A_NAME] [--threads N] [--many]
//
// --many: one flight of 10,000 agents at middle values instead, for losses and cost.
#include "bench/prevention_rows.hpp"
#include "sim/fleet_loop.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using beespace::bench::PreventionRow;
using beespace::sim::ErrorKind;
using beespace::sim::FleetLoop;
using beespace::sim::FleetOptions;

constexpr double kLongest_s = 120.0;

struct Arguments {
  std::size_t seeds = 20;
  std::size_t agents = 500;
  std::string rows;
  unsigned threads = 2;
  bool many = false;
};

// What one flight came to.
struct Flight {
  double arrived = 0.0;  // in per cent
  beespace::sim::FleetTally tally;
  double closest_m = std::numeric_limits<double>::infinity();
  std::size_t weak = 0;
  double latest_naming_s = 0.0;  // after a report passed the naming threshold
  double us = 0.0;               // an agent and a tick
};

// Of one seed.
struct Trial {
  double rho_m = 0.0;
  double horizon_s = 0.0;
  Flight baseline;
  Flight of_threshold;  // ideal, with X alone
  std::array<Flight, 2> flown;
};

[[noreturn]] void stop(const std::string& row, const beespace::Error& error) {
  std::fprintf(stderr, "prevention_table: %s: %s\n", row.c_str(), to_string(error).c_str());
  std::exit(1);
}

// How high what must stay free is, by how wide.
double stretch_of(const FleetOptions& fleet) {
  using beespace::SeparationShape;
  return fleet.separation.shape == SeparationShape::kEllipsoid ? fleet.separation.vertical_factor
                                                               : 1.0;
}

// On a lattice of which each place is clear of the next: what must stay free, and both tubes.
beespace::scenes::Mission swap_for(const FleetOptions& fleet, double rho_m, std::size_t agents) {
  const double free_m = std::max(fleet.threshold_m, 2.0 * fleet.most_radius_m);
  const double apart_m = free_m + 2.0 * rho_m;
  auto mission = beespace::scenes::random_swap(agents, 2.0 * apart_m, 1.02 * apart_m, fleet.seed);
  for (auto* places : {&mission.starts, &mission.goals}) {
    for (beespace::Point& place : *places) place.z *= stretch_of(fleet);
  }
  if (!(fleet.joins_per_s > 0.0)) return mission;
  // Beside the starts, where others still wait for their turn.
  double wide_m = 0.0;
  for (const beespace::Point& place : mission.starts) wide_m = std::max(wide_m, place.x);
  for (beespace::Point& place : mission.goals) place.x += wide_m + 2.0 * apart_m;
  return mission;
}

Flight result_of(const FleetLoop& loop) {
  Flight flight;
  flight.arrived =
      100.0 * static_cast<double>(loop.arrived()) / static_cast<double>(loop.agents().size());
  flight.tally = loop.tally();
  flight.closest_m = loop.verdict().closest_m.value_or(flight.closest_m);
  for (const auto& agent : loop.agents()) {
    if (agent.weak) ++flight.weak;
    if (!agent.passed_s) continue;
    const double named_s = agent.named_s.value_or(loop.time_s());
    flight.latest_naming_s = std::max(flight.latest_naming_s, named_s - *agent.passed_s);
  }
  if (loop.tally().guided > 0) {
    flight.us = 1e6 * loop.tally().guiding_s / static_cast<double>(loop.tally().guided);
  }
  return flight;
}

std::unique_ptr<FleetLoop> begin(const std::string& row, beespace::scenes::Mission mission,
                                 const FleetOptions& fleet) {
  auto loop = FleetLoop::make(std::move(mission), fleet);
  if (!loop) stop(row, loop.error());
  return std::move(loop).value();
}

void fly_until(const std::string& row, FleetLoop& loop, double until_s) {
  while (loop.time_s() < until_s - 1e-9) {
    if (auto flown = loop.step(); !flown) stop(row, flown.error());
  }
}

Flight fly(const std::string& row, const beespace::scenes::Mission& mission,
           const FleetOptions& fleet, double until_s) {
  const auto loop = begin(row, mission, fleet);
  fly_until(row, *loop, until_s);
  return result_of(*loop);
}

Trial fly_trial(const PreventionRow& row, std::size_t agents, std::uint64_t seed) {
  FleetOptions fleet = row.fleet;
  fleet.seed = seed;
  const auto tube = stated_tube(fleet);
  if (!tube) stop(row.name, tube.error());
  Trial trial;
  trial.rho_m = tube->radius_m;
  const auto mission = swap_for(fleet, trial.rho_m, agents);
  // The horizon: twice as long as the baseline needs for 99 %.
  const auto ideal = begin(row.name, mission, ideal_of(fleet, trial.rho_m));
  const double most = 0.99 * static_cast<double>(agents);
  while (ideal->time_s() < kLongest_s && static_cast<double>(ideal->arrived()) < most) {
    fly_until(row.name, *ideal, ideal->time_s() + fleet.link.period_s);
  }
  trial.horizon_s = std::min(2.0 * ideal->time_s(), kLongest_s);
  fly_until(row.name, *ideal, trial.horizon_s);
  trial.baseline = result_of(*ideal);
  trial.of_threshold = fly(row.name, mission, ideal_of(fleet, 0.0), trial.horizon_s);
  for (const ErrorKind kind : {ErrorKind::kUniform, ErrorKind::kAdversarial}) {
    fleet.errors.disturbance.kind = kind;
    trial.flown[static_cast<std::size_t>(kind)] = fly(row.name, mission, fleet, trial.horizon_s);
  }
  return trial;
}

// Half of the interval that has the mean in it with 95 %, by Student's distribution.
double bound_of(const std::vector<double>& values) {
  constexpr std::array kStudent = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                   2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145,
                                   2.131,  2.120, 2.110, 2.101, 2.093};
  const std::size_t count = values.size();
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(count);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double of_mean =
      std::sqrt(squares / static_cast<double>(count - 1) / static_cast<double>(count));
  return of_mean * kStudent[std::min(count - 2, kStudent.size() - 1)];
}

struct Means {
  double arrived = 0.0;
  double baseline = 0.0;
  double of_threshold = 0.0;
  double difference = 0.0;
  double bound = 0.0;
  double us = 0.0;
  double closest_m = std::numeric_limits<double>::infinity();
};

Means means_of(const std::vector<Trial>& trials, std::size_t kind) {
  Means means;
  std::vector<double> differences;
  const double share = 1.0 / static_cast<double>(trials.size());
  for (const Trial& trial : trials) {
    const Flight& flown = trial.flown[kind];
    means.arrived += share * flown.arrived;
    means.baseline += share * trial.baseline.arrived;
    means.of_threshold += share * trial.of_threshold.arrived;
    means.us += share * flown.us;
    means.closest_m = std::min(means.closest_m, flown.closest_m);
    differences.push_back(flown.arrived - trial.baseline.arrived);
  }
  means.difference = means.arrived - means.baseline;
  means.bound = bound_of(differences);
  return means;
}

std::uint64_t sum_of(const std::vector<Trial>& trials, std::size_t kind,
                     std::uint64_t beespace::sim::FleetTally::*count) {
  std::uint64_t sum = 0;
  for (const Trial& trial : trials) sum += trial.flown[kind].tally.*count;
  return sum;
}

std::string notes_of(const PreventionRow& row, const std::vector<Trial>& trials, std::size_t kind) {
  using beespace::sim::FleetTally;
  std::string notes;
  std::size_t weak = 0;
  double latest_s = 0.0;
  for (const Trial& trial : trials) {
    weak += trial.flown[kind].weak;
    latest_s = std::max(latest_s, trial.flown[kind].latest_naming_s);
  }
  if (weak > 0) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "named %llu of %zu, at most %.2f s after passing; %llu losses to the named",
                  static_cast<unsigned long long>(sum_of(trials, kind, &FleetTally::named)), weak,
                  latest_s,
                  static_cast<unsigned long long>(sum_of(trials, kind, &FleetTally::losses_out)));
    notes = text;
  }
  if (row.fleet.joins_per_s > 0.0) {
    notes = std::to_string(sum_of(trials, kind, &FleetTally::joins_refused)) +
            " joins refused, tried again";
  }
  return notes;
}

void print_row(const PreventionRow& row, const std::vector<Trial>& trials, std::size_t kind) {
  using beespace::sim::FleetTally;
  const Means means = means_of(trials, kind);
  const auto count = [&](std::uint64_t FleetTally::*of) {
    return static_cast<unsigned long long>(sum_of(trials, kind, of));
  };
  double horizon_s = 0.0;
  for (const Trial& trial : trials) {
    horizon_s += trial.horizon_s / static_cast<double>(trials.size());
  }
  std::string goal = "reported";
  if (row.within_points >= 0.0) {
    const bool kept = means.difference >= -row.within_points;
    goal = std::to_string(static_cast<int>(row.within_points)) + (kept ? "" : " (missed)");
  }
  std::printf(
      "| %s | %s | %d | %.3f | %.0f | %.2f | %.2f | %+.2f ± %.2f | %s | %.2f | %llu | %llu | "
      "%.5f | %.2f | %s |\n",
      row.name.c_str(), kind == 0 ? "at random" : "adversarial", row.fleet.link.command_delay,
      trials.front().rho_m, horizon_s, means.arrived, means.baseline, means.difference, means.bound,
      goal.c_str(), means.of_threshold, count(&FleetTally::losses),
      count(&FleetTally::false_namings), means.closest_m, means.us,
      notes_of(row, trials, kind).c_str());
  std::fflush(stdout);
}

// Seeds side by side.
void fly_row(const PreventionRow& row, const Arguments& arguments) {
  std::vector<Trial> trials(arguments.seeds);
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < std::max(1U, arguments.threads); ++k) {
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < trials.size(); i = next++) {
        trials[i] = fly_trial(row, arguments.agents, i + 1);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  print_row(row, trials, 0);
  print_row(row, trials, 1);
}

void fly_many() {
  PreventionRow row{"10,000, middle values", beespace::bench::middle_values()};
  const auto tube = stated_tube(row.fleet);
  if (!tube) stop(row.name, tube.error());
  constexpr std::size_t kAgents = 10'000;
  constexpr double kFlown_s = 30.0;
  for (const ErrorKind kind : {ErrorKind::kUniform, ErrorKind::kAdversarial}) {
    row.fleet.errors.disturbance.kind = kind;
    const Flight flown =
        fly(row.name, swap_for(row.fleet, tube->radius_m, kAgents), row.fleet, kFlown_s);
    std::printf("%s, %s, %.0f s: %llu losses, %llu false namings, closest %.5f m, %.2f us\n",
                row.name.c_str(), kind == ErrorKind::kUniform ? "at random" : "adversarial",
                kFlown_s, static_cast<unsigned long long>(flown.tally.losses),
                static_cast<unsigned long long>(flown.tally.false_namings), flown.closest_m,
                flown.us);
    std::fflush(stdout);
  }
}

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0; };
    const bool has_value = i + 1 < argc;
    if (is("--many")) {
      arguments.many = true;
    } else if (is("--seeds") && has_value) {
      arguments.seeds = std::max(1UL, std::strtoul(argv[++i], nullptr, 10));
    } else if (is("--agents") && has_value) {
      arguments.agents = std::max(1UL, std::strtoul(argv[++i], nullptr, 10));
    } else if (is("--threads") && has_value) {
      arguments.threads = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
    } else if (is("--rows") && has_value) {
      arguments.rows = argv[++i];
    } else {
      std::fprintf(stderr, "prevention_table: '%s' is no option\n", argv[i]);
      std::exit(2);
    }
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = arguments_of(argc, argv);
  if (arguments.many) {
    fly_many();
    return 0;
  }
  std::puts(
      "| row | errors | D | ρ, m | horizon, s | arrived, % | baseline, % | difference, points | "
      "within | X alone, % | losses | false namings | closest, m | µs | notes |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const PreventionRow& row : beespace::bench::prevention_rows()) {
    if (row.name.find(arguments.rows) != std::string::npos) fly_row(row, arguments);
  }
}
