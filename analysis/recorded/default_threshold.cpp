#include "analysis/recorded/default_threshold.hpp"

#include "io/aircraft/igc_log.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_aircraft.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

// No drone that one has logs of, and no bird, is both so high and so fast.
constexpr double kAboveDrones_m = 6'000.0;
constexpr double kFasterThanDrones_mps = 90.0;

// Whether one flies as airliners do, in two steps in a row at least.
bool cruises(const io::Recording& recording) {
  if (recording.frame != io::Frame::kWgs84 || recording.flat) return false;
  const auto fast = [&recording](const Fix& from, const Fix& to) {
    const double lasts_s = to.time_s - from.time_s;
    return from.position.z > kAboveDrones_m && to.position.z > kAboveDrones_m &&
           io::flat_distance_m(from.position, to.position, recording.frame) >
               kFasterThanDrones_mps * lasts_s;
  };
  return std::any_of(recording.bees.begin(), recording.bees.end(), [&](const io::RecordedBee& bee) {
    for (std::size_t i = 2; i < bee.fixes.size(); ++i) {
      if (fast(bee.fixes[i - 2], bee.fixes[i - 1]) && fast(bee.fixes[i - 1], bee.fixes[i])) {
        return true;
      }
    }
    return false;
  });
}

// A bare number up to this one is hardly meant in metres, but in nautical miles.
constexpr double kMostMiles = 30.0;

// A bare vertical number from here on is hardly meant in metres, but in feet: of metres 300 and 600
// are usual.
constexpr double kLeastFeet = 400.0;

bool is_clear(const std::optional<io::StatedLength>& typed) {
  return typed && !(typed->bare && typed->metric <= kMostMiles);
}

bool is_clear_vertical(const std::optional<io::StatedLength>& vertical) {
  return !vertical || !(vertical->bare && vertical->metric >= kLeastFeet);
}

// Whether what was typed leaves nothing to ask.
bool says_enough(const std::optional<io::StatedLength>& typed,
                 const std::optional<io::StatedLength>& vertical) {
  return is_clear(typed) && is_clear_vertical(vertical);
}

// Who makes encounters asks what DAIDALUS does: whether two stay well clear, or come next to a
// collision.
bool is_encounter(const io::Recording& recording) {
  return recording.format_description.find("DAIDALUS") != std::string::npos;
}

Error encounter_question() {
  return {
      ErrorCode::kInvalidArgument,
      "this is an encounter of aircraft: how close is too close? Say --separation "
      "well-clear-suas (2000 ft and 250 ft, of small unmanned aircraft), --separation nmac (500 "
      "ft and 100 ft), --threshold 4000ft --vertical 450ft (well clear of RTCA DO-365, without "
      "its time of 35 s), --separation enroute, or --separation terminal",
      {}};
}

Error aircraft_question(std::string_view known_by, const std::optional<io::StatedLength>& typed,
                        const std::optional<io::StatedLength>& vertical) {
  std::string message = "these are aircraft" + std::string(known_by);
  if (!typed) {
    message +=
        ": how close is too close? Say --separation enroute, --separation terminal, or how far it "
        "is, as in --threshold 5NM --vertical 1000ft";
    return {ErrorCode::kInvalidArgument, std::move(message), {}};
  }
  std::string in_aviation;
  std::string units;
  std::string in_metres;
  const auto ask = [&](const std::string& option, const io::StatedLength& length,
                       const std::string& why, const std::string& unit, const std::string& name) {
    const std::string number = io::exact(length.value);
    const std::string bare = option + " " + number;
    message.append(", and ").append(bare);
    message.append(" would be ").append(number).append(" m").append(why);
    in_aviation.append(in_aviation.empty() ? "" : " ").append(bare).append(unit);
    units.append(units.empty() ? "" : " and ").append(name);
    in_metres.append(in_metres.empty() ? "" : " ").append(bare).append("m");
  };
  if (!is_clear(typed)) {
    ask("--threshold", *typed, ", less than any separation of aircraft", "NM", "nautical miles");
  }
  if (!is_clear_vertical(vertical)) ask("--vertical", *vertical, "", "ft", "feet");
  const bool both = in_aviation.find(" --") != std::string::npos;
  message.append(": say ").append(in_aviation).append(both ? " if they are in " : " if it is in ");
  message.append(units).append(", or ").append(in_metres);
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

// All of it is what loggers of gliders wrote.
bool is_of_gliders(const io::Recording& recording) {
  return recording.format_description.starts_with(io::kIgcLog);
}

// They fly close together, in one thermal, and who types a number knows that.
std::optional<Error> glider_question(const std::optional<io::StatedLength>& typed) {
  if (typed) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "these are gliders: how close is too close? Say it in metres, as in --threshold 50, "
               "or with --vertical beside it, as in --threshold 150 --vertical 50",
               {}};
}

