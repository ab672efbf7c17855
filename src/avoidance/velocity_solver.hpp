// The nearest certified velocity to a preferred velocity.
//
// Any preferred velocity is allowed. The result lies in the half-spaces, except that the bee brakes
// as hard as it can where nothing better is found. Braking satisfies the half-spaces too.
#pragma once

#include "avoidance/agent_state.hpp"
#include "avoidance/constraints/constraints.hpp"
#include "avoidance/constraints/half_spaces.hpp"
#include "avoidance/constraints/relaxed_qp.hpp"

#include <beespace/advise.hpp>

#include <vector>

namespace beespace::avoidance {

class VelocitySolver {
 public:
  struct Solved {
    Vector3 velocity;
    AdviceKind kind;
  };
  Solved solve(const AgentState& agent, const Vector3& preferred, const Constraints& constraints);

 private:
  void put_in_changes(const AgentState& agent, const Vector3& from, const Constraints& constraints,
                      double most_change, double within);

  // Of velocity.
  std::vector<HalfSpace> firm_;
  std::vector<Request> requests_;
  RelaxedQp program_;
};

}  // namespace beespace::avoidance
