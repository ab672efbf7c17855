// East, north and up, found again in the frame of the Earth.
#include "report/local_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

TEST(LocalAxes, AreThoseThatVelocitiesAreGivenIn) {
  const LocalVelocity given{80.0, -3.0, 0.5};
  for (const double height_m : {-400.0, 0.0, 12'000.0, 1'000'000.0}) {
    for (const double latitude_deg : {-89.9, -45.0, 0.0, 6.25, 50.0, 89.9}) {
      for (const double longitude_deg : {-180.0, -75.6, 0.0, 90.0, 179.0}) {
        const GeographicPosition place{longitude_deg, latitude_deg, height_m};
        const auto ecef = to_ecef(place);
        const auto velocity = to_ecef_velocity(place, given);
        ASSERT_TRUE(ecef.has_value() && velocity.has_value());
        const LocalVelocity found = to_local_velocity(*ecef, *velocity);
        EXPECT_NEAR(found.east_mps, given.east_mps, 1e-8);
        EXPECT_NEAR(found.north_mps, given.north_mps, 1e-8) << latitude_deg << ", " << height_m;
        EXPECT_NEAR(found.up_mps, given.up_mps, 1e-8) << latitude_deg << ", " << height_m;
      }
    }
  }
}

TEST(LocalAxes, AreThereWhereEastIsAnywhere) {
  const LocalVelocity pole = to_local_velocity({0, 0, 6'356'752.0}, {1, 2, 3});
  EXPECT_NEAR(pole.east_mps, 2.0, 1e-12);
  EXPECT_NEAR(pole.north_mps, -1.0, 1e-12);
  EXPECT_NEAR(pole.up_mps, 3.0, 1e-12);
  const LocalVelocity nowhere = to_local_velocity({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(nowhere.east_mps, 2.0);
}

std::vector<Point> places_at(const std::vector<std::pair<double, double>>& degrees) {
  std::vector<Point> ecef;
  for (const auto& [longitude_deg, latitude_deg] : degrees) {
    ecef.push_back(*to_ecef(GeographicPosition{longitude_deg, latitude_deg, 100.0}));
  }
  return ecef;
}

// There is an origin, and all positions can be converted back.
void expect_places(const std::vector<Point>& ecef) {
  const LocalPlaces local = around_middle(ecef);
  ASSERT_TRUE(to_ecef(local.origin).has_value())
      << local.origin.longitude_deg << ", " << local.origin.latitude_deg;
  EXPECT_EQ(local.origin.height_m, 0.0);
  ASSERT_EQ(local.places.size(), ecef.size());
  const EarthFrame frame(local.origin);
  for (std::size_t i = 0; i < ecef.size(); ++i) {
    const auto again = to_ecef(frame.position_of(local.places[i]));
    ASSERT_TRUE(again.has_value());
    const double off_m =
        std::hypot(again->x - ecef[i].x, again->y - ecef[i].y, again->z - ecef[i].z);
    ASSERT_LT(off_m, 1e-3);
  }
}

TEST(ToGeographic, HasALatitudeDeepInsideTheEarth) {
  for (const double from_axis_m : {0.0, 1e-9, 1.0, 30'000.0, 42'697.0, 50'000.0, 6'200'000.0}) {
    for (const double z : {0.0, -0.0, 1e-9, -1.0, 40'000.0, -42'000.0, 6'200'000.0, -6'300'000.0}) {
      for (const double side : {1.0, -1.0}) {
        const GeographicPosition place = to_geographic({side * from_axis_m, 0.0, z});
        EXPECT_LE(std::abs(place.latitude_deg), 90.0) << from_axis_m << ", " << z;
        EXPECT_LE(std::abs(place.longitude_deg), 180.0) << from_axis_m << ", " << z;
        EXPECT_TRUE(place.latitude_deg * z >= 0.0) << from_axis_m << ", " << z;
        EXPECT_TRUE(std::isfinite(place.height_m));
      }
    }
  }
}

TEST(AroundMiddle, OfAntipodesIsBelowOneOfThem) {
  expect_places(places_at({{0.0, 0.0}, {180.0, 0.0}}));
  expect_places(places_at({{-75.5, 6.25}, {104.5, -6.25}}));
  expect_places(places_at({{0.0, 90.0}, {0.0, -90.0}}));
  expect_places(places_at({{0.0, -90.0}, {0.0, 90.0}, {0.0, 90.0}}));
  const LocalPlaces local = around_middle(places_at({{20.0, 0.0}, {-160.0, 0.0}}));
  EXPECT_NEAR(local.origin.longitude_deg, 20.0, 1e-9);
  EXPECT_NEAR(local.origin.latitude_deg, 0.0, 1e-9);
}

TEST(AroundMiddle, IsAPlaceWhereBeesAreAroundTheWholeEarth) {
  expect_places(places_at({{0.0, 0.0}, {120.0, 0.0}, {-120.0, 0.0}}));
  expect_places(places_at({{0.0, 0.5}, {120.0, 0.0}, {-120.0, 0.0}}));
  expect_places({{0, 0, 6'356'752.0}, {0, 0, -6'356'700.0}});
  std::vector<std::pair<double, double>> globe;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {  // a spiral from pole to pole: each has as much room
    const double sine = 1.0 - (2.0 * i + 1.0) / kCount;
    globe.emplace_back(std::fmod(137.507764 * i, 360.0), std::asin(sine) * 57.29577951308232);
  }
  expect_places(places_at(globe));
}

TEST(AroundMiddle, IsBelowTheOnlyOneInTheMiddleOfTheEarth) {
  const LocalPlaces local = around_middle(std::vector<Point>{{0, 0, 0}});
  EXPECT_TRUE(to_ecef(local.origin).has_value());
  EXPECT_TRUE(around_middle({}).places.empty());
}

}  // namespace
}  // namespace beespace::report
