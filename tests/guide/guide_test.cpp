// A Guide and its fleet: that it gets there, keeps apart, and names who breaks the contract.
#include "tests/guide/small_fleet.hpp"

#include <beespace/guide.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace beespace {
namespace {

double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// Swaps the places of a cube of agents, at random.
struct Swap {
  std::vector<Point> starts;
  std::vector<Point> goals;

  Swap(int side, double spacing_m, unsigned seed) {
    for (int k = 0; k < side * side * side; ++k) {
      starts.push_back(
          {spacing_m * (k % side), spacing_m * (k / side % side), spacing_m * (k / side / side)});
    }
    goals = starts;
    std::mt19937 random(seed);
    std::shuffle(goals.begin(), goals.end(), random);
  }
  void fly(SmallFleet& fleet) const {
    for (AgentId id = 0; id < starts.size(); ++id) {
      fleet.join(id, starts[id]);
      ASSERT_TRUE(fleet.guide().set_goal(id, goals[id]));
    }
  }
  [[nodiscard]] std::size_t arrived(const SmallFleet& fleet) const {
    std::size_t count = 0;
    for (AgentId id = 0; id < goals.size(); ++id) {
      if (distance(fleet.place(id), goals[id]) <= 1.0) ++count;
    }
    return count;
  }
};

TEST(Guide, TwoThatMeetHeadOnPassEachOther) {
  SmallFleet fleet(small_options());
  fleet.join(1, {0, 0, 0});
  fleet.join(2, {60, 0, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {60, 0, 0}));
  ASSERT_TRUE(fleet.guide().set_goal(2, {0, 0, 0}));
  for (int k = 0; k < 300; ++k) {
    fleet.step();
    ASSERT_GE(fleet.closest_m(), 5.0);
  }
  EXPECT_LE(distance(fleet.place(1), {60, 0, 0}), 1.0);
  EXPECT_LE(distance(fleet.place(2), {0, 0, 0}), 1.0);
}

TEST(Guide, LossesCostTimeAndNoSeparation) {
  for (const double probability : {0.0, 0.1, 0.3, 0.6}) {
    GuideOptions options = small_options();
    options.figures = some_figures();
    options.link.command_delay = 4;
    options.link.longest_loss = 8;
    SmallFleet fleet(options);
    fleet.lose(probability, 7);
    const Swap swap(4, 18.0, 3);
    swap.fly(fleet);
    const double kept_m = 5.0 + 2.0 * fleet.guide().tube(0).value().radius_m;
    for (int k = 0; k < 900; ++k) {
      fleet.step();
      ASSERT_GE(fleet.closest_m(), kept_m) << "tick " << k << ", losses " << probability;
      for (const AgentGuidance& agent : fleet.guidance().agents) {
        ASSERT_NE(agent.contract, Contract::kOut) << agent.agent << " at " << k;
      }
      EXPECT_TRUE(fleet.guidance().pairs.empty());
    }
    EXPECT_GE(swap.arrived(fleet), probability > 0.5 ? 40U : 60U) << probability;
  }
}

TEST(Guide, WhatItSaysIsTheSameForEveryNumberOfThreads) {
  std::vector<Point> places;
  for (const unsigned threads : {1U, 3U}) {
    GuideOptions options = small_options();
    options.figures = some_figures();
    options.threads = threads;
    SmallFleet fleet(options);
    const Swap swap(4, 16.0, 5);
    swap.fly(fleet);
    for (int k = 0; k < 150; ++k) fleet.step();
    for (AgentId id = 0; id < swap.starts.size(); ++id) {
      if (threads == 1) {
        places.push_back(fleet.place(id));
      } else {
        EXPECT_EQ(places[id], fleet.place(id)) << id;
      }
    }
  }
}

TEST(Guide, AJoinReservesItsPlace) {
  SmallFleet fleet(small_options());
  fleet.join(1, {0, 0, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {100, 0, 0}));
  for (int k = 0; k < 30; ++k) fleet.step();
  // Ahead of it, within its claim; then beside it.
  const Point place = fleet.place(1);
  const auto ahead = fleet.guide().may_join({.agent = 2, .position = {place.x + 9, 0, 0}});
  ASSERT_TRUE(ahead);
  EXPECT_FALSE(ahead->joined);
  EXPECT_EQ(ahead->touches, std::vector<AgentId>{1});
  const Point beside{place.x, 30, 0};
  const auto asked = fleet.guide().may_join({.agent = 2, .position = beside});
  ASSERT_TRUE(asked);
  EXPECT_TRUE(asked->touches.empty());
  EXPECT_FALSE(asked->joined);
  const auto joined = fleet.guide().join({.agent = 2, .position = beside});
  ASSERT_TRUE(joined && joined->joined);
  const auto same = fleet.guide().join({.agent = 3, .position = {place.x + 1, 30, 0}});
  ASSERT_TRUE(same);
  EXPECT_FALSE(same->joined);
  EXPECT_EQ(same->touches, std::vector<AgentId>{2});
  EXPECT_EQ(fleet.guide().size(), 2U);
  const auto twice = fleet.guide().join({.agent = 2, .position = {500, 0, 0}});
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().message.find("agent 2"), std::string::npos);
}

