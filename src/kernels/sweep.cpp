#include "kernels/sweep.hpp"

#include "kernels/sweep_variants.hpp"

namespace beespace::cpu {

const char* name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::kBaseline:
      return "baseline";
    case InstructionSet::kAvx2:
      return "avx2";
    case InstructionSet::kAvx512:
      return "avx512";
  }
  return "unknown";
}

bool is_available(InstructionSet set) {
  switch (set) {
    case InstructionSet::kBaseline:
      return true;
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt");
    case InstructionSet::kAvx512:
      return is_available(InstructionSet::kAvx2) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("bmi2");
#else
    case InstructionSet::kAvx2:
    case InstructionSet::kAvx512:
      return false;
#endif
  }
  return false;
}

InstructionSet best_instruction_set() {
  auto best = InstructionSet::kBaseline;
  for (const InstructionSet set : kInstructionSets) {
    if (is_available(set)) best = set;
  }
  return best;
}

const Kernels& kernels(InstructionSet set) {
  switch (set) {
#if defined(BEESPACE_X86_KERNELS)
    case InstructionSet::kAvx2:
      return kAvx2Kernels;
    case InstructionSet::kAvx512:
      return kAvx512Kernels;
#else
    case InstructionSet::kAvx2:
    case InstructionSet::kAvx512:
#endif
    case InstructionSet::kBaseline:
      break;
  }
  return kBaselineKernels;
}

}  // namespace beespace::cpu
