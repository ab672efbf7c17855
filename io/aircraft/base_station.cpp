#include "io/aircraft/base_station.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace beespace::io {
namespace {

constexpr std::size_t kFields = 22;
using Fields = std::array<std::string_view, kFields>;

// The places, by the documentation of Kinetic's BaseStation.
constexpr std::size_t kKind = 1;
constexpr std::size_t kAddress = 4;
constexpr std::size_t kDate = 6;
constexpr std::size_t kTime = 7;
constexpr std::size_t kCallsign = 10;
constexpr std::size_t kAltitude = 11;
constexpr std::size_t kSpeed = 12;
constexpr std::size_t kTrack = 13;
constexpr std::size_t kLatitude = 14;
constexpr std::size_t kLongitude = 15;
constexpr std::size_t kClimb = 16;
constexpr std::size_t kGround = 21;

constexpr std::size_t kLongestCallsign = 16;  // eight letters; what is longer is not kept

// The kinds of messages that say where an aircraft is, or how fast.
constexpr char kSurfacePosition = '2';
constexpr char kAirbornePosition = '3';
constexpr char kVelocity = '4';

// How many fields there are; those that fit are put down.
std::size_t split(std::string_view line, Fields& fields) {
  std::size_t count = 0;
  while (true) {
    const std::size_t comma = line.find(',');
    if (count < kFields) fields[count] = without_padding(line.substr(0, comma));
    ++count;
    if (comma == std::string_view::npos) return count;
    line.remove_prefix(comma + 1);
  }
}

std::optional<Error> read_field(const Fields& fields, std::size_t column, std::string_view name,
                                double& value) {
  const std::string_view text = fields[column];
  if (text.empty()) return std::nullopt;
  const NumberKind kind = parse_number(text, value);
  if (kind == NumberKind::kNumber) value = without_dust(value);
  if (kind == NumberKind::kNumber && in_motion_domain(value)) return std::nullopt;
  value = AircraftReport::kUnknown;
  if (kind == NumberKind::kNumber) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " cannot be computed with exactly (" + std::string(name) +
                         "); use 0, or a size of " + std::string(kMotionDomain) +
                         std::string(kOrLeaveOut),
                     column);
  }
  return number_problem(kind, text, name, kMotionDomain, column);
}

// "2024/05/01" and "12:00:00.250", on clocks of the zone.
std::optional<Error> read_time(const Fields& fields, const std::optional<TimeZone>& zone,
                               double& time_s) {
  if (fields[kDate].empty() || fields[kTime].empty()) return std::nullopt;
  std::string text(fields[kDate]);
  std::replace(text.begin(), text.end(), '/', '-');
  text.append("T").append(fields[kTime]);
  WallTime clock;
  if (parse_wall_time(text, clock).empty() && !clock.offset_s) {
    std::int64_t offset_s = 0;
    std::string doubt = zone ? zone->offset_of_local(clock.seconds, offset_s) : std::string();
    if (!doubt.empty()) {
      return at_column(ErrorCode::kNotANumber,
                       excerpt(fields[kDate]) + ", " + excerpt(fields[kTime]) + ": " + doubt,
                       kDate);
    }
    clock.seconds -= offset_s;
    time_s = seconds_after(clock, 0);
    return std::nullopt;
  }
  return at_column(ErrorCode::kNotANumber,
                   excerpt(fields[kDate]) + ", " + excerpt(fields[kTime]) +
                       " is no date and time; write it as 2024/05/01,12:00:00.250" +
                       std::string(kOrLeaveOut),
                   kDate);
}

// Everything that a message may say, whatever its kind.
std::optional<Error> read_values(const Fields& fields, const std::optional<TimeZone>& zone,
                                 AircraftReport& now) {
  double speed = AircraftReport::kUnknown;
  double climb = AircraftReport::kUnknown;
  if (auto error = read_time(fields, zone, now.time_s)) return error;
  if (auto error = read_field(fields, kAltitude, "altitude", now.pressure_height)) return error;
  if (auto error = read_field(fields, kSpeed, "speed", speed)) return error;
  if (auto error = read_field(fields, kTrack, "track", now.track_deg)) return error;
  if (auto error = read_field(fields, kLatitude, "latitude", now.latitude_deg)) return error;
  if (auto error = read_field(fields, kLongitude, "longitude", now.longitude_deg)) return error;
  if (auto error = read_field(fields, kClimb, "vertical rate", climb)) return error;
  now.id = normal_address(fields[kAddress]);
  now.height_unit = Unit::kFoot;
  now.ground_speed_mps = in_metric(speed, Unit::kKnot);
  now.pressure_climb_mps = in_metric(climb, Unit::kFootPerMinute);
  now.on_ground =
      fields[kKind][0] == kSurfacePosition || fields[kGround] == "-1" || fields[kGround] == "1";
  return std::nullopt;
}

