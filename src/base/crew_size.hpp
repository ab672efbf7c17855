// The number of threads for a search.
#pragma once

#include <cstddef>

namespace beespace::cpu {

// The number of threads for `requested` ones (0: all processors) and `points` points: small
// searches end before a second thread has started.
unsigned crew_size(unsigned requested, std::size_t points);

}  // namespace beespace::cpu
