#include "kernels/box_kernels.hpp"

namespace beespace::cpu {

const BoxKernels& box_kernels(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return kAvx2BoxKernels;
    case InstructionSet::kAvx512:
      return kAvx512BoxKernels;
#else
    case InstructionSet::kAvx2:
    case InstructionSet::kAvx512:
#endif
    case InstructionSet::kBaseline:
      break;
  }
  return kBaselineBoxKernels;
}

}  // namespace beespace::cpu
