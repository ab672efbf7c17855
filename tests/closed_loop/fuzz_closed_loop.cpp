// Flies random flocks with random faults by `beespace watch --advise`, and ends with 1 at the first
// promise that is broken:
//   closed_loop_fuzzer --command build/release/beespace [--seconds N] [--flights N] [--seed S]
#include "tests/closed_loop/closed_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include <unistd.h>

namespace {

using namespace beespace::closed_loop;

struct Totals {
  std::uint64_t flights = 0;
  std::uint64_t looks = 0;
  std::uint64_t certified = 0;
  std::uint64_t uncertified = 0;
  std::uint64_t pairs = 0;
  std::uint64_t stale_pairs = 0;
  std::uint64_t losses = 0;
  double closest_m = std::numeric_limits<double>::infinity();
  std::map<std::string, std::uint64_t> because;
};

void add(Totals& totals, const Outcome& outcome) {
  ++totals.flights;
  totals.looks += outcome.looks;
  totals.certified += outcome.certified;
  totals.uncertified += outcome.uncertified;
  totals.pairs += outcome.certified_pairs;
  totals.stale_pairs += outcome.stale_pairs;
  totals.losses += outcome.losses;
  totals.closest_m = std::min(totals.closest_m, outcome.closest_certified_m);
  for (const auto& [reason, count] : outcome.because) totals.because[reason] += count;
}

// Whether all held.
bool fly_one(const std::string& command, const std::string& flown_path, std::uint64_t seed,
             Totals& totals) {
  const FlightPlan plan = random_plan(seed);
  Outcome outcome = fly(command, plan, flown_path);
  if (outcome.looks_missing > 0) {
    outcome.broken.push_back(std::to_string(outcome.looks_missing) + " looks did not come");
  }
  add(totals, outcome);
  if (outcome.broken.empty()) return true;
  std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), description(plan).c_str());
  for (const std::string& sentence : outcome.broken) std::printf("  %s\n", sentence.c_str());
  std::printf("%s", outcome.watch_errors.c_str());
  return false;
}

}  // namespace

int main(int count, char** words) {
  std::string command;
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t flights = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = 1;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string option = words[i];
    const char* const value = words[i + 1];
    if (option == "--command") command = value;
    if (option == "--seconds") seconds = std::strtod(value, nullptr);
    if (option == "--flights") flights = std::strtoull(value, nullptr, 10);
    if (option == "--seed") seed = std::strtoull(value, nullptr, 10);
  }
  if (command.empty()) {
    std::fprintf(stderr, "say which program with --command\n");
    return 2;
  }
  const auto folder =
      std::filesystem::temp_directory_path() / ("beespace-closed-loop-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto begin = std::chrono::steady_clock::now();
  Totals totals;
  bool held = true;
  const auto passed_s = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (held && totals.flights < flights && passed_s() < seconds) {
    held = fly_one(command, (folder / "flown.csv").string(), seed + totals.flights, totals);
  }
  std::filesystem::remove_all(folder);
  std::printf("%llu flights, %llu looks in %.0f s; %llu times a bee was certified, %llu times not:",
              static_cast<unsigned long long>(totals.flights),
              static_cast<unsigned long long>(totals.looks), passed_s(),
              static_cast<unsigned long long>(totals.certified),
              static_cast<unsigned long long>(totals.uncertified));
  for (const auto& [reason, times] : totals.because) {
    std::printf(" %s %llu", reason.c_str(), static_cast<unsigned long long>(times));
  }
  std::printf(
      "; %llu pair-steps promised and %llu with one who is stale, closest %.6f m; %llu pair-steps "
      "lost, none of them "
      "promised%s\n",
      static_cast<unsigned long long>(totals.pairs),
      static_cast<unsigned long long>(totals.stale_pairs), totals.closest_m,
      static_cast<unsigned long long>(totals.losses), held ? "" : ", but for the above");
  // Flights without any promise test nothing.
  return held && totals.pairs > 0 ? 0 : 1;
}
