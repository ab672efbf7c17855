// In which order should cells stand in memory: in rows, along Morton's or Hilbert's curve, or in
// none at all?
//
// One plain at-risk search (cells as wide as the threshold, each pair of cells compared once, both
// points marked), in which nothing but the order of the cells differs. The occupied cells around a
// cell are found
//   lists    beforehand: what is left is comparing, so that only places in memory matter;
//   hash     in a hash table, the same for every order;
//   keys     among the sorted keys, by a directory of their high bits and a binary search;
//   windows  by windows that move along with the sweep, which only rows allow.
// `engine` is the library's own search on the same points.
//
// Every figure is processor time, in nanoseconds a point, per step; `floors` is the whole divided
// by a scalar sum of the input in the same run. `l1_lines` and `l2_lines` are the cache lines of
// points a point that the search brings into a simulated first and second cache. Answers are
// compared with the library's, and the number of comparisons among the orders, before anything is
// timed. For figures to be quoted:
//
//   cell_order_benchmark --benchmark_repetitions=11 --benchmark_enable_random_interleaving=true
#include "bench/cell_order_search.hpp"
#include "scenes/swarm_scenes.hpp"

#include <beespace/beespace.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace beespace::bench;
using beespace::Point;
using beespace::PointId;

struct Swarm {
  std::string name;
  double threshold_m;
  std::vector<Point> points;
  std::vector<PointId> at_risk;   // by the library
  std::uint64_t comparisons = 0;  // of the first one checked; the same for all
};

