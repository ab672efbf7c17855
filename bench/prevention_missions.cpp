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
  const char* name;
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
  options.advice.threads = run.threads;
  options.arrived_m = 0.5 * kThreshold_m;
  return options;
}

beespace::VerifyOptions limits_of(const Run& run) {
  return {.threshold_m = kThreshold_m,
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
  beespace::Verifier verifier(limits_of(run));
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
  std::printf("| %s | %.0f | %d | %llu | %llu | %.7f | %.2f %% | %.3f | %.1f | %.2f | %.2f |\n",
              run.name, bees, run.steps, static_cast<unsigned long long>(verdict.losses),
              static_cast<unsigned long long>(verdict.breaches),
              verdict.closest_m.value_or(std::numeric_limits<double>::quiet_NaN()),
              100.0 * arrived / bees, ratios / std::max(1.0, arrived), stuck_s / bees,
              1e6 * loop.advising_s() / run.steps / bees, busiest_us / bees);
  std::fflush(stdout);
}

beespace::scenes::Mission random_swap(std::size_t bees, double spacing) {
  return beespace::scenes::random_swap(bees, spacing * kThreshold_m, 1.02 * kThreshold_m, 1);
}
beespace::scenes::Mission sphere_swap(std::size_t bees) {
  return beespace::scenes::antipodal_swap(bees, 3.0 * kThreshold_m, 1.02 * kThreshold_m, 1);
}

}  // namespace

int main(int argc, char** argv) {
  const bool small = argc > 1 && std::strcmp(argv[1], "--small") == 0;
  const std::size_t many = small ? 2'000 : 100'000;
  const std::size_t some = small ? 1'000 : 8'000;
  const std::size_t sphere = small ? 500 : 4'000;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::printf(
      "| mission | bees | steps | losses | breaches | closest, m | arrived | path | stuck, s | us "
      "a "
      "bee a step | in the busiest |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  fly({"random swap, 3 X, no advice", random_swap(some, 3.0), 1000, Method::kNone});
  fly({"random swap, 3 X", random_swap(some, 3.0), 1000});
  fly({"random swap, 2 X, no advice", random_swap(some, 2.0), 1000, Method::kNone});
  fly({"random swap, 2 X", random_swap(some, 2.0), 1500});
  fly({"random swap, 1.5 X", random_swap(some, 1.5), 1000});
  fly({"sphere swap, no advice", sphere_swap(sphere), 1500, Method::kNone});
  fly({"sphere swap", sphere_swap(sphere), 1500});
  fly({"head on", beespace::scenes::head_on(100.0), 1000});
  fly({"random swap, 3 X, at once", random_swap(some, 3.0), 1000, Method::kCertified, kNone});
  fly({"sphere swap, at once", sphere_swap(sphere), 1500, Method::kCertified, kNone});
  fly({"random swap, 3 X", random_swap(many, 3.0), 1000});
  fly({"random swap, 3 X, two threads", random_swap(many, 3.0), 200, Method::kCertified,
       kAcceleration_mps2, 2});
}
