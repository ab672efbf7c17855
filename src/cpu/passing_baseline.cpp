#include "cpu/passing_kernel.hpp"

namespace beespace::cpu {

constinit const CollectPassing kBaselinePassing = sweep_passing;

}  // namespace beespace::cpu
