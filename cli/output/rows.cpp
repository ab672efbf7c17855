#include "cli/output/rows.hpp"

#include "cli/output/block_writer.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/csv_field.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

void append_header(std::string& out, const Rows& rows, char delimiter) {
  for (std::size_t i = 0; i < rows.columns.size(); ++i) {
    if (i > 0) out += delimiter;
    out += rows.columns[i].name;
  }
  out += '\n';
}

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* bee = std::get_if<analysis::BeeName>(&value)) return bee->id;
  if (const auto* number = std::get_if<double>(&value)) {
    return std::isfinite(*number) ? io::exact(*number) : std::string();
  }
  if (const auto* count = std::get_if<std::uint64_t>(&value)) return std::to_string(*count);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "yes" : "no";
  return {};
}

std::string text_for_people(const Value& value) {
  const auto* bee = std::get_if<analysis::BeeName>(&value);
  return bee != nullptr ? text_of(*bee) : text_of(value);
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

// Tabs and line ends inside an id would look like those between.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return text;
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

void write_rows_as_text(const Rows& rows, io::AtomicOutput& output) {
  BlockWriter out(output);
  append_header(out.text, rows, '\t');
  for (const auto& row : rows.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out.text += '\t';
      out.text += on_one_line(text_for_people(row[i]));
    }
    out.text += '\n';
    out.pass_on();
  }
}

void write_rows_as_csv(const Rows& rows, io::AtomicOutput& output) {
  BlockWriter out(output);
  append_header(out.text, rows, ',');
  for (const auto& row : rows.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out.text += ',';
      io::append_csv_field(out.text, text_of(row[i]), ',');
    }
    out.text += '\n';
    out.pass_on();
  }
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
