// Fleets that are not exact keep the threshold of true positions; and faults that are put in are
// found.
#include "sim/fleet_loop.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace beespace::sim {
namespace {

constexpr std::size_t kAgents = test::kSanitized ? 20 : 60;
constexpr int kTicks = test::kSanitized ? 150 : 300;

FleetOptions usual(ErrorKind kind) {
  FleetOptions options;
  options.errors.disturbance.kind = kind;
  options.errors.disturbance.drift_mps = 0.1;
  options.errors.sensing_error_m = 0.05;
  options.errors.report_error_m = 0.05;
  return options;
}

scenes::Mission swap_for(const FleetOptions& options) {
  const double apart_m = options.threshold_m + 2.0 * stated_tube(options).value().radius_m;
  return scenes::random_swap(kAgents, 2.0 * apart_m, 1.02 * apart_m, options.seed);
}

struct Flown {
  FleetTally tally;
  TrueVerdict verdict;
  std::size_t arrived = 0;
};

Flown fly(const FleetOptions& options) {
  auto made = FleetLoop::make(swap_for(options), options);
  EXPECT_TRUE(made) << made.error().message;
  FleetLoop& loop = **made;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Status flown = loop.step();
    EXPECT_TRUE(flown) << flown.error().message;
    if (!flown) break;
  }
  return {loop.tally(), loop.verdict(), loop.arrived()};
}

struct Row {
  std::string name;
  std::function<void(FleetOptions&)> change;
};

class Rows : public testing::TestWithParam<std::tuple<Row, ErrorKind>> {};

const Row kRows[] = {
    {"DriftAlone", [](FleetOptions&) {}},
    {"Gusts", [](FleetOptions& options) { options.errors.disturbance.gust_mps = 0.5; }},
    {"ReportErrorsOnTheGround",
     [](FleetOptions& options) {
       options.place = LoopPlace::kGround;
       options.errors.report_error_m = 0.25;
       options.errors.report_velocity_error_mps = 0.25;
     }},
    {"OneTickLateOnTheGround",
     [](FleetOptions& options) {
       options.place = LoopPlace::kGround;
       options.commands.least_latency = options.commands.most_latency = 1;
       options.reports = options.commands;
     }},
    {"Losses",
     [](FleetOptions& options) {
       options.link.command_delay = 4;
       options.link.longest_loss = 8;
       options.commands = {.most_latency = 1, .loss = 0.3, .duplicates = 0.1, .longest_run = 8};
       options.reports = options.commands;
     }},
    {"Clocks",
     [](FleetOptions& options) {
       options.errors.clock = {0.02, true};
     }},
    {"Radii",
     [](FleetOptions& options) {
       options.least_radius_m = 1.0;
       options.most_radius_m = 4.0;
     }},
};

INSTANTIATE_TEST_SUITE_P(
    FleetLoop, Rows,
    testing::Combine(testing::ValuesIn(kRows),
                     testing::Values(ErrorKind::kUniform, ErrorKind::kAdversarial)),
    [](const auto& chosen) {
      return std::get<0>(chosen.param).name +
             (std::get<1>(chosen.param) == ErrorKind::kUniform ? "AtRandom" : "Adversarial");
    });

TEST_P(Rows, LoseNoTrueSeparationAndNameNoAgentFalsely) {
  FleetOptions options = usual(std::get<1>(GetParam()));
  std::get<0>(GetParam()).change(options);
  const Flown flown = fly(options);
  EXPECT_EQ(flown.tally.losses, 0U) << "closest " << flown.verdict.closest_m.value_or(0.0);
  EXPECT_EQ(flown.tally.false_namings, 0U);
  EXPECT_EQ(flown.tally.refused_messages, 0U);
  EXPECT_GT(flown.arrived, kAgents / 4);
  EXPECT_LE(flown.tally.largest_deviation_m, stated_tube(options).value().radius_m);
}

TEST(FleetLoop, NamesTheWeakAndNoOthers) {
  FleetOptions options = usual(ErrorKind::kAdversarial);
  options.weak_share = 0.1;
  auto made = FleetLoop::make(swap_for(options), options);
  ASSERT_TRUE(made) << made.error().message;
  FleetLoop& loop = **made;
  for (int tick = 0; tick < kTicks; ++tick) ASSERT_TRUE(loop.step());
  EXPECT_EQ(loop.tally().losses, 0U);
  EXPECT_EQ(loop.tally().false_namings, 0U);
  EXPECT_GT(loop.tally().named, 0U);
  for (const FleetAgent& agent : loop.agents()) {
    if (!agent.passed_s) continue;
    EXPECT_TRUE(agent.weak);
    ASSERT_TRUE(agent.named_s);
    EXPECT_LE(*agent.named_s, *agent.passed_s + options.link.period_s + 1e-9);
  }
}

TEST(FleetLoop, TheSilentHoldAndNoneComesTooClose) {
  FleetOptions options = usual(ErrorKind::kAdversarial);
  options.silent_share = 0.2;
  const Flown flown = fly(options);
  EXPECT_EQ(flown.tally.losses, 0U);
  EXPECT_EQ(flown.tally.false_namings, 0U);
}

