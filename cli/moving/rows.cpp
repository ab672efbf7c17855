#include "cli/moving/rows.hpp"

#include "cli/block_writer.hpp"
#include "cli/csv_field.hpp"
#include "cli/json_text.hpp"
#include "cli/number_text.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) {
    return std::isfinite(*number) ? exact(*number) : std::string();
  }
  if (const auto* count = std::get_if<std::uint64_t>(&value)) return std::to_string(*count);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "yes" : "no";
  return {};
}

// Tabs and line ends inside an id would look like those between.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

void write_rows_as_text(const Rows& rows, io::AtomicOutput& output) {
  BlockWriter out(output);
  for (const auto& row : rows.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out.text += '\t';
      out.text += on_one_line(text_of(row[i]));
    }
    out.text += '\n';
    out.pass_on();
  }
}

void write_rows_as_csv(const Rows& rows, io::AtomicOutput& output) {
  BlockWriter out(output);
  for (std::size_t i = 0; i < rows.columns.size(); ++i) {
    if (i > 0) out.text += ',';
    out.text += rows.columns[i];
  }
  out.text += '\n';
  for (const auto& row : rows.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out.text += ',';
      append_csv_field(out.text, text_of(row[i]), ',');
    }
    out.text += '\n';
    out.pass_on();
  }
}

void append_json_value(std::string& out, const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    append_json_string(out, *text);
  } else if (const auto* yes = std::get_if<bool>(&value)) {
    out += *yes ? "true" : "false";
  } else {
    const std::string number = text_of(value);
    out += number.empty() ? "null" : number;
  }
}

void append_json_row(std::string& out, const std::vector<const char*>& columns,
                     const std::vector<Value>& row) {
  out += '{';
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) out += ", ";
    append_json_string(out, columns[i]);
    out += ": ";
    append_json_value(out, row[i]);
  }
  out += '}';
}

void append_json_rows(std::string& out, const Rows& rows, const char* indent) {
  out += '[';
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    out += i > 0 ? ",\n" : "\n";
    out += indent;
    append_json_row(out, rows.columns, rows.rows[i]);
  }
  out += ']';
}

}  // namespace beespace::cli
