#include "kernels/crowd_kernel.hpp"

namespace beespace::cpu {

constinit const CrowdKernels kAvx2CrowdKernels = kKernels;

}  // namespace beespace::cpu
