#include "cli/bench/bench_timing.hpp"

#include "cli/stopwatch.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::cli {
namespace {

constexpr double kEnough_s = 0.15;
constexpr std::size_t kLeastRuns = 3;
constexpr std::size_t kMostRuns = 51;

}  // namespace

double median_seconds(const std::function<void()>& run) {
  run();
  std::vector<double> times;
  double spent = 0.0;
  while (times.size() < kLeastRuns || (spent < kEnough_s && times.size() < kMostRuns)) {
    Stopwatch watch;
    run();
    times.push_back(watch.lap());
    spent += times.back();
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

double read_floor_seconds(const std::vector<Point>& points) {
  // Volatile, so that the sum is needed.
  volatile double sum_of_all = 0.0;
  return median_seconds([&] {
    double sum = 0.0;
    for (const Point& point : points) {
      sum += point.x;
      sum += point.y;
      sum += point.z;
    }
    sum_of_all = sum;
  });
}

}  // namespace beespace::cli
