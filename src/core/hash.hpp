// A fast mixing of integers, for tables that live during one search. Not for hostile keys: a bad
// distribution costs time, never correctness.
#pragma once

#include <cstdint>

namespace beespace::core {

// The finaliser of SplitMix64 (Steele, Lea, Flood, 2014): every input bit moves every output bit.
inline std::uint64_t mix(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
  return value ^ (value >> 31);
}

inline std::uint64_t hash_cell(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  // Odd multipliers keep neighbouring cells apart before the high bits are folded down.
  const std::uint64_t sum =
      x * 0x9E3779B97F4A7C15U + y * 0xC2B2AE3D27D4EB4FU + z * 0x165667B19E3779F9U;
  return (sum ^ (sum >> 29)) * 0xBF58476D1CE4E5B9U;
}

}  // namespace beespace::core
