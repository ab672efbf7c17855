// How a table of flight plans is laid out: told by the names in the header; nothing is guessed.
#pragma once

#include "io/plans/flight_plans.hpp"
#include "io/table/column_schema.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// A column that holds a number, and the unit that it names, if it names one.
struct NumberColumn {
  std::size_t column = 0;
  Unit unit = Unit::kUnstated;
};

struct PlanLayout {
  TableLayout table = {};  // but for its choice
  std::optional<std::size_t> id = {};
  // By role. Of a position, a velocity, a goal and a preferred velocity all three are there, or
  // none.
  std::array<std::optional<NumberColumn>, kRoles> columns = {};
  std::vector<UnitTaken> units = {};
  std::vector<std::string> notes = {};

  [[nodiscard]] const std::optional<NumberColumn>& of(Role role) const {
    return columns[index_of(role)];
  }
  [[nodiscard]] bool has(Role role) const { return of(role).has_value(); }
};

// `text` has no byte-order mark. Errors: those of find_table(), kMissingColumn, kUnsupportedFormat
// for units that are not read; with line, without source.
Result<PlanLayout> find_plan_layout(std::string_view text, PlanNeed need);

}  // namespace beespace::io
