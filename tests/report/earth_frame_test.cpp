// Places on a wide map of the Earth, there and back, and how true it is.
#include "report/earth_frame.hpp"

#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kRadius_m = 6'371'000.0;

Point ecef_of(double longitude_deg, double latitude_deg, double height_m) {
  return *to_ecef(GeographicPosition{longitude_deg, latitude_deg, height_m});
}

TEST(EarthFrame, HasHeightsAsTheyAre) {
  const EarthFrame frame({8.5, 47.4, 0.0});
  for (const double away_deg : {0.0, 0.01, 1.0, 10.0, 60.0}) {
    for (const double height_m : {-400.0, 0.0, 11'582.4}) {
      const Point place = frame.place_of(ecef_of(8.5 + away_deg, 47.4 - away_deg, height_m));
      EXPECT_NEAR(place.z, height_m, 1e-4) << away_deg;
    }
  }
}

TEST(EarthFrame, CountsFromItsOriginAlongTheGround) {
  const EarthFrame frame({-75.5, 6.25, 0.0});
  const Point origin = frame.place_of(ecef_of(-75.5, 6.25, 1'500.0));
  EXPECT_NEAR(origin.x, 0.0, 1e-6);
  EXPECT_NEAR(origin.y, 0.0, 1e-6);
  // A quarter of a minute of arc: the chord and the arc are the same to a millimetre.
  const double step_deg = 1.0 / 240.0;
  const Point east = frame.place_of(ecef_of(-75.5 + step_deg, 6.25, 0.0));
  EXPECT_NEAR(east.x, distance(ecef_of(-75.5, 6.25, 0.0), ecef_of(-75.5 + step_deg, 6.25, 0.0)),
              1e-3);
  EXPECT_NEAR(east.y, 0.0, 0.01);
  const Point north = frame.place_of(ecef_of(-75.5, 6.25 + step_deg, 0.0));
  EXPECT_NEAR(north.y, distance(ecef_of(-75.5, 6.25, 0.0), ecef_of(-75.5, 6.25 + step_deg, 0.0)),
              1e-3);
  EXPECT_NEAR(north.x, 0.0, 1e-6);
}

// What the header says of lengths, at places around origins from the equator to near the poles.
TEST(EarthFrame, IsAsTrueAsItSays) {
  for (const double latitude_deg : {-80.0, -45.0, 0.0, 6.25, 30.0, 47.4, 60.0, 89.0}) {
    const EarthFrame frame({20.0, latitude_deg, 0.0});
    for (const double away_m : {1e3, 1e4, 1e5, 1e6}) {
      const double share =
          away_m * away_m / (6.0 * kRadius_m * kRadius_m) + 0.0105 * away_m / kRadius_m;
      for (int bearing = 0; bearing < 360; bearing += 15) {
        for (int course = 0; course < 360; course += 15) {
          const GeographicPosition from = frame.position_of(
              {away_m * std::sin(bearing * kDegree), away_m * std::cos(bearing * kDegree), 0.0});
          const GeographicPosition to{
              from.longitude_deg +
                  0.002 * std::sin(course * kDegree) / std::cos(from.latitude_deg * kDegree),
              from.latitude_deg + 0.002 * std::cos(course * kDegree), 0.0};
          if (std::abs(to.latitude_deg) > 89.9 || std::abs(to.longitude_deg) > 180.0) continue;
          const Point a = *to_ecef(from);
          const Point b = *to_ecef(to);
          const double true_m = distance(a, b);
          EXPECT_NEAR(distance(frame.place_of(a), frame.place_of(b)), true_m,
                      (share + 1e-6) * true_m)
              << latitude_deg << ", " << away_m << " m at " << bearing << ", " << course;
        }
      }
    }
  }
}

TEST(EarthFrame, SaysHowStraightFlightIsBent) {
  const EarthFrame frame({8.5, 47.4, 0.0});
  // A straight line sags by d²/(8 R) below the height of its ends.
  for (const double degrees : {0.0005, 0.01, 0.5, 2.0}) {
    const Point a = ecef_of(8.5, 47.4 - degrees, 10'000.0);
    const Point b = ecef_of(8.5, 47.4 + degrees, 10'000.0);
    const double sag_m = distance(a, b) * distance(a, b) / (8.0 * kRadius_m);
    EXPECT_NEAR(bend_m(frame, a, b), sag_m, 0.08 * sag_m) << degrees;
  }
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
