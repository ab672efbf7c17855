#include "kernels/box_kernel.hpp"

namespace beespace::cpu {

constinit const BoxKernels kBaselineBoxKernels = kKernels;

}  // namespace beespace::cpu
