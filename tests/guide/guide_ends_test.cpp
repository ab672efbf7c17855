// A Guide at the ends of what it can be told: ticks, clocks and lives of agents.
#include "tests/guide/small_fleet.hpp"

#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace beespace {
namespace {

constexpr Tick kFirst = std::numeric_limits<Tick>::min();
constexpr Tick kLast = std::numeric_limits<Tick>::max();
// The largest that a Guide takes.
constexpr Tick kMost = 1'000'000'000'000'000'000;

GuideOptions ground_options() {
  GuideOptions options = small_options();
  options.link.longest_loss = 0;
  options.figures.loop = LoopPlace::kGround;
  options.figures.report_error_m = 0.05;
  options.figures.report_age_s = 0.2;
  options.figures.deviation_mps = 0.1;
  options.figures.correction_mps = 1.0;
  options.figures.correction_mps2 = 1.0;
  return options;
}

// Stands on its branch since then.
StoredBranch standing(AgentId agent, Tick starts, Tick tick) {
  StoredBranch stored;
  stored.branch.agent = agent;
  stored.branch.number = branch_number(1, 5);
  stored.branch.starts = starts;
  stored.branch.state_count = 1;
  stored.promised = 2;
  stored.tick = tick;
  return stored;
}

Acknowledgement taken(const Command& command, Tick tick) {
  return {command.agent, command.number, CommandReply::kTaken, command.number, tick};
}

// One agent that stands at the origin, on its root since tick 10; the next tick is 11.
struct OneAgent {
  explicit OneAgent(const GuideOptions& options) : guide(Guide::make(options).value()) {
    EXPECT_TRUE(guide.join({.agent = 1}));
    EXPECT_TRUE(guide.step(10, guidance));
    root = guidance.commands.at(0);
    EXPECT_TRUE(guide.take(taken(root, 10)));
  }
  AgentReport report(Tick tick) const { return {.agent = 1, .held = root.number, .tick = tick}; }
  const AgentGuidance& step(Tick tick) {
    EXPECT_TRUE(guide.step(tick, guidance));
    return guidance.agents.at(0);
  }

