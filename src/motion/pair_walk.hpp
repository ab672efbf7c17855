// Two runs, piece by piece: in which windows of time are they in conflict, and what is that as one
// stretch?
//
// A window is the time in which both are on one straight piece each; there the exact decision of
// encounter.hpp holds. Windows follow each other without a gap, so a conflict goes on in the next
// one if and only if the two are in conflict at the instant in between.
#pragma once

#include "motion/runs.hpp"
#include "motion/separation.hpp"

#include <beespace/conflict.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace beespace::motion {

class PairWalk {
 public:
  // Where a walk has come to: what it needs to go on later.
  struct State {
    std::size_t first_piece = 0;  // the window to walk next
    std::size_t second_piece = 0;
    double walked_until = -std::numeric_limits<double>::infinity();  // the end of the one before
    std::optional<Conflict> open = {};  // one that goes on beyond it
  };

  PairWalk(const Run& first, const Run& second, const Separation& separation);

  // Walks the windows that meet the time, each as a whole, from where `state` has come to. Conflicts
  // that have ended are added to `ended`.
  void walk(const TimeSpan& time, State& state, std::vector<Conflict>& ended) const;

 private:
  void walk_window(const Piece& first, const Piece& second, const TimeSpan& window, State& state,
                   std::vector<Conflict>& ended) const;

  const Run& first_;
  const Run& second_;
  Separation possible_;  // widened by both tolerances,
  Separation certain_;   // and narrowed by them
  double reach_m_;       // of the wider one: cylinders lie in spheres
  bool exact_;           // there are no tolerances
};

}  // namespace beespace::motion
