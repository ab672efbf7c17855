// What callers of a guide and of followers get wrong becomes an error that says where; who is in
// the fleet and why another is not is said; and both go on after a restart.
#include "tests/c/guide_scenes.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST_F(CGuide, WhoIsInTheFleetIsSaid) {
  const beespace_obstacle ground = [] {
    auto made = sized<beespace_obstacle>();
    made.kind = BEESPACE_GROUND;
    made.high[2] = 0.0;
    return made;
  }();
  beespace_obstacles* obstacles = nullptr;
  ASSERT_EQ(beespace_obstacles_create(&ground, 1, &obstacles, nullptr), BEESPACE_OK);
  options_.obstacles = obstacles;
  options_.clearance_m = 2.0;
  make();
  beespace_obstacles_free(obstacles);  // the guide has a copy
  EXPECT_TRUE(join(1, {0.0, 0.0, 10.0}));
  EXPECT_EQ(answer_.touches, nullptr);
  EXPECT_FALSE(join(2, {1.0, 0.0, 10.0}));
  ASSERT_EQ(answer_.touch_count, 1);
  EXPECT_EQ(answer_.touches[0], 1);
  EXPECT_FALSE(join(2, {30.0, 0.0, 1.0}));
  ASSERT_EQ(answer_.obstacle_count, 1);
  EXPECT_EQ(answer_.obstacles[0], 0);
  beespace_join_request asked = request(2, {30.0, 0.0, 10.0});
  asked.figures = &figures_;
  asked.max_speed_mps = 3.0;
  asked.max_acceleration_mps2 = 2.5;
  ASSERT_EQ(beespace_guide_may_join(guide_.get(), &asked, &answer_, &error_), BEESPACE_OK);
  EXPECT_EQ(answer_.joined, 0);
  EXPECT_EQ(answer_.touch_count + answer_.obstacle_count + answer_.fence_count, 0);
  EXPECT_EQ(beespace_guide_size(guide_.get()), 1);
  ASSERT_EQ(beespace_guide_join(guide_.get(), &asked, &answer_, &error_), BEESPACE_OK);
  EXPECT_EQ(answer_.joined, 1);
  auto tube = sized<beespace_tube>();
  ASSERT_EQ(beespace_guide_tube(guide_.get(), 2, &tube, &error_), BEESPACE_OK);
  auto own = sized<beespace_tube>();
  ASSERT_EQ(beespace_tube_of(&figures_, &link_, 3.0, 2.5, &own, &error_), BEESPACE_OK);
  EXPECT_EQ(std::memcmp(&tube, &own, sizeof tube), 0);
  EXPECT_EQ(own.radius_m, (*tube_of(kFigures, kLink, {3.0, 2.5})).radius_m);
  EXPECT_EQ(own.planned_speed_mps, 2.0);
  const auto refused = [&](beespace_code code, const char* place, beespace_code expected) {
    EXPECT_EQ(code, expected);
    EXPECT_STREQ(error_.place, place) << error_.message;
    error_ = c_error();
  };
  beespace_guide* const guide = guide_.get();
  refused(beespace_guide_join(guide, &asked, &answer_, &error_), "agents",
          BEESPACE_INVALID_ARGUMENT);
  asked.agent = 3;
  asked.position[1] = kNaN;
  refused(beespace_guide_join(guide, &asked, &answer_, &error_), "agents", BEESPACE_NOT_FINITE);
  asked.position[1] = 30.0;
  asked.struct_size = 8;
  refused(beespace_guide_join(guide, &asked, &answer_, &error_), "request",
          BEESPACE_INVALID_ARGUMENT);
  asked = request(3, {0.0, 30.0, 10.0});
  answer_.struct_size = 0;
  refused(beespace_guide_join(guide, &asked, &answer_, &error_), "answer",
          BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_guide_size(guide), 2);  // none joins without an answer
  refused(beespace_guide_leave(guide, 3, &error_), "agents", BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_guide_leave(guide, 2, &error_), BEESPACE_OK);
  EXPECT_EQ(beespace_guide_size(guide), 1);
  refused(beespace_guide_tube(guide, 2, &tube, &error_), "agents", BEESPACE_INVALID_ARGUMENT);
  const std::array<double, 3> nowhere = {kNaN, 0.0, 0.0};
  refused(beespace_guide_set_goal(guide, 1, nowhere.data(), &error_), "agents",
          BEESPACE_NOT_FINITE);
  refused(beespace_guide_set_goal(guide, 1, nullptr, &error_), "goal", BEESPACE_INVALID_ARGUMENT);
  refused(beespace_guide_set_preferred(guide, 1, nullptr, &error_), "velocity",
          BEESPACE_INVALID_ARGUMENT);
  refused(beespace_guide_expect(guide, nullptr, 1, &error_), "agents", BEESPACE_INVALID_ARGUMENT);
  refused(beespace_guide_expect(guide, nullptr, -1, &error_), "agents", BEESPACE_INVALID_ARGUMENT);
  refused(beespace_guide_claim(guide, 1, nullptr, nullptr, &error_), "xyz",
          BEESPACE_INVALID_ARGUMENT);
}

