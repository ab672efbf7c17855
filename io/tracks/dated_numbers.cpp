#include "io/tracks/dated_numbers.hpp"

#include "io/bytes/number.hpp"
#include "io/table/column_names.hpp"
#include "io/tracks/track_time.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace beespace::io {
namespace {

struct CountedColumn {
  std::size_t column;
  Unit said;           // by its name
  Unit since_1970;     // in which it is; kUnstated where in none
  double seconds = 0;  // the first one, if it is since 1970
};

bool names_boot(std::string_view name) {
  const auto words = split_words(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return is_one_of("boot uptime", word); });
}

// Nothing where these are no numbers.
std::optional<CountedColumn> counted(std::string_view text, const Header& header,
                                     std::size_t column) {
  const FirstFields times = first_fields(text, header.table(), column);
  if (times.empty()) return std::nullopt;
  double first = 0.0;
  if (parse_number(times.front(), first) != NumberKind::kNumber) return std::nullopt;
  CountedColumn counts{column, if_unit_of(header.meaning(column).unit, Quantity::kTime),
                       common_unit_since_1970(times)};
  const bool contradicted = counts.said != Unit::kUnstated && counts.said != counts.since_1970;
  if (contradicted || names_boot(header.table().names[column])) counts.since_1970 = Unit::kUnstated;
  if (counts.since_1970 != Unit::kUnstated) counts.seconds = in_metric(first, counts.since_1970);
  return counts;
}

}  // namespace

Unit common_unit_since_1970(const FirstFields& times) {
  Unit common = Unit::kUnstated;
  for (const std::string_view time : times.texts) {
    double value = 0.0;
    if (parse_number(time, value) != NumberKind::kNumber) return Unit::kUnstated;
    const Unit unit = unit_since_1970(value);
    if (unit == Unit::kUnstated || (common != Unit::kUnstated && unit != common)) {
      return Unit::kUnstated;
    }
    common = unit;
  }
  return common;
}

bool are_surely_milliseconds(const FirstFields& times) {
  constexpr double kLongestStep = 2'000.0;  // 500 in a second, of microseconds
  constexpr double kLeast = 1e12;           // of microseconds the twelfth day
  double before = 0.0;
  double longest = 0.0;
  for (const std::string_view time : times.texts) {
    double value = 0.0;
    if (parse_number(time, value) != NumberKind::kNumber || value < kLeast) return false;
    if (before > 0.0) longest = std::max(longest, value - before);
    before = value;
  }
  return longest > 0.0 && longest <= kLongestStep;
}

std::optional<std::size_t> only_since_1970(std::string_view text, const Header& header,
                                           const std::vector<std::size_t>& columns) {
  constexpr double kDay_s = 86'400.0;
  std::vector<CountedColumn> dated;
  for (const std::size_t column : columns) {
    const auto counts = counted(text, header, column);
    if (!counts) return std::nullopt;
    if (counts->since_1970 != Unit::kUnstated) dated.push_back(*counts);
  }
  if (dated.size() > 1) {
    // By their size alone these may be microseconds since a boot.
    std::vector<CountedColumn> said = dated;
    std::erase_if(said, [](const CountedColumn& of) { return of.said == Unit::kUnstated; });
    if (said.size() != 1) return std::nullopt;
    for (const CountedColumn& of : dated) {
      const bool is_other = of.column != said.front().column;
      if (is_other && std::abs(of.seconds - said.front().seconds) < kDay_s) return std::nullopt;
    }
    dated = std::move(said);
  }
  if (dated.size() != 1) return std::nullopt;
  return dated.front().column;
}

}  // namespace beespace::io
