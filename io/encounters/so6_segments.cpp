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
#include <numbers>
#include <string>
#include <unordered_map>
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

// Where it is on the great circle from one end of a segment to the other, at an even speed.
AircraftReport between(const AircraftReport& from, const AircraftReport& to, double share) {
  constexpr double kRadian = std::numbers::pi / 180.0;
  struct Direction {
    double x, y, z;
  };
  const auto direction_of = [](const AircraftReport& at) {
    const double across = std::cos(at.latitude_deg * kRadian);
    return Direction{across * std::cos(at.longitude_deg * kRadian),
                     across * std::sin(at.longitude_deg * kRadian),
                     std::sin(at.latitude_deg * kRadian)};
  };
  const Direction a = direction_of(from);
  const Direction b = direction_of(to);
  const double chord = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
  const double angle = 2.0 * std::asin(std::min(chord / 2.0, 1.0));
  AircraftReport at = from;
  at.time_s += share * (to.time_s - from.time_s);
  at.pressure_height += share * (to.pressure_height - from.pressure_height);
  if (!(std::sin(angle) > 0.0)) return at;  // it stays, or goes straight up
  const double of_a = std::sin((1.0 - share) * angle) / std::sin(angle);
  const double of_b = std::sin(share * angle) / std::sin(angle);
  const Direction on{of_a * a.x + of_b * b.x, of_a * a.y + of_b * b.y, of_a * a.z + of_b * b.z};
  at.longitude_deg = std::atan2(on.y, on.x) / kRadian;
  at.latitude_deg = std::atan2(on.z, std::hypot(on.x, on.y)) / kRadian;
  return at;
}

// A segment is known from its begin to its end, and what is between two segments is not. So a
// long one gets places between its ends, as a gap is a long time between two places (see gaps.hpp).
class SegmentFlights {
 public:
  SegmentFlights(AircraftGathering& gathering, std::uint64_t& line)
      : gathering_(gathering), line_(line) {}

  std::optional<Error> add(const AircraftReport& begin, const AircraftReport& end) {
    if (!goes_on_from_last(begin)) {
      if (auto error = gathering_.add(begin, line_)) return error;
    }
    const double lasts_s = end.time_s - begin.time_s;
    const double steps = std::ceil(lasts_s / kMostBetween_s);
    for (int k = 1; k < steps && steps <= kMostSteps; ++k) {
      if (auto error = gathering_.add(between(begin, end, k / steps), line_)) return error;
    }
    last_.insert_or_assign(end.id, end);
    return gathering_.add(end, line_);
  }

 private:
  static constexpr double kMostBetween_s = 60.0;
  static constexpr double kMostSteps = 1440.0;  // a day: no aircraft flies straight on for longer

  // Nearly all begin where the one before of that flight ends: one place, said twice.
  [[nodiscard]] bool goes_on_from_last(const AircraftReport& begin) const {
    const auto last = last_.find(begin.id);
    return last != last_.end() && last->second.time_s == begin.time_s &&
           last->second.longitude_deg == begin.longitude_deg &&
           last->second.latitude_deg == begin.latitude_deg &&
           last->second.pressure_height == begin.pressure_height &&
           last->second.label == begin.label;
  }

  AircraftGathering& gathering_;
  std::uint64_t& line_;
  std::unordered_map<std::string, AircraftReport> last_ = {};  // ends of segments, by flight
};

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
      "each segment of so6 is one straight line (a great circle), however long it lasts: places on "
      "it are put in once a minute");
  std::uint64_t number = 0;
  SegmentFlights flights(gathering, number);
  for (std::size_t offset = 0; offset < text.size();) {
    const Line line = line_at(text, offset, '\n');
    offset = line.next;
    ++number;
    if (says_nothing(line.text)) continue;
    const auto fields = fields_of(line.text);
    const auto begin = fields ? report_of(*fields, kEnds[0]) : std::nullopt;
    const auto end = fields ? report_of(*fields, kEnds[1]) : std::nullopt;
    std::optional<Error> error;
    if (begin && end) {
      error = flights.add(*begin, *end);
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
    if (auto fatal = assembly.bad(*std::move(error), begin ? begin->id : "")) return fatal;
  }
  return std::nullopt;
}

}  // namespace beespace::io
