#include "c_io/left_out_velocities.hpp"

#include "io/points/record_source.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace beespace::c_io {

namespace {

using io::Role;

bool is_of_velocity(Role role) {
  return role >= Role::kVelocityX && role <= Role::kClimb;
}

// Whether points were read from it: "vx" may be the x that was asked for.
bool is_read(const io::LoadedPoints& loaded, std::size_t column) {
  const io::ColumnChoice& choice = loaded.records->table->choice;
  const auto* const end = choice.axes.data() + choice.dimensions;
  return choice.id == column || std::find(choice.axes.data(), end, column) != end;
}

}  // namespace

std::string left_out_velocities(const io::LoadedPoints& loaded) {
  if (!loaded.records || !loaded.records->table) return {};
  std::array<bool, io::kRoles> has = {};
  std::string columns;
  io::FieldCursor cursor(io::header_line(loaded), io::delimiter(loaded));
  io::Field field;
  for (std::size_t column = 0; cursor.next(field); ++column) {
    if (is_read(loaded, column)) continue;
    const std::string name(io::unquoted(field));
    const Role role = io::read_column_name(io::track_columns(), name).role;
    has[io::index_of(role)] = true;
    if (!is_of_velocity(role)) continue;
    columns.append(columns.empty() ? "" : ", ").append(std::to_string(column + 1));
    columns.append(" ").append(io::excerpt(name));
  }
  // One part of it is no velocity: a speed may be anything.
  const auto both = [&has](Role one, Role other) {
    return has[io::index_of(one)] && has[io::index_of(other)];
  };
  const bool any = both(Role::kVelocityX, Role::kVelocityY) ||
                   both(Role::kVelocityEast, Role::kVelocityNorth) ||
                   both(Role::kGroundSpeed, Role::kTrack);
  if (!any) return {};
  return "velocities, in columns " + columns +
         ", are left out: points have none; read the file as a recording for them";
}

}  // namespace beespace::c_io
