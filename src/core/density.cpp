#include "core/density.hpp"

#include "core/hash.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace beespace::core {

double mean_cell_mates(const PointsView& points, double cell_m) {
  constexpr std::size_t kSample = 4096;
  const std::size_t sample = std::min(points.size(), kSample);
  if (sample < 2) return 0.0;

  std::vector<std::uint64_t> cells(sample);
  for (std::size_t i = 0; i < sample; ++i) {
    // One point at a random place of every stretch of the input: no rhythm of the input's order
    // can hide a crowd.
    const std::size_t begin = points.size() * i / sample;
    const std::size_t end = points.size() * (i + 1) / sample;
    const Point p = points[begin + mix(i + 1) % (end - begin)];
    std::uint64_t hash = 0;
    for (const double coordinate : {p.x, p.y, p.z}) {
      // Any bit pattern that is the same for the same cell will do; + 0.0 makes -0 plain 0.
      hash = mix(hash + std::bit_cast<std::uint64_t>(std::floor(coordinate / cell_m) + 0.0));
    }
    cells[i] = hash;
  }
  std::sort(cells.begin(), cells.end());
  double pairs = 0.0;
  for (std::size_t begin = 0; begin < sample;) {
    std::size_t end = begin + 1;
    while (end < sample && cells[end] == cells[begin]) ++end;
    const auto mates = static_cast<double>(end - begin);
    pairs += mates * (mates - 1.0);
    begin = end;
  }
  const auto drawn = static_cast<double>(sample);
  return pairs / (drawn * (drawn - 1.0)) * static_cast<double>(points.size() - 1);
}

}  // namespace beespace::core
