// How an agent flies if it does as advised: its velocity changes evenly within the step, and stays.
//
// Within the step, the way between two is an arc: it strays from its chord by at most an eighth of
// how much their relative velocity changes, times the step. So a meeting is looked for along the
// chord, that much sooner; and along the straight way after it.
#pragma once

#include "avoidance/agent_state.hpp"
#include "base/vector3.hpp"

#include <beespace/mover.hpp>

#include <optional>

namespace beespace::avoidance {

class AdvisedFlight {
 public:
  AdvisedFlight(const AgentState& agent, const Velocity& advised);
  // Of one that has another velocity a step later.
  AdvisedFlight(const Mover& from, const Velocity& next);
  // Of one that flies straight on.
  explicit AdvisedFlight(const Mover& straight);

  struct Meeting {
    double begins_s;
    double ends_s;     // infinite: never
    double closest_m;  // or less than that far: no more than this is proven
  };

  // When the two are closer than the threshold within the horizon; absent if they surely are not.
  static std::optional<Meeting> meeting(const AdvisedFlight& a, const AdvisedFlight& b,
                                        double threshold_m, double step_s, double horizon_s);

 private:
  [[nodiscard]] Mover chord() const;
  [[nodiscard]] Mover after(double step_s) const;

  core::Vector3 position_;
  core::Vector3 velocity_;  // as the step begins
  core::Vector3 advised_;
};

}  // namespace beespace::avoidance
