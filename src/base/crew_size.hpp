// How many threads suit a search.
#pragma once

#include <cstddef>

namespace beespace::cpu {

// How many workers suit `requested` threads (0: all processors) and `points` points: small
// searches are over before a second thread has started.
unsigned crew_size(unsigned requested, std::size_t points);

}  // namespace beespace::cpu
