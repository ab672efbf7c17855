#include "cpu/passing_kernel.hpp"

namespace beespace::cpu {

constinit const CollectPassing kAvx2Passing = sweep_passing;

}  // namespace beespace::cpu
