// What is shown of a fleet is what its planner had: the branches on which a bee may be are those
// that its claim is made of, though the log does not say so.
#include "analysis/scene/fleet_facts.hpp"
#include "io/fleet/fleet_writer.hpp"
#include "io/fleet/status_message.hpp"
#include "tests/guide/small_fleet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

struct Box {
  std::array<double, 3> least = {1e9, 1e9, 1e9};
  std::array<double, 3> most = {-1e9, -1e9, -1e9};

  void add(const Point& p) {
    const std::array<double, 3> at = {p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], at[i]);
      most[i] = std::max(most[i], at[i]);
    }
  }
  // Whether the other one lies in this one, or so far outside of it at most.
  [[nodiscard]] bool holds(const Box& other, double by_m) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (other.least[i] < least[i] - by_m || other.most[i] > most[i] + by_m) return false;
    }
    return true;
  }
};

constexpr AgentId kAgents = 8;

// Eight that swap their places through one another, over a link that loses; the log, and claims.
struct Flown {
  std::string log;
  std::map<std::pair<AgentId, Tick>, Box> claims;

  Flown(double losses, int command_delay) {
    GuideOptions options = small_options();
    options.figures = some_figures();
    options.link.command_delay = command_delay;
    options.link.longest_loss = 8;
    SmallFleet fleet(options);
    fleet.lose(losses, 5);
    for (AgentId id = 0; id < kAgents; ++id) {
      const double angle = 2.0 * 3.14159 * static_cast<double>(id) / kAgents;
      const Point start{30.0 * std::cos(angle), 30.0 * std::sin(angle), 20.0};
      fleet.join(id, start);
      EXPECT_TRUE(fleet.guide().set_goal(id, {-start.x, -start.y, 20.0}));
    }
    for (int k = 0; k < 250; ++k) add(fleet);
  }

  void add(SmallFleet& fleet) {
    const Guidance& guidance = fleet.step();
    for (const Command& command : guidance.commands) {
      const double braking_mps2 =
          fleet.guide().tube(command.agent).value().planned.max_acceleration_mps2;
      io::append_message(log, std::to_string(command.agent),
                         io::CommandMessage{command, 0.1, braking_mps2});
    }
    for (const AgentGuidance& told : guidance.agents) {
      io::append_status(log, std::to_string(told.agent), "none", guidance.tick, told);
      Box& box = claims[{told.agent, guidance.tick}];
      for (const Point& place : fleet.guide().claim(told.agent).value()) box.add(place);
    }
  }
};

io::FleetLog read(const std::string& text) {
  const auto log = io::read_fleet_log(text, "fleet.ndjson", false);
  EXPECT_TRUE(log.has_value()) << to_string(log.error());
  return log ? *log : io::FleetLog{};
}

// Of agents from 0 on, each there at time 0 and at the last one.
io::Recording recording_of(AgentId agents, double begins_s = 0.0, double ends_s = 25.0) {
  io::Recording recording;
  for (AgentId id = 0; id < agents; ++id) {
    recording.bees.push_back(
        {.id = std::to_string(id), .fixes = {{begins_s, {0, 0, 0}}, {ends_s, {0, 0, 0}}}});
  }
  return recording;
}

Result<report::FleetFacts> facts_of(const io::FleetLog& log, const io::Recording& recording,
                                    std::vector<std::string>& notes, bool skip_bad = false) {
  std::vector<Track> tracks;
  for (const io::RecordedBee& bee : recording.bees) tracks.push_back({.fixes = bee.fixes});
  return fleet_facts(log, recording, tracks, skip_bad, notes);
}

// All nominal places that are shown, from now on.
Box shown(const report::FleetBee& bee, const report::FleetState& state, std::uint32_t& branches) {
  Box box;
  box.add(state.nominal);
  auto at = state.newest;
  for (branches = 0; at && branches < state.branches; ++branches) {
    const report::FleetBranch& branch = bee.branches[*at];
    if (branch.at > state.tick) box.add(branch.place);
    box.add(branch.stop);
    at = branch.parent;
  }
  return box;
}

TEST(FleetFacts, TheBranchesThatAreShownAreThoseOfTheClaim) {
  for (const double losses : {0.0, 0.2, 0.5}) {
    for (const int delay : {1, 2, 5}) {
      const Flown flown(losses, delay);
      std::vector<std::string> notes;
      const auto facts = facts_of(read(flown.log), recording_of(kAgents), notes);
      ASSERT_TRUE(facts.has_value()) << to_string(facts.error());
      EXPECT_TRUE(notes.empty());
      std::uint32_t most = 0;
      for (AgentId id = 0; id < kAgents; ++id) {
        const report::FleetBee& bee = facts->bees[id];
        ASSERT_EQ(bee.states.size(), 250U);
        for (const report::FleetState& state : bee.states) {
          std::uint32_t branches = 0;
          const Box box = shown(bee, state, branches);
          ASSERT_EQ(branches, state.branches)
              << id << " at tick " << state.tick << ", losses " << losses << ", delay " << delay;
          most = std::max(most, branches);
          const Box& claim = flown.claims.at({id, state.tick});
          // A claim begins a tick earlier, and ends half a tick of flight later.
          ASSERT_TRUE(claim.holds(box, 1e-6)) << id << " at tick " << state.tick;
          ASSERT_TRUE(box.holds(claim, 1.2)) << id << " at tick " << state.tick;
        }
      }
      EXPECT_GE(most, losses > 0.0 ? 3U : 1U);
    }
  }
}

