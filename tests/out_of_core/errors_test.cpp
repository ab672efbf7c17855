// What a search out of core does not accept.
#include <beespace/out_of_core.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr std::uint64_t kEnough = std::uint64_t{64} << 20U;

OutOfCoreOptions enough() {
  return {.memory_bytes = kEnough, .folder = std::filesystem::temp_directory_path().string()};
}

ErrorCode code_of(OutOfCore& search, const SearchOptions& options) {
  const auto status = search.find_at_risk(options, [](auto) { ADD_FAILURE() << "an answer"; });
  return status ? ErrorCode::kStopped : status.error().code;
}

TEST(OutOfCoreErrors, OptionsThatMakeNoSense) {
  OutOfCore good(enough());
  ASSERT_TRUE(good.add(std::vector<Point>{{0, 0, 0}, {5, 0, 0}}));
  EXPECT_EQ(code_of(good, {}), ErrorCode::kInvalidThreshold);
  EXPECT_EQ(code_of(good, {.threshold_m = -1.0}), ErrorCode::kInvalidThreshold);
  SearchOptions no_height{.threshold_m = 1.0};
  no_height.vertical_m = 0.0;
  EXPECT_EQ(code_of(good, no_height), ErrorCode::kInvalidThreshold);

  auto options = enough();
  options.memory_bytes = 1 << 20;
  OutOfCore small(options);
  ASSERT_TRUE(small.refer(std::vector<Point>()));
  const auto status = small.find_at_risk({.threshold_m = 1.0}, [](auto) {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
  EXPECT_NE(status.error().message.find("16 MiB"), std::string::npos);

  OutOfCore nowhere({.memory_bytes = kEnough});
  EXPECT_EQ(nowhere.add(std::vector<Point>{{0, 0, 0}}).error().code, ErrorCode::kInvalidArgument);
  auto elsewhere = enough();
  elsewhere.folder = "/no/such/folder";
  OutOfCore missing(elsewhere);
  EXPECT_EQ(missing.add(std::vector<Point>{{0, 0, 0}}).error().code, ErrorCode::kWriteFailed);
}

TEST(OutOfCoreErrors, PointsThatAreNoPlace) {
  std::vector<Point> points(100'000);
  for (std::size_t index = 0; index < points.size(); ++index) {
    points[index] = {10.0 * static_cast<double>(index), 0, 0};
  }
  points[70'001].y = std::numeric_limits<double>::quiet_NaN();
  points[90'000].z = 0x1p401;
  OutOfCore search(enough());
  ASSERT_TRUE(search.add(std::vector<Point>{{-5, 0, 0}}));
  const auto added = search.add(points);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(search.size(), 1U);

  // Where they are they are looked at by the search; ids go on from those before.
  ASSERT_TRUE(search.refer(points));
  const auto status = search.find_at_risk({.threshold_m = 1.0}, [](auto) {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(status.error().location.record, 70'002U);
  EXPECT_EQ(status.error().location.array, "points");
}

// All have heights, or none has; and a question that does not compare them is refused.
TEST(OutOfCoreErrors, HeightsApart) {
  const std::vector<Point> points = {{0, 0, 0}, {5, 0, 0}};
  const std::vector<double> heights = {1.0, 2.0};
  const PointsView level = points;
  const PointsView upright = level.with_heights(heights);
  SearchOptions cylinder{.threshold_m = 1.0};
  cylinder.vertical_m = 1.0;

  OutOfCore with(enough());
  ASSERT_TRUE(with.add(upright));
  for (const auto& added : {with.add(level), with.refer(level)}) {
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(added.error().message.find("to all, or to none"), std::string::npos);
  }
  EXPECT_TRUE(with.add(PointsView()));
  EXPECT_EQ(with.size(), 2U);
  EXPECT_TRUE(with.find_at_risk(cylinder, [](auto) { ADD_FAILURE() << "an answer"; }));
  EXPECT_EQ(code_of(with, {.threshold_m = 1.0}), ErrorCode::kInvalidArgument);
  EXPECT_EQ(with.find_closest_pair().error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(with.find_k_nearest(1, [](auto, auto) {}).error().code, ErrorCode::kInvalidArgument);

  OutOfCore without(enough());
  ASSERT_TRUE(without.refer(level));
  EXPECT_EQ(without.add(upright).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(without.refer(upright).error().code, ErrorCode::kInvalidArgument);
  cylinder.height_unit_m = 0.3048;
  EXPECT_EQ(code_of(without, cylinder), ErrorCode::kInvalidArgument);
}

TEST(OutOfCoreErrors, HeightsThatAreNone) {
  const std::vector<Point> points(70'000, {0, 0, 0});
  std::vector<double> heights(points.size());
  OutOfCore search(enough());
  const std::vector<double> fewer(10);
  for (const auto& added : {search.add(PointsView(points).with_heights(fewer)),
                            search.refer(PointsView(points).with_heights(fewer))}) {
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(added.error().message.find("10 heights for 70000 points"), std::string::npos);
  }
  ASSERT_TRUE(search.add(PointsView(points).with_heights(heights)));

  heights[69'999] = std::numeric_limits<double>::infinity();
  const auto added = search.add(PointsView(points).with_heights(heights));
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(added.error().location.record, 69'999U);
  EXPECT_EQ(search.size(), 70'000U);

  heights[69'999] = 0x1p401;
  ASSERT_TRUE(search.refer(PointsView(points).with_heights(heights)));
  SearchOptions cylinder{.threshold_m = 1.0};
  cylinder.vertical_m = 1.0;
  const auto status = search.find_at_risk(cylinder, [](auto) {});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kOutsideDomain);
  EXPECT_EQ(status.error().location.record, 139'999U);
}

TEST(OutOfCoreErrors, AStopEndsIt) {
  std::stop_source stop;
  auto options = enough();
  options.stop = stop.get_token();
  std::vector<Point> points(50'000, {1, 1, 1});
  OutOfCore search(options);
  ASSERT_TRUE(search.refer(points));
  EXPECT_TRUE(search.find_at_risk({.threshold_m = 1.0}, [](auto) {}));
  stop.request_stop();
  EXPECT_EQ(search.find_at_risk({.threshold_m = 1.0}, [](auto) {}).error().code,
            ErrorCode::kStopped);
}

// In the middle: when the first points have been distributed, and when the first cell was searched.
TEST(OutOfCoreErrors, AStopInTheMiddleEndsIt) {
  std::vector<Point> points(300'000);
  for (std::size_t index = 0; index < points.size(); ++index) {
    points[index] = {static_cast<double>(index), 0, 0};
  }
  for (const auto phase :
       {OutOfCoreProgress::Phase::kDistributing, OutOfCoreProgress::Phase::kSearching}) {
    std::stop_source stop;
    auto options = enough();
    options.memory_bytes = std::uint64_t{16} << 20U;
    options.stop = stop.get_token();
    options.progress = [&](const OutOfCoreProgress& progress) {
      if (progress.phase == phase) stop.request_stop();
    };
    OutOfCore search(options);
    ASSERT_TRUE(search.refer(points));
    EXPECT_EQ(search.find_at_risk({.threshold_m = 2.0}, [](auto) {}).error().code,
              ErrorCode::kStopped);
  }
}

}  // namespace
}  // namespace beespace
