#include "cli/bench/bench_scene.hpp"

#include "scenes/swarm_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace beespace::cli {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kMillion = 1e6;

// By how much a length grows when a space of `full` bees is to hold `count` at the same density.
double scale(std::size_t count, double full) {
  return std::cbrt(static_cast<double>(count) / full);
}

std::vector<Point> box(std::size_t count, double full, const Point& size) {
  const double by = scale(count, full);
  return scenes::uniform_box(count, {size.x * by, size.y * by, size.z * by}, kSeed);
}

std::vector<Point> cube(std::size_t count) {
  return box(count, kMillion, {12'800.0, 12'800.0, 12'800.0});
}

std::vector<Point> valley(std::size_t count) {
  return box(count, kMillion, {3'300.0, 2'300.0, 480.0});
}

std::vector<Point> wide(std::size_t count) {
  return box(count, 150'000.0, {66'000.0, 46'000.0, 9'600.0});
}

std::vector<Point> clusters(std::size_t count) {
  constexpr std::size_t kBeesPerCluster = 1'000;
  constexpr double kSigma_m = 200.0;
  constexpr double kSide_m = 100'000.0;
  const auto many = static_cast<std::uint32_t>(std::max<std::size_t>(count / kBeesPerCluster, 1));
  return scenes::gaussian_clusters(count, many, kSigma_m, kSide_m * scale(count, kMillion), kSeed);
}

}  // namespace

std::span<const BenchScene> bench_scenes() {
  static constexpr std::array kScenes = {
      BenchScene{"2 neighbours", 100.0, true, cube},
      BenchScene{"1,150 neighbours", 100.0, false, valley},
      BenchScene{"1 neighbour", 10.0, true, valley},
      BenchScene{"0.02 neighbours", 100.0, true, wide},
      BenchScene{"clusters", 20.0, true, clusters},
  };
  return kScenes;
}

}  // namespace beespace::cli
