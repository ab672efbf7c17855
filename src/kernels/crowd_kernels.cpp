#include "kernels/crowd_kernels.hpp"

namespace beespace::cpu {

const CrowdKernels& crowd_kernels(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return kAvx2CrowdKernels;
    case InstructionSet::kAvx512:
      return kAvx512CrowdKernels;
#else
    case InstructionSet::kAvx2:
    case InstructionSet::kAvx512:
#endif
    case InstructionSet::kBaseline:
      break;
  }
  return kBaselineCrowdKernels;
}

}  // namespace beespace::cpu
