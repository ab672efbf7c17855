#include "io/tracks/mavlogdump.hpp"

#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

constexpr std::string_view kGiveTheLog =
    ": give beespace the .tlog itself, which 'replay' and 'watch' read";

// "GLOBAL_POSITION_INT.time_boot_ms"
std::optional<std::size_t> column_of_boot(const TableLayout& table) {
  constexpr std::string_view kEnd = "_POSITION_INT.time_boot_ms";
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (std::string_view(table.names[i]).ends_with(kEnd)) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> mixed_vehicles(std::string_view text, const TableLayout& table) {
  constexpr std::size_t kMostLookedAt = 20'000;
  constexpr std::size_t kOften = 3;  // a vehicle that is switched on again goes back, too
  const auto column = column_of_boot(table);
  if (!column) return std::nullopt;
  std::optional<double> last;
  std::size_t back = 0;
  RecordWalk walk(text, table.data_offset, table);
  for (std::size_t i = 0; i < kMostLookedAt && walk.next(); ++i) {
    double boot_ms = 0.0;
    const Field field = field_at(walk.record(), table.delimiter, *column);
    if (parse_number(without_padding(field.text), boot_ms) != NumberKind::kNumber) continue;
    if (last && boot_ms < *last) ++back;
    last = boot_ms;
  }
  if (back < kOften) return std::nullopt;
  return Error{ErrorCode::kMissingColumn,
               "the times since boot go back again and again, as of several vehicles, but a CSV of "
               "mavlogdump does not say which one sent a message (it has no sysid)" +
                   std::string(kGiveTheLog),
               {}};
}

Error dumped_json_problem() {
  return {
      ErrorCode::kUnsupportedFormat,
      "this is a MAVLink log as mavlogdump prints it, which is not read" + std::string(kGiveTheLog),
      {}};
}

std::optional<Error> dumped_text_problem(std::string_view text) {
  const std::string_view line = line_at(text, 0, '\n').text;
  const bool is_text =
      line.size() > 4 && line[4] == '-' && line.find(" {time_boot_ms : ") != std::string_view::npos;
  if (!is_text) return std::nullopt;
  return dumped_json_problem();
}

}  // namespace beespace::io
