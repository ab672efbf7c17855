// One line of a table of flight plans -> one bee and what it intends, or what is wrong.
#pragma once

#include "io/plans/plan_layout.hpp"
#include "io/table/fields.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// What the layout has no columns for stays as it is.
struct PlanRecord {
  std::string id = {};
  Point position = {};
  Velocity velocity = {};
  Point goal = {};
  Velocity preferred = {};
  double max_speed_mps = 0.0;
  double max_acceleration_mps2 = 0.0;
};

class PlanRecordReader {
 public:
  explicit PlanRecordReader(const PlanLayout& layout);

  // `line` has no line end. The error has its column, but no line, record or source yet.
  // Errors: those of read_record(), kOutsideDomain.
  std::optional<Error> read(std::string_view line, PlanRecord& record);

 private:
  std::optional<Error> read_number(Role role);

  const PlanLayout& layout_;
  std::vector<Role> wanted_;  // in the order of their columns
  std::vector<Field> fields_;
  std::array<double, kRoles> values_ = {};
};

}  // namespace beespace::io
