// How well bees are kept apart, and what it costs: whole missions, flown in the closed loop with
// and without advice, every step of them checked by the independent verifier. Prints a table.
//
//   prevention_missions [--small]
#include "sim/closed_loop.hpp"

#include <beespace/verify.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace {

using beespace::sim::ClosedLoop;
using beespace::sim::LoopOptions;
using beespace::sim::Method;

constexpr double kThreshold_m = 5.0;
constexpr double kSpeed_mps = 10.0;
constexpr double kAcceleration_mps2 = 5.0;

struct Run {
  std::string name;
  beespace::scenes::Mission mission;
  int steps;
  Method method = Method::kCertified;
  double acceleration_mps2 = kAcceleration_mps2;
  unsigned threads = 1;
};

LoopOptions options_of(const Run& run) {
  LoopOptions options;
  options.method = run.method;
  options.limits = {kSpeed_mps, run.acceleration_mps2};
  options.advice.threshold_m = kThreshold_m;
  options.advice.step_s = 0.1;
  options.advice.clearance_m = 1.0;
  options.advice.threads = run.threads;
  options.arrived_m = 0.5 * kThreshold_m;
  return options;
}

// Where bees have different limits, the verifier gets the widest.
beespace::VerifyOptions limits_of(const Run& run, const ClosedLoop& loop) {
  return {.threshold_m = kThreshold_m,
          .obstacles = loop.obstacles(),
          .clearance_m = options_of(run).advice.clearance_m,
          .max_speed_mps = kSpeed_mps,
          .max_acceleration_mps2 = run.acceleration_mps2,
          .straight = std::isinf(run.acceleration_mps2)};
}

void stop(const beespace::Error& error) {
  std::fprintf(stderr, "prevention_missions: %s\n", to_string(error).c_str());
  std::exit(1);
}

void fly(const Run& run) {
  ClosedLoop loop(run.mission, options_of(run));
  beespace::Verifier verifier(limits_of(run, loop));
  if (auto added = verifier.add(0.0, loop.movers()); !added) stop(added.error());
  double busiest_us = 0.0;
  for (int step = 0; step < run.steps; ++step) {
    const double before_s = loop.advising_s();
    if (auto flown = loop.step(); !flown) stop(flown.error());
    busiest_us = std::max(busiest_us, 1e6 * (loop.advising_s() - before_s));
    if (auto added = verifier.add(loop.time_s(), loop.movers()); !added) stop(added.error());
  }
  const double bees = static_cast<double>(loop.movers().size());
  double ratios = 0.0;
  double stuck_s = 0.0;
  for (const auto& flight : loop.flights()) {
    if (flight.arrived_s && flight.shortest_m > 0.0) ratios += flight.flown_m / flight.shortest_m;
    stuck_s += flight.stuck_s;
  }
  const auto& verdict = verifier.verdict();
  const double arrived = static_cast<double>(loop.arrived());
  std::printf(
      "| %s | %.0f | %d | %llu | %llu | %llu | %.7f | %.2f %% | %.3f | %.1f | %.2f | %.2f |\n",
      run.name.c_str(), bees, run.steps, static_cast<unsigned long long>(verdict.losses),
      static_cast<unsigned long long>(verdict.clearance_losses),
      static_cast<unsigned long long>(verdict.breaches),
      verdict.closest_m.value_or(std::numeric_limits<double>::quiet_NaN()), 100.0 * arrived / bees,
      ratios / std::max(1.0, arrived), stuck_s / bees, 1e6 * loop.advising_s() / run.steps / bees,
      busiest_us / bees);
  std::fflush(stdout);
}

constexpr double kClear_m = 1.02 * kThreshold_m;

beespace::scenes::Mission random_swap(std::size_t bees, double spacing) {
  return beespace::scenes::random_swap(bees, spacing * kThreshold_m, kClear_m, 1);
}
beespace::scenes::Mission sphere_swap(std::size_t bees) {
  return beespace::scenes::antipodal_swap(bees, 3.0 * kThreshold_m, kClear_m, 1);
}

