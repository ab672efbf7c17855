#include "kernels/crowd_kernels.hpp"

namespace beespace::cpu {

const CrowdKernels& crowd_kernels(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return kAvx2CrowdKernels;
    case InstructionSet::kAvx512:
      return kAvx512CrowdKernels;
#endif
    default:
      return kBaselineCrowdKernels;
  }
}

}  // namespace beespace::cpu
