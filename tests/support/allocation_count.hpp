// Programs that link allocation_count.cpp have operator new and delete of their own, in all their
// forms, which count: on all threads, whoever calls.
#pragma once

#include <cstdint>

namespace beespace::test {

// How often memory was asked for since the program began.
std::uint64_t allocations();

// How many of these have not been given back.
std::uint64_t blocks_held();

}  // namespace beespace::test
