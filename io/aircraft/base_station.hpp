// Messages of BaseStation (SBS-1), as receivers send them on TCP port 30003: 22 fields a line.
//
// An aircraft tells its position in one kind of message and its velocity in another, so the last
// velocity of each is kept, and joined to positions that follow within kVelocityLasts_s. Times are
// those at which the message was generated. The format names no time zone: they are taken for those
// of clocks where the caller says, or for UTC.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/units/time_zone.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace beespace::io {

// Whether a line is such a message, of whatever kind.
bool is_base_station_line(std::string_view line);

// Heights are by pressure and nothing else. Errors: kInvalidArgument where others are asked for.
std::optional<Error> base_station_problem(const RecordingOptions& options);

class BaseStation {
 public:
  static constexpr double kVelocityLasts_s = 10.0;
  static constexpr std::size_t kMostAircraft = std::size_t{1} << 16;  // that are kept apart

  explicit BaseStation(std::optional<TimeZone> zone = std::nullopt) : zone_(std::move(zone)) {}

  // What is to be told.
  [[nodiscard]] std::string note() const;

  // `line` has no line end. Sets `report` where the message completes a position, to nothing where
  // it does not; what it points to holds until the next call. Errors with column, without line:
  // kColumnCount, kMalformedRecord, kNotANumber, kNotFinite, kOutsideDomain.
  std::optional<Error> take(std::string_view line, const AircraftReport*& report);

  // Whose the last message was; empty where it was not understood, or is a notice.
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  struct Heard {
    double time_s = AircraftReport::kUnknown;  // of the velocity
    double ground_speed_mps = AircraftReport::kUnknown;
    double track_deg = AircraftReport::kUnknown;
    double climb_mps = AircraftReport::kUnknown;
    std::string callsign = {};
  };

  Heard& heard_of(const std::string& address);

  std::optional<TimeZone> zone_;
  AircraftReport report_;
  std::string address_;
  std::unordered_map<std::string, Heard> heard_;
};

}  // namespace beespace::io
