// The kernels of each instruction set; those for others than the build's own run only where
// is_available says so.
#pragma once

#include "kernels/sweep.hpp"

namespace beespace::cpu {

extern const Kernels kBaselineKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;

}  // namespace beespace::cpu
