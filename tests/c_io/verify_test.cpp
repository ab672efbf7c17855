// What C is told of a show that is verified: the drones of tests/cli/shows/make-shows, of which it
// is known by arithmetic how close they come and how fast they fly.
#include "tests/c_io/test_file.hpp"

#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

struct FreeVerdict {
  void operator()(beespace_io_verdict* verdict) const { beespace_io_verdict_free(verdict); }
};

beespace_io_verify_options verify_options() {
  beespace_io_verify_options options{};
  options.struct_size = sizeof options;
  return options;
}

struct Verified {
  std::unique_ptr<beespace_io_verdict, FreeVerdict> verdict;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
  beespace_io_verdict_facts facts{};

  [[nodiscard]] std::int64_t size() const { return beespace_io_verdict_size(verdict.get()); }
};

Verified verify(const Recording& recording, const beespace_io_verify_options* options = nullptr) {
  Verified verified;
  beespace_io_verdict* verdict = nullptr;
  verified.code = beespace_io_verify(recording.get(), options, &verdict, &verified.error);
  verified.verdict.reset(verdict);
  verified.facts.struct_size = sizeof verified.facts;
  if (verdict != nullptr) {
    EXPECT_EQ(beespace_io_verdict_facts_of(verdict, &verified.facts, nullptr), BEESPACE_OK);
  }
  return verified;
}

class CVerifiedShow : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    auto read = read_recording({std::string(BEESPACE_SHOWS) + "/" + GetParam()});
    ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    show_ = std::move(read.recording);
  }

  Recording show_;
};
INSTANTIATE_TEST_SUITE_P(Forms, CVerifiedShow, testing::Values("ring.skyc", "ring.json"),
                         [](const auto& form) { return std::string(form.param).substr(5); });

