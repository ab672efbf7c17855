#include "motion/validate.hpp"

#include "exact/validate.hpp"

#include <cmath>
#include <string>

namespace beespace::motion {

namespace {

using core::shown;

constexpr const char* kDomain = "0, or 7.9e-31 to 1.3e+30 in magnitude";

Error error_of(double value, const std::string& name, const std::string& unit, std::size_t record) {
  ErrorLocation location;
  location.array = "movers";
  location.record = record;
  if (!std::isfinite(value)) {
    return {ErrorCode::kNotFinite, name + " is " + shown(value) + "; it must be a finite number",
            location};
  }
  return {ErrorCode::kOutsideDomain,
          name + " is " + shown(value) + " " + unit + ", outside the motion domain (" + kDomain +
              "); scale the units",
          location};
}

std::optional<Error> check_vector(double x, double y, double z, const char* what, const char* unit,
                                  std::size_t record) {
  constexpr const char* kAxes[] = {" x", " y", " z"};
  const double values[] = {x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (in_motion_domain(values[axis])) continue;
    return error_of(values[axis], std::string(what) + kAxes[axis], unit, record);
  }
  return std::nullopt;
}

}  // namespace

bool in_motion_domain(double value) {
  const double magnitude = std::abs(value);
  return magnitude <= kLargestInMotion && (magnitude >= kSmallestInMotion || magnitude == 0.0);
}

std::optional<Error> check_separation(double threshold_m, const std::optional<double>& vertical_m) {
  const auto good = [](double value) { return value > 0.0 && in_motion_domain(value); };
  if (std::isnan(threshold_m)) return core::threshold_not_given();
  if (!good(threshold_m)) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the threshold is " + shown(threshold_m) +
                     " m; give a finite distance above zero (7.9e-31 m to 1.3e+30 m)",
                 {}};
  }
  if (vertical_m && !good(*vertical_m)) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the vertical threshold is " + shown(*vertical_m) +
                     " m; give a finite distance above zero (7.9e-31 m to 1.3e+30 m)",
                 {}};
  }
  return std::nullopt;
}

std::optional<Error> check_heights(bool given, const std::optional<double>& vertical_m) {
  if (!given || vertical_m) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "there are heights apart from the positions, but no vertical threshold to compare "
               "them with; give one, or positions in space",
               {}};
}

std::optional<Error> check_height_unit(double height_unit_m) {
  if (height_unit_m > 0.0 && in_motion_domain(height_unit_m)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the unit of heights is " + shown(height_unit_m) +
                   " m; give how many metres one is, above zero (0.3048 for feet)",
               {}};
}

std::optional<Error> check_options(const PredictOptions& options) {
  if (auto error = check_separation(options.threshold_m, options.vertical_m)) return error;
  if (auto error = check_height_unit(options.height_unit_m)) return error;
  if (options.horizon_s >= 0.0 && in_motion_domain(options.horizon_s)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the horizon is " + shown(options.horizon_s) +
                   " s; give a finite time, zero or more (at most 1.3e+30 s)",
               {}};
}

std::optional<Error> check_options(const ConflictOptions& options) {
  if (auto error = check_separation(options.threshold_m, options.vertical_m)) return error;
  if (auto error = check_height_unit(options.height_unit_m)) return error;
  if (options.max_gap_s > 0.0) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the greatest gap is " + shown(options.max_gap_s) + " s; give a time above zero",
               {}};
}

std::optional<Error> check_position(const Point& position, std::size_t record) {
  return check_vector(position.x, position.y, position.z, "position", "m", record);
}

std::optional<Error> check_height(double height_m, double climb_mps, std::size_t record) {
  if (!in_motion_domain(height_m)) return error_of(height_m, "height", "m", record);
  if (!in_motion_domain(climb_mps)) return error_of(climb_mps, "climb", "m/s", record);
  return std::nullopt;
}

std::optional<Error> check_time(double time_s, std::size_t record) {
  if (in_motion_domain(time_s)) return std::nullopt;
  return error_of(time_s, "time", "s", record);
}