TEST(Guide, TheSilentHoldAndKeepTheirPlaces) {
  GuideOptions options = small_options();
  options.figures = some_figures();
  SmallFleet fleet(options);
  fleet.join(1, {0, 0, 0});
  fleet.join(2, {200, 1, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {200, 0, 0}));
  ASSERT_TRUE(fleet.guide().set_goal(2, {0, 1, 0}));
  fleet.silent = [](AgentId id, Tick now) { return id == 1 && now > 60; };
  for (int k = 0; k < 80; ++k) fleet.step();
  EXPECT_EQ(fleet.told(1).contract, Contract::kDoubted);
  EXPECT_EQ(fleet.told(1).reason, ContractReason::kSilent);
  for (int k = 0; k < 400; ++k) {
    fleet.step();
    ASSERT_GE(fleet.closest_m(), 5.0);
  }
  EXPECT_TRUE(fleet.follower(1).setpoint(0.0).holding);
  EXPECT_LE(distance(fleet.place(2), {0, 1, 0}), 1.0);
  const Point stands = fleet.place(1);
  const auto there = fleet.guide().may_join({.agent = 3, .position = stands});
  ASSERT_TRUE(there);
  EXPECT_EQ(there->touches, std::vector<AgentId>{1});
  ASSERT_TRUE(fleet.guide().leave(1));
  const auto free = fleet.guide().may_join({.agent = 3, .position = stands});
  ASSERT_TRUE(free);
  EXPECT_TRUE(free->touches.empty());
  // What was sent to it may still come; not once it has promised to take nothing of that.
  EXPECT_FALSE(fleet.guide().join({.agent = 1, .position = stands}));
  fleet.follower(1).lose();
  const std::uint32_t promised = fleet.follower(1).stored().promised;
  const auto anew = fleet.guide().join({.agent = 1, .position = stands, .promised = promised});
  ASSERT_TRUE(anew) << anew.error().message;
  ASSERT_TRUE(anew->joined);
  fleet.silent = [](AgentId, Tick) { return false; };
  for (int k = 0; k < 3; ++k) fleet.step();
  EXPECT_NE(fleet.follower(1).held(), 0U);
  EXPECT_EQ(fleet.told(1).contract, Contract::kKept);
}

TEST(Guide, NamesOnlyTheOneThatIsNotWhereItShouldBe) {
  GuideOptions options = small_options();
  options.figures = some_figures();
  SmallFleet fleet(options);
  const Swap swap(3, 40.0, 9);
  swap.fly(fleet);
  fleet.offset = [](AgentId id, Tick now) {
    return id == 5 && now > 50 ? Point{0.05 * static_cast<double>(now - 50), 0, 0} : Point{};
  };
  bool named = false;
  for (int k = 0; k < 150; ++k) {
    fleet.step();
    for (const AgentGuidance& agent : fleet.guidance().agents) {
      if (agent.contract == Contract::kOut) {
        EXPECT_EQ(agent.agent, 5U);
        named = true;
      }
    }
    for (const UncertifiedPair& pair : fleet.guidance().pairs) {
      EXPECT_TRUE(pair.first == 5 || pair.second == 5);
    }
  }
  EXPECT_TRUE(named);
  EXPECT_FALSE(fleet.told(5).certified);
  EXPECT_GE(swap.arrived(fleet), 15U);
}

TEST(Guide, FencesAreKept) {
  GuideOptions options = small_options();
  const std::vector<Fence> fences = {{{0, 0, 1}, 2.0}, {{0, 0, -1}, -20.0}};
  options.fences = fences;
  SmallFleet fleet(options);
  const auto outside = fleet.guide().may_join({.agent = 9, .position = {0, 0, 2.5}});
  ASSERT_TRUE(outside);
  EXPECT_EQ(outside->fences, std::vector<std::size_t>{0});
  fleet.join(1, {0, 0, 10});
  ASSERT_TRUE(fleet.guide().set_goal(1, {30, 0, -50}));
  for (int k = 0; k < 200; ++k) {
    fleet.step();
    ASSERT_GE(fleet.place(1).z, 3.0);
    ASSERT_LE(fleet.place(1).z, 19.0);
  }
  EXPECT_LE(fleet.place(1).z, 3.5);
}

