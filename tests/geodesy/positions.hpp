// Positions all over the Earth, for the tests of this room: hard ones and random ones.
#pragma once

#include <beespace/point.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace beespace::geodesy_test {

// Every combination of edges, their neighbours among the doubles, and both zeros.
inline std::vector<Point> hard_positions() {
  const std::array longitudes = {-360.0,
                                 -315.0,
                                 -270.0,
                                 -225.0,
                                 -180.0,
                                 -135.0,
                                 -90.0,
                                 -45.0,
                                 -1e-9,
                                 -0.0,
                                 0.0,
                                 5e-324,
                                 1e-9,
                                 30.0,
                                 45.0,
                                 90.0,
                                 135.0,
                                 180.0,
                                 179.9999999999999,
                                 225.0,
                                 270.0,
                                 315.0,
                                 360.0,
                                 -75.55};
  const std::array latitudes = {-90.0, -89.99999999, -45.0, -1e-300, -0.0, 0.0,
                                1e-12, 6.33,         45.0,  89.9999, 90.0};
  const std::array heights = {-12'000.0, -0.0, 0.0, 1'500.0, 1'000'000.0};
  std::vector<Point> positions;
  for (const double longitude : longitudes) {
    for (const double latitude : latitudes) {
      for (const double height : heights) {
        positions.push_back({longitude, latitude, height});
        positions.push_back({std::nextafter(longitude, 0.0), std::nextafter(latitude, 0.0),
                             std::nextafter(height, 0.0)});
      }
    }
  }
  return positions;
}

// The engine is specified by the standard; the conversion divides by a power of two, so the
// positions are the same on every machine.
inline std::vector<Point> random_positions(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto between = [&engine](double low, double high) {
    const double unit = static_cast<double>(engine() >> 11u) * 0x1p-53;
    const double scaled = (high - low) * unit;
    return low + scaled;
  };
  std::vector<Point> positions(count);
  for (Point& position : positions) {
    position.x = between(-360.0, 360.0);
    position.y = between(-90.0, 90.0);
    position.z = between(-12'000.0, 1'000'000.0);
  }
  return positions;
}

}  // namespace beespace::geodesy_test
