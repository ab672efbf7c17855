// The groups in a crowd, without comparing every pair of it.
#pragma once

#include "base/disjoint_sets.hpp"
#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "tree/crowd_tree.hpp"

namespace beespace::core {

// Joins the sets of all slots of the tree whose points are closer than the threshold, for which
// `closer` is the test and `units_per_m` the tree's lattice. False, with some sets not joined,
// where floats leave more pairs open than so many a point.
//
// A box whose diagonal is below the threshold is joined with no distance computed. Boxes that are
// known to be of one set each are searched for a single near pair, and not at all once they are of
// the same set: so a crowd costs little more than its tree. Working memory: 1 byte a leaf.
bool join_crowds(const CrowdTree& tree, double threshold, double units_per_m,
                 const ProximityTest& closer, std::uint64_t decisions_a_point,
                 const Resources& with, DisjointSets& sets);

}  // namespace beespace::core