TEST(FleetFacts, ABranchEndsWhereItsBrakingDoes) {
  Command command;
  command.number = branch_number(1, 1);
  command.starts = 4;
  command.state_count = 1;
  command.states[0] = {{{10, 0, 5}, {8, 0, 0}}, {}};
  std::string text;
  io::append_message(text, "0", io::CommandMessage{command, 0.5, 4.0});
  AgentGuidance told;
  told.nominal = {{13.5, 0, 5}, {6, 0, 0}};
  told.branches = 1;
  io::append_status(text, "0", "none", 5, told);
  std::vector<std::string> notes;
  const auto facts = facts_of(read(text), recording_of(1), notes);
  ASSERT_TRUE(facts.has_value()) << to_string(facts.error());
  const report::FleetBee& bee = facts->bees.front();
  ASSERT_EQ(bee.branches.size(), 1U);
  EXPECT_EQ(bee.branches[0].at, 4);
  EXPECT_EQ(bee.branches[0].place, (Point{10, 0, 5}));
  EXPECT_DOUBLE_EQ(bee.branches[0].stop.x, 18.0);
  EXPECT_DOUBLE_EQ(bee.branches[0].braking_s, 2.0);
  EXPECT_EQ(bee.states[0].newest, 0U);
  EXPECT_EQ(facts->period_s, 0.5);
}

TEST(FleetFacts, ABranchThatIsNotInTheLogIsNotGuessed) {
  Command command;
  command.number = branch_number(2, 1);
  command.starts = 4;
  command.state_count = 1;
  std::string text;
  io::append_message(text, "0", io::CommandMessage{command, 0.1, 4.0});
  AgentGuidance told;
  told.nominal.position = {7, 7, 7};
  io::append_status(text, "0", "none", 5, told);
  std::vector<std::string> notes;
  const auto facts = facts_of(read(text), recording_of(1), notes);
  ASSERT_TRUE(facts.has_value()) << to_string(facts.error());
  EXPECT_EQ(facts->bees[0].states[0].newest, std::nullopt);
  EXPECT_EQ(facts->bees[0].branches[0].parent, std::nullopt);
}

TEST(FleetFacts, ALogOfAnotherFlightIsAnError) {
  const io::FleetLog log = read(Flown(0.0, 2).log);
  std::vector<std::string> notes;
  const auto error_of = [&](const io::Recording& recording) {
    const auto facts = facts_of(log, recording, notes);
    EXPECT_FALSE(facts.has_value());
    return facts ? "" : to_string(facts.error());
  };
  // Of the last agent the first line is its first command.
  EXPECT_EQ(error_of(recording_of(kAgents - 1)),
            "fleet.ndjson:8: agent '7' is not in the recording; give the recording of the same "
            "flight, with the ids of its log, or --skip-bad to leave such agents out");
  EXPECT_EQ(error_of(recording_of(kAgents, 100.0, 120.5)),
            "fleet.ndjson: this log is of the times from 0.1 to 25 s (ticks times their period), "
            "and the recording of those from 100 to 120.5 s; give the log of the same flight, by "
            "the same clock");
  io::Recording degrees = recording_of(kAgents);
  degrees.frame = io::Frame::kWgs84;
  EXPECT_NE(error_of(degrees).find("the recording is in degrees"), std::string::npos);
}

TEST(FleetFacts, AgentsThatTheRecordingLacksAreLeftOutWhenAsked) {
  const io::FleetLog log = read(Flown(0.0, 2).log);
  std::vector<std::string> notes;
  const auto facts = facts_of(log, recording_of(kAgents - 2), notes, true);
  ASSERT_TRUE(facts.has_value()) << to_string(facts.error());
  EXPECT_EQ(facts->bees.size(), kAgents - 2);
  EXPECT_EQ(notes, std::vector<std::string>{
                       "agents of the fleet's log that the recording lacks, left out: 2"});
}

TEST(FleetFacts, ABeeOfWhichNothingIsSaidHasNothing) {
  const io::FleetLog log = read(Flown(0.0, 2).log);
  std::vector<std::string> notes;
  const auto facts = facts_of(log, recording_of(kAgents + 1), notes);
  ASSERT_TRUE(facts.has_value()) << to_string(facts.error());
  EXPECT_TRUE(facts->bees.back().states.empty());
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace beespace::analysis