std::optional<Error> check_mover(const Mover& mover, std::size_t record) {
  if (auto error = check_position(mover.position, record)) return error;
  const Velocity& v = mover.velocity;
  return check_vector(v.x, v.y, v.z, "velocity", "m/s", record);
}

namespace {

std::optional<Error> check_track(const Track& track, std::size_t record) {
  if (!(track.tolerance_m >= 0.0) || !in_motion_domain(track.tolerance_m)) {
    return Error{
        ErrorCode::kInvalidArgument,
        "the tolerance is " + shown(track.tolerance_m) + " m; give a finite distance, zero or more",
        {}};
  }
  const auto& fixes = track.fixes;
  if (!track.heights_m.empty() && track.heights_m.size() != fixes.size()) {
    return Error{ErrorCode::kInvalidArgument,
                 std::to_string(track.heights_m.size()) + " heights for " +
                     std::to_string(fixes.size()) + " fixes; give one for each, or none",
                 {}};
  }
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    std::optional<Error> error = check_position(fixes[i].position, record);
    if (!error && !track.heights_m.empty() && !in_motion_domain(track.heights_m[i])) {
      error = error_of(track.heights_m[i], "height", "m", record);
    }
    if (!error) error = check_time(fixes[i].time_s, record);
    if (!error && i > 0 && !(fixes[i - 1].time_s < fixes[i].time_s)) {
      error = Error{ErrorCode::kTimeOrder,
                    "time " + shown(fixes[i].time_s) + " s does not come after " +
                        shown(fixes[i - 1].time_s) + " s; sort the fixes by time",
                    {}};
    }
    if (!error) continue;
    error->message = "fix " + std::to_string(i) + ": " + error->message;
    return error;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> check_tracks(std::span<const Track> tracks) {
  bool heights = false;
  bool none = false;
  for (std::size_t id = 0; id < tracks.size(); ++id) {
    auto error = check_track(tracks[id], id);
    if (!tracks[id].fixes.empty()) (tracks[id].heights_m.empty() ? none : heights) = true;
    if (!error && heights && none) {
      error = Error{ErrorCode::kInvalidArgument,
                    "some tracks have heights apart from their positions, and others have none; "
                    "give them to all, or to none",
                    {}};
    }
    if (!error) continue;
    error->location.array = "tracks";
    error->location.record = id;
    return error;
  }
  return std::nullopt;
}

std::optional<Error> check_size(const MoversView& movers) {
  if (auto error = core::check_size(movers.positions())) {
    error->message.insert(0, "positions: ");
    error->location.array = "movers";
    return error;
  }
  if (auto error = core::check_size(movers.velocities())) {
    error->message.insert(0, "velocities: ");
    error->location.array = "movers";
    return error;
  }
  const std::size_t positions = movers.positions().size();
  const std::size_t velocities = movers.velocities().size();
  if (positions != velocities) {
    return Error{ErrorCode::kInvalidArgument,
                 std::to_string(positions) + " positions and " + std::to_string(velocities) +
                     " velocities; give one of each for every mover",
                 {}};
  }
  if (movers.fits()) return std::nullopt;
  if (movers.positions().has_heights() || movers.velocities().has_heights()) {
    return Error{ErrorCode::kInvalidArgument,
                 "there are heights of the positions alone; give them to the movers, with climb "
                 "rates",
                 {}};
  }
  return Error{ErrorCode::kInvalidArgument,
               std::to_string(movers.heights_m().size()) + " heights and " +
                   std::to_string(movers.climbs_mps().size()) + " climb rates for " +
                   std::to_string(positions) + " movers; give one of each for every one, or none",
               {}};
}

std::optional<Error> check_movers(const MoversView& movers) {
  for (std::size_t i = 0; i < movers.size(); ++i) {
    if (auto error = check_mover(movers[i], i)) return error;
    if (!movers.has_heights()) continue;
    if (auto error = check_height(movers.heights_m()[i], movers.climbs_mps()[i], i)) return error;
  }
  return std::nullopt;
}

}  // namespace beespace::motion
