#include "io/aircraft/aircraft_report.hpp"

#include "io/frames/to_metres.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"

#include <beespace/geodesy.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace beespace::io {
namespace {

std::string number_text(double value) {
  std::array<char, 32> text = {};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

Velocity velocity_of(const AircraftReport& report, double climb_mps) {
  constexpr double kUnknown = AircraftReport::kUnknown;
  Velocity velocity = {kUnknown, kUnknown, climb_mps};
  constexpr double kMostTurns_deg = 1e12;  // of local_velocity()
  if (std::isfinite(report.ground_speed_mps) && std::abs(report.track_deg) <= kMostTurns_deg) {
    const LocalVelocity over_ground =
        local_velocity(report.ground_speed_mps, report.track_deg, 0.0);
    velocity.x = without_dust(over_ground.east_mps);
    velocity.y = without_dust(over_ground.north_mps);
  }
  velocity.z = without_dust(velocity.z);
  return velocity;
}

// Of who says that it is on the ground; what is not known is not beyond anything.
bool flies(const AircraftReport& report) {
  const auto high = [&report](double height) {
    return in_metric(height, report.height_unit) > kHighestGround_m;
  };
  return high(report.pressure_height) || high(report.ellipsoid_height) ||
         report.ground_speed_mps > kFastestOnGround_mps ||
         std::abs(report.pressure_climb_mps) > kMostClimbOnGround_mps ||
         std::abs(report.geometric_climb_mps) > kMostClimbOnGround_mps;
}

}  // namespace

std::string normal_address(std::string_view address) {
  std::string normal(address);
  for (char& c : normal) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return normal;
}

Result<std::optional<AircraftFix>> AircraftChoice::choose(const AircraftReport& report,
                                                          LeftOut& left_out) const {
  const auto leave_out = [&left_out](const LeftOutReason& reason) {
    left_out.add(reason);
    return std::optional<AircraftFix>();
  };
  if (report.on_ground && !grounded_) {
    return leave_out(flies(report) ? kOnGroundInFlight : kOnGround);
  }
  if (std::isnan(report.longitude_deg) || std::isnan(report.latitude_deg)) {
    return leave_out(kNoPosition);
  }
  if (std::isnan(report.time_s)) return leave_out(kNoTime);
  const double stated = by_pressure() ? report.pressure_height : report.ellipsoid_height;
  const double height = in_metric(stated, report.height_unit);
  if (std::isnan(height)) return leave_out(by_pressure() ? kNoPressureHeight : kNoEllipsoidHeight);

  AircraftFix chosen;
  chosen.stated_height = stated;
  chosen.fix = {without_dust(report.time_s), {report.longitude_deg, report.latitude_deg, height}};
  if (auto error = impossible_place(chosen.fix.position)) return *std::move(error);
  if (!in_motion_domain(without_dust(report.time_s))) {
    return Error{ErrorCode::kOutsideDomain,
                 "its time cannot be computed with exactly; use 0, or a size of " +
                     std::string(kMotionDomain) + " s" + std::string(kOrLeaveOut),
                 {}};
  }
  const double wanted = by_pressure() ? report.pressure_climb_mps : report.geometric_climb_mps;
  const double other = by_pressure() ? report.geometric_climb_mps : report.pressure_climb_mps;
  chosen.velocity = velocity_of(report, std::isnan(wanted) ? other : wanted);
  if (!report.on_ground && !report.may_hover && stands_in_air(report.ground_speed_mps, height)) {
    chosen.doubts_standing = true;
    chosen.velocity.x = chosen.velocity.y = AircraftReport::kUnknown;
  }
  return std::optional<AircraftFix>(chosen);
}

Fix AircraftChoice::place_of(const AircraftReport& report) const {
  const double stated = by_pressure() ? report.pressure_height : report.ellipsoid_height;
  return {report.time_s,
          {report.longitude_deg, report.latitude_deg, in_metric(stated, report.height_unit)}};
}

HeightDatum AircraftChoice::datum() const {
  return by_pressure() ? HeightDatum::kPressure : HeightDatum::kEllipsoid;
}

std::string AircraftChoice::note() const {
  return by_pressure() ? "heights are by pressure, of the standard atmosphere"
                       : "heights are geometric, above the WGS84 ellipsoid";
}

std::vector<UnitTaken> AircraftChoice::units(Unit height_unit, std::string_view format) {
  const bool feet = height_unit == Unit::kFoot;
  const std::string reason = std::string(format) + " has them so";
  const auto taken = [&reason](const char* of, Unit unit) {
    return UnitTaken{of, unit, UnitEvidence::kNamed, reason};
  };
  return {taken("heights", height_unit),
          taken("speeds", feet ? Unit::kKnot : Unit::kMetrePerSecond),
          taken("climb rates", feet ? Unit::kFootPerMinute : Unit::kMetrePerSecond)};
}

std::optional<Error> impossible_place(const Point& position) {
  const auto problem = find_out_of_range(std::span<const Point>(&position, 1), 0, Frame::kWgs84);
  const auto is_computable = [](double value) { return in_motion_domain(without_dust(value)); };
  const bool computable =
      is_computable(position.x) && is_computable(position.y) && is_computable(position.z);
  if (!problem && computable) return std::nullopt;
  ErrorCode code = ErrorCode::kOutsideDomain;
  std::string message = "its position cannot be computed with exactly; use 0, or a size of " +
                        std::string(kMotionDomain);
  if (problem) {
    code = problem->code;
    message = problem->axis == 0 ? "longitude " + number_text(position.x) + " is beyond 360 degrees"
              : problem->axis == 1 ? "latitude " + number_text(position.y) + " is beyond 90 degrees"
                                   : "height " + number_text(position.z) +
                                         " m is no height of a bee (-12,000 to 1,000,000 m)";
    message += "; correct it";
  }
  return Error{code, message + std::string(kOrLeaveOut), {}};
}

std::optional<Error> aircraft_problem(const RecordingOptions& options, std::string_view format) {
  if (options.frame == Frame::kMetres) {
    return Error{ErrorCode::kInvalidArgument,
                 "positions of aircraft are in degrees, but --crs metres is given; leave it out",
                 {}};
  }
  return fixed_layout_problem(options, format);
}

std::optional<Error> fixed_layout_problem(const RecordingOptions& options,
                                          std::string_view format) {
  const auto invalid = [](std::string message) {
    return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
  };
  const std::string what(format);
  if (!options.columns.empty()) {
    return invalid("--columns is for tables, but this is " + what + "; leave it out");
  }
  if (options.units.any()) {
    return invalid("the numbers of " + what + " have their units; leave --units out");
  }
  if (options.time_unit != Unit::kUnstated) {
    return invalid("the times of " + what + " have their unit; leave --time-unit out");
  }
  return std::nullopt;
}

}  // namespace beespace::io
