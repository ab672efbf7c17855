#include "kernels/box_kernel.hpp"

namespace beespace::cpu {

constinit const BoxKernels kAvx2BoxKernels = kKernels;

}  // namespace beespace::cpu
