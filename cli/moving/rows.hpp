// An answer about moving bees as a table: named columns, rows of values, written in every form
// alike.
#pragma once

#include "io/atomic_output.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace beespace::cli {

// Nothing, a text such as an id, a number, a count, or yes and no.
using Value = std::variant<std::monostate, std::string, double, std::uint64_t, bool>;

struct Rows {
  std::vector<const char*> columns;
  std::vector<std::vector<Value>> rows;
};

// A row a line: values between tabs; or with a header and commas.
void write_rows_as_text(const Rows& rows, io::AtomicOutput& output);
void write_rows_as_csv(const Rows& rows, io::AtomicOutput& output);

// The value as JSON; and a row as an object, or all of them as an array.
void append_json_value(std::string& out, const Value& value);
void append_json_row(std::string& out, const std::vector<const char*>& columns,
                     const std::vector<Value>& row);
void append_json_rows(std::string& out, const Rows& rows, const char* indent);

}  // namespace beespace::cli