// Half way along the sides of a square of 5 m two drones are 2.5 times the square root of 2 apart;
// the show promises 4 m, and 2.4 m/s downwards, of which one drone has 2.5.
TEST_P(CVerifiedShow, IsHeldAgainstWhatItDeclares) {
  const Verified verified = verify(show_);
  ASSERT_EQ(verified.code, BEESPACE_OK) << text_of(verified.error);
  const beespace_io_verdict_facts& facts = verified.facts;
  EXPECT_EQ(facts.holds, 0);
  EXPECT_EQ(facts.motion, BEESPACE_IO_ALONG_SHOW);
  EXPECT_EQ(facts.threshold_m, 4.0);
  EXPECT_EQ(facts.losses, 4);
  EXPECT_EQ(facts.breaches, 1);
  EXPECT_EQ(facts.gaps, 0);
  EXPECT_NEAR(facts.closest_m, 2.5 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(facts.closest_s, 15.0, 1e-3);
  const std::uint32_t declared = 1U << BEESPACE_IO_HORIZONTAL | 1U << BEESPACE_IO_CLIMB |
                                 1U << BEESPACE_IO_DESCENT | 1U << BEESPACE_IO_HEIGHT;
  EXPECT_EQ(facts.declared, declared);
  EXPECT_EQ(facts.limits, declared);
  EXPECT_EQ(facts.most[BEESPACE_IO_DESCENT], 2.4);
  EXPECT_TRUE(std::isinf(facts.most[BEESPACE_IO_SPEED]));
  EXPECT_NEAR(facts.greatest[BEESPACE_IO_CLIMB], 2.5, 1e-8);
  EXPECT_NEAR(facts.greatest_s[BEESPACE_IO_CLIMB], 7.0, 1e-3);
  EXPECT_EQ(facts.greatest_agent[BEESPACE_IO_CLIMB], 0);

  ASSERT_EQ(verified.size(), 5);
  const auto* const verdict = verified.verdict.get();
  const auto kinds = numbers_of(beespace_io_verdict_kinds(verdict), 5);
  EXPECT_EQ(kinds, (std::vector<std::int32_t>{BEESPACE_IO_LOSS, BEESPACE_IO_LOSS, BEESPACE_IO_LOSS,
                                              BEESPACE_IO_LOSS, BEESPACE_IO_DESCENT}));
  EXPECT_EQ(beespace_io_verdict_first(verdict)[0], 0);
  EXPECT_EQ(beespace_io_verdict_second(verdict)[0], 1);
  EXPECT_NEAR(beespace_io_verdict_values(verdict)[0], 2.5 * std::sqrt(2.0), 1e-6);
  EXPECT_EQ(beespace_io_verdict_first(verdict)[4], 0);
  EXPECT_EQ(beespace_io_verdict_second(verdict)[4], -1);
  EXPECT_EQ(beespace_io_verdict_begins_s(verdict)[4], 20.0);
  EXPECT_EQ(beespace_io_verdict_ends_s(verdict)[4], 26.0);
  EXPECT_NEAR(beespace_io_verdict_values(verdict)[4], 2.5, 1e-8);
  EXPECT_NEAR(beespace_io_verdict_at_s(verdict)[4], 23.0, 1e-3);
  EXPECT_STREQ(beespace_io_finding_name(kinds[4]), "descent");
}

// Of what is asked for, the greatest acceleration is 5/3 m/s^2, on the way up and down.
TEST_P(CVerifiedShow, HoldsWhereItIsAskedForLess) {
  auto options = verify_options();
  options.threshold_m = 3.5;
  options.limits = 1U << BEESPACE_IO_DESCENT | 1U << BEESPACE_IO_ACCELERATION;
  options.most[BEESPACE_IO_DESCENT] = 2.5;
  options.most[BEESPACE_IO_ACCELERATION] = 1.667;
  const Verified holds = verify(show_, &options);
  ASSERT_EQ(holds.code, BEESPACE_OK) << text_of(holds.error);
  EXPECT_EQ(holds.facts.holds, 1);
  EXPECT_EQ(holds.size(), 0);
  EXPECT_EQ(beespace_io_verdict_kinds(holds.verdict.get()), nullptr);
  EXPECT_EQ(holds.facts.declared & (1U << BEESPACE_IO_DESCENT), 0U);
  options.most[BEESPACE_IO_ACCELERATION] = 1.66;
  EXPECT_EQ(verify(show_, &options).facts.holds, 0);
}

// Along the first side, 0.5 m from which a pillar stands; the others are 4 m away from it and more.
TEST_P(CVerifiedShow, KeepsClearOfObstaclesAlongItsCurves) {
  beespace_obstacle pillar{};
  pillar.struct_size = sizeof pillar;
  pillar.kind = BEESPACE_CYLINDER;
  pillar.flags = BEESPACE_HIGHEST;
  pillar.center[1] = -3.5;
  pillar.radius_m = 0.5;
  pillar.high[2] = 20.0;
  auto options = verify_options();
  options.threshold_m = 3.0;
  options.limits = 1U << BEESPACE_IO_DESCENT;
  options.most[BEESPACE_IO_DESCENT] = 3.0;
  options.obstacles = &pillar;
  options.obstacle_count = 1;
  options.clearance_m = 0.6;
  const Verified touched = verify(show_, &options);
  ASSERT_EQ(touched.code, BEESPACE_OK) << text_of(touched.error);
  EXPECT_EQ(touched.facts.clearance_losses, 1);
  ASSERT_EQ(touched.size(), 1);
  EXPECT_EQ(beespace_io_verdict_kinds(touched.verdict.get())[0], BEESPACE_IO_CLEARANCE);
  EXPECT_EQ(beespace_io_verdict_second(touched.verdict.get())[0], 0);
  EXPECT_NEAR(beespace_io_verdict_values(touched.verdict.get())[0], 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(beespace_io_verdict_at_s(touched.verdict.get())[0]));
  options.clearance_m = 0.49;
  EXPECT_EQ(verify(show_, &options).facts.holds, 1);
}

// A limit that is not looked at, and need not be; and options of before there was such a thing.
// a takes off a metre beside b, which stands until a has flown away.
constexpr const char* kGrid =
    R"({"version": 1, "swarm": {"drones": [
       {"settings": {"name": "a", "home": [0, 0, 0], "trajectory": {"version": 1, "points": [
         [0, [0, 0, 0], []], [10, [0, 0, 10], []], [20, [-20, 0, 10], []], [30, [-20, 0, 0], []]]}}},
       {"settings": {"name": "b", "home": [1, 0, 0], "trajectory": {"version": 1, "takeoffTime": 40,
         "points": [[0, [1, 0, 0], []], [10, [1, 0, 10], []], [20, [1, 0, 0], []]]}}}]}})";

