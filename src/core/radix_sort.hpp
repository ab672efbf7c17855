// Stable least-significant-digit radix sort of records by an unsigned key, shared by a crew.
//
// `digit(record, shift)` gives the bits of the record's key from `shift` upward; bits above the
// digit are masked away here. Cost: two reads and one write of all records a pass, at most 11 bits
// a pass.
#pragma once

#include "core/buffer.hpp"
#include "core/crew.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::core {

inline constexpr unsigned kMostDigitBits = 11;  // 2048 open write streams stay in L1 and the TLB

// Sorts the first `size` records of `records` by the low `key_bits` of their keys. `spare` is as
// large; the two are swapped as needed, so the result is always in `records`.
template <class Record, class Digit>
void radix_sort(Buffer<Record>& records, Buffer<Record>& spare, std::size_t size, unsigned key_bits,
                Digit digit, Crew& crew) {
  if (key_bits == 0 || size < 2) return;
  const unsigned passes = (key_bits + kMostDigitBits - 1) / kMostDigitBits;
  const unsigned digit_bits = (key_bits + passes - 1) / passes;
  const std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<std::uint32_t> next(digits * crew.size());  // next[worker][digit]

  for (unsigned pass = 0; pass < passes; ++pass) {
    const unsigned shift = pass * digit_bits;
    const std::size_t mask = (std::size_t{1} << std::min(digit_bits, key_bits - shift)) - 1;
    std::fill(next.begin(), next.end(), 0U);
    crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      std::uint32_t* counts = next.data() + worker * digits;
      const Record* from = records.data();
      for (std::size_t i = begin; i < end; ++i) ++counts[digit(from[i], shift) & mask];
    });
    std::uint32_t sum = 0;
    for (std::size_t value = 0; value < digits; ++value) {
      for (std::size_t worker = 0; worker < crew.size(); ++worker) {
        sum += std::exchange(next[worker * digits + value], sum);
      }
    }
    crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      std::uint32_t* places = next.data() + worker * digits;
      const Record* from = records.data();
      Record* to = spare.data();
      for (std::size_t i = begin; i < end; ++i) {
        to[places[digit(from[i], shift) & mask]++] = from[i];
      }
    });
    std::swap(records, spare);
  }
}

}  // namespace beespace::core
