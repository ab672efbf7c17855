#include "avoidance/soft_program.hpp"

namespace beespace::avoidance {

std::optional<Vector3> SoftProgram::nearest(const Vector3& wish, std::span<const HalfSpace> firm,
                                            std::span<const Request> requests, const Ball& ball) {
  if (requests.empty()) return nearest_place(wish, firm, ball);
  if (auto found = at(0.0, wish, firm, requests, ball)) return found;
  auto best = at(1.0, wish, firm, requests, ball);
  if (!best) return best;
  constexpr int kHalvings = 9;
  double too_little = 0.0;
  double enough = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double share = 0.5 * (too_little + enough);
    const auto found = at(share, wish, firm, requests, ball);
    (found ? enough : too_little) = share;
    if (found) best = found;
  }
  return best;
}

std::optional<Vector3> SoftProgram::at(double share, const Vector3& wish,
                                       std::span<const HalfSpace> firm,
                                       std::span<const Request> requests, const Ball& ball) {
  all_.assign(firm.begin(), firm.end());
  for (const auto& [side, yields] : requests) {
    all_.push_back({side.normal, side.offset - share * yields});
  }
  return nearest_place(wish, all_, ball);
}

}  // namespace beespace::avoidance
