// A show of two drones in metres, and logs of it in degrees, by the radii of curvature of WGS84 (10
// m are 0.000132658 degrees of longitude at 47.4731 degrees, and 0.00008994418 of latitude).
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace beespace::cli_test {

inline constexpr std::string_view kLocation =
    R"(,"environment":{"type":"outdoor","location":{"origin":[474731000,190617000,102500],)"
    R"("orientation":"90"}})";

inline std::string drone(const std::string& name, const std::string& x) {
  const auto at = [&x](const std::string& time, const std::string& z) {
    return "[" + time + ",[" + x + ",0," + z + "],[]]";
  };
  return R"({"type":"generic","settings":{"name":")" + name + R"(","home":[)" + x +
         R"(,0,0],"trajectory":{"version":1,"takeoffTime":0,"points":[)" + at("0", "0") + "," +
         at("5", "0") + "," + at("15", "10") + "," + at("25", "10") + "," + at("35", "0") + "]}}}";
}

// Two, 10 m beside each other along x, climb 10 m from 5 s to 15 s, and land from 25 s to 35 s.
inline std::string show_with(std::string_view location) {
  return R"({"version":1,"settings":{"validation":{"minDistance":2}},"swarm":{"drones":[)" +
         drone("Drone 1", "0") + "," + drone("Drone 2", "10") + "]}" + std::string(location) + "}";
}

inline double height_m(int second) {
  if (second < 5 || second > 35) return 0.0;
  if (second < 15) return second - 5.0;
  return second <= 25 ? 10.0 : 35.0 - second;
}

inline constexpr const char* kLogHeader = "timestamp,drone_id,lat,lon,alt_amsl,alt_rel";

// Which fixes are there: of that bee, at that second.
using IsThere = std::function<bool(std::size_t bee, int second)>;

// The second of `ids` is 1 m north of its place at 20 s. They fly again 100 s later.
inline std::string log_of(const std::array<const char*, 2>& ids,
                          const std::string& header = kLogHeader, const IsThere& is_there = {},
                          int seconds = 40) {
  std::string text = header + "\n";
  for (int second = 0; second <= seconds; ++second) {
    for (std::size_t bee = 0; bee < ids.size(); ++bee) {
      if (is_there && !is_there(bee, second)) continue;
      const double latitude = 47.4731 + (bee == 1 && second == 20 ? 0.000008994418 : 0.0);
      const double longitude = 19.0617 + (bee == 1 ? 0.000132657587 : 0.0);
      std::array<char, 160> line = {};
      std::snprintf(line.data(), line.size(), "2025-11-27T19:%02d:%02dZ,%s,%.10f,%.10f,%.2f,%.2f\n",
                    second / 60, second % 60, ids[bee], latitude, longitude,
                    102.5 + height_m(second % 100), height_m(second % 100));
      text += line.data();
    }
  }
  return text;
}

}  // namespace beespace::cli_test