// Every third bee is slow, every third one slow to turn.
beespace::scenes::Mission mixed_swap(std::size_t bees, double spacing) {
  beespace::scenes::Mission mission = random_swap(bees, spacing);
  for (std::size_t bee = 0; bee < bees; ++bee) {
    const double slow = bee % 3 == 0 ? 0.4 : 1.0;
    const double dull = bee % 3 == 1 ? 0.3 : 1.0;
    mission.limits.push_back({slow * kSpeed_mps, dull * kAcceleration_mps2});
  }
  return mission;
}

struct Sizes {
  std::size_t many;
  std::size_t some;
  std::size_t sphere;
  std::size_t few;
  std::size_t sphere_of_all;  // methods: some take long where all meet
};

void fly_all(const Sizes& sizes) {
  namespace scenes = beespace::scenes;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double usual_m = 3.0 * kThreshold_m;
  fly({"random swap, 3 X", random_swap(sizes.some, 3.0), 1000});
  fly({"random swap, 2 X", random_swap(sizes.some, 2.0), 1500});
  fly({"random swap, 1.5 X", random_swap(sizes.some, 1.5), 1500});
  fly({"random swap, 3 X, mixed limits", mixed_swap(sizes.some, 3.0), 2500});
  fly({"sphere swap", sphere_swap(sizes.sphere), 1500});
  fly({"crossing streams, 2 X",
       scenes::crossing_streams(sizes.some, 2.0 * kThreshold_m, kClear_m, 1), 1500});
  fly({"funnel", scenes::funnel(sizes.few, usual_m, kClear_m, 1), 2500});
  fly({"pillars, 2 X", scenes::pillars(sizes.some, 2.0 * kThreshold_m, kClear_m, 1), 2500});
  fly({"head on", scenes::head_on(100.0), 1000});
  fly({"random swap, 3 X, at once", random_swap(sizes.some, 3.0), 1000, Method::kCertified, kNone});
  fly({"sphere swap, at once", sphere_swap(sizes.sphere), 1500, Method::kCertified, kNone});
  fly({"random swap, 3 X", random_swap(sizes.many, 3.0), 1500});
  fly({"random swap, 3 X", random_swap(sizes.many, 3.0), 100});
  fly({"random swap, 3 X, two threads", random_swap(sizes.many, 3.0), 100, Method::kCertified,
       kAcceleration_mps2, 2});
}

// The same loop with the known methods, for comparison.
void compare_methods(const Sizes& sizes) {
  const struct {
    Method method;
    const char* name;
  } kMethods[] = {{Method::kCertified, "certified"},
                  {Method::kOrca, "ORCA"},
                  {Method::kMvp, "MVP"},
                  {Method::kNone, "none"}};
  for (const auto& [method, name] : kMethods) {
    const auto named = [tail = std::string(", ") + name](const char* mission) {
      return mission + tail;
    };
    fly({named("random swap, 3 X"), random_swap(sizes.some, 3.0), 1000, method});
    fly({named("random swap, 2 X"), random_swap(sizes.some, 2.0), 1500, method});
    fly({named("sphere swap"), sphere_swap(sizes.sphere_of_all), 1500, method});
    fly({named("head on"), beespace::scenes::head_on(100.0), 1000, method});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool small = argc > 1 && std::strcmp(argv[1], "--small") == 0;
  const Sizes sizes =
      small ? Sizes{2'000, 1'000, 500, 200, 100} : Sizes{100'000, 8'000, 4'000, 1'000, 300};
  std::puts(
      "| mission | bees | steps | losses | of clearance | breaches | closest, m | arrived | path | "
      "stuck, s | us a bee a step | in the busiest "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  fly_all(sizes);
  compare_methods(sizes);
}
