#include "io/plans/plan_columns.hpp"

#include "io/table/position_columns.hpp"
#include "io/tracks/track_columns.hpp"

namespace beespace::io {
namespace {

// "max_speed", "vmax [m/s]", "acceleration limit".
NamePattern limits() {
  constexpr unsigned kBoth = Says::kNoun | Says::kQualifier;
  NamePattern pattern;
  pattern.words = {
      {Says::kQualifier, "max maximum greatest limit top"},
      {kBoth, "vmax", Role::kMaxSpeed},
      {kBoth | Says::kNoUnit, "amax", Role::kMaxAcceleration},
      {Says::kNoun, "speed velocity vel v", Role::kMaxSpeed},
      {Says::kNoun | Says::kNoUnit, "acceleration accel acc a", Role::kMaxAcceleration},
      {Says::kForeign, "kt kts kn knot knots kmh kph mph fps h g"},
      {Says::kBeside,
       "m s mps mps2 ms ms2 s2 s² 2 per meter meters metre metres sec second squared"},
  };
  pattern.needed = kBoth;
  pattern.unit = UnitPlace::kLast;
  pattern.quantity = Quantity::kSpeed;
  return pattern;
}

ColumnSchema make_plan_columns() {
  ColumnSchema schema;
  schema.roles = {
      {Role::kX, "x"},
      {Role::kY, "y"},
      {Role::kZ, "z"},
      {Role::kVelocityX, "vx"},
      {Role::kVelocityY, "vy"},
      {Role::kVelocityZ, "vz"},
      {Role::kGoalX, "goal_x"},
      {Role::kGoalY, "goal_y"},
      {Role::kGoalZ, "goal_z"},
      {Role::kPreferredX, "want_vx"},
      {Role::kPreferredY, "want_vy"},
      {Role::kPreferredZ, "want_vz"},
      {Role::kMaxSpeed, "the greatest speed"},
      {Role::kMaxAcceleration, "the greatest acceleration"},
  };
  schema.groups = {
      {"position", {Role::kX, Role::kY, Role::kZ}},
      {"velocity", {Role::kVelocityX, Role::kVelocityY, Role::kVelocityZ}},
      {"goal", {Role::kGoalX, Role::kGoalY, Role::kGoalZ}},
      {"preferred velocity", {Role::kPreferredX, Role::kPreferredY, Role::kPreferredZ}},
  };
  schema.names = {limits(), velocity_names()};
  for (NamePattern pattern : position_columns().names) {
    pattern.intended = pattern.role != Role::kId;
    schema.names.push_back(pattern);
  }
  // Whether x points east is not known here.
  NamePattern& velocity = schema.names[1];
  velocity.intended = true;
  std::erase_if(velocity.words, [](const NameWords& of) { return of.role > Role::kVelocityZ; });
  schema.strict = true;
  // A velocity at the goal would be something else.
  schema.intents = {
      {"start from initial current begin", Role::kX, Role::kVelocityX},
      {"goal destination dest ziel destino objetivo meta", Role::kGoalX, Role::kNone},
      {"target want wanted wish wished preferred pref desired intended setpoint", Role::kGoalX,
       Role::kPreferredX},
  };
  return schema;
}

}  // namespace

const ColumnSchema& plan_columns() {
  static const ColumnSchema schema = make_plan_columns();
  return schema;
}

}  // namespace beespace::io