TEST(FleetLoop, JoinsOneAfterTheOther) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.joins_per_s = 10.0;
  const Flown flown = fly(options);
  EXPECT_EQ(flown.tally.losses, 0U);
  EXPECT_EQ(flown.tally.false_namings, 0U);
  EXPECT_GT(flown.arrived, kAgents / 4);
}

// An agent in a cage of balls that has nearly no strength is carried into one of them: it breaks
// its contract, and that is seen. One that has its strength keeps clear.
TEST(FleetLoop, LossesOfClearanceAreSeen) {
  for (const bool weak : {false, true}) {
    FleetOptions options = usual(ErrorKind::kUniform);
    options.errors.strength = 1.0;
    options.weak_share = weak ? 0.999 : 0.0;
    options.weak_strength = 0.001;
    options.errors.disturbance.drift_mps = 0.5;
    scenes::Mission mission;
    mission.starts = {{0.0, 0.0, 10.0}};
    mission.goals = {{0.5, 0.0, 10.0}};
    for (const double at : {15.5, -15.5}) {
      mission.obstacles.emplace_back(Sphere{{at, 0.0, 10.0}, 12.0});
      mission.obstacles.emplace_back(Sphere{{0.0, at, 10.0}, 12.0});
      mission.obstacles.emplace_back(Sphere{{0.0, 0.0, 10.0 + at}, 12.0});
    }
    auto made = FleetLoop::make(mission, options);
    ASSERT_TRUE(made) << made.error().message;
    for (int tick = 0; tick < 600; ++tick) ASSERT_TRUE((*made)->step());
    EXPECT_EQ((*made)->tally().clearance_losses, 0U);
    EXPECT_EQ((*made)->tally().clearance_losses_out > 0, weak);
    EXPECT_GT((*made)->tally().replies_taken, 0U);
  }
}

TEST(FleetLoop, RemembersWhyWhoCouldNotJoin) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.fences = {{{0.0, 0.0, 1.0}, 0.0}};
  scenes::Mission mission;
  mission.starts = {{0.0, 0.0, 50.0}, {0.0, 0.0, 51.0}, {50.0, 0.0, -5.0}, {90.0, 0.0, 50.0}};
  mission.goals = mission.starts;
  mission.obstacles = {Sphere{{90.0, 0.0, 50.0}, 1.0}};
  auto made = FleetLoop::make(mission, options);
  ASSERT_TRUE(made) << made.error().message;
  const std::vector<FleetAgent>& agents = (*made)->agents();
  EXPECT_FALSE(agents[0].refused);
  ASSERT_TRUE(agents[1].refused && agents[2].refused && agents[3].refused);
  EXPECT_EQ(agents[1].refused->touches, std::vector<AgentId>{0});
  EXPECT_EQ(agents[2].refused->fences, std::vector<std::size_t>{0});
  EXPECT_EQ(agents[3].refused->obstacles, std::vector<std::size_t>{0});
  EXPECT_EQ((*made)->joined().size(), 1U);
}

// Commands that are as late as they take effect come too late for all.
TEST(FleetLoop, CountsCommandsThatComeTooLate) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.commands.least_latency = options.commands.most_latency = 10;
  options.reports = options.commands;
  const Flown flown = fly(options);
  EXPECT_EQ(flown.tally.replies_taken, 0U);
  EXPECT_GT(flown.tally.replies_too_late, 0U);
}

TEST(FleetLoop, AnIdealFleetFliesWhereItShould) {
  const FleetOptions options = ideal_of(usual(ErrorKind::kUniform), 0.2);
  const Flown flown = fly(options);
  EXPECT_EQ(flown.tally.losses, 0U);
  EXPECT_EQ(flown.tally.named, 0U);
  EXPECT_LT(flown.tally.largest_deviation_m, 1e-9);
  EXPECT_EQ(options.threshold_m, 5.4);
  EXPECT_EQ(options.limits.max_speed_mps, 9.0);
}

// Each of these is a fault of somebody's program that the harness must find.

TEST(FleetLoopFaults, TubesThatAreNotKeptFreeLoseSeparation) {
  FleetOptions options = usual(ErrorKind::kAdversarial);
  options.errors.disturbance.gust_mps = 0.5;
  options.faults.no_tubes = true;
  EXPECT_GT(fly(options).tally.losses, 0U);
}

TEST(FleetLoopFaults, FiguresThatAreWithheldNameAgents) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.faults.figures_withheld = true;
  EXPECT_GT(fly(options).tally.false_namings, 0U);
}

TEST(FleetLoopFaults, ReportsThatAreIgnoredLoseSeparationOnTheGround) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.place = LoopPlace::kGround;
  options.faults.reports_ignored = true;
  EXPECT_GT(fly(options).tally.losses, 0U);
}

TEST(FleetLoopFaults, TicksThatAreFloorsOfTimesNameAgents) {
  FleetOptions options = usual(ErrorKind::kUniform);
  options.faults.floors_ticks = true;
  EXPECT_GT(fly(options).tally.false_namings, 0U);
}

}  // namespace
}  // namespace beespace::sim