// Each changes the tube, or whether there is one, as it does in C++.
TEST_F(CGuide, EachFigureCounts) {
  const auto tube_now = [&](FleetFigures figures, const LinkFigures& link) {
    auto found = sized<beespace_tube>();
    const beespace_code code = beespace_tube_of(&figures_, &link_, 6.0, 4.0, &found, &error_);
    const Result<Tube> expected = tube_of(figures, link, {6.0, 4.0});
    EXPECT_EQ(code == BEESPACE_OK, expected.has_value());
    if (!expected) return Tube{};
    const Tube same{found.radius_m,
                    found.clock_m,
                    found.error_m,
                    found.gain_per_s,
                    found.correction_mps2,
                    found.correction_mps,
                    {found.planned_speed_mps, found.planned_acceleration_mps2}};
    EXPECT_EQ(same, *expected);
    return same;
  };
  const Tube usual = tube_now(kFigures, kLink);
  const auto expect_counts = [&](double beespace_fleet_figures::*of_c, double FleetFigures::*of_cpp,
                                 bool on_ground) {
    figures_ = c_figures();
    link_ = c_link();
    FleetFigures figures = kFigures;
    LinkFigures link = kLink;
    if (on_ground) {
      figures_.loop = BEESPACE_LOOP_GROUND;
      figures.loop = LoopPlace::kGround;
      link_.longest_loss = link.longest_loss = 0;
    }
    const Tube before = tube_now(figures, link);
    figures_.*of_c = figures.*of_cpp = figures_.*of_c * 0.875;
    EXPECT_NE(tube_now(figures, link), before);
  };
  using C = beespace_fleet_figures;
  using Cpp = FleetFigures;
  expect_counts(&C::report_error_m, &Cpp::report_error_m, true);
  expect_counts(&C::report_age_s, &Cpp::report_age_s, true);
  expect_counts(&C::sensing_error_m, &Cpp::sensing_error_m, false);
  expect_counts(&C::loop_period_s, &Cpp::loop_period_s, false);
  expect_counts(&C::loop_delay_s, &Cpp::loop_delay_s, false);
  expect_counts(&C::deviation_mps, &Cpp::deviation_mps, false);
  expect_counts(&C::clock_error_s, &Cpp::clock_error_s, false);
  expect_counts(&C::correction_mps2, &Cpp::correction_mps2, false);
  expect_counts(&C::correction_mps, &Cpp::correction_mps, false);
  figures_ = c_figures();
  link_ = c_link();
  figures_.loop = BEESPACE_LOOP_GROUND;
  FleetFigures ground = kFigures;
  ground.loop = LoopPlace::kGround;
  EXPECT_EQ(tube_now(ground, kLink), Tube{});  // messages get lost
  link_.longest_loss = 0;
  LinkFigures slow = kLink;
  slow.longest_loss = 0;
  const Tube at_once = tube_now(ground, slow);
  EXPECT_NE(at_once, Tube{});
  link_.period_s = slow.period_s = 0.15;
  link_.command_delay = slow.command_delay = 3;
  EXPECT_NE(tube_now(ground, slow), at_once);
  EXPECT_NE(usual, at_once);
}

