#include "io/tracks/point_cells.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/table/table_layout.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kMostNumbers = 3;

// "9.07 47.7" of "POINT (9.07 47.7)" or "SRID=4326;POINT Z(9 47 1)", "9.07, 47.7" of "c(9.07,
// 47.7)"; "" of an empty point. Nothing of other cells.
std::optional<std::string_view> inside_point(std::string_view cell) {
  cell = without_padding(cell);
  if (const std::size_t srid = cell.find(';'); cell.starts_with("SRID=") && srid < cell.size()) {
    cell.remove_prefix(srid + 1);
  }
  const std::size_t bracket = cell.find('(');
  const std::string kind = lower_case(without_padding(cell.substr(0, bracket)));
  if (kind == "point empty" || kind == "point z empty") return std::string_view();
  const bool known = is_one_of("point pointz c", kind) || kind == "point z";
  if (!known || bracket == std::string_view::npos || !cell.ends_with(')')) return std::nullopt;
  return cell.substr(bracket + 1, cell.size() - bracket - 2);
}

std::vector<std::string_view> numbers_inside(std::string_view inside) {
  std::vector<std::string_view> numbers;
  while (true) {
    const std::size_t begins = inside.find_first_not_of(", \t");
    if (begins == std::string_view::npos) return numbers;
    inside.remove_prefix(begins);
    const std::size_t ends = std::min(inside.find_first_of(", \t"), inside.size());
    numbers.push_back(inside.substr(0, ends));
    inside.remove_prefix(ends);
  }
}

std::vector<Field> fields_in(std::string_view record, char delimiter) {
  std::vector<Field> fields;
  FieldCursor cursor(record, delimiter);
  for (Field field; cursor.next(field);) fields.push_back(field);
  return fields;
}

struct PointColumn {
  std::size_t column = 0;
  std::size_t numbers = 0;
};

// The first column whose first cell that is there is a point.
std::optional<PointColumn> find_points(std::string_view text, const TableLayout& table) {
  constexpr std::size_t kMostLookedAt = 100;
  RecordWalk walk(text, table.data_offset, table);
  for (std::size_t i = 0; i < kMostLookedAt && walk.next(); ++i) {
    const std::vector<Field> fields = fields_in(walk.record(), table.delimiter);
    for (std::size_t column = 0; column < fields.size(); ++column) {
      const auto inside = inside_point(fields[column].text);
      if (!inside) continue;
      const std::size_t numbers = numbers_inside(*inside).size();
      if (numbers == 2 || numbers == kMostNumbers) return PointColumn{column, numbers};
    }
  }
  return std::nullopt;
}

// As it stands in the text, perhaps with its quotes.
void append_cell(std::string& out, const Field& field, char delimiter) {
  const bool quotes = field.doubled_quotes ||
                      field.text.find(delimiter) != std::string_view::npos ||
                      field.text.find('"') != std::string_view::npos;
  if (quotes) out += '"';
  out.append(field.text);
  if (quotes) out += '"';
}

}  // namespace

std::optional<Bytes> with_split_points(std::string_view text) {
  constexpr std::size_t kHead = 4096;
  const std::string head = lower_case(text.substr(0, kHead));
  if (head.find("point") == std::string::npos && head.find("c(") == std::string::npos) {
    return std::nullopt;
  }
  const auto table = find_table(text, false);
  if (!table || table->names.empty() || table->delimiter == ' ') return std::nullopt;
  const auto points = find_points(text, *table);
  if (!points) return std::nullopt;
  constexpr std::array<std::string_view, kMostNumbers> kNames = {"x", "y", "z"};
  // The lines above, and the header.
  std::string out(table->lines_before > 0 ? table->lines_before - 1 : 0, '\n');
  for (std::size_t column = 0; column < table->names.size(); ++column) {
    if (column > 0) out += table->delimiter;
    if (column != points->column) {
      append_cell(out, Field{table->names[column]}, table->delimiter);
      continue;
    }
    for (std::size_t i = 0; i < points->numbers; ++i) {
      if (i > 0) out += table->delimiter;
      out.append(kNames[i]);
    }
  }
  out += '\n';
  std::uint64_t lines = 0;
  RecordWalk walk(text, table->data_offset, *table);
  while (walk.next()) {
    out.append(walk.line() - lines, '\n');
    lines = walk.line() + 1;
    const std::vector<Field> fields = fields_in(walk.record(), table->delimiter);
    for (std::size_t column = 0; column < fields.size(); ++column) {
      if (column > 0) out += table->delimiter;
      const auto inside = column == points->column ? inside_point(fields[column].text)
                                                   : std::optional<std::string_view>();
      if (!inside) {
        append_cell(out, fields[column], table->delimiter);
        // An unknown place is so in all of its numbers.
        for (std::size_t i = 1; column == points->column && i < points->numbers; ++i) {
          out += table->delimiter;
          append_cell(out, fields[column], table->delimiter);
        }
        continue;
      }
      const std::vector<std::string_view> numbers = numbers_inside(*inside);
      for (std::size_t i = 0; i < points->numbers; ++i) {
        if (i > 0) out += table->delimiter;
        if (i < numbers.size()) out.append(numbers[i]);
      }
    }
    out += '\n';
  }
  return copy_of(out);
}

}  // namespace beespace::io
