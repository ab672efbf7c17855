#include "io/plans/plan_layout.hpp"

#include "io/bytes/characters.hpp"
#include "io/plans/plan_words.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_wishes.hpp"
#include "io/table/header_words.hpp"
#include "io/table/unit_choice.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kExample = "id,x,y,z,goal_x,goal_y,goal_z";

// What has a column for each axis: what it is, and what its columns may be called.
struct Group {
  PlanRole role;
  std::string_view what;
  std::array<std::string_view, 3> names;
};

constexpr Group kPosition = {PlanRole::kPosition, "position", {"x", "y", "z"}};
constexpr Group kVelocity = {PlanRole::kVelocity, "velocity", {"vx", "vy", "vz"}};
constexpr Group kGoal = {PlanRole::kGoal, "goal", {"goal_x", "goal_y", "goal_z"}};
constexpr Group kWish = {PlanRole::kWish, "wished velocity", {"want_vx", "want_vy", "want_vz"}};

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

// The columns of a header by what they mean.
class PlanHeader {
 public:
  explicit PlanHeader(const ColumnsSeen& seen) : seen_(seen), used_(seen.names.size(), false) {
    for (const std::string& name : seen.names) words_.push_back(read_plan_word(name));
  }

  [[nodiscard]] bool has_degrees() const {
    return std::any_of(words_.begin(), words_.end(),
                       [](const PlanWord& word) { return word.role == PlanRole::kDegrees; });
  }

  // The only column of that role and axis, or none.
  Result<std::optional<NumberColumn>> find(PlanRole role, std::size_t axis) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (words_[i].role != role || words_[i].axis != axis) continue;
      if (found) {
        Error error = missing("both " + text(*found) + " and " + text(i) +
                              " look like the same; keep one, or rename the other");
        error.place.column = i + 1;
        return error;
      }
      found = i;
      if (words_[i].foreign_unit.empty()) continue;
      Error error{ErrorCode::kUnsupportedFormat,
                  text(i) + " is in '" + words_[i].foreign_unit +
                      "'; convert it first: beespace reads lengths, speeds and m/s^2",
                  {}};
      error.place.column = i + 1;
      return error;
    }
    if (!found) return std::optional<NumberColumn>();
    used_[*found] = true;
    return std::optional(NumberColumn{*found, words_[*found].unit});
  }

  // All three of a group, or none.
  Result<std::optional<AxisColumns>> find(const Group& group) {
    AxisColumns columns = {};
    std::string there;
    std::string lacking;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto column = find(group.role, axis);
      if (!column) return column.error();
      if (*column) columns[axis] = **column;
      std::string& list = *column ? there : lacking;
      list.append(list.empty() ? "" : ", ")
          .append(*column ? excerpt(seen_.names[(*column)->column])
                          : std::string(group.names[axis]));
    }
    if (lacking.empty()) {
      if (auto error = half_stated(seen_.names, units_of(columns))) return *std::move(error);
      return std::optional<AxisColumns>(columns);
    }
    if (there.empty()) return std::optional<AxisColumns>();
    return missing("a " + std::string(group.what) + " needs three columns, and beside " + there +
                   " there is no " + lacking + "; add it (" + list_columns(seen_) + ")");
  }

  // Places belong together, and so do speeds: where one of them names a unit, the others do.
  [[nodiscard]] std::optional<Error> half_stated_together(const PlanLayout& layout) const {
    std::vector<ColumnUnit> places = units_of(layout.position);
    std::vector<ColumnUnit> speeds;
    const auto append = [](const std::optional<AxisColumns>& columns,
                           std::vector<ColumnUnit>& units) {
      if (!columns) return;
      for (const ColumnUnit& one : units_of(*columns)) units.push_back(one);
    };
    append(layout.goal, places);
    append(layout.velocity, speeds);
    append(layout.wish, speeds);
    if (layout.max_speed) speeds.push_back(unit_of(*layout.max_speed));
    if (auto error = half_stated(seen_.names, places)) return error;
    return half_stated(seen_.names, speeds);
  }

  // "id" before "name" and "frame_id".
  std::optional<std::size_t> find_id() {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (words_[i].role != PlanRole::kId) continue;
      const bool plain = lower_case(seen_.names[i]) == "id";
      if (!found || plain) found = i;
      if (plain) break;
    }
    if (found) used_[*found] = true;
    return found;
  }

  // What nobody has asked for, or nothing.
  [[nodiscard]] std::string left_over() const {
    constexpr std::size_t kMostListed = 20;
    std::string list;
    std::size_t count = 0;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (used_[i] || ++count > kMostListed) continue;
      list.append(list.empty() ? "" : ", ").append(text(i));
    }
    return list + (count > kMostListed ? ", ..." : "");
  }

 private:
  static std::vector<ColumnUnit> units_of(const AxisColumns& columns) {
    std::vector<ColumnUnit> units;
    for (const NumberColumn& of : columns) units.push_back(unit_of(of));
    return units;
  }

  static ColumnUnit unit_of(const NumberColumn& of) {
    return {of.column, of.unit,
            of.unit == Unit::kUnstated ? UnitEvidence::kUsual : UnitEvidence::kNamed};
  }

  [[nodiscard]] std::string text(std::size_t column) const {
    return "column " + std::to_string(column + 1) + " " + excerpt(seen_.names[column]);
  }

  const ColumnsSeen& seen_;
  std::vector<PlanWord> words_;
  std::vector<bool> used_;
};

