// Obstacles of C: what is none is refused by its index. (What each kind is, verify_test.cpp shows.)
#include "tests/c/c_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>
#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

beespace_obstacle plain(std::int32_t kind) {
  beespace_obstacle obstacle{};
  obstacle.struct_size = sizeof obstacle;
  obstacle.kind = kind;
  return obstacle;
}

beespace_obstacle sphere(double x, double y, double z, double radius_m) {
  beespace_obstacle obstacle = plain(BEESPACE_SPHERE);
  obstacle.center[0] = x;
  obstacle.center[1] = y;
  obstacle.center[2] = z;
  obstacle.radius_m = radius_m;
  return obstacle;
}

class CObstacles : public testing::Test {
 protected:
  beespace_code make(const std::vector<beespace_obstacle>& obstacles) {
    beespace_obstacles* made = nullptr;
    error_ = c_error();
    const beespace_code code = beespace_obstacles_create(
        obstacles.data(), static_cast<std::int64_t>(obstacles.size()), &made, &error_);
    made_.reset(made);
    return code;
  }
  // Behind one that is valid, so that the index in the error is not always 0.
  void expect_refused(const beespace_obstacle& obstacle, beespace_code expected,
                      const std::string& words) {
    ASSERT_EQ(make({sphere(0, 0, 0, 1), obstacle}), expected) << words;
    EXPECT_EQ(made_, nullptr);
    EXPECT_STREQ(error_.place, "obstacles");
    EXPECT_EQ(error_.record, 1);
    EXPECT_NE(std::string(error_.message).find(words), std::string::npos) << error_.message;
  }

  beespace_error error_ = c_error();
  Owned<beespace_obstacles> made_;
};

TEST_F(CObstacles, WhatIsNoObstacleIsRefusedByItsIndex) {
  expect_refused(plain(0), BEESPACE_INVALID_ARGUMENT, "the kind is none");
  expect_refused(plain(6), BEESPACE_INVALID_ARGUMENT, "the kind is none");
  expect_refused(sphere(0, 0, 0, -1), BEESPACE_INVALID_ARGUMENT, "the radius");
  expect_refused(sphere(0, kNan, 0, 1), BEESPACE_NOT_FINITE, "center y");
  expect_refused(sphere(0, 1e31, 0, 1), BEESPACE_OUTSIDE_DOMAIN, "center y");
  beespace_obstacle box = plain(BEESPACE_BOX);
  box.low[2] = 1.0;
  expect_refused(box, BEESPACE_INVALID_ARGUMENT, "from z");
  beespace_obstacle prism = plain(BEESPACE_PRISM);
  expect_refused(prism, BEESPACE_INVALID_ARGUMENT, "0 corners");
  prism.corners = 3;
  expect_refused(prism, BEESPACE_INVALID_ARGUMENT, "the outline is NULL");
  const std::array<double, 8> bow = {0, 0, 1, 1, 1, 0, 0, 1};
  prism.outline = bow.data();
  prism.corners = 4;
  expect_refused(prism, BEESPACE_INVALID_ARGUMENT, "crosses");
  prism.corners = std::numeric_limits<std::int64_t>::max();
  expect_refused(prism, BEESPACE_INVALID_ARGUMENT, "number of corners");
  prism.corners = -1;
  expect_refused(prism, BEESPACE_INVALID_ARGUMENT, "number of corners");
}

TEST_F(CObstacles, FieldsThatAKindHasNotAreRefused) {
  // A height that is left out would be a flat disc, through which all could fly.
  beespace_obstacle cylinder = plain(BEESPACE_CYLINDER);
  cylinder.radius_m = 1.0;
  cylinder.high[2] = 50.0;
  expect_refused(cylinder, BEESPACE_INVALID_ARGUMENT, "BEESPACE_HIGHEST");
  cylinder.flags = BEESPACE_HIGHEST;
  EXPECT_EQ(make({cylinder}), BEESPACE_OK) << error_.message;
  cylinder.flags = 4;
  expect_refused(cylinder, BEESPACE_INVALID_ARGUMENT, "flags");
  beespace_obstacle ball = sphere(0, 0, 0, 1);
  ball.flags = BEESPACE_HIGHEST;
  expect_refused(ball, BEESPACE_INVALID_ARGUMENT, "flags");
  ball = sphere(0, 0, 0, 1);
  ball.low[1] = kNan;
  expect_refused(ball, BEESPACE_INVALID_ARGUMENT, "is not zero");
  ball = sphere(0, 0, 0, 1);
  ball.reserved = 1;
  expect_refused(ball, BEESPACE_INVALID_ARGUMENT, "reserved");
}

TEST_F(CObstacles, SizesAndPointersThatMakeNoSenseAreRefused) {
  beespace_obstacle ball = sphere(0, 0, 0, 1);
  beespace_obstacles* made = nullptr;
  EXPECT_EQ(beespace_obstacles_create(&ball, 1, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_obstacles_create(nullptr, 1, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_obstacles_create(&ball, -1, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(beespace_obstacles_create(&ball, kMost, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
  for (const std::size_t size :
       {std::size_t{0}, sizeof ball - 8, sizeof ball + 8, sizeof ball + 4, std::size_t{5000}}) {
    beespace_obstacle wrong = ball;
    wrong.struct_size = size;
    EXPECT_EQ(make({ball, wrong}), BEESPACE_INVALID_ARGUMENT) << size;
    EXPECT_EQ(error_.record, 1) << size;
  }
  alignas(8) std::array<unsigned char, sizeof(beespace_obstacle) + 8> bytes{};
  const auto* const askew = reinterpret_cast<const beespace_obstacle*>(bytes.data() + 1);
  EXPECT_EQ(beespace_obstacles_create(askew, 1, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  beespace_obstacles_free(nullptr);
  EXPECT_EQ(beespace_obstacles_size(nullptr), 0);
}

TEST_F(CObstacles, ALaterHeaderHasLongerObstacles) {
  struct Later {
    beespace_obstacle known;
    double unknown;
  };
  std::array<Later, 2> later{};
  for (Later& each : later) {
    each.known = sphere(0, 0, 0, 1);
    each.known.struct_size = sizeof(Later);
  }
  beespace_obstacles* made = nullptr;
  ASSERT_EQ(beespace_obstacles_create(&later[0].known, 2, &made, nullptr), BEESPACE_OK);
  EXPECT_EQ(beespace_obstacles_size(made), 2);
  beespace_obstacles_free(made);
  later[1].unknown = 1.0;
  EXPECT_EQ(beespace_obstacles_create(&later[0].known, 2, &made, nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CObstacles, NoneAreObstaclesToo) {
  ASSERT_EQ(make({}), BEESPACE_OK);
  EXPECT_NE(made_, nullptr);
  EXPECT_EQ(beespace_obstacles_size(made_.get()), 0);
}

}  // namespace
}  // namespace beespace::test