  Guide guide;
  Guidance guidance;
  Command root;
};

TEST(GuideEnds, TicksThatCannotBeCountedWithAreRefused) {
  OneAgent one(ground_options());
  for (const Tick tick : {kFirst, -kMost - 1, kMost + 1, kLast}) {
    EXPECT_FALSE(one.guide.take(one.report(tick))) << tick;
    EXPECT_FALSE(one.guide.take(taken(one.root, tick))) << tick;
    EXPECT_FALSE(one.guide.step(tick, one.guidance)) << tick;
    EXPECT_FALSE(one.guide.adopt({.agent = 2}, standing(2, 0, tick))) << tick;
  }
  ASSERT_TRUE(one.guide.take(one.report(10)));
  EXPECT_EQ(one.step(11).contract, Contract::kKept);
  ASSERT_TRUE(one.guide.take(one.report(-kMost)));
  ASSERT_TRUE(one.guide.take(one.report(11)));
  EXPECT_EQ(one.step(12).contract, Contract::kKept);
}

TEST(GuideEnds, TheFirstTickMayBeAny) {
  for (const Tick first : {-kMost, Tick{-1000}, Tick{0}, kMost - 100}) {
    for (const GuideOptions& options : {small_options(), ground_options()}) {
      Guide guide = Guide::make(options).value();
      ASSERT_TRUE(guide.join({.agent = 1}).value().joined);
      ASSERT_TRUE(guide.set_goal(1, {9, 0, 0}));
      auto follower = Follower::make(1, guide.tube(1).value().planned, 0.1).value();
      Guidance guidance;
      for (Tick tick = first; tick < first + 60; ++tick) {
        follower.advance(tick);
        if (follower.held() != 0) {
          const Point place = follower.setpoint(0.0).nominal.position;
          ASSERT_TRUE(guide.take(
              AgentReport{.agent = 1, .held = follower.held(), .tick = tick, .position = place}));
        }
        ASSERT_TRUE(guide.step(tick, guidance)) << tick;
        for (const Command& command : guidance.commands) {
          ASSERT_LE(command.state_count, Command::kMostStates);
          ASSERT_TRUE(guide.take(follower.receive(command)));
        }
      }
      EXPECT_EQ(guidance.agents.at(0).contract, Contract::kKept) << first;
      EXPECT_TRUE(guidance.agents.at(0).certified) << first;
      EXPECT_NEAR(guidance.agents.at(0).nominal.position.x, 9.0, 0.5) << first;
    }
  }
}

// A planner that was held up has missed ticks, and its agents have not.
TEST(GuideEnds, APlannerThatIsLateNamesNoAgent) {
  OneAgent one(small_options());
  ASSERT_TRUE(one.guide.take(one.report(15)));
  EXPECT_EQ(one.step(15).contract, Contract::kKept);
  ASSERT_TRUE(one.guide.take(one.report(30)));
  EXPECT_EQ(one.step(29).contract, Contract::kKept);
}

// But from the ground each tick needs its correction.
TEST(GuideEnds, ATickThatWasLeftOutNamesWhoIsCorrectedFromTheGround) {
  for (const bool ground : {false, true}) {
    OneAgent one(ground ? ground_options() : small_options());
    for (Tick tick = 10; tick < 20; ++tick) {
      if (tick > 10) {
        EXPECT_EQ(one.step(tick).contract, Contract::kKept);
      }
      ASSERT_TRUE(one.guide.take(one.report(tick)));
    }
    const AgentGuidance& told = one.step(21);
    EXPECT_EQ(told.contract == Contract::kOut, ground);
    EXPECT_EQ(told.reason == ContractReason::kSilent, ground);
    EXPECT_EQ(told.certified, !ground);
  }
}

// So many commands may be on the way, and reports of them; it cannot do with less.
TEST(GuideEnds, FromTheGroundAllCommandsOnTheWayAreHeld) {
  GuideOptions options = ground_options();
  options.figures.report_age_s = 0.5;
  options.figures.deviation_mps = 0.01;
  for (const int delay : {7, 8}) {
    options.link.command_delay = delay;
    EXPECT_EQ(bool(Guide::make(options)), delay == 7);
  }
  options.figures.clock_error_s = 0.01;
  for (const int delay : {5, 6}) {
    options.link.command_delay = delay;
    EXPECT_EQ(bool(Guide::make(options)), delay == 5);
  }
  // As late as they may be.
  options.figures.clock_error_s = 0.0;
  options.link.command_delay = 7;
  Guide guide = Guide::make(options).value();
  ASSERT_TRUE(guide.join({.agent = 1}).value().joined);
  ASSERT_TRUE(guide.set_goal(1, {300, 0, 0}));
  auto follower = Follower::make(1, guide.tube(1).value().planned, 0.1).value();
  std::deque<std::pair<Tick, Command>> commands;
  std::deque<std::pair<Tick, AgentReport>> reports;
  Guidance guidance;
  for (Tick tick = 0; tick < 200; ++tick) {
    follower.advance(tick);
    for (; !commands.empty() && commands.front().first <= tick; commands.pop_front()) {
      EXPECT_EQ(follower.receive(commands.front().second).reply == CommandReply::kTaken,
                commands.front().second.number > branch_number(1, 1) || tick == 6);
    }
    if (follower.held() != 0) {
      const Point place = follower.setpoint(0.0).nominal.position;
      reports.emplace_back(
          tick + 5,
          AgentReport{.agent = 1, .held = follower.held(), .tick = tick, .position = place});
    }
    for (; !reports.empty() && reports.front().first <= tick; reports.pop_front()) {
      ASSERT_TRUE(guide.take(reports.front().second));
    }
    ASSERT_TRUE(guide.step(tick, guidance));
    ASSERT_EQ(guidance.commands.size(), 1U) << tick;
    ASSERT_NE(guidance.agents.at(0).contract, Contract::kOut) << tick;
    commands.emplace_back(tick + 6, guidance.commands.at(0));
  }
  EXPECT_GT(guidance.agents.at(0).nominal.position.x, 50.0);
}

TEST(GuideEnds, ReportsFromTheFutureNameTheAgent) {
  for (const bool by_tick : {false, true}) {
    SmallFleet fleet(small_options());
    fleet.join(1, {0, 0, 0});
    fleet.join(2, {50, 0, 0});
    for (int k = 0; k < 5; ++k) fleet.step();
    AgentReport future = fleet.report(2);
    if (by_tick) future.tick += 10;
    if (!by_tick) future.after_s = 1e9;
    ASSERT_TRUE(fleet.guide().take(future));
    fleet.step();
    EXPECT_EQ(fleet.told(2).reason, ContractReason::kFuture);
    EXPECT_EQ(fleet.told(2).contract, Contract::kOut);
    EXPECT_EQ(fleet.told(1).contract, Contract::kKept);
  }
}

// Nothing that is told before the first tick counts as told later.
TEST(GuideEnds, AReportOfAFarTickBeforeTheFirstStepIsNotBelieved) {
  Guide guide = Guide::make(ground_options()).value();
  ASSERT_TRUE(guide.join({.agent = 1}).value().joined);
  ASSERT_TRUE(guide.take(
      AgentReport{.agent = 1, .held = branch_number(1, 1), .tick = 1'000'000'000'000'000}));
  Guidance guidance;
  for (Tick tick = 1; tick < 50; ++tick) {
    ASSERT_TRUE(guide.step(tick, guidance));
    EXPECT_FALSE(guidance.agents.at(0).certified);
  }
  EXPECT_EQ(guidance.agents.at(0).contract, Contract::kOut);
}

TEST(GuideEnds, MessagesOfAnEarlierLifeNameNoAgent) {
  OneAgent one(small_options());
  ASSERT_TRUE(one.guide.set_goal(1, {50, 0, 0}));
  one.step(11);
  const Command old = one.guidance.commands.at(0);
  ASSERT_TRUE(one.guide.leave(1));
  for (Tick tick = 12; tick < 20; ++tick) ASSERT_TRUE(one.guide.step(tick, one.guidance));
  ASSERT_TRUE(one.guide.join({.agent = 1}).value().joined);
  one.step(20);
  ASSERT_TRUE(one.guide.take(taken(one.guidance.commands.at(0), 20)));
  one.step(21);
  // All of these are late.
  const AgentReport far{.agent = 1, .held = old.number, .tick = 12, .position = {90, 0, 0}};
  ASSERT_TRUE(one.guide.take(far));
  ASSERT_TRUE(one.guide.take(AgentReport{.agent = 1, .held = 0, .tick = 9}));
  ASSERT_TRUE(one.guide.take(Acknowledgement{1, old.number, CommandReply::kNoBranch, 0, 12}));
  ASSERT_TRUE(one.guide.take(taken(old, 11)));
  EXPECT_EQ(one.step(22).contract, Contract::kKept);
  // This one is not.
  ASSERT_TRUE(one.guide.take(AgentReport{.agent = 1, .held = 0, .tick = 22}));
  EXPECT_EQ(one.step(23).reason, ContractReason::kNoBranch);
}

TEST(GuideEnds, MessagesFromBeforeItWasAdoptedNameNoAgent) {
  GuideOptions options = small_options();
  options.epoch = 2;
  Guide guide = Guide::make(options).value();
  Guidance guidance;
  ASSERT_TRUE(guide.step(10, guidance));
  ASSERT_TRUE(guide.adopt({.agent = 1}, standing(1, 5, 10)));
  ASSERT_TRUE(guide.step(11, guidance));
  AgentReport late{.agent = 1, .held = branch_number(1, 4), .tick = 8};
  EXPECT_FALSE(guide.take(late));
  ASSERT_TRUE(guide.take(AgentReport{.agent = 1, .held = 0, .tick = 2}));
  ASSERT_TRUE(guide.step(12, guidance));
  EXPECT_EQ(guidance.agents.at(0).contract, Contract::kKept);
  late.tick = 11;
  EXPECT_FALSE(guide.take(late));
  ASSERT_TRUE(guide.step(13, guidance));
  EXPECT_EQ(guidance.agents.at(0).reason, ContractReason::kNoBranch);
}

TEST(GuideEnds, NoNumberIsUsedTwice) {
  OneAgent one(small_options());
  ASSERT_TRUE(one.guide.leave(1));
  ASSERT_TRUE(one.guide.join({.agent = 1, .promised = 7}).value().joined);
  one.step(11);
  ASSERT_TRUE(one.guide.leave(1));
  ASSERT_TRUE(one.guide.step(50, one.guidance));
  ASSERT_TRUE(one.guide.join({.agent = 1}).value().joined);
  one.step(51);
  EXPECT_EQ(one.guidance.commands.at(0).number, branch_number(7, 2));
}

// A path that begins later than it is said to be flown would make commands of nothing.
TEST(GuideEnds, WhoIsAdoptedIsOnABranchThatHasBegun) {
  GuideOptions options = small_options();
  options.epoch = 2;
  Guide guide = Guide::make(options).value();
  Guidance guidance;
  ASSERT_TRUE(guide.step(1, guidance));
  EXPECT_FALSE(guide.adopt({.agent = 1}, standing(1, 3, 2)));
  EXPECT_FALSE(guide.adopt({.agent = 1}, standing(1, 1000, 1000)));
  EXPECT_TRUE(guide.adopt({.agent = 1}, standing(1, 2, 2)));
  ASSERT_TRUE(guide.set_goal(1, {50, 0, 0}));
  for (Tick tick = 2; tick < 9; ++tick) {
    ASSERT_TRUE(guide.step(tick, guidance));
    for (const Command& command : guidance.commands) {
      EXPECT_LE(command.state_count, Command::kMostStates);
      EXPECT_TRUE(guide.take(taken(command, tick)));
    }
  }
  EXPECT_TRUE(guidance.agents.at(0).certified);
}

// By its own figures, where they differ from those of the others.
TEST(GuideEnds, TheClockOfAnAgentThatIsAdoptedMayBeOffByWhatItsFiguresSay) {
  GuideOptions options = small_options();
  options.epoch = 2;
  Guide guide = Guide::make(options).value();
  Guidance guidance;
  ASSERT_TRUE(guide.step(1, guidance));
  FleetFigures figures = options.figures;
  figures.clock_error_s = 0.1;
  EXPECT_FALSE(guide.adopt({.agent = 1}, standing(1, 2, 3)));
  EXPECT_FALSE(guide.adopt({.agent = 1, .figures = figures}, standing(1, 2, 4)));
  EXPECT_TRUE(guide.adopt({.agent = 1, .figures = figures}, standing(1, 2, 3)));
}

// Before the first tick it cannot be told whether its clock is right; then it can.
TEST(GuideEnds, AnAgentThatIsAdoptedWithAWrongClockIsNamed) {
  GuideOptions options = small_options();
  options.epoch = 2;
  options.figures.clock_error_s = 0.05;
  for (const Tick ahead : {Tick{1}, Tick{5}}) {
    Guide guide = Guide::make(options).value();
    ASSERT_TRUE(guide.adopt({.agent = 1}, standing(1, 9, 10 + ahead)));
    Guidance guidance;
    ASSERT_TRUE(guide.step(10, guidance));
    EXPECT_EQ(guidance.agents.at(0).contract == Contract::kOut, ahead > 1);
    ASSERT_TRUE(guide.step(11, guidance));
  }
}

TEST(GuideEnds, AStepThatWasStoppedHasPassed) {
  OneAgent one(ground_options());
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(one.guide.step(100, one.guidance, source.get_token()));
  EXPECT_EQ(one.guide.step(11, one.guidance).error().code, ErrorCode::kTimeOrder);
  EXPECT_EQ(one.step(101).contract, Contract::kOut);
}

// Beyond what can be computed with, an intruder may be anywhere; advice goes on.
TEST(GuideEnds, IntrudersThatGrowWithoutBoundVoidNoAnswer) {
  const Mover there{{100, 0, 0}, {1, 0, 0}};
  const std::vector<Intruder> wild = {{.mover = there, .radius_m = 1e30, .position_error_m = 1e30},
                                      {.mover = there, .speed_error_mps = 1.2e30},
                                      {.mover = {{1.2e30, 0, 0}, {1e30, 0, 0}}}};
  for (const Intruder& intruder : wild) {
    Guide guide = Guide::make(small_options()).value();
    ASSERT_TRUE(guide.join({.agent = 1}).value().joined);
    Guidance guidance;
    ASSERT_TRUE(guide.step(1, guidance));
    ASSERT_TRUE(guide.take(taken(guidance.commands.at(0), 1)));
    ASSERT_TRUE(guide.set_intruders({{intruder}}));
    for (const Tick tick : {Tick{2}, Tick{3}, kMost}) {
      ASSERT_TRUE(guide.step(tick, guidance)) << tick;
      EXPECT_TRUE(guidance.agents.at(0).keeps_apart);
      EXPECT_FALSE(guidance.agents.at(0).clear_of_intruders);
      EXPECT_FALSE(guidance.agents.at(0).certified);
    }
    ASSERT_TRUE(guide.set_intruders({}));
  }
}

// They are nearly zero, and no number of another unit.
TEST(GuideEnds, ReportsMayHaveTinyNumbers) {
  OneAgent one(ground_options());
  for (Tick tick = 10; tick < 20; ++tick) {
    AgentReport report = one.report(tick);
    report.position = {5e-32, -1e-300, 0};
    report.velocity = Velocity{1e-31, 0, 0};
    ASSERT_TRUE(one.guide.take(report));
    EXPECT_EQ(one.step(tick + 1).contract, Contract::kKept);
  }
}

TEST(GuideEnds, FiguresThatNoProtocolCanServeAreRefused) {
  GuideOptions options = small_options();
  options.figures.clock_error_s = 0.2;  // two ticks
  EXPECT_FALSE(Guide::make(options));
  options.figures.clock_error_s = 0.1;
  EXPECT_TRUE(Guide::make(options));
  options.link.command_delay = 1;
  EXPECT_FALSE(Guide::make(options));
  options = small_options();
  options.limits.max_acceleration_mps2 = 1e-9;  // 10^11 ticks to a stop
  EXPECT_FALSE(Guide::make(options));
  options = small_options();
  options.link.period_s = 1.2e30;
  EXPECT_FALSE(Guide::make(options));
  options = ground_options();
  options.link.longest_loss = std::numeric_limits<int>::max();
  EXPECT_FALSE(Guide::make(options));
  // And of one agent.
  options = small_options();
  options.link.command_delay = 1;
  Guide guide = Guide::make(options).value();
  FleetFigures figures = options.figures;
  figures.clock_error_s = 0.05;
  EXPECT_FALSE(guide.join({.agent = 1, .figures = figures}));
  EXPECT_FALSE(guide.join({.agent = 1, .limits = FlightLimits{10.0, 1e-9}}));
  EXPECT_TRUE(guide.join({.agent = 1}));
}

}  // namespace
}  // namespace beespace
