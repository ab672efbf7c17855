// Where a few objects are much larger than all others, a grid that suits them would suit no others,
// so they are better compared with all others one by one. Which sizes could be the limit?
#pragma once

#include "base/resources.hpp"
#include "grid/density.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::motion {

struct SizeLevel {
  double size;
  std::size_t beyond;  // how many are larger
};

// The cost of one ball, in nanoseconds, from the balls within the reach in a grid, and those beyond
// it. Measured, with the closer look at those that meet, with AVX2; with AVX-512 the best step is
// the same within what can be told apart.
inline double comparing_cost(const core::DensitySample& sample, double reach_m,
                             std::size_t beyond) {
  constexpr double kComparing = 1.6;
  constexpr double kComparingBeyond = 3.0;
  // Rows around, as far as the reach: as large as a cube of 2.6 times that. Each pair once.
  return 0.5 * kComparing * sample.expected_neighbors(2.6 * reach_m) +
         kComparingBeyond * static_cast<double>(beyond);
}

// The greatest size first, beyond which there is none; where it is much greater than nearly all,
// some smaller ones. `size_of` gives the size of each of `count` objects. Cost: a look at a
// thousand, and a few looks at all where there are such sizes.
template <class SizeOf>
core::Vector<SizeLevel> size_levels(std::size_t count, double largest, core::Memory& memory,
                                    const SizeOf& size_of) {
  core::Vector<SizeLevel> levels({{largest, 0}}, &memory);
  constexpr std::size_t kSome = 1024;
  core::Vector<double> sample(&memory);
  for (std::size_t i = 0; i < count; i += count / kSome + 1) sample.push_back(size_of(i));
  if (sample.empty()) return levels;
  const auto nearly_all = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() * 97 / 100);
  std::nth_element(sample.begin(), nearly_all, sample.end());
  constexpr double kSmallest = 0x1p-16;  // of the largest
  double size = std::max(1.25 * *nearly_all, kSmallest * largest);
  while (size < 0.5 * largest) {
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < count; ++i) beyond += size_of(i) > size ? 1U : 0U;
    levels.push_back({size, beyond});
    size *= 2.0;
  }
  return levels;
}

}  // namespace beespace::motion
