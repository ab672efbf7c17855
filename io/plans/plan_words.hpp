// What the name of a column says of a bee and of what it intends.
//
// As in header_words.hpp, a name is understood to its last word or not at all: "x", "start_x",
// "goal_x [m]", "target_y", "vx", "want_vx", "preferred_velocity_z", "max_speed_mps".
#pragma once

#include "io/units/units.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

enum class PlanRole : std::uint8_t {
  kNone,
  kId,
  kPosition,
  kVelocity,
  kGoal,
  kWish,  // the velocity that the bee would like to have
  kMaxSpeed,
  kMaxAcceleration,
  kDegrees,  // longitude or latitude
};

struct PlanWord {
  PlanRole role = PlanRole::kNone;
  std::size_t axis = 0;  // of what has three: 0 for x, 1 for y, 2 for z
  Unit unit = Unit::kUnstated;
  std::string foreign_unit = {};  // a unit that is not read: "g", "h", ...
};

PlanWord read_plan_word(std::string_view name);

}  // namespace beespace::io
