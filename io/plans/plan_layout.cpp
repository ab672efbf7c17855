#include "io/plans/plan_layout.hpp"

#include "io/bytes/characters.hpp"
#include "io/plans/plan_columns.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/unit_choice.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kExample = "id,x,y,z,goal_x,goal_y,goal_z";

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

// Keeps the only column of that role, if there is one.
std::optional<Error> take(const Header& header, Role role, PlanLayout& layout) {
  const std::vector<std::size_t>& found = header.columns(role);
  if (found.empty()) return std::nullopt;
  const std::string name = column_text(layout.table, found[0]);
  const ColumnMeaning& meaning = header.meaning(found[0]);
  if (!meaning.foreign_unit.empty()) {
    return at_column(ErrorCode::kUnsupportedFormat,
                     name + " is in '" + meaning.foreign_unit +
                         "'; convert it first: beespace reads lengths, speeds and m/s^2",
                     found[0]);
  }
  if (found.size() > 1) {
    return at_column(ErrorCode::kMissingColumn,
                     "both " + name + " and " + column_text(layout.table, found[1]) +
                         " look like the same; keep one, or rename the other",
                     found[1]);
  }
  layout.columns[index_of(role)] = NumberColumn{found[0], meaning.unit};
  return std::nullopt;
}

// Where one of these names a unit, the others do.
std::optional<Error> half_stated(const PlanLayout& layout, const std::vector<Role>& roles) {
  std::vector<ColumnUnit> units;
  for (const Role role : roles) {
    if (!layout.has(role)) continue;
    const auto [column, unit] = *layout.of(role);
    units.push_back(
        {column, unit, unit == Unit::kUnstated ? UnitEvidence::kUsual : UnitEvidence::kNamed});
  }
  return io::half_stated(layout.table.names, units);
}

// Keeps all three of a group, or none.
std::optional<Error> take(const Header& header, const RoleGroup& group, PlanLayout& layout) {
  std::string there;
  std::string lacking;
  for (const Role role : group.roles) {
    if (auto error = take(header, role, layout)) return error;
    const bool found = layout.has(role);
    std::string& list = found ? there : lacking;
    list.append(list.empty() ? "" : ", ")
        .append(found ? excerpt(layout.table.names[layout.of(role)->column])
                      : std::string(header.schema().name_of(role)));
  }
  if (there.empty()) return std::nullopt;
  if (lacking.empty()) {
    return half_stated(layout, {group.roles.begin(), group.roles.end()});
  }
  return missing("a " + std::string(group.what) + " needs three columns, and beside " + there +
                 " there is no " + lacking + "; add it (" + list_columns(layout.table) + ")");
}

// "id" before "name" and "frame_id".
std::optional<std::size_t> find_id(const Header& header) {
  const std::vector<std::size_t>& found = header.columns(Role::kId);
  if (found.empty()) return std::nullopt;
  const auto plain = std::find_if(found.begin(), found.end(), [&header](std::size_t column) {
    return lower_case(header.table().names[column]) == "id";
  });
  return plain != found.end() ? *plain : found.front();
}

// The columns that are not read, or nothing.
std::string left_over(const PlanLayout& layout) {
  constexpr std::size_t kMostListed = 20;
  std::string list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < layout.table.names.size(); ++i) {
    const auto is_this = [i](const std::optional<NumberColumn>& of) {
      return of && of->column == i;
    };
    const bool used =
        layout.id == i || std::any_of(layout.columns.begin(), layout.columns.end(), is_this);
    if (used || ++count > kMostListed) continue;
    list.append(list.empty() ? "" : ", ").append(column_text(layout.table, i));
  }
  return list + (count > kMostListed ? ", ..." : "");
}

Error no_position(const Header& header) {
  if (header.has(Role::kLongitude) || header.has(Role::kLatitude)) {
    return {ErrorCode::kUnsupportedFormat,
            "positions in degrees are not read here; convert them to metres along x, y, z first",
            {}};
  }
  return missing("the header names no position: x, y and z are needed (" +
                 list_columns(header.table()) + ")");
}

