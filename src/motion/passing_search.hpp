// Who may pass whom closely within a step of time: few more than those who do, and nobody missed.
//
// Everybody is a ball that moves in a straight line through the step. The search is that for
// snapshots (see search/), of where they are in the middle of the step, with a reach that covers
// what they move; its kernel looks at the moves as well (cpu/passing).
#pragma once

#include "core/pair_order.hpp"
#include "core/resources.hpp"
#include "search/choices.hpp"

#include <beespace/points_view.hpp>

#include <span>

namespace beespace::motion {

// How a ball moves: metres per second, and what is to be kept clear around it besides the
// clearance. As floats, which are as good as positions in a grid are.
struct Move {
  float x;
  float y;
  float z;
  float radius_m;
};

struct MovingBalls {
  PointsView middles;           // where they are in the middle of the step
  std::span<const Move> moves;  // only differences of velocities matter
};

struct Step {
  double half_s;       // half of its duration
  double clearance_m;  // who surely stays farther apart is left out
};

// Pairs of ids of each worker, each pair once, in no useful order.
core::Vector<core::FoundPairs> find_passing(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with,
                                            const search::Choices& choices);

}  // namespace beespace::motion
