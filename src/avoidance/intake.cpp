#include "avoidance/intake.hpp"

#include "avoidance/constraints/free_shape.hpp"
#include "avoidance/validate.hpp"
#include "exact/validate.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace beespace::avoidance {

namespace {

// The check for the usual case; the reason is found later where it fails.
bool is_usable(double x, double y, double z) {
  return std::abs(x) <= kLargestInMotion && std::abs(y) <= kLargestInMotion &&
         std::abs(z) <= kLargestInMotion;
}
bool is_usable(const Velocity& v) {
  return is_usable(v.x, v.y, v.z);
}
bool is_usable(const Mover& mover) {
  return is_usable(mover.position.x, mover.position.y, mover.position.z) &&
         is_usable(mover.velocity);
}

std::optional<Error> check_preferred(const Velocity& velocity, std::size_t bee) {
  auto error = motion::check_mover({{}, velocity}, bee);
  if (error) {
    error->message.insert(0, "preferred ");
    error->location.array = "preferred";
  }
  return error;
}

std::optional<Error> check_ball(const UnknownAgent& ball, std::size_t index) {
  if (auto error = motion::check_position(ball.center, index)) {
    error->message.insert(0, "unknown bee: ");
    error->location.array = "unknown";
    return error;
  }
  const auto check = [&](double value, const char* name, const char* unit) -> std::optional<Error> {
    if (value >= 0.0 && motion::in_motion_domain(value)) return std::nullopt;
    Error error{ErrorCode::kInvalidArgument,
                std::string("unknown bee: the ") + name + " is " + core::shown(value) + " " + unit +
                    "; give a finite one, zero or more",
                {}};
    error.location.array = "unknown";
    error.location.record = index;
    return error;
  };
  if (auto error = check(ball.radius_m, "radius", "m")) return error;
  return check(ball.growth_mps, "growth", "m/s");
}

Error in_claims(Error error) {
  error.location.array = "claims";
  return error;
}

std::optional<Error> check_claim(const Claim& claim) {
  for (std::size_t k = 0; k < claim.places.size(); ++k) {
    const Point place = motion::flushed(claim.places[k]);
    if (is_usable(place.x, place.y, place.z)) continue;
    auto error = motion::check_position(place, k);
    if (!error) continue;
    error->message.insert(0, "claim: place " + std::to_string(k) + ": ");
    return in_claims(*std::move(error));
  }
  for (const auto& [value, name] : {std::pair(claim.tube_m, "the radius of the tube"),
                                    std::pair(claim.radius_m, "the agent's radius")}) {
    if (value >= 0.0 && motion::in_motion_domain(motion::flushed(value))) continue;
    return in_claims({ErrorCode::kInvalidArgument,
                      std::string("claim: ") + name + " is " + core::shown(value) +
                          " m; give a finite distance, zero or more",
                      {}});
  }
  return std::nullopt;
}

const Claim& claim_of(std::size_t bee, const AdviseOptions& options) {
  static constexpr Claim kNone;
  return options.claims.empty() ? kNone : options.claims[bee];
}

// In planar motion all have one height, and keep it.
std::optional<Error> check_level(const Mover& mover, const Claim& claim, double height_m) {
  const auto error = [](const std::string& message) {
    return Error{ErrorCode::kInvalidArgument, message, {}};
  };
  if (mover.velocity.z != 0.0) {
    return error("the motion is planar, and the vertical velocity is " +
                 core::shown(mover.velocity.z) + " m/s; give 0");
  }
  const auto differs = [&](double z) { return motion::flushed(z) != height_m; };
  const auto other = std::find_if(claim.places.begin(), claim.places.end(),
                                  [&](const Point& p) { return differs(p.z); });
  const bool own = differs(mover.position.z);
  if (!own && other == claim.places.end()) return std::nullopt;
  return error("the motion is planar, and the height is " +
               core::shown(own ? mover.position.z : other->z) + " m where most have " +
               core::shown(height_m) + " m; give all the same height");
}

// An agent of which no radius is known counts as half of the threshold; so the ball of one that is
// larger is larger by the rest.
double widened_m(PointId agent, const AdviseOptions& options) {
  if (agent >= options.claims.size()) return 0.0;
  const double more_m = options.claims[agent].radius_m - 0.5 * options.threshold_m;
  return more_m > 0.0 ? more_m * FreeShape(options.separation, options.planar).growth() : 0.0;
}

}  // namespace

// The median, so that a few with other heights are the ones that are refused.
void Intake::find_height(const MoversView& movers) {
  heights_m_.clear();
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const Mover mover = motion::flushed(movers[bee]);
    const bool is_unknown = !is_unknown_.empty() && is_unknown_[bee] != 0;
    if (!is_unknown && is_usable(mover)) heights_m_.push_back(mover.position.z);
  }
  height_m_ = 0.0;
  if (heights_m_.empty()) return;
  const auto middle = heights_m_.begin() + static_cast<std::ptrdiff_t>(heights_m_.size() / 2);
  std::nth_element(heights_m_.begin(), middle, heights_m_.end());
  height_m_ = *middle;
}