TEST(CVerified, WhoTakesOffBesideAnotherIsLeftOutWhenAsked) {
  const TestFolder folder;
  const auto read = read_recording({folder.file("grid.json", kGrid)});
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  beespace_io_verify_options options = verify_options();
  options.threshold_m = 3;
  const Verified all = verify(read.recording, &options);
  EXPECT_EQ(all.facts.holds, 0);
  EXPECT_EQ(all.facts.losses, 1);
  EXPECT_EQ(all.facts.ignored, 0);
  options.ignore_below_m = 3;
  const Verified low = verify(read.recording, &options);
  EXPECT_EQ(low.facts.holds, 1);
  EXPECT_EQ(low.facts.losses, 0);
  EXPECT_EQ(low.facts.ignored, 1);
  EXPECT_EQ(low.facts.takeoff_unknown, 0);
  options.ignore_below_m = -1;
  EXPECT_EQ(verify(read.recording, &options).code, BEESPACE_INVALID_ARGUMENT);
  // As a program sees it that was built before there was the field.
  options.ignore_below_m = 3;
  options.struct_size = offsetof(beespace_io_verify_options, ignore_below_m);
  EXPECT_EQ(verify(read.recording, &options).facts.losses, 1);
}

TEST(CVerified, FlightsInDegreesAreLookedAtAsTheCommandDoes) {
  const TestFolder folder;
  const auto read = read_recording({folder.file(
      "flights.csv",
      "id,time_s,lon,lat,height_m\na,0,8,47,100\na,10,8.001,47,100\nb,0.5,8.0005,47.0005,100\n"
      "b,10.5,8.0005,46.9995,100\n")});
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  beespace_io_verify_options options = verify_options();
  options.threshold_m = 1;
  const Verified apart = verify(read.recording, &options);
  ASSERT_EQ(apart.code, BEESPACE_OK) << text_of(apart.error);
  EXPECT_EQ(apart.facts.motion, BEESPACE_IO_IN_STRAIGHT_LINES);
  EXPECT_EQ(apart.facts.losses, 0);
  options.threshold_m = 10;
  EXPECT_EQ(verify(read.recording, &options).facts.losses, 1);
  options.limits = 1U << static_cast<unsigned>(BEESPACE_IO_SPEED);
  options.most[BEESPACE_IO_SPEED] = 8;
  EXPECT_GT(verify(read.recording, &options).facts.breaches, 0);
  options.limits = 1U << static_cast<unsigned>(BEESPACE_IO_CLIMB);
  options.most[BEESPACE_IO_SPEED] = 0;
  options.most[BEESPACE_IO_CLIMB] = 8;
  const auto without = read_recording(
      {folder.file("flat.csv", "id,time_s,lon,lat\na,0,8,47\na,1,8,47\nb,0,9,47\nb,2,9,47\n")});
  EXPECT_EQ(verify(without.recording, &options).code, BEESPACE_MISSING_COLUMN);
}

TEST(CVerifiedLimits, ThatNeedNotBeLookedAtAreSkipped) {
  const TestFolder folder;
  const auto read = read_recording({folder.file(
      "alone.json",
      R"({"version": 1, "settings": {"validation": {"minNavAltitude": 2.5}}, "swarm": {"drones": [
        {"type": "generic", "settings": {"name": "a", "home": [0, 0, 0], "landAt": [0, 0, 0],
          "trajectory": {"version": 1, "takeoffTime": 0, "points":
            [[0, [0, 0, 0], []], [5, [1, 0, 5], []], [10, [0, 0, 0], []]]}}}]}})")});
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  auto options = verify_options();
  options.limits = 1U << BEESPACE_IO_SPEED;
  options.most[BEESPACE_IO_SPEED] = 10.0;
  const Verified declared = verify(read.recording, &options);
  ASSERT_EQ(declared.code, BEESPACE_OK) << text_of(declared.error);
  EXPECT_EQ(declared.facts.holds, 0);
  EXPECT_STREQ(beespace_io_verdict_not_looked_at(declared.verdict.get()), "minNavAltitude");
  options.skipped_limits = "minNavAltitude";
  const Verified skipped = verify(read.recording, &options);
  ASSERT_EQ(skipped.code, BEESPACE_OK) << text_of(skipped.error);
  EXPECT_EQ(skipped.facts.holds, 1);
  EXPECT_STREQ(beespace_io_verdict_not_looked_at(skipped.verdict.get()), "minNavAltitude");
  options.struct_size = offsetof(beespace_io_verify_options, skipped_limits);
  EXPECT_EQ(verify(read.recording, &options).facts.holds, 0);
  options.struct_size = sizeof options;
  options.skipped_limits = "minAltitude";
  const Verified mistyped = verify(read.recording, &options);
  EXPECT_EQ(mistyped.code, BEESPACE_INVALID_ARGUMENT);
  EXPECT_NE(text_of(mistyped.error).find("'minAltitude'"), std::string::npos);
  EXPECT_STREQ(beespace_io_verdict_not_looked_at(nullptr), "");
  // Alone, and without any limit: nothing was compared.
  options = verify_options();
  options.skipped_limits = "minNavAltitude";
  EXPECT_EQ(verify(read.recording, &options).facts.holds, 0);
}

