#include <beespace/geodesy.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/geodesy/positions.hpp"

namespace beespace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// FNV-1a over the bits of all coordinates, in order.
std::uint64_t fingerprint(const std::vector<Point>& points) {
  std::uint64_t hash = 14'695'981'039'346'656'037u;
  for (const Point& point : points) {
    for (const double coordinate : {point.x, point.y, point.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 1'099'511'628'211u;
    }
  }
  return hash;
}

ErrorCode code_of(const GeographicPosition& position) {
  const Result<Point> result = to_ecef(position);
  EXPECT_FALSE(result.has_value());
  return result.has_value() ? ErrorCode::kInvalidArgument : result.error().code;
}

TEST(Ecef, AxesPointWhereTheyShould) {
  const Point x = to_ecef(GeographicPosition{0.0, 0.0, 0.0}).value();
  EXPECT_EQ(x, (Point{6'378'137.0, 0.0, 0.0}));
  const Point y = to_ecef(GeographicPosition{90.0, 0.0, 0.0}).value();
  EXPECT_EQ(y, (Point{0.0, 6'378'137.0, 0.0}));
  const Point z = to_ecef(GeographicPosition{0.0, 90.0, 0.0}).value();
  EXPECT_EQ(z.x, 0.0);
  EXPECT_EQ(z.y, 0.0);
  EXPECT_NEAR(z.z, 6'356'752.314245179, 1e-8);  // the published semi-minor axis
}

TEST(Ecef, FullTurnsAndBothZerosGiveTheSameBits) {
  const Point here = to_ecef(GeographicPosition{0.0, 0.0, 7.0}).value();
  for (const GeographicPosition same :
       {GeographicPosition{-0.0, -0.0, 7.0}, GeographicPosition{360.0, 0.0, 7.0},
        GeographicPosition{-360.0, -0.0, 7.0}}) {
    EXPECT_EQ(fingerprint({to_ecef(same).value()}), fingerprint({here}));
  }
  EXPECT_EQ(to_ecef(GeographicPosition{-180.0, 12.0, 1.0}).value(),
            to_ecef(GeographicPosition{180.0, 12.0, 1.0}).value());
  EXPECT_EQ(to_ecef(GeographicPosition{10.0, 90.0, 1.0}).value(),
            to_ecef(GeographicPosition{200.0, 90.0, 1.0}).value());
}

TEST(Ecef, EveryMachineReturnsTheseBits) {
  const Point bee = to_ecef(GeographicPosition{-75.5499363497, 6.31612928218, 1683.77}).value();
  EXPECT_EQ(bee.x, 0x1.8253c69d2df9p+20);
  EXPECT_EQ(bee.y, -0x1.76cd2ac6d8022p+22);
  EXPECT_EQ(bee.z, 0x1.546e276a8f09cp+19);

  std::vector<Point> points = geodesy_test::random_positions(100'000, 3);
  ASSERT_TRUE(to_ecef(points, points).has_value());
  EXPECT_EQ(fingerprint(points), 13'197'325'161'430'188'905u);
  points = geodesy_test::hard_positions();
  ASSERT_TRUE(to_ecef(points, points).has_value());
  EXPECT_EQ(fingerprint(points), 3'260'264'240'945'909'936u);
}

TEST(Ecef, OneAtATimeInPlaceAndSeparateArraysGiveTheSameBits) {
  const std::vector<Point> positions = geodesy_test::random_positions(1'003, 4);
  std::vector<Point> single;
  std::vector<double> longitudes;
  std::vector<double> latitudes;
  std::vector<double> heights;
  for (const Point& position : positions) {
    single.push_back(to_ecef(GeographicPosition{position.x, position.y, position.z}).value());
    longitudes.push_back(position.x);
    latitudes.push_back(position.y);
    heights.push_back(position.z);
  }
  std::vector<Point> in_place = positions;
  ASSERT_TRUE(to_ecef(in_place, in_place).has_value());
  EXPECT_EQ(fingerprint(in_place), fingerprint(single));
  std::vector<Point> separate(positions.size());
  ASSERT_TRUE(to_ecef(PointsView::separate(longitudes, latitudes, heights), separate).has_value());
  EXPECT_EQ(fingerprint(separate), fingerprint(single));
}

TEST(Ecef, EverySizeAroundABlockIsConvertedWhole) {
  const std::vector<Point> positions = geodesy_test::random_positions(260, 5);
  for (const std::size_t size : {0u, 1u, 2u, 127u, 128u, 129u, 255u, 256u, 257u}) {
    const std::vector<Point> some(positions.begin(),
                                  positions.begin() + static_cast<std::ptrdiff_t>(size));
    std::vector<Point> ecef(size, Point{kNan, kNan, kNan});
    ASSERT_TRUE(to_ecef(some, ecef).has_value());
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(ecef[i], to_ecef(GeographicPosition{some[i].x, some[i].y, some[i].z}).value());
    }
  }
}

TEST(Ecef, TheLimitsThemselvesAreValid) {
  EXPECT_TRUE(to_ecef(GeographicPosition{360.0, 90.0, kGreatestHeight_m}).has_value());
  EXPECT_TRUE(to_ecef(GeographicPosition{-360.0, -90.0, kLowestHeight_m}).has_value());
}

TEST(Ecef, OneUlpBeyondALimitIsAnErrorOfItsOwnKind) {
  const double beyond_90 = std::nextafter(90.0, 100.0);
  const double beyond_360 = std::nextafter(360.0, 400.0);
  EXPECT_EQ(code_of({0.0, beyond_90, 0.0}), ErrorCode::kInvalidLatitude);
  EXPECT_EQ(code_of({0.0, -beyond_90, 0.0}), ErrorCode::kInvalidLatitude);
  EXPECT_EQ(code_of({beyond_360, 0.0, 0.0}), ErrorCode::kInvalidLongitude);
  EXPECT_EQ(code_of({-beyond_360, 0.0, 0.0}), ErrorCode::kInvalidLongitude);
  EXPECT_EQ(code_of({0.0, 0.0, std::nextafter(kGreatestHeight_m, 2e6)}), ErrorCode::kInvalidHeight);
  EXPECT_EQ(code_of({0.0, 0.0, std::nextafter(kLowestHeight_m, -2e6)}), ErrorCode::kInvalidHeight);
  EXPECT_EQ(code_of({1e300, 0.0, 0.0}), ErrorCode::kInvalidLongitude);
}

TEST(Ecef, NanAndInfinityAreNotFiniteInEveryField) {
  for (const double bad :
       {kNan, -kNan, kInfinity, -kInfinity, std::numeric_limits<double>::signaling_NaN()}) {
    EXPECT_EQ(code_of({bad, 0.0, 0.0}), ErrorCode::kNotFinite);
    EXPECT_EQ(code_of({0.0, bad, 0.0}), ErrorCode::kNotFinite);
    EXPECT_EQ(code_of({0.0, 0.0, bad}), ErrorCode::kNotFinite);
  }
}

TEST(Ecef, TheFirstBadPositionIsNamed) {
  for (const std::size_t first : {0u, 1u, 127u, 128u, 300u, 399u}) {
    std::vector<Point> positions = geodesy_test::random_positions(400, 6);
    positions[first].y = 91.0;
    positions.back().x = first == 399u ? positions.back().x : kNan;
    std::vector<Point> ecef(positions.size());
    const Status status = to_ecef(positions, ecef);
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidLatitude);
    EXPECT_EQ(status.error().location.record, first);
    EXPECT_NE(status.error().message.find("91"), std::string::npos) << status.error().message;
  }
}

TEST(Ecef, DifferentSizesAreAnError) {
  const std::vector<Point> positions(3);
  std::vector<Point> ecef(2);
  const Status status = to_ecef(positions, ecef);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace beespace