// What is wrong with a message before any of its values is read.
std::optional<Error> shape_problem(const Fields& fields, std::size_t count) {
  if (count != kFields) {
    return Error{ErrorCode::kColumnCount,
                 "a message has 22 fields, this one has " + std::to_string(count) + "; correct it" +
                     std::string(kOrLeaveOut),
                 {}};
  }
  const std::string_view kind = fields[kKind];
  if (kind.size() != 1 || kind[0] < '1' || kind[0] > '8') {
    return at_column(
        ErrorCode::kMalformedRecord,
        excerpt(kind) + " is no kind of message (1 to 8); correct it" + std::string(kOrLeaveOut),
        kKind);
  }
  constexpr std::size_t kLongestAddress = 16;  // six digits, and perhaps a sign before them
  const std::string_view address = fields[kAddress];
  if (!address.empty() && address.size() <= kLongestAddress) return std::nullopt;
  return at_column(ErrorCode::kMalformedRecord,
                   excerpt(address) + " is no address of an aircraft; write it as 4B1814" +
                       std::string(kOrLeaveOut),
                   kAddress);
}

// mlat-client writes places that were found by the times of several receivers as MLAT.
bool is_message(std::string_view word) {
  return word == "MSG" || word == "MLAT";
}

// Others than MSG say nothing of positions: who is selected, seen first, or lost.
bool is_notice(std::string_view word) {
  return word == "SEL" || word == "ID" || word == "AIR" || word == "STA" || word == "CLK";
}

}  // namespace

bool is_base_station_line(std::string_view line) {
  Fields fields;
  const std::size_t count = split(line, fields);
  if (is_message(fields[0])) return count == kFields;
  // "ID" may begin the header of a table; what follows it here is a number or nothing.
  constexpr std::size_t kLeastOfNotice = 10;
  return is_notice(fields[0]) && count >= kLeastOfNotice &&
         fields[kKind].find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<Error> base_station_problem(const RecordingOptions& options) {
  if (options.heights == HeightSource::kGeometric) {
    return Error{ErrorCode::kInvalidArgument,
                 "BaseStation messages tell heights by pressure only, but --heights geometric is "
                 "given; leave it out",
                 {}};
  }
  return aircraft_problem(options, "BaseStation messages");
}

std::string BaseStation::note() const {
  if (zone_) {
    return "times are those of " + zone_->name() +
           ", as --time-zone says: BaseStation messages name no time zone";
  }
  return "times are taken for UTC: BaseStation messages name no time zone (--time-zone says "
         "which)";
}

BaseStation::Heard& BaseStation::heard_of(const std::string& address) {
  // A receiver hears some thousands; more come from who makes them up. Velocities are heard again.
  if (heard_.size() >= kMostAircraft && !heard_.contains(address)) heard_.clear();
  return heard_[address];
}

std::optional<Error> BaseStation::take(std::string_view line, const AircraftReport*& report) {
  report = nullptr;
  address_.clear();
  if (line.size() > kLongestLine) return long_line(line);
  Fields fields;
  const std::size_t count = split(line, fields);
  if (is_notice(fields[0])) return std::nullopt;
  if (!is_message(fields[0])) {
    return at_column(ErrorCode::kMalformedRecord,
                     excerpt(fields[0]) + " is no BaseStation message (MSG); correct it" +
                         std::string(kOrLeaveOut),
                     0);
  }
  if (auto error = shape_problem(fields, count)) return error;
  const char kind = fields[kKind][0];

  AircraftReport now;
  address_ = normal_address(fields[kAddress]);
  if (auto error = read_values(fields, zone_, now)) return error;
  Heard& heard = heard_of(now.id);
  if (!fields[kCallsign].empty()) heard.callsign = fields[kCallsign].substr(0, kLongestCallsign);
  const bool has_velocity = !std::isnan(now.ground_speed_mps) && !std::isnan(now.track_deg);
  if (kind == kVelocity || has_velocity) {
    heard.time_s = now.time_s;
    heard.ground_speed_mps = now.ground_speed_mps;
    heard.track_deg = now.track_deg;
    heard.climb_mps = now.pressure_climb_mps;
  }
  if (kind != kSurfacePosition && kind != kAirbornePosition) return std::nullopt;
  if (std::abs(now.time_s - heard.time_s) <= kVelocityLasts_s) {
    now.ground_speed_mps = heard.ground_speed_mps;
    now.track_deg = heard.track_deg;
    now.pressure_climb_mps = heard.climb_mps;
  }
  now.label = heard.callsign;
  report_ = std::move(now);
  report = &report_;
  return std::nullopt;
}

}  // namespace beespace::io