TEST_P(CVerifiedShow, FliesNoStraightLines) {
  auto options = verify_options();
  options.flags = BEESPACE_IO_STRAIGHT;
  EXPECT_EQ(verify(show_, &options).code, BEESPACE_INVALID_ARGUMENT);
}

class CVerifiedRecording : public testing::Test {
 protected:
  [[nodiscard]] Recording table(const std::string& text) const {
    auto read = read_recording({folder_.file("flight.csv", text)});
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    return std::move(read.recording);
  }

  TestFolder folder_;
};

// Two bees with times of their own, one of which crosses 3 m before the other: in straight lines.
constexpr const char* kCrossing = "id,t_s,x,y,z\na,0,0,0,0\na,10,100,0,0\nb,1,0,3,0\nb,9,0,3,0\n";

TEST_F(CVerifiedRecording, InStraightLinesWhereThereAreNoVelocities) {
  const Recording flight = table(kCrossing);
  auto options = verify_options();
  EXPECT_EQ(verify(flight).code, BEESPACE_INVALID_THRESHOLD);
  options.threshold_m = 11.0;
  options.max_gap_s = INFINITY;
  const Verified verified = verify(flight, &options);
  ASSERT_EQ(verified.code, BEESPACE_OK) << text_of(verified.error);
  EXPECT_EQ(verified.facts.motion, BEESPACE_IO_IN_STRAIGHT_LINES);
  EXPECT_EQ(verified.facts.losses, 1);
  EXPECT_NEAR(verified.facts.closest_m, std::sqrt(109.0), 1e-6);
  EXPECT_NEAR(verified.facts.greatest[BEESPACE_IO_SPEED], 10.0, 1e-7);
  options.limits = 1U << BEESPACE_IO_ACCELERATION;
  options.most[BEESPACE_IO_ACCELERATION] = 1.0;
  const Verified limited = verify(flight, &options);
  EXPECT_EQ(limited.code, BEESPACE_MISSING_COLUMN);
  EXPECT_NE(std::strstr(limited.error.message, "'a' has none at 0 s"), nullptr);
}

// In 2 s from rest to rest over 8 m: 1.5 times the mean speed in the middle.
TEST_F(CVerifiedRecording, AlongCurvesWhereThereAreVelocities) {
  const Recording flight = table(
      "id,t_s,x,y,z,vx,vy,vz\na,0,0,0,0,0,0,0\na,2,8,0,0,0,0,0\nb,0,0,90,0,0,0,0\nb,1,0,90,0,0,0,"
      "0\n");
  auto options = verify_options();
  options.threshold_m = 1.0;
  const Verified verified = verify(flight, &options);
  ASSERT_EQ(verified.code, BEESPACE_OK) << text_of(verified.error);
  EXPECT_EQ(verified.facts.motion, BEESPACE_IO_WITH_VELOCITIES);
  EXPECT_NEAR(verified.facts.greatest[BEESPACE_IO_SPEED], 6.0, 1e-7);
  options.flags = BEESPACE_IO_STRAIGHT;
  const Verified straight = verify(flight, &options);
  EXPECT_EQ(straight.facts.motion, BEESPACE_IO_IN_STRAIGHT_LINES);
  EXPECT_NEAR(straight.facts.greatest[BEESPACE_IO_SPEED], 4.0, 1e-7);
}

TEST_F(CVerifiedRecording, WithAGapDoesNotHold) {
  const Recording flight = table(kCrossing);
  auto options = verify_options();
  options.threshold_m = 1.0;
  options.max_gap_s = 8.0;
  const Verified verified = verify(flight, &options);
  ASSERT_EQ(verified.code, BEESPACE_OK) << text_of(verified.error);
  EXPECT_EQ(verified.facts.gaps, 1);
  EXPECT_EQ(verified.size(), 0);
  EXPECT_EQ(verified.facts.holds, 0);
}

