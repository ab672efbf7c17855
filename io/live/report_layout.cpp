#include "io/live/report_layout.hpp"

#include "io/frames/to_metres.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/tracks/local_positions.hpp"
#include "io/units/heights.hpp"

#include <array>
#include <charconv>
#include <span>
#include <string>

namespace beespace::io {

std::optional<Error> live_problem(const TrackLayout& layout, Frame asked) {
  if (asked == Frame::kAuto && layout.frame == Frame::kWgs84 &&
      layout.table.choice.datum == HeightDatum::kHome) {
    return Error{ErrorCode::kInvalidArgument, std::string(kOwnGrounds), {}};
  }
  if (asked == Frame::kAuto && local_origin_of(layout)) {
    return Error{ErrorCode::kUnknownFrame,
                 "x, y, z are counted from ref_lat, ref_lon, ref_alt, which each drone has of its "
                 "own; give longitude, latitude and height, or say --crs metres if all have one "
                 "origin",
                 {}};
  }
  if (!layout.table.choice.id) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no id, by which the bees are told apart; name it id, or say which it is "
                 "with --columns id=...",
                 {}};
  }
  if (!layout.time) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no time; name it, for example, time_s, or say which it is with "
                 "--columns time=...",
                 {}};
  }
  if (layout.time->clock) {
    return Error{ErrorCode::kMissingColumn,
                 layout.time->clock->dated
                     ? "the times name no time zone; say which it is, as in --time-zone UTC or "
                       "--time-zone Europe/Madrid"
                     : "the times of day have no date, and after midnight would come again; add a "
                       "column with the date",
                 {}};
  }
  if (layout.frame == Frame::kAuto) {
    return Error{ErrorCode::kUnknownFrame,
                 "degrees or metres? The names do not tell; say it with --crs wgs84 (longitude, "
                 "latitude in degrees) or --crs metres",
                 {}};
  }
  return std::nullopt;
}

std::optional<Error> out_of_range(const Point& position, Frame frame) {
  if (frame != Frame::kWgs84) return std::nullopt;
  const auto problem = find_out_of_range(std::span<const Point>(&position, 1), 0, frame);
  if (!problem) return std::nullopt;
  const std::array<double, 3> values = {position.x, position.y, position.z};
  std::array<char, 32> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), values[problem->axis]).ptr;
  return range_error(*problem, position, std::string(text.data(), end));
}

Result<std::optional<ReportLine>> report_line(const AircraftReport& report,
                                              const AircraftChoice& choice, LeftOut& left_out) {
  auto chosen = choice.choose(report, left_out);
  if (!chosen) return without_advice(std::move(chosen).error());
  if (!chosen.value()) return std::optional<ReportLine>();
  const AircraftFix& fix = **chosen;
  ReportLine line;
  line.id = report.id;
  line.label = report.label;
  line.time_s = fix.fix.time_s;
  line.position = fix.fix.position;
  line.frame = Frame::kWgs84;
  line.stated_height = fix.stated_height;
  line.height_unit = report.height_unit;
  set_velocity(line, fix.velocity);
  line.since_1970 = true;
  return std::optional<ReportLine>(line);
}

}  // namespace beespace::io