TEST(Guide, RefusesWhatCannotBe) {
  SmallFleet fleet(small_options());
  fleet.join(1, {0, 0, 0});
  fleet.join(2, {50, 0, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {0, 50, 0}));
  for (int k = 0; k < 20; ++k) fleet.step();
  Guide& guide = fleet.guide();
  EXPECT_FALSE(guide.set_goal(7, {}));
  EXPECT_FALSE(guide.leave(7));
  EXPECT_FALSE(guide.take(AgentReport{.agent = 7, .position = {}}));
  EXPECT_FALSE(guide.take(Acknowledgement{.agent = 1, .number = branch_number(1, 4000)}));
  AgentReport nowhere = fleet.report(2);
  nowhere.position.x = std::nan("");
  EXPECT_EQ(guide.take(nowhere).error().code, ErrorCode::kNotFinite);
  Guidance guidance;
  EXPECT_EQ(guide.step(fleet.now(), guidance).error().code, ErrorCode::kTimeOrder);
  fleet.step();
  EXPECT_EQ(fleet.told(2).contract, Contract::kKept);
  GuideOptions options = small_options();
  options.epoch = 0;
  EXPECT_FALSE(Guide::make(options));
  options = small_options();
  options.threshold_m = -1.0;
  EXPECT_EQ(Guide::make(options).error().code, ErrorCode::kInvalidThreshold);
  options = small_options();
  options.figures = some_figures();
  options.figures.correction_mps = 0.1;
  EXPECT_FALSE(Guide::make(options));
}

TEST(Guide, APlaneHasOneHeight) {
  GuideOptions options = small_options();
  options.planar = true;
  SmallFleet fleet(options);
  fleet.join(1, {0, 0, 4});
  EXPECT_FALSE(fleet.guide().join({.agent = 2, .position = {50, 0, 3}}));
  fleet.join(2, {50, 0, 4});
  ASSERT_TRUE(fleet.guide().set_goal(1, {50, 3, 4}));
  ASSERT_TRUE(fleet.guide().set_goal(2, {0, 0, 4}));
  for (int k = 0; k < 200; ++k) {
    fleet.step();
    EXPECT_TRUE(fleet.told(1).certified || fleet.now() < 3) << k;
    EXPECT_EQ(fleet.place(1).z, 4.0);
    ASSERT_GE(fleet.closest_m(), 5.0);
  }
  EXPECT_LE(distance(fleet.place(2), {0, 0, 4}), 1.0);
}

TEST(Guide, GivesWayToIntrudersAndNamesThoseThatCannotBe) {
  SmallFleet fleet(small_options());
  fleet.join(1, {0, 0, 0});
  for (int k = 0; k < 5; ++k) fleet.step();
  const std::vector<Intruder> both = {{.mover = {{std::nan(""), 0, 0}, {}}},
                                      {.mover = {{60, 0.5, 0}, {-6, 0, 0}}, .radius_m = 3.0}};
  const Status refused = fleet.guide().set_intruders(both);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(refused.error().location.record, 0U);
  double closest = 1e9;
  for (int k = 0; k < 150; ++k) {
    fleet.step();
    EXPECT_FALSE(fleet.told(1).clear_of_intruders);
    const Point intruder{60 - 0.6 * k, 0.5, 0};
    closest = std::min(closest, distance(fleet.place(1), intruder));
    for (const AgentAndObject& conflict : fleet.guidance().intruder_conflicts) {
      EXPECT_EQ(conflict.object, 1U);
    }
  }
  EXPECT_GT(closest, 8.0);
  ASSERT_TRUE(fleet.guide().set_intruders({}));
  fleet.step();
  EXPECT_TRUE(fleet.told(1).clear_of_intruders);
}

