// Which columns hold the position: as the caller says, as the header says, or plainly in order.
// Where none of these decides, that is an error: nothing is guessed.
#pragma once

#include "io/table/column_names.hpp"
#include "io/table/column_options.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/column_schema.hpp"
#include "io/table/table_layout.hpp"
#include "io/table/table_sources.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

// The header of a table, read by a schema. A column that the caller overrides as an id, a time or a
// velocity is nothing else.
class Header {
 public:
  // All must outlive it.
  Header(const ColumnSchema& schema, const ColumnOptions& options, const TableLayout& table,
         const ColumnsByRole& overrides);

  [[nodiscard]] const ColumnSchema& schema() const { return schema_; }
  [[nodiscard]] const ColumnOptions& options() const { return options_; }
  [[nodiscard]] const TableLayout& table() const { return table_; }
  [[nodiscard]] const ColumnsByRole& overrides() const { return overrides_; }
  [[nodiscard]] const std::optional<std::size_t>& override_of(Role role) const {
    return overrides_[index_of(role)];
  }

  [[nodiscard]] std::size_t size() const { return meanings_.size(); }  // 0 without a header
  [[nodiscard]] const ColumnMeaning& meaning(std::size_t column) const { return meanings_[column]; }
  [[nodiscard]] const std::vector<std::size_t>& columns(Role role) const {
    return by_role_[index_of(role)];
  }
  [[nodiscard]] bool has(Role role) const { return !columns(role).empty(); }
  // The only column of that role; nothing where there is none, or several.
  [[nodiscard]] std::optional<std::size_t> only(Role role) const {
    if (columns(role).size() != 1) return std::nullopt;
    return columns(role).front();
  }
  // Whose documented header it is; null where that is not known.
  [[nodiscard]] const TableSource* source() const { return source_; }
  // What its name says, whatever the caller takes it for; nothing without a name.
  [[nodiscard]] ColumnMeaning stated(std::size_t column) const;

 private:
  ColumnMeaning meaning_of(std::size_t column) const;
  [[nodiscard]] bool is_flight_level(std::size_t column) const;
  [[nodiscard]] bool is_of_a_quaternion(std::size_t column) const;
  void prefer_plain_coordinates();

  const ColumnSchema& schema_;
  const ColumnOptions& options_;
  const TableLayout& table_;
  const ColumnsByRole& overrides_;
  const TableSource* source_;
  std::vector<ColumnMeaning> meanings_;
  std::array<std::vector<std::size_t>, kRoles> by_role_;
};

// Of columns that could all be the id, the one that is: "id" before "frame_id", "icao24" before
// "callsign".
std::size_t choose_id(const TableLayout& table, const std::vector<std::size_t>& candidates);

// A column whose name is not understood, but resembles the role.
bool resembles(const ColumnSchema& schema, const std::string& name, Role role);

// The position, with its units, but without the id. Errors: kInvalidArgument for units that must be
// said (with column), kMissingColumn, kUnsupportedFormat for a unit that is not read.
Result<ColumnChoice> choose_position(const Header& header);

// Position and id of a table of points. Errors: the same, and kInvalidArgument for overrides that
// make no sense.
Result<ColumnChoice> choose_columns(const TableLayout& table, const ColumnOptions& options);
// The same by another schema: of a community with words of its own.
Result<ColumnChoice> choose_columns(const TableLayout& table, const ColumnOptions& options,
                                    const ColumnSchema& schema);

}  // namespace beespace::io
