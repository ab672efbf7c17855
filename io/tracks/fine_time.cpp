#include "io/tracks/fine_time.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/tracks/wall_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::io {

std::optional<TimeChoice> find_fine_time(std::string_view text, const Header& header,
                                         std::size_t dated, std::size_t numbers,
                                         const RecordingOptions& options) {
  const TableLayout& table = header.table();
  const Unit unit = if_unit_of(header.meaning(numbers).unit, Quantity::kTime);
  const FirstFields dates = first_fields(text, table, dated);
  if (unit == Unit::kUnstated || !is_date_with_time(dates)) return std::nullopt;
  TimeChoice wall;
  wall.column = dated;
  if (choose_wall_times(text, header, dates, options, wall) || !wall.since_1970 || wall.date) {
    return std::nullopt;
  }
  // A date says when the second began in which the other one is: the zero of that is not before
  // any of these differences, and not a second behind one.
  double latest_s = -std::numeric_limits<double>::infinity();
  double earliest_s = std::numeric_limits<double>::infinity();
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next()) {
    const auto field = [&](std::size_t column) {
      return without_padding(field_at(walk.record(), table.delimiter, column).text);
    };
    double began_s = 0.0;
    double again_after_s = 0.0;
    double count = 0.0;
    if (parse_number(field(numbers), count) != NumberKind::kNumber) continue;
    if (!read_wall_time(wall, field(dated), {}, began_s, again_after_s).empty()) continue;
    if (began_s != std::floor(began_s)) return std::nullopt;
    const double zero_s = began_s - in_metric(count, unit);
    latest_s = std::max(latest_s, zero_s);
    earliest_s = std::min(earliest_s, zero_s);
  }
  // Dates that are told a little late or early are rounded; others are of another clock.
  constexpr double kRounded_s = 0.25;
  constexpr double kWell_s = 0.5;  // so that the zero is known better than by one date
  const double apart_s = latest_s - earliest_s;
  if (!(apart_s >= kWell_s && apart_s <= 1.0 + kRounded_s)) return std::nullopt;
  TimeChoice time;
  time.column = numbers;
  time.unit = unit;
  time.since_1970 = true;
  time.zero_s = latest_s;
  time.other = dated;
  return time;
}

}  // namespace beespace::io
