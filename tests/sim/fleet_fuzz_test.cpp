// A short run of the fleet fuzzer; and that it finds faults.
#include "tests/sim/judged_fleet.hpp"

#include <gtest/gtest.h>

namespace beespace::sim {
namespace {

constexpr std::uint64_t kSeeds = 60;

TEST(FleetFuzz, RandomFleetsKeepWhatIsPromised) {
  std::uint64_t agent_ticks = 0;
  std::uint64_t arrived = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto fleet = draw_fleet(seed);
    if (!fleet) continue;
    const JudgedFleet judged = judge_fleet(*fleet);
    for (const std::string& sentence : judged.broken) {
      ADD_FAILURE() << "seed " << seed << ": " << fleet->text << "\n  " << sentence;
    }
    agent_ticks += judged.agent_ticks;
    arrived += judged.arrived;
  }
  EXPECT_GT(agent_ticks, 50'000U);
  EXPECT_GT(arrived, 50U);
}

class Faults : public testing::TestWithParam<bool LoopFaults::*> {};

TEST_P(Faults, AreFound) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    auto fleet = draw_fleet(seed);
    if (!fleet) continue;
    fleet->options.faults.*GetParam() = true;
    if (!judge_fleet(*fleet).broken.empty()) return;
  }
  FAIL() << "no fault was found in " << kSeeds << " seeds";
}

INSTANTIATE_TEST_SUITE_P(Each, Faults,
                         testing::Values(&LoopFaults::no_tubes, &LoopFaults::figures_withheld,
                                         &LoopFaults::floors_ticks));

}  // namespace
}  // namespace beespace::sim
