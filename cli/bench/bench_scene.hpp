// The swarms that `beespace bench` times: crowded, spread out, clustered.
#pragma once

#include <beespace/point.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace beespace::cli {

struct BenchScene {
  const char* name;
  double threshold_m;
  bool pairs_fit;  // in memory; in a crowd there are hundreds for every bee
  // As many bees as asked for, in a space that keeps the neighbours of each as many.
  std::vector<Point> (*make)(std::size_t count);
};

std::span<const BenchScene> bench_scenes();

}  // namespace beespace::cli
