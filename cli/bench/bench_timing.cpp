#include "cli/bench/bench_timing.hpp"

#include "cli/console/stopwatch.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::cli {
namespace {

constexpr double kEnough_s = 0.15;
constexpr std::size_t kLeastRuns = 3;
constexpr std::size_t kMostRuns = 51;

double median(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace

void ReadFloor::pass() {
  Stopwatch watch;
  double sum = 0.0;
  for (const Point& point : points_) {
    sum += point.x;
    sum += point.y;
    sum += point.z;
  }
  // Volatile, so that the sum is needed.
  [[maybe_unused]] volatile double sum_of_all = sum;
  times_.push_back(watch.lap());
}

double ReadFloor::median_seconds() const {
  return median(times_);
}

double median_seconds(const std::function<void()>& run, ReadFloor& floor) {
  run();
  std::vector<double> times;
  double spent = 0.0;
  while (times.size() < kLeastRuns || (spent < kEnough_s && times.size() < kMostRuns)) {
    Stopwatch watch;
    run();
    times.push_back(watch.lap());
    spent += times.back();
    floor.pass();
  }
  return median(std::move(times));
}

}  // namespace beespace::cli
