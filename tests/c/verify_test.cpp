// A verifier of C finds what the one of C++ finds, and says what was not seen; what callers get
// wrong is refused and leaves it as it was.
#include "tests/c/c_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>
#include <beespace/obstacle.hpp>
#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Row = std::tuple<std::string, std::int64_t, std::int64_t, double, double, double>;

struct CMovers {
  explicit CMovers(const std::vector<Mover>& movers) {
    const auto count = static_cast<std::int64_t>(movers.size());
    positions = velocities = beespace_points_interleaved(nullptr, count);
    for (beespace_points* const points : {&positions, &velocities}) {
      points->x_stride = points->y_stride = points->z_stride = sizeof(Mover);
    }
    if (movers.empty()) return;
    const auto& [p, v] = movers.front();
    std::tie(positions.x, positions.y, positions.z) = std::tuple(&p.x, &p.y, &p.z);
    std::tie(velocities.x, velocities.y, velocities.z) = std::tuple(&v.x, &v.y, &v.z);
  }
  beespace_points positions{};
  beespace_points velocities{};
};

class CVerifier : public testing::Test {
 protected:
  void SetUp() override {
    options_.struct_size = sizeof options_;
    options_.threshold_m = 2.0;
  }
  void begin() {
    beespace_verifier* made = nullptr;
    error_ = c_error();
    ASSERT_EQ(beespace_verifier_create(&options_, &made, &error_), BEESPACE_OK) << error_.message;
    verifier_.reset(made);
  }
  // One of each kind, as in map_of_all().
  void set_obstacles() {
    std::array<beespace_obstacle, 5> all{};
    static constexpr std::array<double, 6> kOutline = {8, 1, 12, 1, 8, 4};
    for (beespace_obstacle& each : all) each.struct_size = sizeof each;
    all[0].kind = BEESPACE_SPHERE;
    all[0].center[0] = 5.0;
    all[0].center[2] = 4.0;
    all[0].radius_m = 1.0;
    all[1].kind = BEESPACE_GROUND;
    all[1].high[2] = 1.0;
    all[2].kind = BEESPACE_BOX;
    std::iota(all[2].low, all[2].low + 3, 1.0);
    std::iota(all[2].high, all[2].high + 3, 2.0);
    all[3].kind = BEESPACE_CYLINDER;
    all[3].flags = BEESPACE_HIGHEST;
    all[3].center[0] = 10.0;
    all[3].center[1] = 10.0;
    all[3].radius_m = 1.0;
    all[3].high[2] = 3.0;
    all[4].kind = BEESPACE_PRISM;
    all[4].flags = BEESPACE_LOWEST | BEESPACE_HIGHEST;
    all[4].outline = kOutline.data();
    all[4].corners = 3;
    all[4].low[2] = 4.0;
    all[4].high[2] = 6.0;
    beespace_obstacles* made = nullptr;
    ASSERT_EQ(beespace_obstacles_create(all.data(), 5, &made, &error_), BEESPACE_OK);
    obstacles_.reset(made);
    options_.obstacles = made;
    options_.clearance_m = 0.5;
  }
  beespace_code add(double time_s, const std::vector<Mover>& movers, bool with_velocities = true,
                    const beespace_run* run = nullptr) {
    const CMovers given(movers);
    error_ = c_error();
    return beespace_verifier_add(verifier_.get(), time_s, &given.positions,
                                 with_velocities ? &given.velocities : nullptr, run, &error_);
  }
  beespace_verdict verdict() {
    beespace_verdict verdict{};
    verdict.struct_size = sizeof verdict;
    EXPECT_EQ(beespace_verifier_verdict(verifier_.get(), &verdict, nullptr), BEESPACE_OK);
    return verdict;
  }
  std::vector<Row> violations() {
    EXPECT_EQ(beespace_verifier_violations(verifier_.get(), violations_.get(), nullptr),
              BEESPACE_OK);
    const beespace_violations* const from = violations_.get();
    std::vector<Row> rows;
    for (std::int64_t i = 0; i < beespace_violations_size(from); ++i) {
      rows.emplace_back(beespace_violation_name(beespace_violations_kinds(from)[i]),
                        beespace_violations_first(from)[i], beespace_violations_second(from)[i],
                        beespace_violations_begins_s(from)[i], beespace_violations_ends_s(from)[i],
                        beespace_violations_values(from)[i]);
    }
    return rows;
  }
  std::vector<std::string> violations_told() {
    std::vector<std::string> told;
    for (const auto& [kind, first, second, begins_s, ends_s, value] : violations()) {
      told.push_back(kind + " " + std::to_string(first) + " " + std::to_string(second) + " from " +
                     std::to_string(static_cast<int>(begins_s)) + " to " +
                     std::to_string(static_cast<int>(ends_s)));
    }
    return told;
  }
  void expect_no_verifier(beespace_code code, const std::string& words) {
    auto* made = reinterpret_cast<beespace_verifier*>(this);
    error_ = c_error();
    EXPECT_EQ(beespace_verifier_create(&options_, &made, &error_), code) << words;
    EXPECT_EQ(made, nullptr);
    EXPECT_STREQ(error_.place, "options");
    EXPECT_NE(std::string(error_.message).find(words), std::string::npos) << error_.message;
    options_ = {};
    SetUp();
  }

