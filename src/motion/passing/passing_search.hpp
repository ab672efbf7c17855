// Which movers may pass each other closely within a step of time: few more than those that do, and
// none missed.
//
// Each is a ball that moves in a straight line through the step. The search is that for snapshots
// (see search/), of the midpoints of the step: it finds pairs whose balls around all of the step
// meet. A closer look at the moves of those few follows (pass_check.hpp).
#pragma once

#include "base/bounds.hpp"
#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace beespace::motion {

// The move of a ball: metres per second, and its radius, which adds to the clearance. In floats,
// which are as accurate as positions in a grid.
struct Move {
  float x;
  float y;
  float z;
  float radius_m;
};

struct MovingBalls {
  PointsView middles;           // at the midpoint of the step
  core::Bounds bounds;          // of the middles
  std::span<const Move> moves;  // only differences of velocities matter
  double reach_m;               // how far any ball gets at most from its middle within the step
};

struct Step {
  double half_s;       // half of its duration
  double clearance_m;  // pairs that surely stay farther apart, less their radii, are left out
  // Centres that come closer than this pass, whatever their radii; below zero: none surely does.
  double surely_m = -1.0;
  // Whether to leave out pairs that are surely closer than that when the step begins: the step
  // before has found them.
  bool follows_another = false;
  // The search ends once more than so many have been found, with no exact number.
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

// Whether two pass that may: by their ids.
using DecidePass = std::function<bool(PointId, PointId)>;

// Pairs of ids of each worker, each pair once, in no useful order: those that surely pass, and of
// those that may the ones that `decide` accepts; all of them where there is none.
core::Vector<core::FoundPairs> find_passing(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with,
                                            const search::TuningOverrides& tuning,
                                            const DecidePass& decide = {});

}  // namespace beespace::motion
