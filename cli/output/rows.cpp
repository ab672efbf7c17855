#include "cli/output/rows.hpp"

#include "cli/output/block_writer.hpp"
#include "io/table/table_writer.hpp"

#include <cstddef>
#include <utility>

namespace beespace::cli {
namespace {

void write_field(io::TableWriter& table, const Value& value, bool with_label) {
  if (const auto* bee = std::get_if<analysis::BeeName>(&value)) {
    table.field(with_label ? text_of(*bee) : bee->id);
    return;
  }
  if (const auto* text = std::get_if<std::string>(&value)) table.field(*text);
  if (const auto* number = std::get_if<double>(&value)) table.field(*number);
  if (const auto* count = std::get_if<std::uint64_t>(&value)) table.field(*count);
  if (const auto* yes = std::get_if<bool>(&value)) table.field(*yes);
  if (std::holds_alternative<std::monostate>(value)) table.empty_field();
}

// Whether the values are dates to people.
bool has_dates(const Rows& rows, const RowColumn& column) {
  return rows.calendar.tells() && column.moment != nullptr;
}

// A time as a date; any other value as it is.
Value as_date(const Value& value, const io::Calendar& calendar) {
  const auto* time_s = std::get_if<double>(&value);
  if (time_s == nullptr) return value;
  std::string date = calendar.text(*time_s);
  return date.empty() ? value : Value(std::move(date));
}

void write_table(const Rows& rows, char delimiter, io::TableText text, io::AtomicOutput& output) {
  const bool for_people = text == io::TableText::kOneLine;
  BlockWriter out(output);
  io::TableWriter table(out.text, delimiter, text);
  for (const RowColumn& column : rows.columns) {
    table.field(for_people && has_dates(rows, column) ? column.moment : column.name);
  }
  table.end_row();
  for (const auto& row : rows.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool date = for_people && has_dates(rows, rows.columns[i]);
      write_field(table, date ? as_date(row[i], rows.calendar) : row[i], for_people);
    }
    table.end_row();
    out.pass_on();
  }
}

Value label_of(const Value& value) {
  const auto* bee = std::get_if<analysis::BeeName>(&value);
  return bee != nullptr && !bee->label.empty() ? Value(bee->label) : Value();
}

void write_value(io::JsonWriter& json, std::monostate) {
  json.null();
}

void write_value(io::JsonWriter& json, const analysis::BeeName& bee) {
  json.value(bee.id);
}

void write_value(io::JsonWriter& json, const auto& value) {
  json.value(value);
}

}  // namespace

void set_labels_apart(Rows& rows) {
  if (!rows.labelled) return;
  const std::vector<RowColumn> columns = rows.columns;
  for (const RowColumn& column : columns) {
    if (column.label != nullptr) rows.columns.push_back({column.label});
  }
  for (auto& row : rows.rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].label != nullptr) row.push_back(label_of(row[i]));
    }
  }
}

void add_dates(Rows& rows) {
  const std::size_t columns = rows.columns.size();
  for (std::size_t i = 0; i < columns; ++i) {
    if (!has_dates(rows, rows.columns[i])) continue;
    rows.columns.push_back({rows.columns[i].moment});
    for (auto& row : rows.rows) {
      const auto* time_s = std::get_if<double>(&row[i]);
      row.push_back(time_s == nullptr ? Value() : Value(rows.calendar.text(*time_s)));
    }
  }
}

void write_rows_as_text(const Rows& rows, io::AtomicOutput& output) {
  write_table(rows, '\t', io::TableText::kOneLine, output);
}

void write_rows_as_csv(const Rows& rows, io::AtomicOutput& output) {
  write_table(rows, ',', io::TableText::kQuoted, output);
}

void write_row(io::JsonWriter& json, const std::vector<RowColumn>& columns,
               const std::vector<Value>& row) {
  json.begin_object();
  for (std::size_t i = 0; i < row.size(); ++i) {
    json.key(columns[i].name);
    std::visit([&json](const auto& value) { write_value(json, value); }, row[i]);
  }
  json.end();
}

}  // namespace beespace::cli
