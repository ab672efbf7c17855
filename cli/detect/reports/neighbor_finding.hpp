// What is worth knowing about how many neighbours bees have.
#pragma once

#include "io/bytes/number_text.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

inline std::string neighbor_finding(std::uint64_t neighbors, std::size_t bees, std::uint64_t most) {
  if (most == 0) return "none";
  const double mean = static_cast<double>(neighbors) / static_cast<double>(bees);
  return io::grouped(mean, 2) + " a bee on average, " + io::grouped(most) + " at most";
}

}  // namespace beespace::cli
