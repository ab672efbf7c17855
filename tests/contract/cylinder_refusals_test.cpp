// What searches with a vertical threshold refuse, and what they say of it.
#include "tests/contract/answer.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

TEST(CylinderRefusals, SayWhichSetAndWhichHeight) {
  const std::vector<Point> two = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<Point> three = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<double> of_two = {1, 2};
  const std::vector<double> bad = {1, 2, std::nan("")};
  using Heights = std::vector<double>;
  SearchOptions options{.threshold_m = 5.0, .vertical_m = 5.0};
  const auto refused = [&](const Heights& ours, const Heights& theirs, ErrorCode code,
                           const std::string& array) {
    const PointsView points = PointsView(two).with_heights(ours);
    const PointsView others = PointsView(three).with_heights(theirs);
    const auto found = find_pairs_between(points, others, options);
    const auto brute = brute_force::find_pairs_between(points, others, options);
    ASSERT_FALSE(found);
    ASSERT_FALSE(brute);
    EXPECT_EQ(found.error().code, code);
    EXPECT_EQ(found.error().location.array, array);
    EXPECT_EQ(flat(found.error()), flat(brute.error()));
  };
  refused(of_two, {}, ErrorCode::kInvalidArgument, "others");  // no heights of the others
  refused(of_two, of_two, ErrorCode::kInvalidArgument, "others");
  refused(of_two, bad, ErrorCode::kNotFinite, "others");
  refused({}, bad, ErrorCode::kInvalidArgument, "points");
  options.height_unit_m = 0.3048;  // of z
  refused({}, {}, ErrorCode::kInvalidArgument, "");
  options.height_unit_m = 1.0;
  EXPECT_TRUE(find_pairs_between(two, three, options));
  options.vertical_m.reset();
  refused(of_two, {1, 2, 3}, ErrorCode::kInvalidArgument, "");
}

// A search without a vertical threshold does not pass over heights in silence.
TEST(CylinderRefusals, OfHeightsThatNothingCompares) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<double> heights = {1, 2};
  const PointsView apart = PointsView(points).with_heights(heights);
  const auto refused = [](const auto& found, const char* array) {
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(found.error().location.array, array);
  };
  refused(find_nearest(apart), "points");
  refused(find_nearest_between(points, apart), "others");
  refused(find_k_nearest(apart, 1), "points");
  refused(find_closest_pair(apart), "points");
  refused(find_closest_pair_between(points, apart), "others");
  refused(brute_force::find_nearest(apart), "points");
  refused(Index::build(apart), "points");
  const Index index = *Index::build(points);
  refused(index.find_around(apart, {1.0}), "places");
  refused(index.k_nearest(apart, 1), "places");
  refused(predict_pairs(MoversView(apart, points), {.threshold_m = 1.0}), "");
}

}  // namespace
}  // namespace beespace::test
