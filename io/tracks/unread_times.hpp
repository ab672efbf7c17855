// What is asked of times whose unit, or form, is not known.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/first_fields.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace beespace::io {

// Of `times`, the first fields of a column, which are neither numbers nor dates. Errors:
// kNotANumber, with the column.
Error unread_time(const TableLayout& table, std::size_t column, const FirstFields& times);

// Of numbers: in which unit? Errors: kInvalidArgument, with the column.
Error which_unit(const TableLayout& table, std::size_t column, const FirstFields& times);

// Whether they are days as MATLAB's datenum counts them, for all that can be told: between 1890 and
// 2080, with fractions that make whole seconds.
bool may_be_datenums(const FirstFields& times);
// What to say where the caller says that such are in another unit.
Error unit_of_datenums(const TableLayout& table, std::size_t column, const FirstFields& times);

// Of a table without a column that is called a time: that one holds differences of pandas, "0 days
// 00:00:01.5".
std::optional<Error> pandas_timedeltas(std::string_view text, const TableLayout& table);

// What to say where there is no time, but a column of steps, as of a simulation; or nothing.
std::optional<std::string> text_of_steps(const TableLayout& table);

}  // namespace beespace::io