// What flies across an agent's way now is met before a command of now takes effect.
TEST(Guide, SeesIntrudersOnTheWayToWhereCommandsDepart) {
  GuideOptions options = small_options();
  options.threshold_m = 2.0;
  options.link = {.period_s = 0.5, .command_delay = 3, .longest_loss = 4};
  options.limits = {6.0, 6.0};
  std::mt19937 random(5);
  const auto any = [&](double most) {
    return std::uniform_real_distribution<double>(-most, most)(random);
  };
  int met = 0;
  int early = 0;
  for (int round = 0; round < 300; ++round) {
    SmallFleet fleet(options);
    fleet.join(1, {0, 0, 0});
    const double apart_m = 2.0 + fleet.guide().tube(1).value().radius_m;
    for (int k = 0; k < 14; ++k) {
      if (k % 7 == 1) {
        ASSERT_TRUE(fleet.guide().set_goal(1, Point{any(20), any(20), any(20)}));
      }
      fleet.step();
    }
    const Point here = fleet.place(1);
    const Mover intruder{{here.x + any(4), here.y + any(4), here.z + any(4)},
                         {any(8), any(8), any(8)}};
    ASSERT_TRUE(fleet.guide().set_intruders({{{.mover = intruder}}}));
    fleet.step();
    const bool said_clear = fleet.told(1).clear_of_intruders;
    const bool said_conflict = !fleet.guidance().intruder_conflicts.empty();
    EXPECT_EQ(said_clear, !said_conflict);
    EXPECT_FALSE(fleet.told(1).certified && said_conflict);
    // Its places at the ticks of the delay, where a command cannot change them any more.
    double closest = 1e9;
    for (int k = 0; k <= 3; ++k) {
      if (k > 0) fleet.step();
      const double s = 0.5 * k;
      const auto& [p, v] = intruder;
      closest = std::min(closest,
                         distance(fleet.place(1), {p.x + v.x * s, p.y + v.y * s, p.z + v.z * s}));
    }
    if (closest < apart_m - 1e-9) {
      ++met;
      EXPECT_FALSE(said_clear) << round << ": " << closest;
    }
    early += said_conflict ? 1 : 0;
  }
  EXPECT_GT(met, 25);
  EXPECT_LT(early, 290);
}

// An acknowledgement that the agent never sent rules out the branch that it is on.
TEST(Guide, AForgedAcknowledgementNamesTheAgent) {
  SmallFleet fleet(small_options());
  fleet.join(1, {0, 0, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {90, 0, 0}));
  for (int k = 0; k < 20; ++k) fleet.step();
  const BranchNumber held = fleet.follower(1).held();
  fleet.silent = [](AgentId, Tick) { return true; };
  fleet.step();
  ASSERT_EQ(fleet.guidance().commands.size(), 1U);
  const BranchNumber lost = fleet.guidance().commands[0].number;
  ASSERT_GT(lost, held);
  ASSERT_TRUE(
      fleet.guide().take(Acknowledgement{1, lost, CommandReply::kTaken, lost, fleet.now()}));
  fleet.step();
  EXPECT_FALSE(fleet.guide().take(fleet.report(1)));
  fleet.step();
  EXPECT_EQ(fleet.told(1).contract, Contract::kOut);
  EXPECT_EQ(fleet.told(1).reason, ContractReason::kNoBranch);
  EXPECT_FALSE(fleet.told(1).certified);
}

TEST(Guide, ANewPlannerTakesTheFleetOver) {
  const GuideOptions options = small_options();
  SmallFleet fleet(options);
  fleet.join(1, {0, 0, 0});
  fleet.join(2, {20, 0, 0});
  ASSERT_TRUE(fleet.guide().set_goal(1, {0, 90, 0}));
  for (int k = 0; k < 25; ++k) fleet.step();
  GuideOptions anew = options;
  anew.epoch = 2;
  Guide second = Guide::make(anew).value();
  const std::vector<AgentId> both = {1, 2};
  second.expect(both);
  Guidance guidance;
  for (const AgentId id : both) {
    ASSERT_TRUE(fleet.follower(id).promise(2));
    if (id == 2) {
      // Nothing is known of the second: the first cannot be certified.
      ASSERT_TRUE(second.step(fleet.now(), guidance));
      EXPECT_FALSE(guidance.agents.at(0).certified);
    }
    ASSERT_TRUE(second.adopt({.agent = id, .position = {}}, fleet.follower(id).stored()));
  }
  ASSERT_TRUE(second.set_goal(1, {0, 0, 0}));
  for (Tick tick = fleet.now() + 1; tick < fleet.now() + 200; ++tick) {
    for (const AgentId id : both) {
      const Follower& follower = fleet.follower(id);
      fleet.follower(id).advance(tick);
      ASSERT_TRUE(second.take(AgentReport{
          .agent = id, .held = follower.held(), .tick = tick, .position = fleet.place(id)}));
    }
    ASSERT_TRUE(second.step(tick, guidance));
    for (const Command& command : guidance.commands) {
      ASSERT_TRUE(second.take(fleet.follower(command.agent).receive(command)));
    }
    EXPECT_TRUE(guidance.agents.at(0).certified) << tick;
  }
  EXPECT_LE(distance(fleet.place(1), {0, 0, 0}), 1.0);
}

}  // namespace
}  // namespace beespace
