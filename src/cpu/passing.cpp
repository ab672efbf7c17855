#include "cpu/passing.hpp"

namespace beespace::cpu {

CollectPassing collect_passing(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return kAvx2Passing;
    case InstructionSet::kAvx512:
      return kAvx512Passing;
#endif
    default:
      return kBaselinePassing;
  }
}

}  // namespace beespace::cpu
