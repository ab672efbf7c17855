// An answer about moving bees as a table: named columns, rows of values, written in every form
// alike.
#pragma once

#include "analysis/text/bee_name.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/moment_text.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace beespace::cli {

// Nothing, a text, a bee, a number, a count, or yes and no.
using Value =
    std::variant<std::monostate, std::string, analysis::BeeName, double, std::uint64_t, bool>;

struct RowColumn {
  const char* name;
  const char* label = nullptr;   // of bees: what the column of their labels is called
  const char* moment = nullptr;  // of times: what the column is called where they are dates
};

struct Rows {
  std::vector<RowColumn> columns;
  std::vector<std::vector<Value>> rows;
  bool labelled = false;       // whether any bee of the input has a label
  io::Calendar calendar = {};  // how times are told to people
};

// For programs, to whom a bee is its id: labels go into columns of their own, behind all others.
void set_labels_apart(Rows& rows);

// For spreadsheets: times as dates, too, in columns behind all others, where they are more than
// seconds.
void add_dates(Rows& rows);

// A header line, then a row a line: values between tabs, bees with their labels, times since 1970
// as dates; or between commas.
void write_rows_as_text(const Rows& rows, io::AtomicOutput& output);
void write_rows_as_csv(const Rows& rows, io::AtomicOutput& output);

// A row as an object of JSON.
void write_row(io::JsonWriter& json, const std::vector<RowColumn>& columns,
               const std::vector<Value>& row);

}  // namespace beespace::cli
