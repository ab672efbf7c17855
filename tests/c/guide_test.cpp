// A guide and followers of C say what those of C++ say, bit by bit, while messages between them are
// lost, late, doubled and put out of order.
#include "tests/c/guide_scenes.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <random>
#include <vector>

namespace beespace::test {
namespace {

void expect_command(const beespace_command& found, const Command& expected) {
  EXPECT_EQ(cpp_agent(found.agent), expected.agent);
  EXPECT_EQ(found.number, expected.number);
  EXPECT_EQ(found.starts, expected.starts);
  ASSERT_EQ(static_cast<std::size_t>(found.state_count), expected.path().size());
  for (std::size_t i = 0; i < expected.path().size(); ++i) {
    static_assert(sizeof(BranchState) == sizeof(beespace_branch_state));
    EXPECT_EQ(std::memcmp(&found.states[i], &expected.states[i], sizeof(BranchState)), 0);
  }
  ASSERT_EQ(static_cast<std::size_t>(found.ancestor_count), expected.departs_from().size());
  for (std::size_t i = 0; i < expected.departs_from().size(); ++i) {
    EXPECT_EQ(found.ancestors[i].number, expected.ancestors[i].number);
    EXPECT_EQ(found.ancestors[i].departs, expected.ancestors[i].departs);
  }
}

template <class Found>
void expect_objects(const beespace_guidance* guidance, std::int32_t what,
                    const std::vector<Found>& expected) {
  auto list = sized<beespace_findings>();
  ASSERT_EQ(beespace_guidance_findings(guidance, what, &list, nullptr), BEESPACE_OK);
  ASSERT_EQ(list.count, static_cast<std::int64_t>(expected.size()));
  EXPECT_EQ(list.times_s, nullptr);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(cpp_agent(list.first[i]), expected[i].agent);
    EXPECT_EQ(list.second[i], static_cast<std::int64_t>(expected[i].object));
    EXPECT_EQ(list.distances_m[i], expected[i].gap_m);
  }
}

void expect_same(const beespace_guidance* found, const Guidance& expected) {
  EXPECT_EQ(beespace_guidance_tick(found), expected.tick);
  ASSERT_EQ(beespace_guidance_size(found), static_cast<std::int64_t>(expected.agents.size()));
  for (std::size_t i = 0; i < expected.agents.size(); ++i) {
    const AgentGuidance& one = expected.agents[i];
    EXPECT_EQ(cpp_agent(beespace_guidance_agents(found)[i]), one.agent);
    EXPECT_EQ(beespace_guidance_contracts(found)[i], static_cast<int>(one.contract));
    EXPECT_EQ(beespace_guidance_reasons(found)[i], static_cast<int>(one.reason));
    EXPECT_EQ(beespace_guidance_certified(found)[i], one.certified ? 1 : 0);
    EXPECT_EQ(beespace_guidance_keeps_apart(found)[i], one.keeps_apart ? 1 : 0);
    EXPECT_EQ(beespace_guidance_clear_of_intruders(found)[i], one.clear_of_intruders ? 1 : 0);
    EXPECT_EQ(beespace_guidance_kinds(found)[i], static_cast<int>(one.kind));
    EXPECT_EQ(beespace_guidance_commanded(found)[i], one.commanded ? 1 : 0);
    EXPECT_EQ(beespace_guidance_branches(found)[i], static_cast<std::int32_t>(one.branches));
    EXPECT_EQ(std::memcmp(beespace_guidance_positions(found) + 3 * i, &one.nominal.position,
                          sizeof(Point)),
              0);
    EXPECT_EQ(std::memcmp(beespace_guidance_velocities(found) + 3 * i, &one.nominal.velocity,
                          sizeof(Velocity)),
              0);
    EXPECT_EQ(beespace_guidance_tubes_m(found)[i], one.tube_m);
    EXPECT_EQ(beespace_guidance_deviations_m(found)[i], one.deviation_m);
  }
  ASSERT_EQ(beespace_guidance_command_count(found),
            static_cast<std::int64_t>(expected.commands.size()));
  for (std::size_t i = 0; i < expected.commands.size(); ++i) {
    expect_command(*beespace_guidance_command(found, static_cast<std::int64_t>(i)),
                   expected.commands[i]);
  }
  auto pairs = sized<beespace_findings>();
  ASSERT_EQ(beespace_guidance_findings(found, BEESPACE_TOO_CLOSE, &pairs, nullptr), BEESPACE_OK);
  ASSERT_EQ(pairs.count, static_cast<std::int64_t>(expected.pairs.size()));
  for (std::size_t i = 0; i < expected.pairs.size(); ++i) {
    EXPECT_EQ(cpp_agent(pairs.first[i]), expected.pairs[i].first);
    EXPECT_EQ(cpp_agent(pairs.second[i]), expected.pairs[i].second);
    EXPECT_EQ(pairs.distances_m[i], expected.pairs[i].gap_m);
    EXPECT_EQ(pairs.times_s[i], expected.pairs[i].clear_s);
  }
  expect_objects(found, BEESPACE_NEAR_OBSTACLE, expected.near_obstacle);
  expect_objects(found, BEESPACE_NEAR_FENCE, expected.near_fence);
  expect_objects(found, BEESPACE_INTRUDER_CONFLICTS, expected.intruder_conflicts);
}

Command cpp_command(const beespace_command& given) {
  Command all;
  all.agent = cpp_agent(given.agent);
  all.number = given.number;
  all.starts = given.starts;
  all.state_count = static_cast<std::uint32_t>(given.state_count);
  all.ancestor_count = static_cast<std::uint32_t>(given.ancestor_count);
  std::memcpy(all.states.data(), given.states, sizeof given.states);
  for (std::size_t i = 0; i < all.ancestors.size(); ++i) {
    all.ancestors[i] = {given.ancestors[i].number, given.ancestors[i].departs};
  }
  return all;
}

void expect_same_setpoint(const Agent& agent) {
  if (agent.cpp.held() == 0) return;
  auto found = sized<beespace_setpoint>();
  ASSERT_EQ(beespace_follower_setpoint(agent.follower.get(), 0.03, &found, nullptr), BEESPACE_OK);
  const Setpoint expected = agent.cpp.setpoint(0.03);
  EXPECT_EQ(std::memcmp(found.position, &expected.nominal.position, sizeof(Point)), 0);
  EXPECT_EQ(std::memcmp(found.velocity, &expected.nominal.velocity, sizeof(Velocity)), 0);
  EXPECT_EQ(std::memcmp(found.correction, &expected.correction, sizeof(Velocity)), 0);
  EXPECT_EQ(found.holding, expected.holding ? 1 : 0);
}

TEST_F(CGuide, SaysWhatThatOfCppSaysWhateverBecomesOfMessages) {
  const std::vector<Point> inward = {{0.0, 0.0, 1.0}};
  const std::vector<Fence> fences = {{inward[0], 0.0}};
  const double offset_m = 0.0;
  const beespace_points c_inward = c_vectors(inward);
  options_.fence_directions = &c_inward;
  options_.fence_offsets_m = &offset_m;
  options_.clearance_m = 2.0;
  make();
  GuideOptions cpp_options = CGuide::cpp_options();
  cpp_options.fences = fences;
  cpp_options.clearance_m = 2.0;
  Guide cpp = *Guide::make(cpp_options);
  std::vector<Agent> agents;
  // Negative numbers are numbers of agents, too.
  const std::vector<std::int64_t> ids = {7, 12, 1'000'000'007, -3, -9};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Point place{9.0 * static_cast<double>(i), 0.0, 10.0};
    ASSERT_TRUE(join(ids[i], place));
    const JoinRequest asked{.agent = cpp_agent(ids[i]), .position = place};
    ASSERT_TRUE((*cpp.join(asked)).joined);
    const std::array goal = {36.0 - place.x, 20.0, 10.0};
    ASSERT_EQ(beespace_guide_set_goal(guide_.get(), ids[i], goal.data(), &error_), BEESPACE_OK);
    ASSERT_TRUE(cpp.set_goal(cpp_agent(ids[i]), {goal[0], goal[1], goal[2]}));
    agents.push_back(make_agent(ids[i], *cpp.tube(cpp_agent(ids[i]))));
  }
  EXPECT_EQ(beespace_guide_size(guide_.get()), 5);
  std::mt19937 random(5);
  Guidance expected;
  std::size_t commands = 0;
  std::size_t taken = 0;
  for (Tick tick = 1; tick <= 200; ++tick) {
    if (tick == 40) {
      const std::array velocity = {0.0, 0.0, -3.0};
      beespace_guide_set_preferred(guide_.get(), 7, velocity.data(), nullptr);
      (void)cpp.set_preferred(cpp_agent(7), {0.0, 0.0, -3.0});
    }
    if (tick == 60) {
      const std::vector<Intruder> all = {{{{18.0, -20.0, 10.0}, {0.0, 4.0, 0.0}}, 0.5, 0.2, 0.1}};
      const std::vector<Mover> movers = {all[0].mover};
      const beespace_points at = beespace_points_interleaved(&movers[0].position.x, 1);
      const beespace_points speed = beespace_points_interleaved(&movers[0].velocity.x, 1);
      ASSERT_EQ(
          beespace_guide_set_intruders(guide_.get(), &at, &speed, &all[0].radius_m,
                                       &all[0].position_error_m, &all[0].speed_error_mps, &error_),
          BEESPACE_OK);
      ASSERT_TRUE(cpp.set_intruders(all));
    }
    if (tick == 150) {
      const std::int64_t unknown = 99;
      ASSERT_EQ(beespace_guide_expect(guide_.get(), &unknown, 1, nullptr), BEESPACE_OK);
      const std::array<AgentId, 1> same = {cpp_agent(99)};
      cpp.expect(same);
    }
    step(tick);
    ASSERT_TRUE(cpp.step(tick, expected));
    expect_same(guidance_.get(), expected);
    commands += expected.commands.size();
    for (std::int64_t k = 0; k < beespace_guidance_command_count(guidance_.get()); ++k) {
      const beespace_command& command = *beespace_guidance_command(guidance_.get(), k);
      const auto to = std::find(ids.begin(), ids.end(), command.agent) - ids.begin();
      for (int copy = 0; copy < 2; ++copy) {
        if (random() % 3 == 0) continue;  // lost
        agents[static_cast<std::size_t>(to)].under_way.emplace(
            tick + static_cast<Tick>(random() % 4), command);
      }
    }
    for (std::size_t i = 0; i < agents.size(); ++i) {
      Agent& agent = agents[i];
      beespace_follower_advance(agent.follower.get(), tick);
      agent.cpp.advance(tick);
      while (!agent.under_way.empty() && agent.under_way.begin()->first <= tick) {
        const beespace_command command = agent.under_way.begin()->second;
        agent.under_way.erase(agent.under_way.begin());
        auto reply = sized<beespace_acknowledgement>();
        ASSERT_EQ(beespace_follower_receive(agent.follower.get(), &command, &reply, &error_),
                  BEESPACE_OK);
        const Acknowledgement said = agent.cpp.receive(cpp_command(command));
        EXPECT_EQ(reply.reply, static_cast<int>(said.reply) + 1);
        EXPECT_EQ(reply.number, said.number);
        EXPECT_EQ(reply.held, said.held);
        EXPECT_EQ(reply.tick, said.tick);
        taken += said.reply == CommandReply::kTaken ? 1 : 0;
        if (random() % 4 == 0) continue;
        ASSERT_EQ(beespace_guide_take_acknowledgement(guide_.get(), &reply, &error_), BEESPACE_OK);
        ASSERT_TRUE(cpp.take(said));
      }
      expect_same_setpoint(agent);
      EXPECT_EQ(beespace_follower_held(agent.follower.get()), agent.cpp.held());
      EXPECT_EQ(beespace_follower_tick(agent.follower.get()), tick);
      if (agent.cpp.held() == 0 || random() % 3 == 0) continue;
      auto report = sized<beespace_agent_report>();
      report.agent = ids[i];
      report.held = agent.cpp.held();
      report.tick = tick;
      report.after_s = 0.03;
      const Setpoint at = agent.cpp.setpoint(0.03);
      report.position[0] = at.nominal.position.x + (i == 2 && tick > 120 ? 8.0 : 0.05);
      report.position[1] = at.nominal.position.y;
      report.position[2] = at.nominal.position.z;
      AgentReport same{cpp_agent(ids[i]), report.held, tick, 0.03, at.nominal.position};
      same.position.x = report.position[0];
      if (i == 1) {
        report.flags = BEESPACE_WITH_VELOCITY;
        std::memcpy(report.velocity, &at.nominal.velocity, sizeof report.velocity);
        same.velocity = at.nominal.velocity;
      }
      ASSERT_EQ(beespace_guide_take_report(guide_.get(), &report, &error_), BEESPACE_OK)
          << error_.message;
      ASSERT_TRUE(cpp.take(same));
    }
    if (tick == 110) {
      EXPECT_TRUE(std::all_of(expected.agents.begin(), expected.agents.end(),
                              [](const AgentGuidance& a) { return a.keeps_apart; }));
    }
  }
  EXPECT_GT(commands, 100U);
  EXPECT_GT(taken, 50U);
  EXPECT_EQ(beespace_guidance_contracts(guidance_.get())[4], BEESPACE_CONTRACT_OUT);
  EXPECT_EQ(beespace_guidance_certified(guidance_.get())[0], 0);
  const double* claim = nullptr;
  std::int64_t places = 0;
  ASSERT_EQ(beespace_guide_claim(guide_.get(), 12, &claim, &places, &error_), BEESPACE_OK);
  const std::vector<Point> same = *cpp.claim(cpp_agent(12));
  ASSERT_EQ(places, static_cast<std::int64_t>(same.size()));
  EXPECT_EQ(std::memcmp(claim, same.data(), same.size() * sizeof(Point)), 0);
}

}  // namespace
}  // namespace beespace::test
