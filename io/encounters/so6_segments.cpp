#include "io/encounters/so6_segments.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/aircraft_report.hpp"
#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"
#include "io/encounters/encounter_lines.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/table_layout.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kFields = 20;
using Fields = std::array<std::string_view, kFields>;

// Where each end of a segment has its fields, 0-based.
struct End {
  std::size_t time;
  std::size_t level;
  std::size_t day;
  std::size_t latitude;
  std::size_t longitude;
};
constexpr std::array<End, 2> kEnds = {{{4, 6, 10, 12, 13}, {5, 7, 11, 14, 15}}};
constexpr std::size_t kCallsign = 9;
constexpr std::size_t kFlight = 16;

std::optional<Fields> fields_of(std::string_view line) {
  Fields fields;
  std::size_t count = 0;
  while (!(line = without_padding(line)).empty()) {
    if (count == kFields) return std::nullopt;
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    fields[count++] = line.substr(0, end);
    line.remove_prefix(end);
  }
  return count == kFields ? std::optional(fields) : std::nullopt;
}

// "240701" and "120000": seconds since 1970.
std::optional<double> moment_of(std::string_view day, std::string_view time) {
  if (day.size() != 6 || time.size() != 6 || !parse_whole(day) || !parse_whole(time)) {
    return std::nullopt;
  }
  std::string text = "20";
  text.append(day.substr(0, 2)).append("-").append(day.substr(2, 2)).append("-");
  text.append(day.substr(4, 2)).append("T").append(time.substr(0, 2)).append(":");
  text.append(time.substr(2, 2)).append(":").append(time.substr(4, 2)).append("Z");
  double seconds = 0.0;
  if (!parse_iso_time(text, seconds).empty()) return std::nullopt;
  return seconds;
}

std::optional<AircraftReport> report_of(const Fields& fields, const End& end) {
  constexpr double kMinutesPerDegree = 60.0;
  constexpr double kFeetPerLevel = 100.0;
  const auto time_s = moment_of(fields[end.day], fields[end.time]);
  const auto level = parse_number(fields[end.level]);
  const auto latitude = parse_number(fields[end.latitude]);
  const auto longitude = parse_number(fields[end.longitude]);
  if (!time_s || !level || !latitude || !longitude || !std::isfinite(*level)) return std::nullopt;
  AircraftReport report;
  report.id = fields[kFlight];
  report.label = fields[kCallsign];
  report.time_s = *time_s;
  report.latitude_deg = *latitude / kMinutesPerDegree;
  report.longitude_deg = *longitude / kMinutesPerDegree;
  report.height_unit = Unit::kFoot;
  report.pressure_height = kFeetPerLevel * *level;
  return report;
}

}  // namespace

bool is_so6(std::string_view text) {
  for (std::size_t offset = 0; offset < text.size();) {
    const Line line = line_at(text, offset, '\n');
    offset = line.next;
    if (says_nothing(line.text)) continue;
    const auto fields = fields_of(line.text);
    if (!fields || (*fields)[0].find('_') == std::string_view::npos) return false;
    return report_of(*fields, kEnds[0]) && report_of(*fields, kEnds[1]);
  }
  return false;
}

std::optional<Error> read_so6(std::string_view text, RecordingAssembly& assembly) {
  AircraftGathering gathering({HeightSource::kPressure, assembly.options().grounded}, assembly);
  if (auto error = gathering.begin("segments of so6", Unit::kFoot, 0.0, false)) return error;
  assembly.note(
      "each segment of so6 is one straight line, however long it lasts: where such are told as "
      "gaps, --max-gap 3600 believes segments of up to an hour");
  std::uint64_t number = 0;
  for (std::size_t offset = 0; offset < text.size();) {
    const Line line = line_at(text, offset, '\n');
    offset = line.next;
    ++number;
    if (says_nothing(line.text)) continue;
    const auto fields = fields_of(line.text);
    for (const End& end : kEnds) {
      const auto report = fields ? report_of(*fields, end) : std::nullopt;
      std::optional<Error> error;
      if (report) {
        error = gathering.add(*report, number);
      } else {
        error = Error{ErrorCode::kMalformedRecord,
                      excerpt(line.text) +
                          " is no segment of so6 (20 fields: times as 120000, days as 240701, "
                          "flight levels, minutes of arc); correct it" +
                          std::string(kOrLeaveOut),
                      {}};
      }
      if (!error) continue;
      error->location.line = number;
      if (auto fatal = assembly.bad(*std::move(error), report ? report->id : "")) return fatal;
      break;
    }
  }
  return std::nullopt;
}

}  // namespace beespace::io
