// Counts neighbours in crowds: whole boxes of points at once where all of them are near or none.
#pragma once

#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "kernels/sweep.hpp"
#include "tree/crowd_tree.hpp"

#include <cstdint>

namespace beespace::cpu {

// A tree, and how many points are at each of its places; by slot, null: one each. Weights are
// readable to the end of the last leaf, where they are 0.
struct Crowds {
  const core::CrowdTree& tree;
  const std::uint32_t* weights;
};

// Both trees are of one lattice; the same crowds twice: of a set with itself.
struct CrowdQuery {
  Crowds asked;
  Crowds others;
  double threshold;
  double units_per_m;
  const core::ProximityTest& closer;
  InstructionSet instruction_set;
  std::uint64_t decisions_a_point;  // one by one, of pairs that floats leave open
};

// Writes to counts[index] how many of the others are near, for every index of the asked tree's
// points; of a set with itself, each point counts as near to itself. False, and counts of no use,
// where floats leave more pairs open than may be decided one by one.
//
// Cost: proportional to the pairs of leaves that are near in part. Working memory: 5 bytes a point;
// of a set with itself, for every worker.
bool count_crowds(const CrowdQuery& question, const core::Resources& with, std::uint32_t* counts);

}  // namespace beespace::cpu
