// What a column holds in the first records of a table.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace beespace::io {

struct FirstFields {
  std::vector<std::string_view> texts = {};
  ErrorLocation first = {};  // where the first of them is: its line, record and column

  [[nodiscard]] bool empty() const { return texts.empty(); }
  [[nodiscard]] std::string_view front() const { return texts.front(); }
};

// The fields of a column in the first records, those that are there.
FirstFields first_fields(std::string_view text, const TableLayout& table, std::size_t column);

// That the first of them, of which there is one, is not a "time".
Error not_a(std::string_view what, const FirstFields& fields, std::string_view why);

}  // namespace beespace::io