  beespace_verify_options options_{};
  Owned<beespace_obstacles> obstacles_;
  Owned<beespace_verifier> verifier_;
  Owned<beespace_violations> violations_{beespace_violations_create()};
  beespace_error error_ = c_error();
};

// Steps of half a second.
std::vector<Row> rows_of(const Verdict& verdict) {
  std::vector<Row> rows;
  for (const Loss& loss : verdict.first_losses) {
    rows.emplace_back("loss", loss.pair.first, loss.pair.second, loss.begins_s, loss.ends_s,
                      loss.closest_m);
  }
  for (const ClearanceLoss& loss : verdict.first_clearance_losses) {
    rows.emplace_back("clearance", loss.agent, static_cast<std::int64_t>(loss.obstacle),
                      loss.begins_s, loss.ends_s, loss.closest_m);
  }
  for (const Breach& each : verdict.first_breaches) {
    rows.emplace_back(each.kind == BreachKind::kSpeed ? "speed" : "acceleration", each.agent, -1,
                      each.begins_s, each.begins_s + 0.5, each.value);
  }
  return rows;
}

ObstacleMap map_of_all() {
  return *ObstacleMap::of({Sphere{{5, 0, 4}, 1.0}, Ground{1.0}, Box{{1, 2, 3}, {2, 3, 4}},
                           UprightCylinder{10, 10, 1.0, {-INFINITY, 3.0}},
                           UprightPrism{{{8, 1}, {12, 1}, {8, 4}}, {4.0, 6.0}}});
}

std::vector<Mover> random_flock(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0.0, 12.0);
  std::uniform_real_distribution<double> speed(-2.0, 2.0);
  std::vector<Mover> movers(9);
  for (auto& [p, v] : movers) {
    p = {place(random), place(random), 1.0 + 0.5 * place(random)};
    v = {speed(random), speed(random), 0.1 * speed(random)};
  }
  return movers;
}

