// The loop that keeps an agent near its nominal path: what to correct, from how far it deviates.
//
// In each period the deviation x and the velocity u of the correction change by
//   x' = x + T u + T^2/2 a + what carried it off,   u' = u + T a,   a = -k1 x - k2 u,
// x as far as it is known. Both poles lie at exp(-gain T), so a deviation dies away without
// swinging. In space as along a line, as k1 and k2 are numbers.
#pragma once

#include "base/vector3.hpp"

#include <beespace/fleet.hpp>

#include <cmath>

namespace beespace::fleet {

class CorrectionLoop {
 public:
  // Corrects nothing.
  CorrectionLoop() = default;
  // That of the tube, closed once in a period, which is above zero. Corrections never ask for more
  // than what the figures keep for them; as long as the figures hold, they never would.
  CorrectionLoop(const Tube& tube, const FleetFigures& figures, double period_s)
      : period_s_(period_s),
        most_mps2_(figures.correction_mps2),
        most_mps_(figures.correction_mps) {
    const double share = -std::expm1(-tube.gain_per_s * period_s);
    per_s2_ = share * share / (period_s * period_s);
    per_s_ = (2.0 - 0.5 * share) * share / period_s;
  }

  // The velocity of the correction a period later; until then it changes evenly. `deviation`: how
  // far the agent is taken to be off at the begin of the period.
  [[nodiscard]] core::Vector3 next(const core::Vector3& deviation,
                                   const core::Vector3& correction) const {
    const core::Vector3 wanted = deviation * -per_s2_ - correction * per_s_;
    const core::Vector3 acceleration = core::at_most(wanted, most_mps2_);
    // To draw places into a ball brings no two of them farther apart: this accelerates no more.
    return core::at_most(correction + acceleration * period_s_, most_mps_);
  }

  [[nodiscard]] double period_s() const { return period_s_; }

 private:
  double per_s2_ = 0.0;  // k1
  double per_s_ = 0.0;   // k2
  double period_s_ = 0.0;
  double most_mps2_ = 0.0;
  double most_mps_ = 0.0;
};

}  // namespace beespace::fleet