// One is in the air when the log of the other ends; and two that are never there at one time.
TEST_F(CVerifiedRecording, ThatIsNotKnownAsAWholeDoesNotHold) {
  auto options = verify_options();
  options.threshold_m = 1.0;
  options.max_gap_s = INFINITY;
  const Verified cut = verify(
      table("id,t_s,x,y,z\na,0,0,0,0\na,5,9,0,9\na,10,9,0,0\nb,0,0,50,0\nb,4,9,50,9\n"), &options);
  ASSERT_EQ(cut.code, BEESPACE_OK) << text_of(cut.error);
  EXPECT_EQ(cut.facts.holds, 0);
  EXPECT_EQ(cut.size(), 0);
  beespace_io_coverage coverage{};
  coverage.struct_size = sizeof coverage;
  ASSERT_EQ(beespace_io_verdict_coverage(cut.verdict.get(), &coverage, nullptr), BEESPACE_OK);
  EXPECT_EQ(coverage.agents_cut_off, 1);
  EXPECT_EQ(coverage.may_hide, 1);
  const Verified apart =
      verify(table("id,t_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,2,9,0,0\nb,3,9,0,0\n"), &options);
  ASSERT_EQ(apart.code, BEESPACE_OK) << text_of(apart.error);
  EXPECT_EQ(apart.facts.holds, 0);
  EXPECT_EQ(apart.facts.closest_first, -1);
}

TEST_F(CVerifiedRecording, ThatCannotBeIsRefused) {
  const Recording degrees =
      table("id,t_s,lon,lat,height_m\na,0,19,47,0\na,9,19,47,9\nb,0,19.1,47,0\nb,9,19.1,47,9\n");
  auto options = verify_options();
  options.threshold_m = 5.0;
  beespace_obstacle obstacle{};
  obstacle.struct_size = sizeof obstacle;
  options.obstacles = &obstacle;
  options.obstacle_count = 1;
  options.clearance_m = 1.0;
  EXPECT_EQ(verify(degrees, &options).code, BEESPACE_UNKNOWN_FRAME);
  options = verify_options();
  options.threshold_m = 5.0;
  const Recording single = table("id,t_s,x,y,z\na,0,0,0,0\na,9,1,0,0\nb,5,0,9,0\n");
  const Verified verified = verify(single, &options);
  EXPECT_EQ(verified.code, BEESPACE_UNSUPPORTED_FORMAT);
  EXPECT_NE(std::strstr(verified.error.message, "'b' has a single fix"), nullptr);
}

TEST_F(CVerifiedRecording, ArgumentsThatMakeNoSenseAreNamed) {
  const Recording flight = table(kCrossing);
  const auto code_of = [&](auto&& change) {
    auto options = verify_options();
    options.threshold_m = 1.0;
    change(options);
    return verify(flight, &options).code;
  };
  EXPECT_EQ(code_of([](auto&) {}), BEESPACE_OK);
  EXPECT_EQ(code_of([](auto& o) { o.flags = 2; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.limits = 64; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.most[0] = 1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.limits = 1, o.most[0] = -1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.max_gap_s = -1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.obstacle_count = 1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.clearance_m = 1; }), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(code_of([](auto& o) { o.threshold_m = -1; }), BEESPACE_INVALID_THRESHOLD);
  EXPECT_EQ(code_of([](auto& o) { o.struct_size = 8; }), BEESPACE_INVALID_ARGUMENT);
  auto error = io_error();
  beespace_io_verdict* verdict = nullptr;
  EXPECT_EQ(beespace_io_verify(nullptr, nullptr, &verdict, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_verify(flight.get(), nullptr, nullptr, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_verdict_facts_of(nullptr, nullptr, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_verdict_size(nullptr), 0);
  EXPECT_EQ(beespace_io_verdict_values(nullptr), nullptr);
  EXPECT_STREQ(beespace_io_finding_name(8), "unknown");
  beespace_io_verdict_free(nullptr);
}

TEST_F(CVerifiedRecording, CanBeStopped) {
  const Recording flight = table(kCrossing);
  auto options = verify_options();
  options.threshold_m = 1.0;
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = beespace_stop_create();
  beespace_stop_request(run.stop);
  options.run = &run;
  const Verified verified = verify(flight, &options);
  beespace_stop_free(run.stop);
  EXPECT_EQ(verified.code, BEESPACE_STOPPED);
  EXPECT_EQ(verified.verdict, nullptr);
}

}  // namespace
}  // namespace beespace::test