TEST_F(CVerifier, FindsWhatTheOneOfCppFinds) {
  std::mt19937_64 random(1234);
  const ObstacleMap map = map_of_all();
  std::set<std::string> seen;
  std::set<std::int64_t> obstacles;
  for (int round = 0; round < rounds(40); ++round) {
    SCOPED_TRACE(round);
    options_ = {};
    SetUp();
    const bool straight = round % 3 == 0;
    VerifyOptions options{.threshold_m = 2.0, .straight = straight};
    if (straight) options_.flags |= BEESPACE_VERIFY_STRAIGHT;
    if (round % 2 == 0) {
      set_obstacles();
      options.obstacles = &map;
      options.clearance_m = 0.5;
    }
    if (round % 4 < 2) {
      options.max_speed_mps = options_.max_speed_mps = 2.2;
      options_.flags |= BEESPACE_VERIFY_MAX_SPEED;
    }
    if (!straight && round % 5 != 0) {
      options.max_acceleration_mps2 = options_.max_acceleration_mps2 = 1.0;
      options_.flags |= BEESPACE_VERIFY_MAX_ACCELERATION;
    }
    begin();
    obstacles_.reset();  // the verifier keeps what it needs
    Verifier verifier(options);
    std::vector<Mover> flock = random_flock(random);
    for (int step = 0; step < 8; ++step) {
      if (step == 5) {
        verifier.skip();
        beespace_verifier_skip(verifier_.get());
        flock = random_flock(random);
      }
      const double time_s = 0.5 * step;
      ASSERT_TRUE(verifier.add(time_s, flock));
      ASSERT_EQ(add(time_s, flock, !straight || round % 2 == 0), BEESPACE_OK) << error_.message;
      for (auto& [p, v] : flock) {
        const double turn = std::uniform_real_distribution<double>(-0.6, 0.6)(random);
        p = {p.x + 0.5 * v.x, p.y + 0.5 * v.y, p.z + 0.5 * v.z};
        v = {v.x - turn * v.y, v.y + turn * v.x, v.z};
      }
    }
    const Verdict& expected = verifier.verdict();
    const beespace_verdict told = verdict();
    EXPECT_EQ(violations(), rows_of(expected));
    EXPECT_EQ(told.moments, 8U);
    EXPECT_EQ(told.steps, 6U);
    EXPECT_EQ(told.unseen, 1U);
    EXPECT_EQ(told.holds, 0);
    EXPECT_EQ(told.losses, expected.losses);
    EXPECT_EQ(told.clearance_losses, expected.clearance_losses);
    EXPECT_EQ(told.breaches, expected.breaches);
    EXPECT_EQ(told.peak_speed_mps, expected.peak_speed_mps);
    ASSERT_TRUE(expected.closest_m);
    EXPECT_EQ(told.closest_m, *expected.closest_m);
    EXPECT_EQ(told.closest_first, expected.closest_pair->first);
    EXPECT_EQ(told.closest_second, expected.closest_pair->second);
    EXPECT_EQ(told.closest_step_s, expected.closest_step_s);
    if (straight) {
      EXPECT_TRUE(std::isnan(told.peak_acceleration_mps2));
    } else {
      EXPECT_EQ(told.peak_acceleration_mps2, expected.peak_acceleration_mps2);
    }
    for (const Row& row : violations()) {
      seen.insert(std::get<0>(row));
      if (std::get<0>(row) == "clearance") obstacles.insert(std::get<2>(row));
    }
  }
  if (kSanitized) return;
  EXPECT_EQ(seen, (std::set<std::string>{"loss", "clearance", "speed", "acceleration"}));
  EXPECT_EQ(obstacles, (std::set<std::int64_t>{0, 1, 2, 3, 4}));
}

// A verdict holds only where something was checked, and all of it.
TEST_F(CVerifier, HoldsOnlyWhatWasSeen) {
  const std::vector<Mover> apart = {{{0, 0, 0}, {}}, {{50, 0, 0}, {}}};
  begin();
  EXPECT_EQ(verdict().holds, 0);
  beespace_verifier_skip(verifier_.get());  // before the first there is nothing to be skipped
  ASSERT_EQ(add(0.0, apart), BEESPACE_OK);
  EXPECT_EQ(verdict().holds, 0);
  ASSERT_EQ(add(1.0, apart), BEESPACE_OK);
  EXPECT_EQ(verdict().holds, 1);
  EXPECT_EQ(verdict().closest_first, -1);
  EXPECT_TRUE(std::isnan(verdict().closest_m));
  beespace_verifier_skip(verifier_.get());
  beespace_verifier_skip(verifier_.get());
  EXPECT_EQ(verdict().holds, 0);
  ASSERT_EQ(add(2.0, {apart[0]}), BEESPACE_OK);
  ASSERT_EQ(add(3.0, {apart[0]}), BEESPACE_OK);
  EXPECT_EQ(verdict().holds, 0);
  EXPECT_EQ(verdict().unseen, 1U);
  EXPECT_EQ(verdict().steps, 2U);
  EXPECT_EQ(beespace_verifier_violations(verifier_.get(), violations_.get(), nullptr), BEESPACE_OK);
  EXPECT_EQ(beespace_violations_size(violations_.get()), 0);
  EXPECT_EQ(beespace_violations_kinds(violations_.get()), nullptr);
}

