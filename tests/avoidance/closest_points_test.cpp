#include "avoidance/constraints/closest_points.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;
using test::long_of;
using test::LongSegment;

LongSegment long_segment(const Segment& segment) {
  return {long_of(segment.from), long_of(segment.way)};
}

double size_of(const Segment& first, const Segment& second) {
  return length(first.from) + length(second.from) + length(first.way) + length(second.way);
}

// Both points lie on their segments, and their distance exceeds the least by at most `tolerance`.
void expect_closest(const Segment& first, const Segment& second, double tolerance) {
  const ClosestPoints found = closest_points(first, second);
  const double rounding = 1e-14 * size_of(first, second);
  ASSERT_LE(static_cast<double>(long_segment(first).distance_to(long_of(found.first))), rounding);
  ASSERT_LE(static_cast<double>(long_segment(second).distance_to(long_of(found.second))), rounding);
  const auto least = distance_between(long_segment(first), long_segment(second));
  const auto apart = test::length(long_of(found.first) - long_of(found.second));
  ASSERT_LE(static_cast<double>(apart - least), tolerance)
      << "closest " << static_cast<double>(least) << ", found " << static_cast<double>(apart);
}

void expect_closest_both_ways(const Segment& first, const Segment& second, double tolerance) {
  expect_closest(first, second, tolerance);
  expect_closest(second, first, tolerance);
}

TEST(ClosestPoints, OfCrossesParallelsAndPoints) {
  const auto distance = [](const Segment& first, const Segment& second) {
    return length(closest_points(first, second).between());
  };
  const Segment along_x{{0, 0, 0}, {4, 0, 0}};
  EXPECT_EQ(distance(along_x, {{2, -1, 0}, {0, 2, 0}}), 0.0);  // they meet
  EXPECT_EQ(distance(along_x, {{2, -1, 3}, {0, 2, 0}}), 3.0);  // one above the other
  EXPECT_EQ(distance(along_x, {{7, -4, 0}, {0, 8, 0}}), 3.0);  // an end and the inside
  EXPECT_EQ(distance(along_x, {{7, 4, 0}, {0, 8, 0}}), 5.0);   // two ends
  EXPECT_EQ(distance(along_x, {{1, 2, 0}, {2, 0, 0}}), 2.0);   // one beside the other
  EXPECT_EQ(distance(along_x, {{9, 2, 0}, {-7, 0, 0}}), 2.0);  // against it
  EXPECT_EQ(distance(along_x, {{8, 3, 0}, {5, 0, 0}}), 5.0);   // one behind the other
  EXPECT_EQ(distance(along_x, {{3, 0, 0}, {5, 0, 0}}), 0.0);   // on one line, with a piece of both
  EXPECT_EQ(distance(along_x, {{9, 0, 0}, {-3, 0, 0}}), 2.0);  // on one line, apart
  EXPECT_EQ(distance(along_x, {{3, 4, 0}, {0, 0, 0}}), 4.0);   // a point beside it
  EXPECT_EQ(distance({{7, 4, 0}, {0, 0, 0}}, along_x), 5.0);   // a point beyond it
  EXPECT_EQ(distance({{1, 2, 2}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}), 3.0);
  EXPECT_EQ(distance({{1, 2, 2}, {0, 0, 0}}, {{1, 2, 2}, {0, 0, 0}}), 0.0);
}

TEST(ClosestPoints, OfRandomSegmentsOfAllLengths) {
  RandomStream random(1);
  for (int round = 0; round < test::rounds(200'000); ++round) {
    const auto segment = [&] {
      const double long_m = std::exp(random.uniform(-14.0, 7.0));
      return Segment{direction(random) * random.uniform(0.0, 3.0), direction(random) * long_m};
    };
    const Segment first = segment();
    const Segment second = segment();
    ASSERT_NO_FATAL_FAILURE(expect_closest_both_ways(first, second, 1e-12 * size_of(first, second)))
        << "round " << round;
  }
}

// Segments that cross, to within a few roundings: their distance is almost zero.
TEST(ClosestPoints, OfSegmentsThatMeet) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const Vector3 meet = direction(random) * random.uniform(0.0, 2.0);
    const auto through = [&] {
      const Vector3 way = direction(random) * std::exp(random.uniform(-5.0, 5.0));
      return Segment{meet - way * random.uniform(), way};
    };
    const Segment first = through();
    const Segment second = through();
    ASSERT_NO_FATAL_FAILURE(expect_closest_both_ways(first, second, 1e-11 * size_of(first, second)))
        << "round " << round;
  }
}

// The worst case at any angle: each segment crosses over the other, near or far.
TEST(ClosestPoints, OfParallelSegments) {
  RandomStream random(4);
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const Vector3 way = direction(random) * std::exp(random.uniform(-10.0, 5.0));
    const Segment first{direction(random), way};
    const Segment second{direction(random), way * random.uniform(-2.0, 2.0)};
    ASSERT_NO_FATAL_FAILURE(expect_closest_both_ways(first, second, 1e-12 * size_of(first, second)))
        << "round " << round;
  }
}

}  // namespace
}  // namespace beespace::avoidance
