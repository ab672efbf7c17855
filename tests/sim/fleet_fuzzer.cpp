// Flies random fleets that are not exact, and ends with 1 at the first promise that is broken:
//   fleet_fuzzer [--seconds N] [--flights N] [--seed S]
#include "tests/sim/judged_fleet.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace {

using namespace beespace::sim;

struct Totals {
  std::uint64_t seeds = 0;
  std::uint64_t flights = 0;
  std::uint64_t agent_ticks = 0;
  std::uint64_t agents = 0;
  std::uint64_t arrived = 0;
  std::uint64_t named = 0;
};

unsigned long long shown(std::uint64_t value) {
  return value;
}

// Whether all held.
bool fly_one(std::uint64_t seed, Totals& totals) {
  ++totals.seeds;
  const auto fleet = draw_fleet(seed);
  if (!fleet) return true;
  const JudgedFleet judged = judge_fleet(*fleet);
  ++totals.flights;
  totals.agent_ticks += judged.agent_ticks;
  totals.agents += judged.agents;
  totals.arrived += judged.arrived;
  totals.named += judged.named;
  if (judged.broken.empty()) return true;
  std::printf("seed %llu: %s\n", shown(seed), fleet->text.c_str());
  for (const std::string& sentence : judged.broken) std::printf("  %s\n", sentence.c_str());
  return false;
}

}  // namespace

int main(int count, char** words) {
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t flights = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = 1;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string option = words[i];
    const char* const value = words[i + 1];
    if (option == "--seconds") seconds = std::strtod(value, nullptr);
    if (option == "--flights") flights = std::strtoull(value, nullptr, 10);
    if (option == "--seed") seed = std::strtoull(value, nullptr, 10);
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto passed_s = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Totals totals;
  bool held = true;
  while (held && totals.flights < flights && passed_s() < seconds) {
    held = fly_one(seed + totals.seeds, totals);
  }
  std::printf(
      "%s: %llu flights of %llu seeds from %llu, %.0f s; %llu agents, %llu agent-ticks, %llu "
      "arrived; %llu named, all of them weak\n",
      held ? "all held" : "BROKEN", shown(totals.flights), shown(totals.seeds), shown(seed),
      passed_s(), shown(totals.agents), shown(totals.agent_ticks), shown(totals.arrived),
      shown(totals.named));
  return held ? 0 : 1;
}
