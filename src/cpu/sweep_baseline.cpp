#include "cpu/sweep_kernel.hpp"

namespace beespace::cpu {

void sweep_baseline(const Positions& positions, const Neighbourhood& neighbourhood,
                    const Limits& limits, std::uint8_t* near_marks, std::uint32_t first_mark,
                    const Unsure& unsure) {
  Sweep<4>(positions, limits, near_marks, first_mark, unsure).run(neighbourhood);
}

}  // namespace beespace::cpu
