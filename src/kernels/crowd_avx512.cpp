#include "kernels/crowd_kernel.hpp"

namespace beespace::cpu {

constinit const CrowdKernels kAvx512CrowdKernels = kKernels;

}  // namespace beespace::cpu
