#include "io/tracks/unread_times.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/excel_days.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace beespace::io {
namespace {

constexpr std::string_view kDatenumAdvice =
    "if these are days as MATLAB counts them (datenum), write dates instead, as by "
    "datestr(t, 'yyyy-mm-dd HH:MM:SS')";

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

// "00:00.0", as Excel shows a time of day with fractions of seconds, and then saves it.
bool is_minutes_of_excel(std::string_view text) {
  constexpr std::string_view kShown = "00:00.0";
  if (text.size() != kShown.size()) return false;
  for (std::size_t i = 0; i < kShown.size(); ++i) {
    const bool digit = kShown[i] == '0';
    if (digit ? !is_digit_at(text, i) : text[i] != kShown[i]) return false;
  }
  return true;
}

// "0 days 00:00:01".
bool is_timedelta(std::string_view text) {
  const std::size_t days = text.find(" days ");
  if (days == std::string_view::npos || days == 0) return false;
  const bool counted = std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(days),
                                   [](char c) { return (c >= '0' && c <= '9') || c == '-'; });
  return counted && text.find(':', days) != std::string_view::npos;
}

std::string timedelta_text(const TableLayout& table, std::size_t column, std::string_view first) {
  const std::string name = column < table.names.size() ? table.names[column] : "time";
  return column_text(table, column) + " holds differences of time as pandas writes them, " +
         excerpt(first) + "; write seconds, as by df['" + name + "'] = pandas.to_timedelta(df['" +
         name + "']).dt.total_seconds(), and call it time_s";
}

}  // namespace

Error unread_time(const TableLayout& table, std::size_t column, const FirstFields& times) {
  const std::string_view first = times.front();
  if (is_timedelta(first)) {
    return at_column(ErrorCode::kNotANumber, timedelta_text(table, column, first), column);
  }
  std::string message = column_text(table, column) + " holds the time, but " + excerpt(first) +
                        " is neither a number nor a date that is read; ";
  message += is_minutes_of_excel(first)
                 ? "Excel shows times so, as minutes and seconds, and where it saved the table, "
                   "dates and hours are lost: take the table as it was before, or let Excel show "
                   "that column as yyyy-mm-dd hh:mm:ss before it saves"
                 : "write it as 2024-05-01T12:00:00Z";
  return at_column(ErrorCode::kNotANumber, std::move(message), column);
}

Error which_unit(const TableLayout& table, std::size_t column, const FirstFields& times) {
  std::string message =
      column_text(table, column) +
      " holds the time, but in which unit? Say it with --time-unit s, ms, us or ns" +
      std::string(kAndOneClock) + ", or in the header: time_s";
  if (may_be_excel_days(times)) message += kExcelDaysAdvice;
  if (may_be_datenums(times)) message.append("; ").append(kDatenumAdvice);
  return at_column(ErrorCode::kInvalidArgument, std::move(message), column);
}

bool may_be_datenums(const FirstFields& times) {
  constexpr double kDay_s = 86'400.0;
  constexpr double kIn1890 = 690'300.0;
  constexpr double kIn2080 = 759'700.0;
  constexpr double kRounded_s = 0.06;   // days with six decimals
  constexpr std::size_t kDecimals = 5;  // fewer may be tenths of seconds, or frames
  std::size_t fine = 0;
  for (const std::string_view text : times.texts) {
    double days = 0.0;
    if (parse_number(text, days) != NumberKind::kNumber) return false;
    if (!(days >= kIn1890 && days < kIn2080)) return false;
    const double seconds = days * kDay_s;
    if (std::abs(seconds - std::round(seconds)) > kRounded_s) return false;
    const std::size_t point = text.find('.');
    if (point != std::string_view::npos && text.size() - point > kDecimals) ++fine;
  }
  return fine > times.texts.size() / 2;
}

Error unit_of_datenums(const TableLayout& table, std::size_t column, const FirstFields& times) {
  return at_column(ErrorCode::kInvalidArgument,
                   column_text(table, column) + " begins with " + excerpt(times.front()) +
                       ", which --time-unit says is no day; " + std::string(kDatenumAdvice) +
                       "; otherwise name the unit in the header, as time_s",
                   column);
}

std::optional<Error> pandas_timedeltas(std::string_view text, const TableLayout& table) {
  for (std::size_t column = 0; column < table.columns; ++column) {
    const FirstFields fields = first_fields(text, table, column);
    if (fields.empty() || !is_timedelta(fields.front())) continue;
    return at_column(ErrorCode::kMissingColumn, timedelta_text(table, column, fields.front()),
                     column);
  }
  return std::nullopt;
}

std::optional<std::string> text_of_steps(const TableLayout& table) {
  const auto counts = [](const std::string& name) {
    return is_one_of(
        "step steps stepnumber step_number sim_step simstep time_step timestep tick "
        "ticks iteration iter",
        plain_name(name));
  };
  const auto steps = std::find_if(table.names.begin(), table.names.end(), counts);
  if (steps == table.names.end()) return std::nullopt;
  const auto column = static_cast<std::size_t>(steps - table.names.begin());
  return column_text(table, column) +
         " seems to count steps, and there is no time; say how many are in a second, as in "
         "--columns frame=" +
         std::to_string(column + 1) + " --fps 10 (" + list_columns(table) + ")";
}

}  // namespace beespace::io
