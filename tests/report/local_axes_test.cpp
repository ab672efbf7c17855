// East, north and up, found again in the frame of the Earth.
#include "report/local_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace beespace::report
