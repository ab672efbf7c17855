#include "io/plans/plan_columns.hpp"
#include "io/table/column_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

std::string role_text(Role role) {
  constexpr std::pair<Role, std::string_view> kGroups[] = {{Role::kX, "position "},
                                                           {Role::kVelocityX, "velocity "},
                                                           {Role::kGoalX, "goal "},
                                                           {Role::kPreferredX, "wish "}};
  for (const auto& [first, what] : kGroups) {
    if (const auto axis = part_within(first, role)) return std::string(what) + "xyz"[*axis];
  }
  switch (role) {
    case Role::kId:
      return "id";
    case Role::kMaxSpeed:
      return "max_speed";
    case Role::kMaxAcceleration:
      return "max_acceleration";
    case Role::kLongitude:
    case Role::kLatitude:
      return "degrees";
    default:
      return role == Role::kNone ? "none" : "another";
  }
}

std::string meaning(std::string_view name) {
  const ColumnMeaning word = read_column_name(plan_columns(), name);
  const std::string text = role_text(word.role);
  if (word.unit != Unit::kUnstated && word.unit != Unit::kMetre &&
      word.unit != Unit::kMetrePerSecond) {
    return text + " in " + std::string(symbol_of(word.unit));
  }
  return word.foreign_unit.empty() ? text : text + " in " + word.foreign_unit;
}

void expect_meaning(std::string_view expected, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) EXPECT_EQ(meaning(name), expected) << name;
}

TEST(PlanWords, WhereABeeIs) {
  expect_meaning("position x", {"x", "X", " x [m]", "pos_x", "start_x", "from x (m)", "current_x",
                                "startX", "easting"});
  expect_meaning("position y", {"y", "position_y", "y_m", "initial_y", "North"});
  expect_meaning("position z", {"z", "Z", "start_z", "up"});
}

TEST(PlanWords, WhereItWantsToGo) {
  expect_meaning("goal x", {"goal_x", "Goal X [m]", "goalX", "target_x", "destination_x", "dest x",
                            "x_goal", "x_target", "goal_pos_x", "desired_x", "ziel_x"});
  expect_meaning("goal z", {"goal_z", "goalz", "target-z", "wanted z"});
}

TEST(PlanWords, HowFastItFliesAndHowFastItWouldLikeTo) {
  expect_meaning("velocity x", {"vx", "v_x", "velocity_x", "vx [m/s]", "initial_vx", "vel_x_mps"});
  expect_meaning("velocity z", {"vz", "speed z"});
  expect_meaning("wish x", {"want_vx", "wish_vx", "preferred_vx", "pref_velocity_x", "target_vx",
                            "desired_velocity_x [m/s]", "vx_wanted"});
  expect_meaning("wish y", {"want_vy", "intended vy"});
}

TEST(PlanWords, WhatItCanDo) {
  expect_meaning("max_speed", {"max_speed", "max_speed_mps", "Max. speed [m/s]", "vmax", "v_max",
                               "speed_limit", "maximum velocity"});
  expect_meaning("max_acceleration", {"max_acceleration", "max_acceleration_mps2", "amax", "a_max",
                                      "max_accel [m/s^2]", "max acc (m/s²)"});
}

TEST(PlanWords, TheId) {
  expect_meaning("id", {"id", "ID", "bee_id", "name", "drone", "bee"});
}

TEST(PlanWords, UnitsThatAreNotReadAreReported) {
  expect_meaning("position x in ft", {"x [ft]"});
  expect_meaning("goal y in km", {"goal_y_km"});
  expect_meaning("velocity x in kt", {"vx_kt"});
  expect_meaning("wish x in kt", {"want_vx_kt"});
  expect_meaning("max_speed in km/h", {"max_speed_kmh"});
  expect_meaning("degrees", {"lon", "latitude", "goal_lat", "x [deg]"});
}

TEST(PlanWords, WhatIsNotUnderstoodToItsLastWordIsNothing) {
  expect_meaning("none", {"", "battery", "goal", "x_error", "goal_x_error", "goal_vx", "speed",
                          "uav_x", "goal_goal_x", "max_x", "max_speed_acceleration", "maximum",
                          "acceleration", "ve", "want_ve", "goal_battery", "last_x", "x y"});
}

}  // namespace
}  // namespace beespace::io
