#include "avoidance/advised_flight.hpp"

#include <beespace/closest_approach.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::avoidance {

namespace {

constexpr double kForever_s = 1e9;  // a horizon that the library takes

Mover mover_of(const Vector3& position, const Vector3& velocity) {
  return {{position.x, position.y, position.z}, {velocity.x, velocity.y, velocity.z}};
}

// How far positions that are computed here may be off: a few units in the last place.
double rounding_m(const Vector3& position, double way_m) {
  return 0x1p-50 * (length(position) + way_m);
}

// One of the library's answers, or that the two meet now where it has none.
std::optional<AdvisedFlight::Meeting> meeting_of(const Mover& a, const Mover& b, double threshold_m,
                                                 double horizon_s) {
  const auto approach =
      closest_approach(a, b, {.threshold_m = threshold_m, .horizon_s = horizon_s});
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (!approach) return AdvisedFlight::Meeting{0.0, kNever, 0.0};
  if (!approach->conflict) return std::nullopt;
  const auto& [begins_s, ends_s] = *approach->conflict;
  return AdvisedFlight::Meeting{begins_s, ends_s, approach->closest_m};
}

}  // namespace

AdvisedFlight::AdvisedFlight(const AgentState& agent, const Velocity& advised)
    : position_(agent.position),
      velocity_(agent.braking.at_once() ? core::vector_of(advised) : agent.velocity),
      advised_(core::vector_of(advised)) {
}

AdvisedFlight::AdvisedFlight(const Mover& from, const Velocity& next)
    : position_(core::vector_of(from.position)),
      velocity_(core::vector_of(from.velocity)),
      advised_(core::vector_of(next)) {
}

AdvisedFlight::AdvisedFlight(const Mover& straight) : AdvisedFlight(straight, straight.velocity) {
}

Mover AdvisedFlight::chord() const {
  return mover_of(position_, (velocity_ + advised_) * 0.5);
}

Mover AdvisedFlight::after(double step_s) const {
  return mover_of(position_ + (velocity_ + advised_) * (0.5 * step_s), advised_);
}

std::optional<AdvisedFlight::Meeting> AdvisedFlight::meeting(const AdvisedFlight& a,
                                                             const AdvisedFlight& b,
                                                             double threshold_m, double step_s,
                                                             double horizon_s) {
  const double longest_s = std::min(horizon_s, kForever_s);
  const double change = length((a.advised_ - a.velocity_) - (b.advised_ - b.velocity_));
  std::optional<Meeting> found;
  if (a.velocity_ == a.advised_ && b.velocity_ == b.advised_) {
    found = meeting_of(a.chord(), b.chord(), threshold_m, longest_s);
  } else {
    const double way_m = step_s * (length(a.velocity_) + length(a.advised_) + length(b.velocity_) +
                                   length(b.advised_));
    const double off_m = rounding_m(a.position_, way_m) + rounding_m(b.position_, way_m);
    const double strays_m = change * step_s / 8.0 + off_m;
    found = meeting_of(a.chord(), b.chord(), threshold_m + strays_m, std::min(step_s, longest_s));
    if (found) found->closest_m = std::max(0.0, found->closest_m - strays_m);
    if (longest_s > step_s) {
      const auto later =
          meeting_of(a.after(step_s), b.after(step_s), threshold_m + off_m, longest_s - step_s);
      if (later && !found) {
        found = Meeting{later->begins_s + step_s, later->ends_s + step_s, later->closest_m};
      } else if (later) {
        found->ends_s = later->ends_s + step_s;
        found->closest_m = std::min(found->closest_m, later->closest_m);
      }
    }
  }
  if (found && found->ends_s > 0.999 * kForever_s) {  // as far as anything is looked at
    found->ends_s = std::numeric_limits<double>::infinity();
  }
  return found;
}

}  // namespace beespace::avoidance
