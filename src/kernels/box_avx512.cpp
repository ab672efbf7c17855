#include "kernels/box_kernel.hpp"

namespace beespace::cpu {

constinit const BoxKernels kAvx512BoxKernels = kKernels;

}  // namespace beespace::cpu