TEST_F(CVerifier, OptionsThatMakeNoSenseAreRefused) {
  options_.threshold_m = 0.0;
  expect_no_verifier(BEESPACE_INVALID_THRESHOLD, "threshold");
  options_.max_speed_mps = 5.0;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "without its flag");
  options_.max_acceleration_mps2 = kNan;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "without its flag");
  options_.flags = BEESPACE_VERIFY_MAX_SPEED;
  options_.max_speed_mps = -1.0;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "speed");
  options_.flags = BEESPACE_VERIFY_STRAIGHT | BEESPACE_VERIFY_MAX_ACCELERATION;
  options_.max_acceleration_mps2 = 1.0;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "straight lines");
  options_.flags = 8;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "flags");
  options_.reserved = 1;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "reserved");
  options_.clearance_m = 1.0;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "no obstacles");
  set_obstacles();
  options_.clearance_m = 0.0;
  expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "clearance");
  for (const std::size_t size : {std::size_t{0}, sizeof options_ - 8, std::size_t{5000}}) {
    options_.struct_size = size;
    expect_no_verifier(BEESPACE_INVALID_ARGUMENT, "struct_size");
  }
  EXPECT_EQ(beespace_verifier_create(&options_, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CVerifier, WhatCannotBeIsRefusedAndLeavesItAsItWas) {
  const std::vector<Mover> flock = {{{0, 0, 0}, {1, 0, 0}}, {{50, 0, 0}, {0, 1, 0}}};
  begin();
  ASSERT_EQ(add(1.0, flock), BEESPACE_OK);
  std::vector<Mover> wrong = flock;
  wrong[1].position.y = kNan;
  EXPECT_EQ(add(2.0, wrong), BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "positions");
  EXPECT_EQ(error_.record, 1);
  wrong = flock;
  wrong[1].velocity.z = 1e31;
  EXPECT_EQ(add(2.0, wrong), BEESPACE_OUTSIDE_DOMAIN);
  EXPECT_STREQ(error_.place, "velocities");
  EXPECT_EQ(error_.record, 1);
  for (const double time_s : {1.0, 0.0}) EXPECT_EQ(add(time_s, flock), BEESPACE_TIME_ORDER);
  EXPECT_STREQ(error_.place, "time");
  EXPECT_EQ(add(kNan, flock), BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "time");
  EXPECT_EQ(add(2.0, {flock[0]}), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(add(2.0, flock, false), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "velocities");
  const CMovers one({flock[0]});
  const CMovers two(flock);
  EXPECT_EQ(beespace_verifier_add(verifier_.get(), 2.0, &two.positions, &one.velocities, nullptr,
                                  &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_verifier_add(verifier_.get(), 2.0, nullptr, &two.velocities, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_verifier_add(nullptr, 2.0, &two.positions, &two.velocities, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(verdict().moments, 1U);
  ASSERT_EQ(add(2.0, flock), BEESPACE_OK);
  EXPECT_EQ(verdict().moments, 2U);
  beespace_verdict small{};
  small.struct_size = sizeof small - 8;
  EXPECT_EQ(beespace_verifier_verdict(verifier_.get(), &small, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(small.moments, 0U);
  EXPECT_EQ(beespace_verifier_verdict(verifier_.get(), nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_verifier_violations(verifier_.get(), nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_verifier_violations(nullptr, violations_.get(), nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(beespace_violation_name(4), "unknown");
  EXPECT_EQ(beespace_violations_size(nullptr), 0);
  beespace_verifier_skip(nullptr);
  beespace_verifier_free(nullptr);
  beespace_violations_free(nullptr);
}

TEST_F(CVerifier, TakesARecordingOfCommonTimes) {
  // Rows by time; two that pass each other between 1 s and 2 s, and a gap from 2 s to 9 s.
  struct Fix {
    std::int64_t agent;
    double time_s;
    Point position;
  };
  std::vector<Fix> rows = {{7, 0, {0, 0, 0}},  {-3, 0, {9, 0, 0}}, {7, 1, {3, 0, 0}},
                           {-3, 1, {6, 0, 0}}, {7, 2, {6, 0, 0}},  {-3, 2, {3, 0, 0}},
                           {7, 9, {50, 0, 0}}, {-3, 9, {0, 0, 0}}};
  const auto take = [&](double max_gap_s) {
    constexpr auto kStride = static_cast<std::ptrdiff_t>(sizeof(Fix));
    beespace_fixes fixes{};
    fixes.struct_size = sizeof fixes;
    fixes.agents = &rows[0].agent;
    fixes.times_s = &rows[0].time_s;
    fixes.agents_stride = fixes.times_stride = kStride;
    beespace_points places = beespace_points_separate(
        &rows[0].position.x, &rows[0].position.y, nullptr, static_cast<std::int64_t>(rows.size()));
    places.x_stride = places.y_stride = kStride;
    beespace_recording* made = nullptr;
    EXPECT_EQ(beespace_recording_create(&fixes, &places, nullptr, &made, nullptr), BEESPACE_OK);
    error_ = c_error();
    const beespace_code code =
        beespace_verifier_add_recording(verifier_.get(), made, max_gap_s, nullptr, &error_);
    beespace_recording_free(made);
    return code;
  };
  options_.flags = BEESPACE_VERIFY_STRAIGHT;
  begin();
  ASSERT_EQ(take(INFINITY), BEESPACE_OK) << error_.message;
  EXPECT_EQ(verdict().steps, 3U);
  EXPECT_EQ(verdict().unseen, 0U);
  EXPECT_EQ(violations_told(), (std::vector<std::string>{"loss 0 1 from 1 to 2"}));
  begin();
  ASSERT_EQ(take(1.0), BEESPACE_OK) << error_.message;
  EXPECT_EQ(verdict().steps, 2U);
  EXPECT_EQ(verdict().unseen, 1U);
  EXPECT_EQ(verdict().moments, 4U);
  begin();
  EXPECT_EQ(take(0.0), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "max_gap");
  rows[2].time_s = 1.5;
  EXPECT_EQ(take(INFINITY), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "recording");
  EXPECT_EQ(error_.record, 1);  // -3 is the first
  EXPECT_NE(std::string(error_.message).find("agent 7"), std::string::npos) << error_.message;
  EXPECT_EQ(verdict().moments, 0U);
  rows[2].time_s = 1.0;
  EXPECT_EQ(beespace_verifier_add_recording(verifier_.get(), nullptr, 1.0, nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  options_.flags = 0;
  begin();
  EXPECT_EQ(take(INFINITY), BEESPACE_INVALID_ARGUMENT);  // of curves
}

TEST_F(CVerifier, AStopEndsOneCallAndTheSameCanBeMadeAgain) {
  const std::vector<Mover> flock = {{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 1, 0}}};
  begin();
  ASSERT_EQ(add(0.0, flock), BEESPACE_OK);
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_stop_request(stop.get());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  EXPECT_EQ(add(1.0, flock, true, &run), BEESPACE_STOPPED);
  EXPECT_EQ(verdict().moments, 1U);
  EXPECT_EQ(verdict().losses, 0U);
  run.stop = nullptr;
  run.poll = [](void*) { return 0; };
  EXPECT_EQ(add(1.0, flock, true, &run), BEESPACE_OK);
  EXPECT_EQ(verdict().moments, 2U);
  EXPECT_EQ(verdict().losses, 1U);
}

}  // namespace
}  // namespace beespace::test
