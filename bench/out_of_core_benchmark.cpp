// How fast points beyond memory are searched, and with how much memory: beside a search in memory
// of so many of them as fit.
//
//   out_of_core_benchmark [POINTS [MEMORY_MB [FOLDER]]]     (3e8 points, 4000 MB, /var/tmp)
//
// Uniform points of which each has two neighbours on average, and clusters whose middle is a
// million times as dense as what is around them. The points lie in a mapped file; of the memory,
// what is not mapped from it counts.
#include <beespace/at_risk.hpp>
#include <beespace/out_of_core.hpp>

#include "bench/peak_memory.hpp"
#include "scenes/random_stream.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace {

using beespace::Point;
using beespace::bench::PeakMemory;
using Clock = std::chrono::steady_clock;

constexpr double kThreshold_m = 1.0;
constexpr double kNeighbours = 2.0;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A file of points without a name, mapped.
class MappedPoints {
 public:
  MappedPoints(std::size_t count, const std::string& folder) : count_(count) {
    const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR, 0600);
    const std::size_t bytes = count * sizeof(Point);
    if (file < 0 || ::posix_fallocate(file, 0, static_cast<off_t>(bytes)) != 0) {
      std::perror(folder.c_str());
      std::exit(1);
    }
    void* const data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    if (data == MAP_FAILED) {
      std::perror("mmap");
      std::exit(1);
    }
    data_ = static_cast<Point*>(data);
  }
  MappedPoints(const MappedPoints&) = delete;
  MappedPoints& operator=(const MappedPoints&) = delete;
  ~MappedPoints() { ::munmap(data_, count_ * sizeof(Point)); }

  [[nodiscard]] std::span<Point> points() { return {data_, count_}; }

 private:
  std::size_t count_;
  Point* data_ = nullptr;
};

enum class Scene { kUniform, kClustered };

// Nine of ten points are uniform; of the clustered ones the tenth lies in balls that are a million
// times as dense.
void fill(std::span<Point> points, Scene scene) {
  const double per_ball = kNeighbours / (4.0 / 3.0 * std::numbers::pi);
  const double side = std::cbrt(static_cast<double>(points.size()) / per_ball) * kThreshold_m;
  beespace::scenes::RandomStream random(1);
  constexpr std::size_t kInBall = 1'000'000;
  const double ball = std::cbrt(static_cast<double>(kInBall) / per_ball / 1e6) * kThreshold_m;
  Point corner;
  std::size_t left = 0;
  for (Point& point : points) {
    point = {random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(0.0, side)};
    if (scene == Scene::kUniform || random.index(10) != 0) continue;
    if (left == 0) {
      corner = point;
      left = kInBall;
    }
    --left;
    point = {corner.x + random.uniform(0.0, ball), corner.y + random.uniform(0.0, ball),
             corner.z + random.uniform(0.0, ball)};
  }
}

void measure(Scene scene, std::size_t count, std::uint64_t memory, const std::string& folder) {
  MappedPoints mapped(count, folder);
  const std::span<Point> points = mapped.points();
  fill(points, scene);

  beespace::OutOfCoreOptions options;
  options.memory_bytes = memory;
  options.folder = folder;
  options.threads = 0;
  double distributed_s = 0.0;
  const auto begin = Clock::now();
  options.progress = [&](const beespace::OutOfCoreProgress& progress) {
    if (progress.phase == beespace::OutOfCoreProgress::Phase::kDistributing) {
      distributed_s = seconds_since(begin);
    }
  };
  std::uint64_t found = 0;
  beespace::OutOfCore search(options);
  beespace::Status status = search.refer(std::span<const Point>(points));
  double total_s = 0.0;
  std::uint64_t peak = 0;
  if (status) {
    const PeakMemory watched;
    status =
        search.find_at_risk({.threshold_m = kThreshold_m},
                            [&](std::span<const beespace::LargeId> ids) { found += ids.size(); });
    total_s = seconds_since(begin);
    peak = watched.bytes();
  }
  if (!status) {
    std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
    std::exit(1);
  }
  const auto facts = search.facts();
  std::printf(
      "%-10s %11zu points: %7.1f s (distributing %.1f), %5.0f ns a point, %6.0f MB of %.0f; "
      "%llu cells, %llu crowded, %.1f %% copies; %llu at risk\n",
      scene == Scene::kUniform ? "uniform" : "clustered", count, total_s, distributed_s,
      total_s / static_cast<double>(count) * 1e9, static_cast<double>(peak) / 1e6,
      static_cast<double>(memory) / 1e6, static_cast<unsigned long long>(facts.cells),
      static_cast<unsigned long long>(facts.crowded_cells),
      100.0 * static_cast<double>(facts.copies) / static_cast<double>(count),
      static_cast<unsigned long long>(found));

  // As many in memory: the ratio is that of the time a point.
  const std::size_t some = std::min<std::size_t>(count, 100'000'000);
  std::vector<Point> in_memory(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(some));
  if (some < count) fill(in_memory, scene);
  const auto start = Clock::now();
  const auto expected =
      beespace::find_at_risk(in_memory, {.threshold_m = kThreshold_m, .threads = 0});
  const double in_memory_s = seconds_since(start);
  const bool same = some < count || (expected && expected->size() == found);
  std::printf("%-10s %11zu in memory: %6.1f s, %5.0f ns a point; ratio %.2f%s\n", "", some,
              in_memory_s, in_memory_s / static_cast<double>(some) * 1e9,
              total_s / static_cast<double>(count) / (in_memory_s / static_cast<double>(some)),
              some < count ? ""
              : same       ? "; the same answer"
                           : "; ANOTHER ANSWER");
  if (!same) std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 3e8);
  const auto memory = static_cast<std::uint64_t>((argc > 2 ? std::atof(argv[2]) : 4000.0) * 1e6);
  const std::string folder = argc > 3 ? argv[3] : "/var/tmp";
  measure(Scene::kUniform, count, memory, folder);
  measure(Scene::kClustered, count, memory, folder);
  return 0;
}