void Intake::take(const MoversView& movers, std::span<const Velocity> preferred,
                  std::span<const FlightLimits> limits, const AdviseOptions& options,
                  std::vector<Refused>& refused) {
  bees_ = movers.size();
  bee_anywhere_ = false;
  intruder_anywhere_ = false;
  refused.clear();
  options_ = options;
  take_unknown(options, movers.size(), refused);
  take_bees(movers, preferred, limits, options, refused);
  take_intruders(options, refused);
  options_.claims = claims_;
  options_.intruders = intruders_;
  options_.intruder_margins_m = intruder_margins_m_;
  options_.unknown = unknown_;
}

void Intake::take_unknown(const AdviseOptions& options, std::size_t bees,
                          std::vector<Refused>& refused) {
  unknown_.clear();
  given_unknown_.clear();
  is_unknown_.clear();
  for (std::size_t k = 0; k < options.unknown.size(); ++k) {
    UnknownAgent ball = options.unknown[k];
    if (ball.agent) {
      is_unknown_.resize(bees);
      is_unknown_[*ball.agent] = 1;
      ball.radius_m += widened_m(*ball.agent, options);
    }
    ball.center = motion::flushed(ball.center);
    ball.radius_m = motion::flushed(ball.radius_m);
    ball.growth_mps = motion::flushed(ball.growth_mps);
    if (auto error = check_ball(ball, k)) {
      given_unknown_.leave_out(unknown_.size());
      refused.push_back({RefusedKind::kUnknown, k, *std::move(error)});
      bee_anywhere_ = true;
      continue;
    }
    unknown_.push_back(ball);
    given_unknown_.take(k);
  }
}

void Intake::take_bees(const MoversView& movers, std::span<const Velocity> preferred,
                       std::span<const FlightLimits> limits, const AdviseOptions& options,
                       std::vector<Refused>& refused) {
  movers_.clear();
  preferred_.clear();
  limits_.clear();
  claims_.clear();
  if (options.planar) find_height(movers);
  movers_.reserve(movers.size());
  preferred_.reserve(movers.size());
  given_bees_.clear();
  const bool own_limits = limits.size() != 1;
  if (!own_limits) limits_.push_back(limits.front());
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const bool is_unknown = !is_unknown_.empty() && is_unknown_[bee] != 0;
    const Mover mover = motion::flushed(movers[bee]);
    if (is_unknown) {
      given_bees_.leave_out(movers_.size());
      continue;
    }
    std::optional<Error> error;
    if (!is_usable(mover)) error = motion::check_mover(mover, bee);
    if (!error && own_limits) {
      error = check_limits(limits[bee]);
      if (error) error->location.array = "limits";
    }
    if (!error && !options.claims.empty()) error = check_claim(options.claims[bee]);
    if (!error && options.planar) error = check_level(mover, claim_of(bee, options), height_m_);
    if (error) {
      given_bees_.leave_out(movers_.size());
      error->location.record = bee;
      refused.push_back({RefusedKind::kState, bee, *std::move(error)});
      bee_anywhere_ = true;
      continue;
    }
    Velocity velocity = motion::flushed(preferred[bee]);
    if (!is_usable(velocity)) {
      refused.push_back(
          {RefusedKind::kPreferred, bee, check_preferred(velocity, bee).value_or(Error{})});
      velocity = {};
    }
    if (options.planar) velocity.z = 0.0;
    movers_.push_back(mover);
    preferred_.push_back(velocity);
    if (own_limits) limits_.push_back(limits[bee]);
    if (!options.claims.empty()) claims_.push_back(options.claims[bee]);
    given_bees_.take(bee);
  }
}

void Intake::take_intruders(const AdviseOptions& options, std::vector<Refused>& refused) {
  intruders_.clear();
  intruder_margins_m_.clear();
  given_intruders_.clear();
  for (std::size_t k = 0; k < options.intruders.size(); ++k) {
    const Mover intruder = motion::flushed(options.intruders[k]);
    if (auto error = motion::check_mover(intruder, k)) {
      error->message.insert(0, "intruder: ");
      error->location.array = "intruders";
      given_intruders_.leave_out(intruders_.size());
      refused.push_back({RefusedKind::kIntruder, k, *std::move(error)});
      intruder_anywhere_ = true;
      continue;
    }
    intruders_.push_back(intruder);
    if (!options.intruder_margins_m.empty()) {
      intruder_margins_m_.push_back(options.intruder_margins_m[k]);
    }
    given_intruders_.take(k);
  }
}

void Intake::number_as_given(Advised& advised) const {
  const auto bee_given = [this](PointId taken) { return static_cast<PointId>(given_bees_[taken]); };
  for (auto& close : advised.too_close) {
    close.pair = {bee_given(close.pair.first), bee_given(close.pair.second)};
  }
  for (auto& near : advised.near_obstacle) near.agent = bee_given(near.agent);
  for (auto& near : advised.near_fence) near.agent = bee_given(near.agent);
  for (auto& conflict : advised.intruder_conflicts) {
    conflict.agent = bee_given(conflict.agent);
    conflict.intruder = given_intruders_[conflict.intruder];
  }
  for (auto& near : advised.near_unknown) {
    near.agent = bee_given(near.agent);
    near.unknown = given_unknown_[near.unknown];
  }
  advised.advice.resize(bees_);
  if (!given_bees_.any_left_out()) return;
  // From the last to the first, so that no element is overwritten before it is moved.
  for (std::size_t taken = movers_.size(); taken-- > 0;) {
    const std::size_t given = given_bees_[taken];
    if (given != taken) advised.advice[given] = std::exchange(advised.advice[taken], {});
  }
}

}  // namespace beespace::avoidance
