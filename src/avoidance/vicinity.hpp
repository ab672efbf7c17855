// Which agents may interact in a step.
//
// Those whose balls meet: each agent's own, which contains all that it may do (see AgentStates).
// The few that reach farther than a float holds are compared with all others.
#pragma once

#include "avoidance/agent_states.hpp"
#include "base/memory.hpp"

#include <beespace/crew.hpp>
#include <beespace/engine.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstddef>
#include <vector>

namespace beespace::avoidance {

class Vicinity {
 public:
  // With the threads of `lent`, which must outlive this; null: with threads of its own.
  explicit Vicinity(Crew* lent = nullptr) : engine_(lent == nullptr ? Engine() : Engine(*lent)) {}

  // All agents that may meet. Errors: as Engine::find_neighbors.
  Status find(const AgentStates& agents, Crew& crew);
  // All agents within this distance.
  Status find_within(const PointsView& places, double within_m, const RunOptions& run);

  // All of so few agents matter to each other.
  void take_all(std::size_t agents) {
    agents_ = agents;
    far_.assign(1, 0);
    is_far_.assign(agents, 1);
  }

  // Calls visit(other) for each agent that may matter to a bee, and for some that do not, once
  // each, in ascending order, until it returns false. The order depends on nothing else: so a bee
  // that knows its neighbours alone finds the same.
  template <class Visit>
  void visit(PointId bee, Visit&& visit) const {
    if (reaches_far(bee)) {
      for (PointId other = 0; other < agents_; ++other) {
        if (other != bee && !visit(other)) return;
      }
      return;
    }
    auto far = far_.begin();
    for (const PointId other : rows_[bee]) {
      for (; far != far_.end() && *far < other; ++far) {
        if (!visit(*far)) return;
      }
      if (!reaches_far(other) && !visit(other)) return;
    }
    for (; far != far_.end(); ++far) {
      if (!visit(*far)) return;
    }
  }

 private:
  [[nodiscard]] bool reaches_far(PointId bee) const { return !far_.empty() && is_far_[bee] != 0; }
  void look_for_far(const AgentStates& agents);

  Engine engine_;
  core::Memory memory_;
  IdRows rows_;
  std::size_t agents_ = 0;
  std::vector<PointId> far_;  // ascending
  std::vector<char> is_far_;  // of each, where there are any
};

}  // namespace beespace::avoidance
