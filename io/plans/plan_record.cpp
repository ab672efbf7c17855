#include "io/plans/plan_record.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/record_problems.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kPosition = 0;
constexpr std::size_t kVelocity = 3;
constexpr std::size_t kGoal = 6;
constexpr std::size_t kWish = 9;
constexpr std::size_t kMaxSpeed = 12;
constexpr std::size_t kMaxAcceleration = 13;

constexpr std::array<std::string_view, 14> kNames = {"x",
                                                     "y",
                                                     "z",
                                                     "vx",
                                                     "vy",
                                                     "vz",
                                                     "goal_x",
                                                     "goal_y",
                                                     "goal_z",
                                                     "want_vx",
                                                     "want_vy",
                                                     "want_vz",
                                                     "the greatest speed",
                                                     "the greatest acceleration"};

std::string_view unit_of(std::size_t number) {
  if (number == kMaxAcceleration) return " m/s^2";
  const bool place = number < kVelocity || (number >= kGoal && number < kWish);
  return place ? " m" : " m/s";
}

Error at_column(ErrorCode code, std::string message, std::size_t column) {
  Error error{code, std::move(message), {}};
  error.place.column = column + 1;
  return error;
}

}  // namespace

PlanRecordReader::PlanRecordReader(const PlanLayout& layout)
    : layout_(layout), fields_(layout.table.columns) {
  const auto want_all = [this](const AxisColumns& columns, std::size_t first) {
    for (std::size_t axis = 0; axis < 3; ++axis) want(columns[axis], first + axis);
  };
  want_all(layout.position, kPosition);
  if (layout.velocity) want_all(*layout.velocity, kVelocity);
  if (layout.goal) want_all(*layout.goal, kGoal);
  if (layout.wish) want_all(*layout.wish, kWish);
  if (layout.max_speed) want(*layout.max_speed, kMaxSpeed);
  if (layout.max_acceleration) want(*layout.max_acceleration, kMaxAcceleration);
  // What comes first in the line is blamed first.
  std::sort(wanted_.begin(), wanted_.end(), [](const WantedColumn& a, const WantedColumn& b) {
    return a.column.column < b.column.column;
  });
}

void PlanRecordReader::want(const NumberColumn& column, std::size_t number) {
  wanted_.push_back({column, number});
}

std::optional<Error> PlanRecordReader::read_number(const WantedColumn& wanted) {
  const std::size_t column = wanted.column.column;
  const std::size_t number = wanted.number;
  const std::string name(kNames[number]);
  const std::string unit(unit_of(number));
  const std::string_view text = without_padding(fields_[column].text);
  double value = 0.0;
  const NumberKind kind = parse_number(text, value);
  if (kind == NumberKind::kNotFinite) {
    return at_column(ErrorCode::kNotFinite,
                     excerpt(text) + " is no number of" + unit + " (" + name + "); correct it",
                     column);
  }
  if (kind != NumberKind::kNumber) {
    return without_advice(
        number_problem(kind, text, name, std::string(kMotionDomain) + unit, column));
  }
  if (number >= kMaxSpeed && !(value > 0.0)) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " is not above zero (" + name + "); correct it", column);
  }
  // A limit that is too small is not none.
  const bool is_limit = number >= kMaxSpeed;
  if (!in_motion_domain(is_limit ? value : without_dust(value))) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " cannot be computed with exactly (" + name +
                         "); use a size of " + std::string(kMotionDomain) + unit +
                         (is_limit ? "" : ", or 0"),
                     column);
  }
  values_[number] = without_dust(in_metric(value, wanted.column.unit));
  return std::nullopt;
}

std::optional<Error> PlanRecordReader::read(std::string_view line, PlanRecord& record) {
  if (line.size() > kLongestLine) return long_line(line);
  std::size_t count = 0;
  FieldCursor cursor(line, layout_.table.delimiter);
  for (Field field; cursor.next(field); ++count) {
    if (count < fields_.size()) fields_[count] = field;
  }
  if (auto problem = record_problem(line, layout_.table, count, cursor.problem())) {
    return without_advice(*std::move(problem));
  }
  if (layout_.id) {
    record.id = unquoted(fields_[*layout_.id]);
    if (record.id.empty()) {
      return at_column(ErrorCode::kMalformedRecord, "the id is empty; fill it in", *layout_.id);
    }
  }
  for (const WantedColumn& wanted : wanted_) {
    if (auto problem = read_number(wanted)) return problem;
  }
  const auto three = [this](std::size_t first) {
    return std::array<double, 3>{values_[first], values_[first + 1], values_[first + 2]};
  };
  const auto [x, y, z] = three(kPosition);
  record.position = {x, y, z};
  const auto [vx, vy, vz] = three(kVelocity);
  record.velocity = {vx, vy, vz};
  const auto [goal_x, goal_y, goal_z] = three(kGoal);
  record.goal = {goal_x, goal_y, goal_z};
  const auto [want_vx, want_vy, want_vz] = three(kWish);
  record.wish = {want_vx, want_vy, want_vz};
  record.max_speed_mps = values_[kMaxSpeed];
  record.max_acceleration_mps2 = values_[kMaxAcceleration];
  return std::nullopt;
}

}  // namespace beespace::io
