// How long the library takes for whole answers in the vectors of C++, and how much memory beyond
// them: what the packages above it are held against (make compare-python).
//
//   answer_benchmark QUESTION POINTS.f64 THRESHOLD RUNS
//
// Points are doubles x y z x y z ... Prints JSON: what was found, seconds of processor time of each
// run, and by how many bytes the first raised the peak memory beyond its answer. Each run has an
// Engine of its own, as a call of a function has.
#include <beespace/engine.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace beespace;

// One run's answer. It is given back after the run.
struct Answer {
  std::vector<PointId> ids;  // or counts
  std::vector<Pair> pairs;
  IdRows rows;
  std::vector<Nearest> nearest;
  NearestRows nearest_rows;
  std::vector<double> distances_m;

  [[nodiscard]] std::size_t entries() const {
    return ids.size() + pairs.size() + rows.ids.size() + nearest.size() +
           nearest_rows.entries.size();
  }
  [[nodiscard]] std::size_t bytes() const {
    return bytes_of(ids) + bytes_of(pairs) + bytes_of(rows.offsets) + bytes_of(rows.ids) +
           bytes_of(nearest) + bytes_of(nearest_rows.entries) + bytes_of(distances_m);
  }

 private:
  template <class T>
  static std::size_t bytes_of(const std::vector<T>& vector) {
    return vector.size() * sizeof(T);
  }
};

using Points = std::vector<Point>;

Status find_pairs_m(Engine& engine, const Points& points, const SearchOptions& within,
                    Answer& answer) {
  Status status = engine.find_pairs(points, within, answer.pairs);
  if (status) answer.distances_m = pair_distances(points, answer.pairs);
  return status;
}

Status find_rows_m(Engine& engine, const Points& points, const SearchOptions& within,
                   Answer& answer) {
  Status status = engine.find_neighbors(points, within, answer.rows);
  answer.distances_m.reserve(answer.rows.ids.size());
  for (std::size_t row = 0; row < answer.rows.size(); ++row) {
    for (const PointId id : answer.rows[row]) {
      answer.distances_m.push_back(distance(points[row], points[id]));
    }
  }
  return status;
}

using Ask = std::function<Status(Engine&, const Points&, const SearchOptions&, Answer&)>;

const std::map<std::string, Ask> kQuestions = {
    {"at_risk", [](auto& engine, const auto& points, const auto& within,
                   Answer& to) { return engine.find_at_risk(points, within, to.ids); }},
    {"pairs", [](auto& engine, const auto& points, const auto& within,
                 Answer& to) { return engine.find_pairs(points, within, to.pairs); }},
    {"pairs_m", find_pairs_m},
    {"counts", [](auto& engine, const auto& points, const auto& within,
                  Answer& to) { return engine.count_neighbors(points, within, to.ids); }},
    {"neighbors", [](auto& engine, const auto& points, const auto& within,
                     Answer& to) { return engine.find_neighbors(points, within, to.rows); }},
    {"neighbors_m", find_rows_m},
    {"nearest", [](auto& engine, const auto& points, const auto&,
                   Answer& to) { return engine.find_nearest(points, to.nearest); }},
    {"nearest_8", [](auto& engine, const auto& points, const auto&,
                     Answer& to) { return engine.find_k_nearest(points, 8, to.nearest_rows); }},
};

// Asks an Engine that lives for this call alone.
Status ask_once(const Ask& ask, const Points& points, const SearchOptions& within, Answer& answer) {
  Engine engine;
  return ask(engine, points, within, answer);
}

double processor_seconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Not of getrusage: there a child begins with the peak of its parent.
std::int64_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    std::int64_t kilobytes = 0;
    status >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

std::vector<Point> read_points(const char* path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return {};
  std::vector<Point> points(static_cast<std::size_t>(file.tellg()) / sizeof(Point));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(points.data()),
            static_cast<std::streamsize>(points.size() * sizeof(Point)));
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  const auto question = argc == 5 ? kQuestions.find(argv[1]) : kQuestions.end();
  const std::vector<Point> points = argc == 5 ? read_points(argv[2]) : std::vector<Point>();
  if (question == kQuestions.end() || points.empty()) {
    std::fprintf(stderr, "answer_benchmark QUESTION POINTS.f64 THRESHOLD RUNS\n");
    return 2;
  }
  const SearchOptions within = {.threshold_m = std::atof(argv[3])};
  const int runs = std::atoi(argv[4]);
  std::int64_t beyond = 0;
  std::size_t entries = 0;
  std::string seconds;
  for (int run = 0; run < runs; ++run) {
    Answer answer;
    const std::int64_t peak_before = peak_bytes();
    const double before = processor_seconds();
    const Status status = ask_once(question->second, points, within, answer);
    const double taken = processor_seconds() - before;
    if (!status) {
      std::fprintf(stderr, "%s\n", status.error().message.c_str());
      return 1;
    }
    if (run == 0) beyond = peak_bytes() - peak_before - static_cast<std::int64_t>(answer.bytes());
    entries = answer.entries();
    seconds += (run == 0 ? "" : ", ") + std::to_string(taken);
  }
  std::printf("{\"found\": %zu, \"seconds\": [%s], \"peak_bytes\": %lld}\n", entries,
              seconds.c_str(), static_cast<long long>(beyond));
  return 0;
}