std::optional<Error> unmet(PlanNeed need, const PlanLayout& layout) {
  if (need == PlanNeed::kNothing || layout.has(Role::kGoalX)) return std::nullopt;
  if (layout.has(Role::kPreferredX) && need == PlanNeed::kGoalsOrPreferred) return std::nullopt;
  std::string wanted = "no goals: goal_x, goal_y and goal_z are needed";
  if (need == PlanNeed::kGoalsOrPreferred) {
    wanted =
        "neither goals nor preferred velocities: goal_x, goal_y, goal_z or want_vx, want_vy, "
        "want_vz are "
        "needed";
  }
  return missing("the header names " + wanted + " (" + list_columns(layout.table) + ")");
}

// What is to be said of units: which are named, and that the rest are ours.
std::vector<UnitTaken> units_taken(const PlanLayout& layout) {
  struct Said {
    Role role;
    const char* of;
    Unit ours;
  };
  std::vector<UnitTaken> units;
  for (const auto& [role, of, ours] :
       {Said{Role::kX, "positions", Unit::kMetre},
        {Role::kVelocityX, "velocities", Unit::kMetrePerSecond},
        {Role::kGoalX, "goals", Unit::kMetre},
        {Role::kPreferredX, "preferred velocities", Unit::kMetrePerSecond},
        {Role::kMaxSpeed, "greatest speeds", Unit::kMetrePerSecond}}) {
    if (!layout.has(role)) continue;
    const auto [column, unit] = *layout.of(role);
    if (unit == Unit::kUnstated) {
      units.push_back({of, ours, UnitEvidence::kUsual, "no unit is named"});
    } else {
      units.push_back({of, unit, UnitEvidence::kNamed,
                       "the header names it: " + excerpt(layout.table.names[column])});
    }
  }
  return units;
}

std::optional<Error> choose_columns_of(PlanLayout& layout, PlanNeed need) {
  if (layout.table.names.empty()) {
    return missing(
        "there is no header that names the columns; put one before the first record, "
        "for example " +
        std::string(kExample));
  }
  const ColumnOptions options;
  const ColumnsByRole overrides = {};
  const Header header(plan_columns(), options, layout.table, overrides);
  for (const RoleGroup& group : plan_columns().groups) {
    if (auto error = take(header, group, layout)) return error;
    if (!layout.has(Role::kX)) return no_position(header);
  }
  for (const Role role : {Role::kMaxSpeed, Role::kMaxAcceleration}) {
    if (auto error = take(header, role, layout)) return error;
  }
  // Places belong together, and so do speeds.
  for (const auto& roles :
       {std::vector<Role>{Role::kX, Role::kY, Role::kZ, Role::kGoalX, Role::kGoalY, Role::kGoalZ},
        {Role::kVelocityX, Role::kVelocityY, Role::kVelocityZ, Role::kPreferredX, Role::kPreferredY,
         Role::kPreferredZ, Role::kMaxSpeed}}) {
    if (auto error = half_stated(layout, roles)) return error;
  }
  layout.id = find_id(header);
  if (!layout.id) {
    layout.notes.emplace_back("there is no id: bees are numbered in their order, from 0");
  }
  layout.units = units_taken(layout);
  if (auto error = unmet(need, layout)) return error;
  if (const std::string left = left_over(layout); !left.empty()) {
    layout.notes.push_back("not read: " + left);
  }
  return std::nullopt;
}

}  // namespace

Result<PlanLayout> find_plan_layout(std::string_view text, PlanNeed need) {
  auto table = find_table(text, false);
  if (!table) return table.error();
  if (need != PlanNeed::kNothing) {
    if (auto error = no_record_problem(text, *table)) return *std::move(error);
  }
  PlanLayout layout;
  layout.table = std::move(table).value();
  if (auto error = choose_columns_of(layout, need)) {
    return at_first_line(*std::move(error), layout.table);
  }
  return layout;
}

}  // namespace beespace::io
