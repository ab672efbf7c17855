#include "io/tracks/joined_place.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

std::optional<std::size_t> column_named(const TableLayout& table, std::string_view wanted) {
  const auto found =
      std::find_if(table.names.begin(), table.names.end(),
                   [wanted](const std::string& name) { return plain_name(name) == wanted; });
  if (found == table.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.names.begin());
}

}  // namespace

std::optional<std::size_t> column_of_joined_place(const TableLayout& table) {
  const auto column = column_named(table, "position");
  if (!column || *column >= table.contents.size()) return std::nullopt;
  return table.contents[*column] == ColumnContent::kText ? column : std::nullopt;
}

std::optional<std::size_t> joined_place_of(const Header& header) {
  const bool said = header.override_of(Role::kX) || header.override_of(Role::kLongitude);
  if (said || header.source() == nullptr || header.source()->name != kFlightradar24) {
    return std::nullopt;
  }
  return column_named(header.table(), "position");
}

Result<ColumnChoice> choose_joined_place(const Header& header, std::size_t column) {
  ColumnChoice choice;
  choice.axes = {column, column, *column_named(header.table(), "altitude")};
  choice.dimensions = 3;
  choice.naming = Naming::kSure;
  choice.evidence = Frame::kWgs84;
  choice.reason = "the header is that of Flightradar24, with latitude and longitude in one column";
  if (auto problem =
          settle_coordinate_units(header.schema(), header.table(), header.options(), choice)) {
    return *std::move(problem);
  }
  return choice;
}

JoinedPlace split_place(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return {text, {}};
  return {without_padding(text.substr(0, comma)), without_padding(text.substr(comma + 1))};
}

}  // namespace beespace::io
