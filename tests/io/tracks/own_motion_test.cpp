// Places from which a bee goes on otherwise than its own velocities can have led it.
#include "io/stream_recording.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

struct Told {
  double x;
  double y;
  double vx;
  double vy;
};

// A place each 0.1 s, or as told.
std::string table_of_told(const std::function<Told(int)>& told, double step_s = 0.1) {
  std::string text = "id,time_s,x_m,y_m,z_m,vx,vy,vz\n";
  for (int i = 0; i < 200; ++i) {
    const auto [x, y, vx, vy] = told(i);
    char line[160];
    std::snprintf(line, sizeof line, "a,%.1f,%.4f,%.4f,5,%.3f,%.3f,0\n", step_s * i, x, y, vx, vy);
    text += line;
  }
  return text;
}

// 2 m/s to the east.
Told flies(int i) {
  return {0.2 * i, 0.0, 2.0, 0.0};
}

// From one record to another, where it is at first, with no velocity.
Told freezes(int i) {
  if (i <= 60 || i >= 130) return flies(i);
  return {flies(60).x, 0.0, 0.0, 0.0};
}

double spread(int i) {
  const double turned = std::sin(12.9898 * i) * 43758.5453;
  return 2.0 * (turned - std::floor(turned) - 0.5);
}

TEST(OwnMotion, WhereItSaysThatItStandsAndThenJumpsIsUnknownFromThenOn) {
  const Recording read = recording_of(record(table_of_told(freezes)));
  EXPECT_EQ(read.bees[0].fixes.size(), 131u);
  EXPECT_EQ(read.missing.count, 69u);
  EXPECT_EQ(read.missing.jumping, 0u);
  EXPECT_TRUE(has_note(read, "farther than its own velocities lead it"));
  const TemporaryFolder folder;
  auto stream = RecordingStream::open({folder.write("bees.csv", table_of_told(freezes))}, {}, 64);
  ASSERT_TRUE(stream);
  std::vector<StreamedFix> fixes;
  do {
    ASSERT_TRUE(stream->next(fixes));
  } while (!fixes.empty());
  const auto finished = stream->finish(0);
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error().message.find("cannot be left out with --memory"), std::string::npos);
}

// A filter that goes astray, and finds its satellites again.
TEST(OwnMotion, AJumpBackFromADriftIsTold) {
  const auto drifts = [](int i) {
    Told at = flies(i);
    if (i > 60 && i < 130) at.y = 0.15 * (i - 60);
    if (i > 60 && i < 130) at.vy = 1.5;
    return at;
  };
  const Recording read = recording_of(record(table_of_told(drifts)));
  EXPECT_EQ(read.missing.jumping_ids, std::vector<std::string>{"a"});
  EXPECT_TRUE(has_note(read, "than it says itself"));
}

TEST(OwnMotion, WhatStandsAndStartsOrIsCoarseOrNoisyIsKnown) {
  const auto stands = [](int i) {
    const double t = std::max(0, i - 100) / 10.0;
    const double v = std::min(2.0, 2.0 * t);
    return Told{t < 1.0 ? t * t : 1.0 + 2.0 * (t - 1.0), 0.0, v, 0.0};
  };
  // Its place each 0.1 s, and its velocity a second late.
  const auto late = [&](int i) {
    Told at = stands(i);
    at.vx = stands(std::max(0, i - 10)).vx;
    return at;
  };
  const auto noisy = [](int i) { return Told{2.0 * i + spread(i), spread(i + 500), 2.0, 0.0}; };
  // At which nothing is told of a velocity; or along other axes, in other units.
  const auto untold = [](int i) { return Told{freezes(i).x, 0.0, 0.0, 0.0}; };
  const auto turned = [](int i) { return Told{freezes(i).x, 0.0, 0.0, i % 2 == 0 ? 2.0 : 0.1}; };
  const auto slow = [&](int i) {
    return Told{10.0 * stands(i).x, 0.0, stands(i).vx, 0.0};  // each second
  };
  EXPECT_TRUE(recording_of(record(table_of_told(stands))).missing.none());
  EXPECT_TRUE(recording_of(record(table_of_told(late))).missing.none());
  EXPECT_TRUE(recording_of(record(table_of_told(noisy, 1.0))).missing.none());
  EXPECT_TRUE(recording_of(record(table_of_told(slow, 1.0))).missing.none());
  EXPECT_EQ(recording_of(record(table_of_told(untold))).missing.jumping, 0u);
  EXPECT_EQ(recording_of(record(table_of_told(turned))).missing.jumping, 0u);
}

// What landed may be found somewhere else by some metres, as its receiver settles.
TEST(OwnMotion, AParkedDroneWhosePlaceSettlesIsKnown) {
  const auto parked = [](int i) {
    Told at = flies(std::max(0, i - 100));
    if (i <= 100) at.vx = 0.0;
    at.y = i < 30 ? 1.5 : 0.0;
    return at;
  };
  EXPECT_TRUE(recording_of(record(table_of_told(parked))).missing.none());
}

}  // namespace
}  // namespace beespace::io
