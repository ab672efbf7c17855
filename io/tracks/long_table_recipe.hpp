// What to type to make a record for each vehicle and time of a table whose rows have columns for
// several beside each other.
#pragma once

#include "io/table/table_layout.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// The columns of one vehicle's x, y, and perhaps z.
struct VehicleColumns {
  std::string name;
  std::size_t x = 0;
  std::size_t y = 0;
  std::optional<std::size_t> z = {};
  std::optional<std::size_t> named_by = {};  // what holds its name, rather than `name`
  bool own_origin = false;                   // by its topic, where each may have its own
};

// Whether it means itself within quotes of awk, and in a table with any delimiter.
bool means_itself_in_awk(std::string_view text);

// A line of awk, with FILE for the name of the table. Empty where no column holds the time, where
// vehicles have coordinates of several kinds or units, or where there are too many of them.
std::string long_table_recipe(const TableLayout& table,
                              const std::vector<VehicleColumns>& vehicles);

}  // namespace beespace::io
