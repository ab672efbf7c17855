// Whether places are written with too few decimals, and what that makes of a verdict.
#include "analysis/recorded/coarse_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

// On a way with bends, at places that are multiples of that.
PlaceSteps on_a_way(double step, double per_unit = 1.0, double at = 20'000.0) {
  PlaceSteps steps;
  for (int i = 0; i < 60; ++i) {
    const double x = at + per_unit * (3.1 * i + 40.0 * std::sin(0.3 * i));
    const double y = at + per_unit * 55.0 * std::cos(0.17 * i);
    steps.take({i * 10.0, {rounded(x, step), rounded(y, step), 0.0}});
  }
  return steps;
}

double alone_m(const PlaceSteps& steps, io::Frame frame) {
  return steps.coarse_m(frame, steps.decimals());
}

TEST(CoarsePlaces, AreAsCoarseAsTheyAreWritten) {
  EXPECT_NEAR(alone_m(on_a_way(0.1), io::Frame::kMetres), std::hypot(0.1, 0.1), 1e-9);
  EXPECT_NEAR(alone_m(on_a_way(10.0), io::Frame::kMetres), std::hypot(10.0, 10.0), 1e-9);
  const double of_degrees = alone_m(on_a_way(1e-3, 1.0 / 111'195.0, 60.0), io::Frame::kWgs84);
  EXPECT_NEAR(of_degrees, 111.195 * std::hypot(0.5, 1.0), 0.1);
  EXPECT_LT(alone_m(on_a_way(1e-7), io::Frame::kMetres), 1e-6);
}

// Cells of a lattice are where they are, and what goes evenly is computed.
TEST(CoarsePlaces, AreNotThoseOfALatticeOrOfEvenMotion) {
  EXPECT_EQ(alone_m(on_a_way(1.0, 1.0, 0.0), io::Frame::kMetres), 0.0);
  PlaceSteps even;
  for (int i = 0; i < 60; ++i) even.take({i * 1.0, {20'000.0 + 2.0 * i, 20'000.0 - 3.0 * i, 0.0}});
  EXPECT_EQ(alone_m(even, io::Frame::kMetres), 0.0);
}

// What is measured wavers, but for what is rounded.
TEST(CoarsePlaces, WhoNeverMovesInDegreesHasTheDecimalsOfTheOthers) {
  PlaceSteps still;
  for (int i = 0; i < 60; ++i) still.take({i * 1.0, {8.5, 60.0, 0.0}});
  const std::size_t three = on_a_way(1e-3, 1.0, 60.0).decimals();
  EXPECT_NEAR(still.coarse_m(io::Frame::kWgs84, three), 111.195 * std::hypot(0.5, 1.0), 0.1);
  EXPECT_EQ(alone_m(still, io::Frame::kMetres), 0.0);
  PlaceSteps climbing;
  for (int i = 0; i < 60; ++i) climbing.take({i * 1.0, {8.5, 60.0, 2.0 * i}});
  EXPECT_EQ(climbing.coarse_m(io::Frame::kWgs84, three), 0.0);
}

TEST(CoarsePlaces, MatterWhereTwoMayBeCloserThanTheThreshold) {
  const std::vector<PlaceSteps> steps = {on_a_way(1.0), on_a_way(1e-7), on_a_way(1.0)};
  const auto judged = [&steps](const CoarseQuestion& question) {
    Coverage coverage;
    judge_places(steps, io::Frame::kMetres, question, coverage);
    EXPECT_EQ(coverage.may_hide_conflicts(), coverage.coarse > 0);
    return coverage.coarse;
  };
  EXPECT_EQ(judged({2.0, false, 3.3}), 2U);
  EXPECT_EQ(judged({2.0, false, 3.5}), 0U);           // too far apart for that
  EXPECT_EQ(judged({2.0, true, 1.0}), 0U);            // there are conflicts in any case
  EXPECT_EQ(judged({50.0, false, 50.5}), 0U);         // a small share of the threshold
  EXPECT_EQ(judged({2.0, false, std::nullopt}), 0U);  // no two are there at the same time
}

io::Recording in_whole_seconds(double late_s) {
  io::Recording recording;
  for (int bee = 0; bee < 2; ++bee) {
    io::RecordedBee& added = recording.bees.emplace_back();
    for (int i = 0; i < 60; ++i) {
      added.fixes.push_back({i + late_s, {5.0 * i, 3.0 * bee, 0.0}});
    }
  }
  return recording;
}

// It is said, and no more: most loggers take places at whole seconds.
TEST(WholeSeconds, AreSaidWhereBeesGoFartherThanTheThreshold) {
  const auto said = [](const io::Recording& recording, const CoarseQuestion& question) {
    Coverage coverage;
    judge_places(recording, question, coverage);
    EXPECT_FALSE(coverage.may_hide_conflicts());
    return coverage.whole_seconds;
  };
  EXPECT_NE(said(in_whole_seconds(0.0), {2.0, false, 3.0}).find("up to 5"), std::string::npos);
  EXPECT_EQ(said(in_whole_seconds(0.25), {2.0, false, 3.0}), "");
  EXPECT_EQ(said(in_whole_seconds(0.0), {6.0, false, 7.0}), "");
  EXPECT_EQ(said(in_whole_seconds(0.0), {2.0, false, 8.0}), "");
}

}  // namespace
}  // namespace beespace::analysis