// By its heights, which others do not state so; empty where these say nothing.
std::string_view known_by_heights(io::Frame frame, io::Unit unit, io::HeightDatum datum) {
  if (frame != io::Frame::kWgs84) return {};
  if (unit == io::Unit::kFoot || unit == io::Unit::kFlightLevel) return ", by heights in feet";
  return datum == io::HeightDatum::kPressure ? ", by heights of pressure" : "";
}

constexpr std::size_t kLongestHeaderOfPoints = 10'000;

bool header_names_aircraft(std::string_view header) {
  if (header.size() > kLongestHeaderOfPoints) return false;
  for (const char delimiter : {',', ';', '\t'}) {
    io::FieldCursor cursor(header, delimiter);
    std::vector<std::string> columns;
    for (io::Field name; cursor.next(name);) columns.emplace_back(io::unquoted(name));
    if (io::name_aircraft(columns)) return true;
  }
  return false;
}

}  // namespace

DefaultThreshold default_threshold(const io::Recording& recording, double otherwise_m) {
  if (recording.declared_threshold_m.value_or(0.0) > 0.0) {
    return {*recording.declared_threshold_m, ", as the input declares"};
  }
  if (recording.show) {
    return {kDefaultShowThreshold_m, ", the default of shows that declare none (--threshold)"};
  }
  if (recording.of_drones || recording.called_drones) {
    return {kDefaultDroneThreshold_m, ", the default of logs of drones (--threshold)"};
  }
  return {otherwise_m, {}};
}

std::optional<Error> threshold_needed(const io::Recording& recording,
                                      const std::optional<io::StatedLength>& typed,
                                      const std::optional<io::StatedLength>& vertical) {
  if (!typed && recording.declared_threshold_m == 0.0) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the show declares a least distance of 0 (settings.validation.minDistance), which "
                 "no two can fall short of: say how close is too close, as in --threshold 2",
                 {}};
  }
  if (says_enough(typed, vertical) || recording.show) return std::nullopt;
  if (!typed && recording.declared_threshold_m) return std::nullopt;
  if (is_of_gliders(recording)) return glider_question(typed);
  if (!typed && is_encounter(recording)) return encounter_question();
  const std::string_view by =
      known_by_heights(recording.frame, recording.height_unit, recording.heights);
  if (!by.empty()) return aircraft_question(by, typed, vertical);
  if (recording.of_aircraft) return aircraft_question({}, typed, vertical);
  // Who typed a number there knows what flies.
  if (typed || !cruises(recording)) return std::nullopt;
  return aircraft_question(", higher and faster than drones fly", typed, vertical);
}

std::optional<Error> threshold_needed(const io::LoadedPoints& points,
                                      const std::optional<io::StatedLength>& typed,
                                      const std::optional<io::StatedLength>& vertical) {
  return threshold_needed(points, io::header_line(points), typed, vertical);
}

std::optional<Error> threshold_needed(const io::LoadedPoints& points, std::string_view header,
                                      const std::optional<io::StatedLength>& typed,
                                      const std::optional<io::StatedLength>& vertical) {
  if (says_enough(typed, vertical)) return std::nullopt;
  return threshold_needed(
      TrafficSigns{points.frame, points.height_unit, points.heights, header_names_aircraft(header)},
      typed, vertical);
}

std::optional<Error> threshold_needed(const TrafficSigns& signs,
                                      const std::optional<io::StatedLength>& typed,
                                      const std::optional<io::StatedLength>& vertical) {
  const std::string_view by = known_by_heights(signs.frame, signs.height_unit, signs.heights);
  if (says_enough(typed, vertical) || (by.empty() && !signs.of_aircraft)) return std::nullopt;
  return aircraft_question(by, typed, vertical);
}

}  // namespace beespace::analysis
