#include "io/plans/plan_record.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/frames/track_domain.hpp"
#include "io/plans/plan_columns.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/record_problems.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {
namespace {

bool is_limit(Role role) {
  return role == Role::kMaxSpeed || role == Role::kMaxAcceleration;
}

std::string_view unit_of(Role role) {
  if (role == Role::kMaxAcceleration) return " m/s^2";
  return part_within(Role::kX, role) || part_within(Role::kGoalX, role) ? " m" : " m/s";
}

}  // namespace

PlanRecordReader::PlanRecordReader(const PlanLayout& layout)
    : layout_(layout), fields_(layout.table.columns) {
  for (const RoleFacts& facts : plan_columns().roles) {
    if (layout.has(facts.role)) wanted_.push_back(facts.role);
  }
  // What comes first in the line is blamed first.
  std::sort(wanted_.begin(), wanted_.end(),
            [&layout](Role a, Role b) { return layout.of(a)->column < layout.of(b)->column; });
}

std::optional<Error> PlanRecordReader::read_number(Role role) {
  const auto [column, stated_unit] = *layout_.of(role);
  const std::string name(plan_columns().name_of(role));
  const std::string unit(unit_of(role));
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
  if (is_limit(role) && !(value > 0.0)) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " is not above zero (" + name + "); correct it", column);
  }
  // A limit that is too small is not none.
  const bool limit = is_limit(role);
  if (!in_motion_domain(limit ? value : without_dust(value))) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " cannot be computed with exactly (" + name +
                         "); use a size of " + std::string(kMotionDomain) + unit +
                         (limit ? "" : ", or 0"),
                     column);
  }
  values_[index_of(role)] = without_dust(in_metric(value, stated_unit));
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
  for (const Role role : wanted_) {
    if (auto problem = read_number(role)) return problem;
  }
  const auto at = [this](Role first, std::size_t axis) {
    return values_[index_of(part_of(first, axis))];
  };
  const auto point = [&at](Role first) { return Point{at(first, 0), at(first, 1), at(first, 2)}; };
  const auto velocity = [&at](Role first) {
    return Velocity{at(first, 0), at(first, 1), at(first, 2)};
  };
  record.position = point(Role::kX);
  record.velocity = velocity(Role::kVelocityX);
  record.goal = point(Role::kGoalX);
  record.preferred = velocity(Role::kPreferredX);
  record.max_speed_mps = at(Role::kMaxSpeed, 0);
  record.max_acceleration_mps2 = at(Role::kMaxAcceleration, 0);
  return std::nullopt;
}

}  // namespace beespace::io
