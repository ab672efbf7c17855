// Bees that fly as `beespace watch --advise` advises keep their distance, and where they may not,
// no bee is certified.
#include "tests/closed_loop/closed_loop.hpp"

#include "tests/cli/run/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace beespace::closed_loop {
namespace {

Outcome flown(const FlightPlan& plan) {
  const cli_test::TemporaryFolder folder;
  Outcome outcome = fly(BEESPACE_COMMAND, plan, folder.path("flown.csv"));
  for (const std::string& sentence : outcome.broken) ADD_FAILURE() << sentence;
  return outcome;
}

// Whose first two reports have been heard is certified, and stays so.
void expect_all_certified(const FlightPlan& plan) {
  SCOPED_TRACE(description(plan));
  const Outcome outcome = flown(plan);
  EXPECT_EQ(outcome.looks_missing, 0u);
  EXPECT_GT(outcome.certified_pairs, 0u);
  // Each at first, until it was heard of twice.
  EXPECT_LE(outcome.uncertified, 3 * plan.bees.size());
  for (const auto& [reason, count] : outcome.because) EXPECT_EQ(reason, "heard_once") << count;
  EXPECT_EQ(outcome.losses, 0u);
  EXPECT_GE(outcome.closest_m, plan.threshold_m);
  EXPECT_EQ(outcome.verify_status, 0);
}

FlightPlan at(FlightPlan plan, double reports_per_s, double epoch_s, double phase_s,
              bool shuffled) {
  plan.reports_per_s = reports_per_s;
  plan.epoch_s = epoch_s;
  plan.phase_s = phase_s;
  plan.shuffled = shuffled;
  plan.seed = static_cast<std::uint64_t>(reports_per_s * 10) + (shuffled ? 1 : 0);
  return plan;
}

constexpr double kEpoch_s = 1'763'000'000;

class ClosedLoopAtRate : public testing::TestWithParam<double> {};

TEST_P(ClosedLoopAtRate, HeadOnKeepsItsDistance) {
  for (const double epoch_s : {0.0, kEpoch_s}) {
    for (const double phase_s : {0.0, 0.037}) {
      expect_all_certified(at(head_on(40, 8), GetParam(), epoch_s, phase_s, false));
      expect_all_certified(at(head_on(61.3, 10), GetParam(), epoch_s, phase_s, true));
    }
  }
}

TEST_P(ClosedLoopAtRate, SwapsKeepTheirDistance) {
  for (const double epoch_s : {0.0, kEpoch_s}) {
    for (const double phase_s : {0.0, 0.037}) {
      expect_all_certified(at(swap(12, 14, 8), GetParam(), epoch_s, phase_s, phase_s > 0));
    }
  }
}

TEST_P(ClosedLoopAtRate, CrowdsKeepTheirDistance) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    expect_all_certified(at(crowd(25, 14, 7, seed), GetParam(), seed == 2 ? kEpoch_s : 0.0,
                            seed == 3 ? 0.037 : 0.0, seed != 1));
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, ClosedLoopAtRate, testing::Values(5.0, 10.0, 12.5));

}  // namespace
}  // namespace beespace::closed_loop