// The scenes of the other benchmarks, equally dense at every size.
Swarm make_swarm(const std::string& scene, std::size_t size) {
  const double scale = std::cbrt(static_cast<double>(size) / 1e6);
  Swarm swarm{scene + "/" + std::to_string(size), 100.0, {}, {}};
  if (scene == "uniform_2_neighbours") {
    const double side = 12'800 * scale;
    swarm.points = beespace::scenes::uniform_box(size, {side, side, side}, 1);
  } else if (scene == "sparse_0.02_neighbours") {
    const double wider = scale * std::cbrt(1e6 / 150'000);
    swarm.points =
        beespace::scenes::uniform_box(size, {66'000 * wider, 46'000 * wider, 9'600 * wider}, 1);
  } else {
    swarm.threshold_m = 20.0;
    swarm.points = beespace::scenes::gaussian_clusters(
        size, static_cast<std::uint32_t>(size / 1'000), 200.0, 100'000 * scale, 1);
  }
  swarm.at_risk = *beespace::find_at_risk(swarm.points, {swarm.threshold_m});
  return swarm;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Adds the time since the last call.
class Stopwatch {
 public:
  void lap(double& seconds) {
    const double now = cpu_seconds();
    seconds += now - last_;
    last_ = now;
  }

 private:
  double last_ = cpu_seconds();
};

struct Seconds {
  double key = 0.0;
  double sort = 0.0;
  double table = 0.0;
  double search = 0.0;
  double answer = 0.0;

  [[nodiscard]] double all() const { return key + sort + table + search + answer; }
};

Buffer<Record> key_records(const std::vector<Point>& points, const Cells& cells, const auto& order,
                           Memory& memory) {
  Buffer<Record> records(memory, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    records[i] = {order.key(cells.place(points[i])), static_cast<PointId>(i)};
  }
  return records;
}

// From points to ids; adds the time of each step.
template <class Order, template <class> class Locator>
void search(const Swarm& swarm, Memory& memory, Seconds& seconds, std::vector<PointId>& at_risk) {
  Stopwatch watch;
  const Cells cells(swarm.points, swarm.threshold_m);
  const Order order(cells.bits);
  Buffer<Record> records = key_records(swarm.points, cells, order, memory);
  watch.lap(seconds.key);
  radix_sort(records, swarm.points.size(), 3 * cells.bits, memory);
  const Grid grid = gather(swarm.points, records, cells, memory);
  watch.lap(seconds.sort);
  Locator<Order> locator(grid, cells, order, memory);
  watch.lap(seconds.table);
  Marks marks(grid, swarm.threshold_m, memory);
  sweep(grid, locator, marks);
  watch.lap(seconds.search);
  marks.ids(grid, memory, at_risk);
  watch.lap(seconds.answer);
}

// The memory that `search` accesses.
template <class Order, template <class> class Locator>
Looks look(const Swarm& swarm, Memory& memory) {
  const Cells cells(swarm.points, swarm.threshold_m);
  const Order order(cells.bits);
  Buffer<Record> records = key_records(swarm.points, cells, order, memory);
  radix_sort(records, swarm.points.size(), 3 * cells.bits, memory);
  const Grid grid = gather(swarm.points, records, cells, memory);
  Locator<Order> locator(grid, cells, order, memory);
  Looks looks;
  sweep(grid, locator, looks);
  return looks;
}

[[noreturn]] void fail(const Swarm& swarm, const char* order, const char* what) {
  std::fprintf(stderr, "%s, %s: %s\n", swarm.name.c_str(), order, what);
  std::exit(1);
}

template <class Order, template <class> class Locator>
Looks check(Swarm& swarm, Memory& memory) {
  Seconds seconds;
  std::vector<PointId> at_risk;
  search<Order, Locator>(swarm, memory, seconds, at_risk);
  if (at_risk != swarm.at_risk) fail(swarm, Order::kName, "the answer is not the library's");
  Looks looks = look<Order, Locator>(swarm, memory);
  if (swarm.comparisons == 0) swarm.comparisons = looks.comparisons;
  if (looks.comparisons != swarm.comparisons) fail(swarm, Order::kName, "not the same work");
  return looks;
}

// A curve must visit every cell of a cube, Hilbert's one going from neighbour to neighbour.
template <class Order>
void check_curve(bool steps_to_neighbours) {
  constexpr unsigned kBits = 4;
  const Order order(kBits);
  std::vector<Place> curve(std::size_t{1} << (3 * kBits), ~Place{0});
  for (Place place = 0; place < curve.size(); ++place) curve.at(order.key(place)) = place;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    bool right = curve[i] < curve.size();
    if (i > 0 && steps_to_neighbours) {
      const Place step = std::max(curve[i], curve[i - 1]) - std::min(curve[i], curve[i - 1]);
      right = right && (step == 1 || step == 1U << kBits || step == 1U << (2 * kBits));
    }
    if (right) continue;
    std::fprintf(stderr, "%s is not the curve it should be\n", Order::kName);
    std::exit(1);
  }
}

// Seconds to read the points; the middle one of a few.
double floor_seconds(const std::vector<Point>& points) {
  std::array<double, 5> times{};
  for (double& time : times) {
    Stopwatch watch;
    const double* values = &points.front().x;
    double sum = 0.0;
    for (std::size_t i = 0; i < 3 * points.size(); ++i) sum += values[i];
    benchmark::DoNotOptimize(sum);
    watch.lap(time);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void report(benchmark::State& state, const Swarm& swarm, const Seconds& seconds) {
  const double searches = static_cast<double>(state.iterations());
  const double ns_a_point = 1e9 / (searches * static_cast<double>(swarm.points.size()));
  state.counters["total"] = seconds.all() * ns_a_point;
  state.counters["floors"] = seconds.all() / searches / floor_seconds(swarm.points);
  if (seconds.key == 0.0) return;
  state.counters["key"] = seconds.key * ns_a_point;
  state.counters["sort"] = seconds.sort * ns_a_point;
  state.counters["table"] = seconds.table * ns_a_point;
  state.counters["search"] = seconds.search * ns_a_point;
  state.counters["answer"] = seconds.answer * ns_a_point;
}

// One swarm and memory that is kept, so that no run pays for new pages.
struct Bench {
  explicit Bench(Swarm&& made) : swarm(std::move(made)) {}

  Swarm swarm;
  Memory memory = {};
};

// About a million points a measurement, whatever the size.
benchmark::IterationCount repeats(const Swarm& swarm) {
  return static_cast<benchmark::IterationCount>(
      std::max<std::size_t>(1, 1'000'000 / swarm.points.size()));
}

template <class Order, template <class> class Locator>
void add(const std::shared_ptr<Bench>& bench) {
  const std::string name = bench->swarm.name + "/" + Order::kName + "/" + Locator<Order>::kName;
  const auto looks = std::make_shared<Looks>();
  const auto run = [bench, looks](benchmark::State& state) {
    Swarm& swarm = bench->swarm;
    if (looks->comparisons == 0) *looks = check<Order, Locator>(swarm, bench->memory);
    Seconds seconds;
    std::vector<PointId> at_risk;
    at_risk.reserve(swarm.points.size());
    for (auto _ : state) search<Order, Locator>(swarm, bench->memory, seconds, at_risk);
    report(state, swarm, seconds);
    const auto size = static_cast<double>(swarm.points.size());
    state.counters["l1_lines"] = static_cast<double>(looks->l1.misses()) / size;
    state.counters["l2_lines"] = static_cast<double>(looks->l2.misses()) / size;
  };
  benchmark::RegisterBenchmark(name.c_str(), run)->Iterations(repeats(bench->swarm));
}

void add_engine(const std::shared_ptr<Bench>& bench) {
  const auto engine = std::make_shared<beespace::Engine>();
  const auto run = [bench, engine](benchmark::State& state) {
    const Swarm& swarm = bench->swarm;
    Seconds seconds;
    std::vector<PointId> at_risk;
    const auto once = [&] {
      (void)engine->find_at_risk(swarm.points, {swarm.threshold_m}, at_risk);
    };
    once();
    for (auto _ : state) {
      Stopwatch watch;
      once();
      watch.lap(seconds.search);
    }
    report(state, swarm, seconds);
  };
  benchmark::RegisterBenchmark((bench->swarm.name + "/engine").c_str(), run)
      ->Iterations(repeats(bench->swarm));
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  check_curve<MortonOrder>(false);
  check_curve<RandomOrder>(false);
  check_curve<HilbertOrder>(true);
  for (const char* scene : {"uniform_2_neighbours", "sparse_0.02_neighbours", "clusters"}) {
    for (const std::size_t size : {100'000U, 1'000'000U, 4'000'000U}) {
      const auto bench = std::make_shared<Bench>(make_swarm(scene, size));
      add<RowOrder, ByWindows>(bench);
      add<RowOrder, ByList>(bench);
      add<MortonOrder, ByList>(bench);
      add<HilbertOrder, ByList>(bench);
      add<RandomOrder, ByList>(bench);
      add<RowOrder, ByHash>(bench);
      add<MortonOrder, ByHash>(bench);
      add<HilbertOrder, ByHash>(bench);
      add<RandomOrder, ByHash>(bench);
      add<RowOrder, ByKey>(bench);
      add<MortonOrder, ByKey>(bench);
      add<HilbertOrder, ByKey>(bench);
      add<RandomOrder, ByKey>(bench);
      add_engine(bench);
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
