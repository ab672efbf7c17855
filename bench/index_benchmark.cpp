// How fast an Index is built and asked, and how many times as fast as nanoflann (float64, the best
// of three leaf sizes), where its header was there to build with.
//
// `times_nanoflann` is nanoflann's time divided by ours, for the same places in the same run.
// Places asked one by one come in random order. Places asked all at once are random for Index,
// which sorts them, and sorted along a Morton curve beforehand for nanoflann, at no charge. Answers
// are checked by brute force before anything is timed.
#include <beespace/index.hpp>

#include "scenes/random_stream.hpp"
#include "scenes/swarm_scenes.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <vector>

#if defined(BEESPACE_HAS_NANOFLANN)
#include <nanoflann.hpp>
#endif

namespace {

using beespace::Index;
using beespace::Nearest;
using beespace::Point;
using beespace::PointId;

constexpr std::size_t kPlaces = 200'000;

struct Scene {
  std::string name;
  std::vector<Point> points;
  std::vector<Point> places;
  double radius_m;
};

std::vector<Point> shuffled(std::vector<Point> points) {
  beespace::scenes::RandomStream random(3);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.index(static_cast<std::uint32_t>(i))]);
  }
  return points;
}

Scene make_scene(const std::string& name) {
  constexpr std::size_t kPoints = 1'000'000;
  if (name == "uniform") {
    const Point size{12'800, 12'800, 12'800};
    return {name, beespace::scenes::uniform_box(kPoints, size, 1),
            beespace::scenes::uniform_box(kPlaces, size, 2), 100.0};
  }
  // Places among the bees of the same clusters.
  std::vector<Point> all =
      shuffled(beespace::scenes::gaussian_clusters(kPoints + kPlaces, 1'000, 200.0, 100'000.0, 1));
  std::vector<Point> places(all.begin() + kPoints, all.end());
  all.resize(kPoints);
  return {name, std::move(all), std::move(places), 20.0};
}

const Scene& scene_of(const std::string& name) {
  static std::vector<std::unique_ptr<Scene>> scenes;
  for (const auto& scene : scenes) {
    if (scene->name == name) return *scene;
  }
  scenes.push_back(std::make_unique<Scene>(make_scene(name)));
  return *scenes.back();
}

const Index& index_of(const Scene& scene) {
  static std::vector<std::pair<const Scene*, Index>> indexes;
  for (const auto& entry : indexes) {
    if (entry.first == &scene) return entry.second;
  }
  indexes.emplace_back(&scene, Index::build(scene.points).value());
  return indexes.back().second;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

[[noreturn]] void wrong(const Scene& scene, const char* what) {
  std::fprintf(stderr, "%s: wrong %s\n", scene.name.c_str(), what);
  std::exit(1);
}

void check_answers(const Scene& scene) {
  const Index& index = index_of(scene);
  for (std::size_t i = 0; i < scene.places.size(); i += 10'007) {
    const Point& place = scene.places[i];
    std::vector<PointId> around;
    std::vector<double> distances;
    for (PointId id = 0; id < scene.points.size(); ++id) {
      distances.push_back(beespace::distance(scene.points[id], place));
      if (distances.back() < scene.radius_m) around.push_back(id);
    }
    if (*index.find_around(place, scene.radius_m) != around) wrong(scene, "points around a place");
    std::nth_element(distances.begin(), distances.begin() + 31, distances.end());
    if (index.k_nearest(place, 32).value().back().distance_m != distances[31])
      wrong(scene, "distance");
  }
}

#if defined(BEESPACE_HAS_NANOFLANN)

struct Cloud {
  const std::vector<Point>& points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return (&points[i].x)[axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

class Peer {
 public:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                   Cloud, 3, std::uint32_t>;

  Peer(const std::vector<Point>& points, std::size_t leaf_size)
      : cloud_{points}, tree_(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {
    tree_.buildIndex();
  }

  std::size_t find_around(const Point& place, double radius_m) {
    found_.clear();
    nanoflann::RadiusResultSet<double, std::uint32_t> results(radius_m * radius_m, found_);
    tree_.radiusSearchCustomCallback(&place.x, results, nanoflann::SearchParams(32, 0, false));
    return found_.size();
  }

  double k_nearest(const Point& place, std::size_t k) {
    ids_.resize(k);
    squares_.resize(k);
    tree_.knnSearch(&place.x, k, ids_.data(), squares_.data());
    return squares_.back();
  }

 private:
  Cloud cloud_;
  Tree tree_;
  std::vector<std::pair<std::uint32_t, double>> found_;
  std::vector<std::uint32_t> ids_;
  std::vector<double> squares_;
};

std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16U) & 0x030000FF0000FFU;
  bits = (bits | bits << 8U) & 0x0300F00F00F00FU;
  bits = (bits | bits << 4U) & 0x030C30C30C30C3U;
  return (bits | bits << 2U) & 0x09249249249249U;
}

std::vector<Point> sorted(std::vector<Point> places) {
  double low = places[0].x;
  double high = places[0].x;
  for (const Point& p : places) {
    low = std::min({low, p.x, p.y, p.z});
    high = std::max({high, p.x, p.y, p.z});
  }
  const auto key = [&](const Point& p) {
    const auto cell = [&](double at) {
      return spread(static_cast<std::uint64_t>((at - low) / (high - low) * 65'535.0));
    };
    return cell(p.x) | cell(p.y) << 1U | cell(p.z) << 2U;
  };
  std::sort(places.begin(), places.end(),
            [&](const Point& a, const Point& b) { return key(a) < key(b); });
  return places;
}

// The seconds of the best leaf size. `ask` is called with a tree and a place.
template <class Ask>
double peer_seconds(const Scene& scene, bool in_order, const Ask& ask) {
  double best = 1e9;
  const std::vector<Point> places = in_order ? sorted(scene.places) : scene.places;
  for (const std::size_t leaf_size : {8U, 16U, 32U}) {
    Peer peer(scene.points, leaf_size);
    const double start = cpu_seconds();
    for (const Point& place : places) benchmark::DoNotOptimize(ask(peer, place));
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

double peer_build_seconds(const Scene& scene) {
  double best = 1e9;
  for (const std::size_t leaf_size : {8U, 16U, 32U}) {
    const double start = cpu_seconds();
    const Peer peer(scene.points, leaf_size);
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}
double peer_around_seconds(const Scene& scene, bool in_order) {
  return peer_seconds(scene, in_order, [&](Peer& peer, const Point& place) {
    return peer.find_around(place, scene.radius_m);
  });
}
double peer_nearest_seconds(const Scene& scene, bool in_order, std::size_t k) {
  return peer_seconds(scene, in_order,
                      [&](Peer& peer, const Point& place) { return peer.k_nearest(place, k); });
}

#else

double peer_build_seconds(const Scene& /*scene*/) {
  return 0.0;
}
double peer_around_seconds(const Scene& /*scene*/, bool /*in_order*/) {
  return 0.0;
}
double peer_nearest_seconds(const Scene& /*scene*/, bool /*in_order*/, std::size_t /*k*/) {
  return 0.0;
}

#endif

// Google Benchmark calls a function several times; the peer needs to be timed only once.
template <class Measure>
double once(const std::string& what, const Measure& measure) {
  static std::map<std::string, double> known;
  const auto entry = known.find(what);
  return entry != known.end() ? entry->second : known[what] = measure();
}

// `mine` and `peer` are seconds, of all iterations and of one.
void report(benchmark::State& state, std::size_t count, double mine, double peer) {
  const double seconds = mine / static_cast<double>(state.iterations());
  state.counters["each_ns"] = 1e9 * seconds / static_cast<double>(count);
  if (peer > 0.0) state.counters["times_nanoflann"] = peer / seconds;
}

void build(benchmark::State& state, const Scene& scene) {
  const double start = cpu_seconds();
  for (auto _ : state) benchmark::DoNotOptimize(Index::build(scene.points));
  const double mine = cpu_seconds() - start;
  report(state, scene.points.size(), mine,
         once("build " + scene.name, [&] { return peer_build_seconds(scene); }));
}

void find_around(benchmark::State& state, const Scene& scene) {
  const Index& index = index_of(scene);
  std::vector<PointId> found;
  const double start = cpu_seconds();
  for (auto _ : state) {
    for (const Point& place : scene.places) {
      (void)index.find_around(place, scene.radius_m, false, found);
      benchmark::DoNotOptimize(found.data());
    }
  }
  const double mine = cpu_seconds() - start;
  report(state, kPlaces, mine,
         once("around false " + scene.name, [&] { return peer_around_seconds(scene, false); }));
}

void k_nearest(benchmark::State& state, const Scene& scene) {
  const Index& index = index_of(scene);
  const auto k = static_cast<std::size_t>(state.range(0));
  std::vector<Nearest> nearest;
  const double start = cpu_seconds();
  for (auto _ : state) {
    for (const Point& place : scene.places) {
      (void)index.k_nearest(place, k, nearest);
      benchmark::DoNotOptimize(nearest.data());
    }
  }
  const double mine = cpu_seconds() - start;
  report(state, kPlaces, mine, once("nearest false " + std::to_string(k) + scene.name, [&] {
           return peer_nearest_seconds(scene, false, k);
         }));
}

void find_around_all(benchmark::State& state, const Scene& scene) {
  const Index& index = index_of(scene);
  const double start = cpu_seconds();
  for (auto _ : state) {
    benchmark::DoNotOptimize(index.find_around(scene.places, {scene.radius_m}));
  }
  const double mine = cpu_seconds() - start;
  report(state, kPlaces, mine,
         once("around true " + scene.name, [&] { return peer_around_seconds(scene, true); }));
}

void k_nearest_all(benchmark::State& state, const Scene& scene) {
  const Index& index = index_of(scene);
  const auto k = static_cast<std::size_t>(state.range(0));
  const double start = cpu_seconds();
  for (auto _ : state) benchmark::DoNotOptimize(index.k_nearest(scene.places, k));
  const double mine = cpu_seconds() - start;
  report(state, kPlaces, mine, once("nearest true " + std::to_string(k) + scene.name, [&] {
           return peer_nearest_seconds(scene, true, k);
         }));
}

void insert(benchmark::State& state, const Scene& scene) {
  double seconds = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    Index index = Index::build(scene.points).value();
    const double start = cpu_seconds();
    state.ResumeTiming();
    for (const Point& place : scene.places) benchmark::DoNotOptimize(index.insert(place));
    seconds += cpu_seconds() - start;
  }
  report(state, kPlaces, seconds, 0.0);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto add = [](const std::string& name, const auto& run, const Scene& scene) {
    return benchmark::RegisterBenchmark((name + "/" + scene.name).c_str(), run, scene)
        ->Unit(benchmark::kMillisecond);
  };
  for (const char* name : {"uniform", "clusters"}) {
    const Scene& scene = scene_of(name);
    check_answers(scene);
    add("build", build, scene);
    add("find_around", find_around, scene);
    add("k_nearest", k_nearest, scene)->Arg(1)->Arg(8)->Arg(32);
    add("find_around_all", find_around_all, scene);
    add("k_nearest_all", k_nearest_all, scene)->Arg(1)->Arg(8)->Arg(32);
    add("insert", insert, scene)->Iterations(1);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
