#include "kernels/crowd_kernel.hpp"

namespace beespace::cpu {

constinit const CrowdKernels kBaselineCrowdKernels = kKernels;

}  // namespace beespace::cpu
