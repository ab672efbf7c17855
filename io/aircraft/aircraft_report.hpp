// What aircraft say of themselves, whatever the format, and which of it becomes a fix.
//
// An aircraft tells two heights: by satellites, above the WGS84 ellipsoid, and by the pressure of
// the air, as if it were the standard atmosphere's. They differ by hundreds of metres, so that one
// kind is taken for all; who has the other one only is left out.
#pragma once

#include "io/problems/left_out.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"
#include "io/units/units.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Not-a-number: it does not say.
struct AircraftReport {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  std::string id = {};       // the address, as normal_address() writes it
  std::string label = {};    // the flight, without padding; may be empty
  double time_s = kUnknown;  // of the position, since 1970
  double longitude_deg = kUnknown;
  double latitude_deg = kUnknown;
  double ellipsoid_height = kUnknown;  // both in height_unit, as they were sent
  double pressure_height = kUnknown;
  Unit height_unit = Unit::kMetre;
  bool on_ground = false;
  bool may_hover = false;  // by its category: a helicopter, a balloon, a drone
  double ground_speed_mps = kUnknown;
  double track_deg = kUnknown;  // clockwise from true north
  double geometric_climb_mps = kUnknown;
  double pressure_climb_mps = kUnknown;
};

// The same address always in the same letters: formats differ in their case.
std::string normal_address(std::string_view address);

struct AircraftFix {
  Fix fix;                       // longitude, latitude, height in metres
  Velocity velocity;             // east, north, up; not-a-number where unknown
  double stated_height = 0.0;    // in AircraftReport::height_unit
  bool doubts_standing = false;  // it says that it stands in the air, which it cannot: no velocity
};

class AircraftChoice {
 public:
  AircraftChoice(HeightSource heights, bool grounded) : heights_(heights), grounded_(grounded) {}

  // Nothing where the report is left out, which `left_out` counts. Errors without place:
  // kInvalidLongitude, kInvalidLatitude, kInvalidHeight, kOutsideDomain.
  Result<std::optional<AircraftFix>> choose(const AircraftReport& report, LeftOut& left_out) const;

  // Where an aircraft says that it is, on the ground or not; what it does not say is not-a-number.
  [[nodiscard]] Fix place_of(const AircraftReport& report) const;

  [[nodiscard]] HeightDatum datum() const;
  // To be told.
  [[nodiscard]] std::string note() const;
  // That of a format whose heights are in that unit.
  static std::vector<UnitTaken> units(Unit height_unit, std::string_view format);

 private:
  [[nodiscard]] bool by_pressure() const {
    return heights_ == HeightSource::kPressure || heights_ == HeightSource::kRatherPressure;
  }

  HeightSource heights_;  // kAuto: geometric
  bool grounded_;
};

// Positions in degrees that no bee can have, for records that have no columns. Without place.
std::optional<Error> impossible_place(const Point& position);

// What the caller asked for that a format of its own layout cannot give. Errors: kInvalidArgument.
std::optional<Error> fixed_layout_problem(const RecordingOptions& options, std::string_view format);

// The same for aircraft, whose positions are in degrees.
std::optional<Error> aircraft_problem(const RecordingOptions& options, std::string_view format);

}  // namespace beespace::io
