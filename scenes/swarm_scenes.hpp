// Generated swarms: one set of scenes for the generate command, the demo, tests and benchmarks.
//
// The same arguments give the same doubles on every machine. Values are returned; nothing is
// kept. Cost: 10 to 100 nanoseconds a point. Sizes and distances are in metres.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::scenes {

// Uniform in the box from the origin to `size`.
std::vector<Point> uniform_box(std::size_t count, const Point& size, std::uint64_t seed);

// Around `clusters` centres (at least one) that are uniform in the cube [0, side]^3, each bee
// about `sigma` from its centre on every axis: nearly normal, never beyond 6 sigma.
std::vector<Point> gaussian_clusters(std::size_t count, std::uint32_t clusters, double sigma,
                                     double side, std::uint64_t seed);

// A part of the Earth: WGS84 degrees, and metres above the ellipsoid.
struct Area {
  std::string_view name;
  double west_deg;
  double east_deg;
  double south_deg;
  double north_deg;
  double lowest_m;
  double highest_m;
};

// The region of the course files, near Medellín.
inline constexpr Area kMedellin{"medellin", -75.57, -75.54, 6.327, 6.348, 1'310.0, 1'790.0};

std::optional<Area> find_area(std::string_view name);

// Uniform in the area's ranges; x is the longitude, y the latitude, z the height.
std::vector<Point> geographic_area(std::size_t count, const Area& area, std::uint64_t seed);

}  // namespace beespace::scenes
