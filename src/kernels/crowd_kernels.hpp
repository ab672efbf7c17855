// Counting in crowds, a node of a core::CrowdTree against another: leaves are compared by their
// boxes, 16 at a time, and only those that are near in part point by point, 16 pairs at a time.
//
// As in sweep.hpp, a kernel classifies and hands what is unsure to `decide`; there is one set of
// kernels an instruction set, all compiled from crowd_kernel.hpp.
#pragma once

#include "kernels/sweep.hpp"

#include <cstdint>

namespace beespace::cpu {

inline constexpr std::uint32_t kCrowdLanes = 16;  // points of a leaf, leaves of a node

// A node of level 0. Pointers are to what belongs to its first slot or leaf.
struct CrowdNode {
  const std::int32_t* position[3];    // by slot; far from everywhere where there is no point
  const std::int32_t* low;            // [axis][leaf]
  const std::int32_t* high;           // [axis][leaf]
  const std::uint32_t* weights;       // by slot: how many points are there; null: one each
  const std::uint32_t* leaf_weights;  // by leaf: how many points it has in all
  std::uint32_t first_slot;
  std::uint32_t size;
};

// The arrays of counts. Lanes are added up when a node has been compared with all others.
struct CrowdSums {
  std::uint32_t* of_asked;         // [slot of the query node][lane]
  std::uint32_t* of_asked_leaves;  // [leaf of the query node][lane]: for all its points
  std::uint32_t* of_others;        // by slot of the other node
  std::uint32_t* of_other_leaves;  // by leaf of it
};

struct CrowdUnsure {
  // Whether both count the other, or only the query point does.
  void (*decide)(void* context, std::uint32_t asked, std::uint32_t other, bool both);
  void* context;
};

using CountCrowds = void (*)(const CrowdNode& asked, const CrowdNode& others, const Limits& limits,
                             const CrowdSums& sums, const CrowdUnsure& unsure);

// `weighted` says whether nodes have weights.
struct CrowdKernels {
  CountCrowds count[2];         // [weighted]: both count the other
  CountCrowds count_asked[2];   // [weighted]
  CountCrowds count_within[2];  // [weighted]: of a node with itself; a point is its own neighbour
};

const CrowdKernels& crowd_kernels(InstructionSet set);

extern const CrowdKernels kBaselineCrowdKernels;
extern const CrowdKernels kAvx2CrowdKernels;
extern const CrowdKernels kAvx512CrowdKernels;

}  // namespace beespace::cpu
