// Which of the numbers of a table's dates is the day, where the year is the last one.
#pragma once

#include "io/table/table_layout.hpp"
#include "io/units/iso_time.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {

struct DateOrderChoice {
  DateOrder order = DateOrder::kUnsaid;  // also where no date has the year last
  std::string reason = {};
};

// `asked` is what the caller says; otherwise one date of `text` that can be read in one way alone
// tells it of all. Errors, with line and column: kInvalidArgument where all can be read in two, or
// some contradict others.
Result<DateOrderChoice> choose_date_order(std::string_view text, const TableLayout& table,
                                          std::size_t column, DateOrder asked);

}  // namespace beespace::io
