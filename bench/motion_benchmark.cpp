// How fast bees that move are searched: between two fixes beside the snapshot search of the same
// bees, a minute ahead a bee, recordings a fix. Answers are compared with brute force before
// anything is timed. (A live swarm is soaked by swarm_soak.)
#include <beespace/beespace.hpp>

#include "scenes/moving_scenes.hpp"
#include "scenes/recorded_flights.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using beespace::Mover;
using beespace::Point;
using beespace::Track;

constexpr double kThreshold_m = 5.0;
constexpr beespace::scenes::Speeds kSpeeds{2.0, 20.0};
constexpr std::size_t kMillion = 1'000'000;

// As many bees a cubic metre.
std::vector<Mover> flight(std::size_t count, double density) {
  const double side = std::cbrt(static_cast<double>(count) / density);
  return beespace::scenes::random_flight(count, {side, side, side}, kSpeeds, 1);
}

// Two neighbours within the threshold on average.
double with_two_neighbours() {
  constexpr double kPi = 3.14159265358979;
  return 2.0 / (4.0 / 3.0 * kPi * kThreshold_m * kThreshold_m * kThreshold_m);
}

constexpr double kSparse = 2e-5;

std::vector<Point> places_of(const std::vector<Mover>& movers) {
  std::vector<Point> places;
  places.reserve(movers.size());
  for (const Mover& mover : movers) places.push_back(mover.position);
  return places;
}

beespace::PredictOptions ahead(double horizon_s) {
  return {.threshold_m = kThreshold_m, .horizon_s = horizon_s};
}

void fail(const char* what) {
  std::fprintf(stderr, "motion_benchmark: %s differs from brute force\n", what);
  std::exit(1);
}

std::vector<beespace::Pair> pairs_of(const std::vector<beespace::Conflict>& conflicts) {
  std::vector<beespace::Pair> pairs;
  pairs.reserve(conflicts.size());
  for (const auto& conflict : conflicts) pairs.push_back({conflict.first, conflict.second});
  return pairs;
}

void check_answers() {
  constexpr std::size_t kFew = 3000;
  for (const double density : {with_two_neighbours(), kSparse}) {
    const auto movers = flight(kFew, density);
    for (const double horizon_s : {0.1, 60.0}) {
      const auto found = beespace::predict_conflicts(movers, ahead(horizon_s));
      const auto truth = beespace::brute_force::predict_conflicts(movers, ahead(horizon_s));
      if (*found != *truth) fail("predict_conflicts");
      if (*beespace::predict_pairs(movers, ahead(horizon_s)) != pairs_of(*truth)) {
        fail("predict_pairs");
      }
    }
  }
  const auto tracks = beespace::scenes::fly(flight(300, 1e-4), {60.0, 0.5});
  const beespace::ConflictOptions options{.threshold_m = kThreshold_m};
  if (beespace::find_conflicts(tracks, options).value().conflicts !=
      beespace::brute_force::find_conflicts(tracks, options).value().conflicts) {
    fail("find_conflicts");
  }
}

void per_bee(benchmark::State& state, std::size_t bees, std::size_t found) {
  state.counters["time_a_bee"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(bees),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["found"] = static_cast<double>(found);
}

// As in a later frame: an Engine keeps its memory, and the answer's.
void snapshot_pairs(benchmark::State& state) {
  const auto places = places_of(flight(kMillion, with_two_neighbours()));
  beespace::Engine engine;
  std::vector<beespace::Pair> pairs;
  for (auto _ : state) (void)engine.find_pairs(places, {.threshold_m = kThreshold_m}, pairs);
  per_bee(state, places.size(), pairs.size());
}

void predict_pairs(benchmark::State& state, double density, double horizon_s) {
  const auto movers = flight(kMillion, density);
  beespace::Engine engine;
  std::vector<beespace::Pair> pairs;
  for (auto _ : state) (void)engine.predict_pairs(movers, ahead(horizon_s), pairs);
  per_bee(state, movers.size(), pairs.size());
}

void predict_conflicts(benchmark::State& state, double density, double horizon_s) {
  const auto movers = flight(kMillion, density);
  beespace::Engine engine;
  std::vector<beespace::Conflict> conflicts;
  for (auto _ : state) (void)engine.predict_conflicts(movers, ahead(horizon_s), conflicts);
  per_bee(state, movers.size(), conflicts.size());
}

// As plain calls, which begin with fresh memory.
void snapshot_pairs_once(benchmark::State& state) {
  const auto places = places_of(flight(kMillion, with_two_neighbours()));
  std::size_t found = 0;
  for (auto _ : state) {
    found = beespace::find_pairs(places, {.threshold_m = kThreshold_m}).value().size();
  }
  per_bee(state, places.size(), found);
}

void predict_pairs_once(benchmark::State& state, double density, double horizon_s) {
  const auto movers = flight(kMillion, density);
  std::size_t found = 0;
  for (auto _ : state) found = beespace::predict_pairs(movers, ahead(horizon_s)).value().size();
  per_bee(state, movers.size(), found);
}

void predict_conflicts_once(benchmark::State& state, double density, double horizon_s) {
  const auto movers = flight(kMillion, density);
  std::size_t found = 0;
  for (auto _ : state) found = beespace::predict_conflicts(movers, ahead(horizon_s)).value().size();
  per_bee(state, movers.size(), found);
}

void recording(benchmark::State& state) {
  const auto tracks = beespace::scenes::fly(flight(1000, 1e-4), {600.0, 0.5});
  std::size_t fixes = 0;
  for (const Track& track : tracks) fixes += track.fixes.size();
  std::size_t found = 0;
  for (auto _ : state) {
    found =
        beespace::find_conflicts(tracks, {.threshold_m = kThreshold_m}).value().conflicts.size();
  }
  state.counters["time_a_fix"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(fixes),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["found"] = static_cast<double>(found);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  check_answers();
  const auto add = [](const char* name, auto function) {
    benchmark::RegisterBenchmark(name, function)
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(5)
        ->ReportAggregatesOnly(true);
  };
  const double two = with_two_neighbours();
  const auto add_motion = [&](const char* name, auto function, double density, double horizon_s) {
    add(name, [=](benchmark::State& state) { function(state, density, horizon_s); });
  };
  add("snapshot/pairs", snapshot_pairs);
  add_motion("between_fixes/pairs", predict_pairs, two, 0.1);
  add_motion("between_fixes/conflicts", predict_conflicts, two, 0.1);
  add("snapshot/pairs/once", snapshot_pairs_once);
  add_motion("between_fixes/pairs/once", predict_pairs_once, two, 0.1);
  add_motion("between_fixes/conflicts/once", predict_conflicts_once, two, 0.1);
  add_motion("a_minute_ahead/conflicts/once", predict_conflicts_once, kSparse, 60.0);
  add("recording/1000_bees_10_minutes", recording);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
