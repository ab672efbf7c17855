// The last place of a drone, said again and again while it hovers or flies on: and what truly
// hovers without moving, as in a simulation.
#include "io/recording/frozen_in_air.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Way = std::function<Point(double time_s)>;

// Once a second, rounded to centimetres, with a place that is kept from then to then.
std::vector<Fix> heard(const Way& way, double frozen_from_s, double until_s) {
  const auto rounded = [](double metres) { return std::round(metres * 100.0) / 100.0; };
  std::vector<Fix> fixes;
  for (int second = 0; second <= 120; ++second) {
    const double time_s = second;
    const bool frozen = time_s > frozen_from_s && time_s <= until_s;
    const Point at = way(frozen ? frozen_from_s : time_s);
    fixes.push_back({time_s, {rounded(at.x), rounded(at.y), rounded(at.z)}});
  }
  return fixes;
}

// Up to 20 m in the first 10 s and down again in the last 10 s.
double height_at(double time_s) {
  return std::clamp(std::min(2.0 * time_s, 2.0 * (120.0 - time_s)), 0.0, 20.0);
}

// As the wind and its estimator have it, which on the ground are still.
Point hovers(double time_s) {
  const double z = height_at(time_s);
  if (z < 0.5) return {0.0, 0.0, z};
  return {0.12 * std::sin(0.7 * time_s), 0.10 * std::cos(0.9 * time_s),
          z + 0.08 * std::sin(0.5 * time_s)};
}

std::ptrdiff_t frozen_count(const std::vector<Fix>& fixes) {
  const auto frozen = frozen_in_air(fixes, Frame::kMetres);
  return std::count(frozen.begin(), frozen.end(), true);
}

TEST(FrozenInAir, WhoHoversIsNowhereExactly) {
  EXPECT_EQ(frozen_count(heard(hovers, 500, 0)), 0);
  const auto fixes = heard(hovers, 50, 59);
  EXPECT_EQ(frozen_count(fixes), 9);
  EXPECT_FALSE(frozen_in_air(fixes, Frame::kMetres)[50]) << "there it was";
  EXPECT_EQ(frozen_count(heard(hovers, 50, 500)), 70) << "to the end";
  EXPECT_EQ(frozen_count(heard(hovers, 50, 53)), 0) << "too short to tell";
}

TEST(FrozenInAir, WhoGoesOnFasterThanItCameWasElsewhere) {
  const Way flies = [](double time_s) {
    const double way_s = std::clamp(time_s - 15.0, 0.0, 60.0);
    return Point{(way_s < 30.0 ? 0.5 * way_s : 2.0 * way_s - 45.0) * 1.001, 0.0, height_at(time_s)};
  };
  EXPECT_EQ(frozen_count(heard(flies, 30, 40)), 10);
}

// It never hovers, but its height swings by centimetres.
TEST(FrozenInAir, WhoGoesLevelOnTheEarthIsNotStillAtOnce) {
  const Way cruises = [](double time_s) {
    return Point{19.0 + 3e-6 * time_s, 47.0 + 2e-6 * time_s,
                 height_at(time_s) + (time_s < 1.0 ? 0.0 : 0.08 * std::sin(0.5 * time_s))};
  };
  std::vector<Fix> fixes;
  for (int second = 0; second <= 100; ++second) {
    const Point at = cruises(std::min(second, 50));
    fixes.push_back({static_cast<double>(second), {at.x, at.y, std::round(at.z * 100.0) / 100.0}});
  }
  const auto frozen = frozen_in_air(fixes, Frame::kWgs84);
  EXPECT_EQ(std::count(frozen.begin(), frozen.end(), true), 50);
  // It comes to rest.
  for (Fix& fix : fixes) {
    if (fix.time_s >= 49.0) fix.position.z = fixes[49].position.z;
  }
  EXPECT_TRUE(frozen_in_air(fixes, Frame::kWgs84).empty());
}

// A simulation stops at once, hovers exactly, and goes on from there.
TEST(FrozenInAir, WhatIsComputedHoversExactly) {
  const Way waits = [](double time_s) {
    const double way_s = time_s < 40.0 ? time_s : time_s < 70.0 ? 40.0 : time_s - 30.0;
    return Point{1.5 * way_s, 0.3 * way_s, height_at(time_s)};
  };
  EXPECT_EQ(frozen_count(heard(waits, 500, 0)), 0);
  // What a controller brings to rest gets there slowly.
  const Way settles = [](double time_s) {
    const double swing = 0.6 * std::exp(-0.12 * time_s) * std::sin(0.9 * time_s);
    return Point{swing, swing / 2.0, height_at(time_s) + swing};
  };
  EXPECT_EQ(frozen_count(heard(settles, 500, 0)), 0);
}

TEST(FrozenInAir, WhatStandsOrIsRoundedRepeatsItself) {
  const Way stands = [](double) { return Point{1.0, 2.0, 100.0}; };
  EXPECT_EQ(frozen_count(heard(stands, 500, 0)), 0);
  auto rough = heard(hovers, 50, 59);
  for (Fix& fix : rough) {
    fix.position.x = std::round(fix.position.x * 4.0) / 4.0;
    fix.position.y = std::round(fix.position.y * 4.0) / 4.0;
    fix.position.z = std::round(fix.position.z * 4.0) / 4.0;
  }
  EXPECT_EQ(frozen_count(rough), 0);
  // On the ground nothing is asked.
  const Way low = [](double time_s) {
    const Point at = hovers(time_s);
    return Point{at.x, at.y, at.z / 10.0};
  };
  EXPECT_EQ(frozen_count(heard(low, 50, 59)), 0);
}

std::string table_of(const std::string& header, const std::vector<Fix>& fixes) {
  std::string text = header;
  for (const Fix& fix : fixes) {
    char line[120];
    std::snprintf(line, sizeof line, "a,%.1f,%.2f,%.2f,%.2f\n", fix.time_s, fix.position.x,
                  fix.position.y, fix.position.z);
    text += line;
  }
  return text;
}

TEST(FrozenInAir, IsUnknownInTablesOfDrones) {
  const auto fixes = heard(hovers, 50, 59);
  const auto drones = recording_of(record(table_of("drone_id,time_s,x_m,y_m,z_m\n", fixes)));
  EXPECT_EQ(drones.missing.count, 9u);
  EXPECT_EQ(drones.bees[0].fixes.size(), 112u);
  EXPECT_TRUE(has_note(drones, "that repeat a place exactly in the air"));
  ASSERT_EQ(drones.bees[0].lost.size(), 1u);
  EXPECT_EQ(drones.bees[0].lost[0].begins_s, 50.0);
  EXPECT_EQ(drones.bees[0].lost[0].ends_s, 60.0);
}

}  // namespace
}  // namespace beespace::io
