// A fast mixing of integers, for tables that live during one search. Not for hostile keys: a bad
// distribution costs time, never correctness.
#pragma once

#include <beespace/point.hpp>

#include <bit>
#include <cstdint>

namespace beespace::core {

// The finaliser of SplitMix64 (Steele, Lea, Flood, 2014): every input bit moves every output bit.
inline std::uint64_t mix(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
  return value ^ (value >> 31);
}

// The same for the same place: -0 is 0.
inline std::uint64_t hash_place(const Point& p) {
  std::uint64_t hash = mix(std::bit_cast<std::uint64_t>(p.x + 0.0));
  hash = mix(hash + std::bit_cast<std::uint64_t>(p.y + 0.0));
  return mix(hash + std::bit_cast<std::uint64_t>(p.z + 0.0));
}

// Cells are hashed by a sum, so that the hash of a cell beside another one costs an addition.
inline constexpr std::uint64_t kCellStep[3] = {0x9E3779B97F4A7C15U, 0xC2B2AE3D27D4EB4FU,
                                               0x165667B19E3779F9U};

inline std::uint64_t cell_sum(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x * kCellStep[0] + y * kCellStep[1] + z * kCellStep[2];
}

inline std::uint64_t hash_cell_sum(std::uint64_t sum) {
  return (sum ^ (sum >> 29)) * 0xBF58476D1CE4E5B9U;
}

inline std::uint64_t hash_cell(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return hash_cell_sum(cell_sum(x, y, z));
}

}  // namespace beespace::core
