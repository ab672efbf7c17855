#include "bench/compare/machine_floors.hpp"

#include "bench/compare/cost_meters.hpp"

#include <beespace/pairs.hpp>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace beespace::compare {
namespace {

// The compiler must believe that `value` is used.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

template <class Work>
double median_ms(int warm_ups, int runs, Work&& work) {
  std::vector<double> times;
  for (int run = -warm_ups; run < runs; ++run) {
    const Stopwatch watch;
    work();
    if (run >= 0) times.push_back(watch.cpu_ms());
  }
  return median(std::move(times));
}

// Short work is repeated oftener. 3 runs at least; some 100 million points a second.
int runs_for(std::size_t points) {
  return static_cast<int>(std::clamp<std::size_t>(30'000'000 / (points + 1), 3, 31));
}

void sum_in_order(std::span<const Point> points) {
  double sum = 0.0;
  for (const Point& point : points) {
    sum += point.x;
    sum += point.y;
    sum += point.z;
  }
  keep(sum);
}

}  // namespace

double read_pass_ms(std::span<const Point> points) {
  const Stopwatch watch;
  sum_in_order(points);
  return watch.cpu_ms();
}

double warm_read_floor_ms(std::span<const Point> points) {
  const int runs = runs_for(points.size());
  return median_ms(runs / 2, runs, [points] { sum_in_order(points); });
}

double copy_floor_ms(std::span<const Point> points) {
  std::vector<Point> copy(points.size());
  const auto copy_all = [&] {
    std::memcpy(copy.data(), points.data(), points.size_bytes());
    keep(copy);
  };
  return median_ms(2, runs_for(points.size()), copy_all);
}

double write_pairs_floor_ms(std::uint64_t pairs) {
  const auto fill = [pairs] {
    std::vector<Pair> written;
    written.reserve(pairs);
    for (std::uint64_t i = 0; i < pairs; ++i) {
      written.push_back({static_cast<PointId>(i), static_cast<PointId>(i + 1)});
    }
    keep(written);
  };
  return median_ms(1, pairs > 100'000'000 ? 3 : 9, fill);
}

}  // namespace beespace::compare
