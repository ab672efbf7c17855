#include "io/tracks/date_order.hpp"

#include "io/bytes/characters.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

// A date that tells the order, or one that does not.
struct Witness {
  std::string_view text;
  std::uint64_t line = 0;
  std::uint64_t record = 0;
};

Error ask_for_order(const Witness& witness, std::size_t column, std::string what) {
  Error error{ErrorCode::kInvalidArgument, std::move(what), {}};
  error.location.line = witness.line;
  error.location.record = witness.record;
  error.location.column = column + 1;
  return error;
}

// Records that are put together from JSON have no lines of their own.
std::string in_line(const Witness& witness, const TableLayout& table) {
  if (table.delimiter == kUnitSeparator) return {};
  return " in line " + std::to_string(witness.line);
}

std::string reason_of(const Witness& witness, const TableLayout& table) {
  if (witness.text.substr(0, 3).find('.') != std::string_view::npos) return "they have points";
  return "as " + excerpt(witness.text) + in_line(witness, table) + " tells";
}

}  // namespace

Result<DateOrderChoice> choose_date_order(std::string_view text, const TableLayout& table,
                                          std::size_t column, DateOrder asked) {
  if (asked != DateOrder::kUnsaid) return DateOrderChoice{asked, "as --dates says"};
  std::optional<Witness> day_first;
  std::optional<Witness> month_first;
  std::optional<Witness> unsaid;
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next() && !(day_first && month_first)) {
    const auto field = without_padding(field_at(walk.record(), table.delimiter, column).text);
    const auto order = order_told_by(field);
    if (!order) continue;
    std::optional<Witness>& witness = *order == DateOrder::kDayFirst     ? day_first
                                      : *order == DateOrder::kMonthFirst ? month_first
                                                                         : unsaid;
    if (witness) continue;
    witness = {field, table.lines_before + walk.line() / table.records_per_line + 1, walk.row()};
  }
  if (day_first && month_first) {
    const bool later = day_first->line < month_first->line;
    const Witness& first = later ? *day_first : *month_first;
    const Witness& second = later ? *month_first : *day_first;
    return ask_for_order(second, column,
                         excerpt(second.text) + " has the " + (later ? "month" : "day") +
                             " first, but " + excerpt(first.text) + in_line(first, table) +
                             " the " + (later ? "day" : "month") +
                             "; write all dates alike, best as 2024-05-01, or say which order "
                             "they have with --dates day-first or --dates month-first");
  }
  if (day_first) return DateOrderChoice{DateOrder::kDayFirst, reason_of(*day_first, table)};
  if (month_first) return DateOrderChoice{DateOrder::kMonthFirst, reason_of(*month_first, table)};
  if (!unsaid) return DateOrderChoice();
  return ask_for_order(*unsaid, column,
                       excerpt(unsaid->text) +
                           ": is the day first, or the month? No date here tells it; say it with "
                           "--dates day-first or --dates month-first, or write dates with the "
                           "year first, as in 2024-05-01");
}

}  // namespace beespace::io
