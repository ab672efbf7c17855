// Our conversion against GeographicLib's, which is an independent and long-proven one.
#include <beespace/geodesy.hpp>

#include <gtest/gtest.h>
#include <GeographicLib/Geocentric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/geodesy/positions.hpp"

namespace beespace {
namespace {

constexpr double kPromised_m = 1e-8;

double greatest_difference(const std::vector<Point>& positions) {
  std::vector<Point> ours(positions.size());
  const Status status = to_ecef(positions, ours);
  EXPECT_TRUE(status.has_value());
  const auto& oracle = GeographicLib::Geocentric::WGS84();
  double greatest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Point theirs;
    oracle.Forward(positions[i].y, positions[i].x, positions[i].z, theirs.x, theirs.y, theirs.z);
    const double difference =
        std::max({std::abs(ours[i].x - theirs.x), std::abs(ours[i].y - theirs.y),
                  std::abs(ours[i].z - theirs.z)});
    if (!(difference <= greatest)) greatest = difference;
  }
  return greatest;
}

TEST(EcefAgainstGeographicLib, AgreesAtPolesAntimeridianFullTurnsAndZeros) {
  EXPECT_LT(greatest_difference(geodesy_test::hard_positions()), kPromised_m);
}

TEST(EcefAgainstGeographicLib, AgreesAtRandomPositionsUpToAThousandKilometres) {
  EXPECT_LT(greatest_difference(geodesy_test::random_positions(500'000, 1)), kPromised_m);
}

TEST(EcefAgainstGeographicLib, AgreesInsideOneSwarm) {
  std::vector<Point> positions = geodesy_test::random_positions(100'000, 2);
  for (Point& position : positions) {
    position = {-75.555 + position.x * 1e-4, 6.34 + position.y * 1e-4, 1'310.0 + position.z * 1e-3};
  }
  EXPECT_LT(greatest_difference(positions), kPromised_m);
}

}  // namespace
}  // namespace beespace
