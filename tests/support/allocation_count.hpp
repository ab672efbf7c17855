// Programs that link allocation_count.cpp replace operator new and delete, in all their forms, with
// ones that count the calls of all threads.
#pragma once

#include <cstdint>

namespace beespace::test {

// The number of allocations since the program began.
std::uint64_t allocations();

// How many of these have not been given back.
std::uint64_t blocks_held();

}  // namespace beespace::test
