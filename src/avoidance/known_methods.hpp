// Known methods of the literature, for comparison: the velocity that they give to one bee.
#pragma once

#include "avoidance/agent_states.hpp"
#include "avoidance/constraints/relaxed_qp.hpp"
#include "avoidance/vicinity.hpp"

#include <beespace/advise.hpp>

#include <vector>

namespace beespace::avoidance {

// Their look-ahead time: as long as it takes to stop.
double looks_ahead_s(const AgentStates& agents, double step_s);

class KnownMethod {
 public:
  // ORCA: half-spaces of velocities, with half of each change for either bee; the velocity in them
  // that is nearest to the preferred velocity.
  Vector3 orca(const AgentStates& agents, PointId bee, const Vicinity& near,
               const Vector3& preferred, double horizon_s, double step_s);
  // MVP: for each conflict ahead, sideways by the distance that is missing at the closest approach;
  // the sum of these. Hoekstra, van Gent, Ruigrok: Designing for safety: the free flight air
  // traffic management concept (2002).
  static Vector3 mvp(const AgentStates& agents, PointId bee, const Vicinity& near,
                     const Vector3& preferred, double horizon_s, double step_s);

 private:
  std::vector<Request> requests_;
  RelaxedQp program_;
};

}  // namespace beespace::avoidance
