// Methods that are well known, to compare with: what they tell one bee.
#pragma once

#include "avoidance/agent_states.hpp"
#include "avoidance/constraints/relaxed_qp.hpp"
#include "avoidance/vicinity.hpp"

#include <beespace/advise.hpp>

#include <vector>

namespace beespace::avoidance {

// How far ahead they look: as long as it takes to come to a stop.
double looks_ahead_s(const AgentStates& agents, double step_s);

class KnownMethod {
 public:
  // Half-spaces of velocities, half of each change for either of two; the nearest to the wish in
  // them.
  Vector3 orca(const AgentStates& agents, PointId bee, const Vicinity& near, const Vector3& wish,
               double horizon_s, double step_s);
  // For each conflict that lies ahead, sideways by what is missing when the two are closest; the
  // sum of these. Hoekstra, van Gent, Ruigrok: Designing for safety: the free flight air traffic
  // management concept (2002).
  static Vector3 mvp(const AgentStates& agents, PointId bee, const Vicinity& near,
                     const Vector3& wish, double horizon_s, double step_s);

 private:
  std::vector<Request> requests_;
  RelaxedQp program_;
};

}  // namespace beespace::avoidance
