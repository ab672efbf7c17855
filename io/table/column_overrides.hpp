// What the caller says of the columns: "lon=1,lat=2,height=3", by number (from 1) or by name.
#pragma once

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

struct ColumnOverride {
  Role role = Role::kNone;
  std::string_view name = {};  // of the role, as the caller writes it
  std::string column = {};
};

// An empty text says nothing. Errors: kInvalidArgument for what no file can fulfil, or what
// contradicts `frame`.
Result<std::vector<ColumnOverride>> read_column_overrides(const ColumnSchema& schema,
                                                          std::string_view text, Frame frame);

// The column (0-based) of each role.
using ColumnsByRole = std::array<std::optional<std::size_t>, kRoles>;

// The same, found in a table. Errors: kMissingColumn where there is no such column, or more than
// one; kInvalidArgument where one column is to be two things.
Result<ColumnsByRole> find_overrides(const ColumnSchema& schema, const ColumnOptions& options,
                                     const TableLayout& table);

// One column that is to be two things, of which none is an id: kInvalidArgument.
std::optional<Error> doubly_used(const ColumnSchema& schema, const ColumnsByRole& columns);

// "the columns are 1 'a', 2 'b'".
std::string list_columns(const TableLayout& table);

// "column 2 'b'"
std::string column_text(const TableLayout& table, std::size_t column);

}  // namespace beespace::io
