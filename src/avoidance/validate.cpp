#include "avoidance/validate.hpp"

#include "base/vector3.hpp"
#include "exact/validate.hpp"
#include "motion/validate.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace beespace::avoidance {

namespace {

using core::shown;

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

// Of an array of the call, by its name.
Error about(const char* array, std::string message) {
  Error error = invalid(std::move(message));
  error.location.array = array;
  return error;
}

std::optional<Error> check_clearance(const AdviseOptions& options) {
  const double clearance_m = options.clearance_m;
  if (std::isnan(clearance_m)) {
    if (options.obstacles == nullptr && options.fences.empty()) return std::nullopt;
    return invalid(std::string("there are ") +
                   (options.obstacles == nullptr ? "fences" : "obstacles") +
                   ", and the clearance from them is not given (or is not a number); say "
                   "in metres how close is too close");
  }
  if (clearance_m > 0.0 && motion::in_motion_domain(clearance_m)) return std::nullopt;
  return invalid("the clearance is " + shown(clearance_m) +
                 " m; give a finite distance above zero");
}

bool is_method(AdviseMethod method) {
  return method == AdviseMethod::kCertified || method == AdviseMethod::kOrca ||
         method == AdviseMethod::kMvp;
}

// The vertical semi-axis must be a length as any other.
std::optional<Error> check_shape(const AdviseOptions& options) {
  const Separation& separation = options.separation;
  const auto is_length = [](double value) {
    return value > 0.0 && motion::in_motion_domain(value);
  };
  switch (separation.shape) {
    case SeparationShape::kSphere:
      return std::nullopt;
    case SeparationShape::kEllipsoid:
      if (is_length(separation.vertical_factor) &&
          is_length(separation.vertical_factor * options.threshold_m)) {
        return std::nullopt;
      }
      return invalid("the vertical factor of the ellipsoid that stays free is " +
                     shown(separation.vertical_factor) + "; give a finite one above zero");
    case SeparationShape::kCylinder:
      if (is_length(separation.vertical_m)) return std::nullopt;
      return invalid("half of the height of the cylinder that stays free is " +
                     (std::isnan(separation.vertical_m) ? "not given (or is not a number)"
                                                        : shown(separation.vertical_m) + " m") +
                     "; give a finite distance above zero");
  }
  return invalid("the shape that stays free is number " +
                 std::to_string(static_cast<int>(separation.shape)) +
                 ", which is none; give one of SeparationShape");
}

std::optional<Error> check_fence(const Fence& fence) {
  constexpr double kInexact = 1e-9;
  const double long_m = length(core::vector_of(fence.inward));
  if (!(std::abs(long_m - 1.0) <= kInexact)) {
    return invalid("the direction inwards is of length " + shown(long_m) +
                   "; give one of length 1");
  }
  if (motion::in_motion_domain(fence.offset_m)) return std::nullopt;
  return invalid("the offset is " + shown(fence.offset_m) + " m; give a finite distance");
}

std::optional<Error> check_fences(std::span<const Fence> fences) {
  for (std::size_t k = 0; k < fences.size(); ++k) {
    auto error = check_fence(fences[k]);
    if (!error) continue;
    error->message.insert(0, "fence " + std::to_string(k) + ": ");
    error->location.array = "fences";
    error->location.record = k;
    return error;
  }
  return std::nullopt;
}

std::optional<Error> check_horizon(double horizon_s, const char* whose) {
  if (horizon_s > 0.0 && motion::in_motion_domain(horizon_s)) return std::nullopt;
  return invalid("the horizon of " + std::string(whose) + " is " + shown(horizon_s) +
                 " s; give a finite time above zero (7.9e-31 s to 1.3e+30 s)");
}

std::optional<Error> check_options(const AdviseOptions& options) {
  if (!is_method(options.method)) {
    return invalid("the method is number " + std::to_string(static_cast<int>(options.method)) +
                   ", which is none; give one of AdviseMethod");
  }
  if (auto error = motion::check_separation(options.threshold_m, std::nullopt)) return error;
  if (auto error = check_shape(options)) return error;
  if (auto error = check_step(options.step_s)) return error;
  if (!(options.uncertainty_m >= 0.0) || !motion::in_motion_domain(options.uncertainty_m)) {
    return invalid("the uncertainty is " + shown(options.uncertainty_m) +
                   " m; give a finite distance, zero or more");
  }
  if (auto error = check_clearance(options)) return error;
  if (auto error = check_fences(options.fences)) return error;
  if (auto error = check_horizon(options.intruder_horizon_s, "intruders")) return error;
  return check_horizon(options.unknown_horizon_s, "unknown bees");
}

std::optional<Error> check_margins(const AdviseOptions& options) {
  const auto& margins_m = options.intruder_margins_m;
  if (!margins_m.empty() && margins_m.size() != options.intruders.size()) {
    return about("intruders", std::to_string(margins_m.size()) + " margins for " +
                                  std::to_string(options.intruders.size()) +
                                  " intruders; give one for each, or none");
  }
  for (const double margin_m : margins_m) {
    if (margin_m >= 0.0 && motion::in_motion_domain(margin_m)) continue;
    return about("intruders", "the margin of an intruder is " + shown(margin_m) +
                                  " m; give a finite one, zero or more");
  }
  return std::nullopt;
}

std::optional<Error> check_unknown(std::span<const UnknownAgent> unknown, std::size_t bees) {
  for (std::size_t k = 0; k < unknown.size(); ++k) {
    if (!unknown[k].agent || *unknown[k].agent < bees) continue;
    return about("unknown", "unknown bee " + std::to_string(k) + " is said to be mover " +
                                std::to_string(*unknown[k].agent) + " of " + std::to_string(bees) +
                                "; give the number of one, counted from 0, or none");
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> check_step(double step_s) {
  if (step_s > 0.0 && motion::in_motion_domain(step_s)) return std::nullopt;
  return invalid("the step is " + shown(step_s) +
                 " s; give a finite time above zero (7.9e-31 s to 1.3e+30 s)");
}

std::optional<Error> check_limits(const FlightLimits& limits) {
  if (!(limits.max_speed_mps >= 0.0) || !motion::in_motion_domain(limits.max_speed_mps)) {
    return invalid("the greatest speed is " + shown(limits.max_speed_mps) +
                   " m/s; give a finite speed, zero or more");
  }
  const double acceleration = limits.max_acceleration_mps2;
  const bool none = std::isinf(acceleration) && acceleration > 0.0;
  if (!none && (!(acceleration > 0.0) || !motion::in_motion_domain(acceleration))) {
    return invalid("the greatest acceleration is " + shown(acceleration) +
                   " m/s^2; give one above zero, or infinity for none");
  }
  return std::nullopt;
}

std::optional<Error> check(const MoversView& movers, std::span<const Velocity> preferred,
                           std::span<const FlightLimits> limits, const AdviseOptions& options) {
  if (auto error = check_options(options)) return error;
  if (auto error = motion::check_size(movers)) return error;
  if (auto error = motion::check_size(options.intruders)) {
    error->message.insert(0, "intruders: ");
    error->location.array = "intruders";
    return error;
  }
  if (movers.has_heights() || options.intruders.has_heights()) {
    return invalid("there are heights apart from the positions; give positions in space");
  }
  if (auto error = check_margins(options)) return error;
  if (preferred.size() != movers.size()) {
    return about("preferred", std::to_string(preferred.size()) + " preferred velocities for " +
                                  std::to_string(movers.size()) + " movers; give one for each");
  }
  if (limits.size() != 1 && limits.size() != movers.size()) {
    return about("limits", std::to_string(limits.size()) + " sets of limits for " +
                               std::to_string(movers.size()) +
                               " movers; give one for each, or one for all");
  }
  if (limits.size() == 1) {
    if (auto error = check_limits(limits.front())) {
      error->location.array = "limits";
      return error;
    }
  }
  if (!options.claims.empty() && options.claims.size() != movers.size()) {
    return about("claims", std::to_string(options.claims.size()) + " claims for " +
                               std::to_string(movers.size()) +
                               " movers; give one for each, or none");
  }
  return check_unknown(options.unknown, movers.size());
}

}  // namespace beespace::avoidance