TEST_F(CGuide, OptionsThatMakeNoSenseAreRefused) {
  const beespace_guide_options good = options_;
  const auto refuse = [&](auto&& change, const char* place,
                          beespace_code code = BEESPACE_INVALID_ARGUMENT) {
    options_ = good;
    figures_ = c_figures();
    link_ = c_link();
    change(options_);
    refuse_options(place, code);
  };
  using Options = beespace_guide_options;
  refuse([](Options& o) { o.struct_size = 1; }, "options");
  refuse([](Options& o) { o.reserved = 1; }, "options");
  refuse([](Options& o) { o.more_reserved = 1; }, "options");
  refuse([](Options& o) { o.flags = 8; }, "options");
  refuse([](Options& o) { o.threshold_m = 0.0; }, "", BEESPACE_INVALID_THRESHOLD);
  refuse([](Options& o) { o.shape = -1; }, "options");
  refuse([](Options& o) { o.vertical_m = 2.0; }, "options");
  refuse([](Options& o) { o.vertical_factor = 2.0; }, "options");
  refuse([](Options& o) { o.max_acceleration_mps2 = 0.0; }, "");
  refuse([](Options& o) { o.max_acceleration_mps2 = INFINITY; }, "");
  refuse([&](Options&) { figures_.loop = 2; }, "figures");
  refuse([&](Options&) { figures_.struct_size = 0; }, "figures");
  refuse([&](Options&) { figures_.deviation_mps = -1.0; }, "");
  refuse([&](Options&) { link_.reserved = 1; }, "link");
  refuse([&](Options&) { link_.command_delay = 33; }, "");
  refuse([&](Options& o) { o.fence_offsets_m = &o.threshold_m; }, "fence_directions");
  EXPECT_EQ(beespace_guide_create(nullptr, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  auto tube = sized<beespace_tube>();
  EXPECT_EQ(beespace_tube_of(nullptr, nullptr, 6.0, 4.0, &tube, nullptr), BEESPACE_OK);
  EXPECT_EQ(tube.radius_m, (*tube_of({}, {}, {6.0, 4.0})).radius_m);
  tube.struct_size = 16;
  EXPECT_EQ(beespace_tube_of(nullptr, nullptr, 6.0, 4.0, &tube, nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CGuide, MessagesThatCannotBeAreRefused) {
  make();
  ASSERT_TRUE(join(1, {0.0, 0.0, 10.0}));
  step(1);
  ASSERT_EQ(beespace_guidance_command_count(guidance_.get()), 1);
  const auto refused = [&](beespace_code code, const char* place) {
    EXPECT_EQ(code, BEESPACE_INVALID_ARGUMENT);
    EXPECT_STREQ(error_.place, place) << error_.message;
    error_ = c_error();
  };
  beespace_guide* const guide = guide_.get();
  auto reply = sized<beespace_acknowledgement>();
  reply.agent = 1;
  refused(beespace_guide_take_acknowledgement(guide, &reply, &error_), "acknowledgement");
  reply.reply = BEESPACE_REPLY_TAKEN;
  reply.number = 77;
  refused(beespace_guide_take_acknowledgement(guide, &reply, &error_), "agents");
  refused(beespace_guide_take_acknowledgement(guide, nullptr, &error_), "acknowledgement");
  auto report = sized<beespace_agent_report>();
  report.agent = 2;
  refused(beespace_guide_take_report(guide, &report, &error_), "agents");
  report.flags = 4;
  refused(beespace_guide_take_report(guide, &report, &error_), "report");
  refused(beespace_guide_take_report(nullptr, &report, &error_), "guide");
  EXPECT_EQ(beespace_guide_step(guide, 1, nullptr, guidance_.get(), &error_), BEESPACE_TIME_ORDER);
  EXPECT_EQ(beespace_guidance_size(guidance_.get()), 0);
  EXPECT_EQ(beespace_guidance_command(guidance_.get(), 0), nullptr);
  refused(beespace_guide_step(guide, 5, nullptr, nullptr, &error_), "guidance");
  // An intruder that may be anywhere.
  const std::array<double, 3> nowhere = {kNaN, 0.0, 0.0};
  const beespace_points at = beespace_points_interleaved(nowhere.data(), 1);
  EXPECT_EQ(beespace_guide_set_intruders(guide, &at, &at, nullptr, nullptr, nullptr, &error_),
            BEESPACE_NOT_FINITE);
  EXPECT_EQ(error_.record, 0);
  step(6);
  EXPECT_EQ(beespace_guidance_clear_of_intruders(guidance_.get())[0], 0);
  auto list = sized<beespace_findings>();
  refused(beespace_guidance_findings(guidance_.get(), BEESPACE_NEAR_UNKNOWN, &list, &error_),
          "what");
  EXPECT_EQ(beespace_guidance_size(nullptr), 0);
  EXPECT_EQ(beespace_guidance_command(nullptr, 0), nullptr);
}

TEST_F(CGuide, AFollowerGoesOnAfterARestartAndAPlannerAdoptsIt) {
  make();
  ASSERT_TRUE(join(1, {0.0, 0.0, 10.0}));
  step(1);
  const beespace_command root = *beespace_guidance_command(guidance_.get(), 0);
  Agent agent = make_agent(1, *tube_of(kFigures, kLink, {6.0, 4.0}));
  beespace_follower* const follower = agent.follower.get();
  auto point = sized<beespace_setpoint>();
  EXPECT_EQ(beespace_follower_setpoint(follower, 0.0, &point, nullptr), BEESPACE_INVALID_ARGUMENT);
  beespace_follower_advance(follower, 2);
  auto reply = sized<beespace_acknowledgement>();
  beespace_command broken = root;
  broken.state_count = -1;
  ASSERT_EQ(beespace_follower_receive(follower, &broken, &reply, &error_), BEESPACE_OK);
  EXPECT_EQ(reply.reply, BEESPACE_REPLY_INVALID);
  broken.struct_size = 8;
  EXPECT_EQ(beespace_follower_receive(follower, &broken, &reply, &error_),
            BEESPACE_INVALID_ARGUMENT);
  reply.struct_size = 1;
  EXPECT_EQ(beespace_follower_receive(follower, &root, &reply, &error_), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_follower_held(follower), 0U);  // nothing is taken without a reply
  reply.struct_size = sizeof reply;
  ASSERT_EQ(beespace_follower_receive(follower, &root, &reply, &error_), BEESPACE_OK);
  EXPECT_EQ(reply.reply, BEESPACE_REPLY_TAKEN);
  EXPECT_EQ(beespace_follower_held(follower), root.number);
  for (const double after_s : {-0.1, kNaN}) {
    EXPECT_EQ(beespace_follower_setpoint(follower, after_s, &point, nullptr),
              BEESPACE_INVALID_ARGUMENT);
  }
  EXPECT_EQ(beespace_follower_promise(follower, 2), 1);
  EXPECT_EQ(beespace_follower_promise(follower, 1), 0);
  auto stored = sized<beespace_stored_branch>();
  ASSERT_EQ(beespace_follower_stored(follower, &stored, &error_), BEESPACE_OK);
  EXPECT_EQ(stored.promised, 2U);
  Agent again = make_agent(1, *tube_of(kFigures, kLink, {6.0, 4.0}));
  ASSERT_EQ(beespace_follower_restore(again.follower.get(), &stored, &error_), BEESPACE_OK);
  EXPECT_EQ(beespace_follower_held(again.follower.get()), root.number);
  Agent other = make_agent(2, *tube_of(kFigures, kLink, {6.0, 4.0}));
  EXPECT_EQ(beespace_follower_restore(other.follower.get(), &stored, &error_),
            BEESPACE_INVALID_ARGUMENT);
  // Another planner.
  options_.epoch = 2;
  make();
  const beespace_join_request asked = request(1, {});
  ASSERT_EQ(beespace_guide_adopt(guide_.get(), &asked, &stored, &error_), BEESPACE_OK)
      << error_.message;
  step(4);
  EXPECT_EQ(beespace_guidance_agents(guidance_.get())[0], 1);
  stored.branch.struct_size = 0;
  EXPECT_EQ(beespace_guide_adopt(guide_.get(), &asked, &stored, &error_),
            BEESPACE_INVALID_ARGUMENT);
  beespace_follower_lose(follower);
  EXPECT_EQ(beespace_follower_held(follower), 0U);
  beespace_follower_lose(nullptr);
  beespace_follower_advance(nullptr, 1);
  EXPECT_EQ(beespace_follower_promise(nullptr, 1), 0);
  beespace_follower* none = nullptr;
  EXPECT_EQ(beespace_follower_create(1, 5.0, 0.0, 0.1, &none, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_follower_create(1, 5.0, 3.0, kNaN, &none, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(none, nullptr);
}

TEST_F(CGuide, AgentsHaveTheirNumbersInErrorsAndInOrder) {
  make();
  constexpr auto kLowest = std::numeric_limits<std::int64_t>::min();
  for (const std::int64_t agent : {std::int64_t{3}, std::int64_t{-5}, std::int64_t{-1}, kLowest}) {
    const std::string name = "agent " + std::to_string(agent);
    error_ = c_error();
    EXPECT_EQ(beespace_guide_leave(guide_.get(), agent, &error_), BEESPACE_INVALID_ARGUMENT);
    EXPECT_STREQ(error_.place, "agents");
    EXPECT_EQ(error_.record, agent);
    EXPECT_EQ(std::string(error_.message).rfind(name + " is not in the fleet", 0), 0U)
        << error_.message;
  }
  const std::vector<std::int64_t> ascending = {kLowest, -5, -1, 0, 3};
  for (const std::size_t i : {3U, 1U, 4U, 0U, 2U}) {
    EXPECT_TRUE(join(ascending[i], {20.0 * static_cast<double>(i), 0.0, 10.0}));
  }
  EXPECT_FALSE(join(7, {20.0, 0.5, 10.0}));
  EXPECT_EQ(answer_.touches[0], -5);
  step(1);
  ASSERT_EQ(beespace_guidance_size(guidance_.get()), 5);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(beespace_guidance_agents(guidance_.get())[i], ascending[i]);
    const auto k = static_cast<std::int64_t>(i);
    EXPECT_EQ(beespace_guidance_command(guidance_.get(), k)->agent, ascending[i]);
  }
}

TEST_F(CGuide, AVelocityOfAReportWithoutItsFlagIsRefused) {
  make();
  EXPECT_TRUE(join(7, {0.0, 0.0, 10.0}));
  auto report = sized<beespace_agent_report>();
  report.agent = 7;
  report.velocity[2] = 1.0;
  EXPECT_EQ(beespace_guide_take_report(guide_.get(), &report, &error_), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "report");
}

}  // namespace
}  // namespace beespace::test
