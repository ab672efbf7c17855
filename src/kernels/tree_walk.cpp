#include "kernels/tree_walk.hpp"

#include "exact/exact_distance.hpp"

namespace beespace::cpu {

TreeWalks tree_walks_baseline();
#if defined(BEESPACE_X86_KERNELS)
TreeWalks tree_walks_avx2();
FindNearestOfLeaf tree_walk_of_leaf_avx512();
#endif

bool Ball::holds(const Point& point) const {
  return core::ProximityTest(radius_m, inclusive)(point, centre);
}

TreeWalks tree_walks(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return tree_walks_avx2();
    case InstructionSet::kAvx512: {
      TreeWalks walks = tree_walks_avx2();
      walks.find_nearest_of_leaf = tree_walk_of_leaf_avx512();
      return walks;
    }
#else
    case InstructionSet::kAvx2:
    case InstructionSet::kAvx512:
#endif
    case InstructionSet::kBaseline:
      break;
  }
  return tree_walks_baseline();
}

}  // namespace beespace::cpu
