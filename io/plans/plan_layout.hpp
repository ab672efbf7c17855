// How a table of flight plans is laid out: told by the names in the header; nothing is guessed.
#pragma once

#include "io/plans/flight_plans.hpp"
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

using AxisColumns = std::array<NumberColumn, 3>;  // x, y, z

struct PlanLayout {
  TableLayout table = {};  // but for its choice
  std::optional<std::size_t> id = {};
  AxisColumns position = {};
  std::optional<AxisColumns> velocity = {};
  std::optional<AxisColumns> goal = {};
  std::optional<AxisColumns> wish = {};
  std::optional<NumberColumn> max_speed = {};
  std::optional<NumberColumn> max_acceleration = {};
  std::vector<UnitTaken> units = {};
  std::vector<std::string> notes = {};
};

// `text` has no byte-order mark. Errors: those of find_table(), kMissingColumn, kUnsupportedFormat
// for units that are not read; with line, without source.
Result<PlanLayout> find_plan_layout(std::string_view text, PlanNeed need);

}  // namespace beespace::io