Error no_position(const PlanHeader& header, const ColumnsSeen& seen) {
  if (header.has_degrees()) {
    return {ErrorCode::kUnsupportedFormat,
            "positions in degrees are not read here; convert them to metres along x, y, z first",
            {}};
  }
  return missing("the header names no position: x, y and z are needed (" + list_columns(seen) +
                 ")");
}

std::optional<Error> unmet(PlanNeed need, const PlanLayout& layout, const ColumnsSeen& seen) {
  if (need == PlanNeed::kNothing || layout.goal) return std::nullopt;
  if (layout.wish && need == PlanNeed::kGoalsOrWishes) return std::nullopt;
  std::string wanted = "no goals: goal_x, goal_y and goal_z are needed";
  if (need == PlanNeed::kGoalsOrWishes) {
    wanted =
        "neither goals nor wishes: goal_x, goal_y, goal_z or want_vx, want_vy, want_vz are "
        "needed";
  }
  return missing("the header names " + wanted + " (" + list_columns(seen) + ")");
}

// What is to be said of units: which are named, and that the rest are ours.
std::vector<UnitTaken> units_of(const PlanLayout& layout, const ColumnsSeen& seen) {
  std::vector<UnitTaken> units;
  const auto add = [&](const char* of, Unit ours, const NumberColumn& column) {
    if (column.unit == Unit::kUnstated) {
      units.push_back({of, ours, UnitEvidence::kUsual, "no unit is named"});
    } else {
      units.push_back({of, column.unit, UnitEvidence::kNamed,
                       "the header names it: " + excerpt(seen.names[column.column])});
    }
  };
  add("positions", Unit::kMetre, layout.position[0]);
  if (layout.velocity) add("velocities", Unit::kMetrePerSecond, (*layout.velocity)[0]);
  if (layout.goal) add("goals", Unit::kMetre, (*layout.goal)[0]);
  if (layout.wish) add("wished velocities", Unit::kMetrePerSecond, (*layout.wish)[0]);
  if (layout.max_speed) add("greatest speeds", Unit::kMetrePerSecond, *layout.max_speed);
  return units;
}

std::optional<Error> choose_columns_of(PlanLayout& layout, const ColumnsSeen& seen, PlanNeed need) {
  if (seen.names.empty()) {
    return missing(
        "there is no header that names the columns; put one before the first record, "
        "for example " +
        std::string(kExample));
  }
  PlanHeader header(seen);
  const auto position = header.find(kPosition);
  if (!position) return position.error();
  if (!*position) return no_position(header, seen);
  layout.position = **position;
  const auto velocity = header.find(kVelocity);
  if (!velocity) return velocity.error();
  layout.velocity = *velocity;
  const auto goal = header.find(kGoal);
  if (!goal) return goal.error();
  layout.goal = *goal;
  const auto wish = header.find(kWish);
  if (!wish) return wish.error();
  layout.wish = *wish;
  const auto max_speed = header.find(PlanRole::kMaxSpeed, 0);
  if (!max_speed) return max_speed.error();
  layout.max_speed = *max_speed;
  const auto max_acceleration = header.find(PlanRole::kMaxAcceleration, 0);
  if (!max_acceleration) return max_acceleration.error();
  layout.max_acceleration = *max_acceleration;
  if (auto error = header.half_stated_together(layout)) return error;
  layout.id = header.find_id();
  if (!layout.id)
    layout.notes.emplace_back("there is no id: bees are numbered in their order, from 0");
  layout.units = units_of(layout, seen);
  if (auto error = unmet(need, layout, seen)) return error;
  if (const std::string left = header.left_over(); !left.empty()) {
    layout.notes.push_back("not read: " + left);
  }
  return std::nullopt;
}

}  // namespace

Result<PlanLayout> find_plan_layout(std::string_view text, PlanNeed need) {
  ColumnsSeen seen;
  auto table = find_table(text, false, seen);
  if (!table) return table.error();
  PlanLayout layout;
  layout.table = std::move(table).value();
  if (need != PlanNeed::kNothing) {
    if (auto error = no_record_problem(text, layout.table)) return *std::move(error);
  }
  if (auto error = choose_columns_of(layout, seen, need)) {
    error->place.line = first_line(layout.table);
    return *std::move(error);
  }
  return layout;
}

}  // namespace beespace::io
