#include "avoidance/constraints/relaxed_qp.hpp"

#include <algorithm>

namespace beespace::avoidance {

std::optional<Vector3> RelaxedQp::nearest(const Vector3& target, std::span<const HalfSpace> firm,
                                          std::span<const Request> requests, const Ball& ball) {
  if (requests.empty()) return nearest_place(target, firm, ball);
  ask_for_what_there_is(requests, ball);
  if (auto found = at(0.0, target, firm, ball)) return found;
  auto best = at(1.0, target, firm, ball);
  if (!best) return best;
  constexpr int kHalvings = 9;
  double too_little = 0.0;
  double enough = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double share = 0.5 * (too_little + enough);
    const auto found = at(share, target, firm, ball);
    (found ? enough : too_little) = share;
    if (found) best = found;
  }
  return best;
}

// The part of a request that lies beyond the ball is dropped before the rest is relaxed. So the
// share is as fine within the ball, however large the request is.
void RelaxedQp::ask_for_what_there_is(std::span<const Request> requests, const Ball& ball) {
  constexpr double kReached = 0.999;  // of the ball: the rest is little, and hard to meet exactly
  requests_.clear();
  for (const auto& [side, yields] : requests) {
    const double beyond = std::max(0.0, -side.inside_by(ball.center) - kReached * ball.radius);
    requests_.push_back({{side.normal, side.offset - beyond}, std::max(0.0, yields - beyond)});
  }
}

std::optional<Vector3> RelaxedQp::at(double share, const Vector3& target,
                                     std::span<const HalfSpace> firm, const Ball& ball) {
  all_.assign(firm.begin(), firm.end());
  for (const auto& [side, yields] : requests_) {
    all_.push_back({side.normal, side.offset - share * yields});
  }
  return nearest_place(target, all_, ball);
}

}  // namespace beespace::avoidance
