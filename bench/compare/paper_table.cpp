// One method on one text file, as the paper measures: the time to parse it and the time to find
// which bees are at risk, over many repetitions, and the memory of the process.
//
//   compare_paper_table hash|kdtree|octree|beespace FILE SECONDS
//
// The file has a header and lines of longitude, latitude (degrees) and height (metres). The paper's
// methods read it line by line and take 111,111 m for a degree of either; beespace takes WGS84.
// Every repetition starts from nothing. Prints a line of JSON, with what the answer has too much
// and too little: of those at risk on the method's own metres, and of those at risk on the Earth.
#include "bench/compare/answer.hpp"
#include "bench/compare/cost_meters.hpp"
#include "bench/compare/fail.hpp"
#include "bench/compare/text_key_hash.hpp"
#include "bench/compare/textbook_kdtree.hpp"
#include "bench/compare/textbook_octree.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/load_points.hpp"

#include <beespace/at_risk.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>

namespace beespace::compare {
namespace {

constexpr double kThreshold_m = 100.0;
constexpr double kMetresPerDegree = 111'111.0;
constexpr int kMostRepetitions = 100;

struct Answered {
  std::vector<PointId> at_risk;
  std::vector<double> parse_ms;
  std::vector<double> find_ms;
  double parse_mb = 0.0;  // of the first repetition, the whole process
  double find_mb = 0.0;
};

// Parses and finds once more, and records the cost. `ids` names the found ones, which is not timed:
// the paper's program does not do it.
template <class Parse, class Find, class Ids>
void repeat(Answered& result, Parse&& parse, Find&& find, Ids&& ids) {
  const bool first = result.parse_ms.empty();
  const Stopwatch parse_watch;
  auto parsed = parse();
  result.parse_ms.push_back(parse_watch.cpu_ms());
  if (first) result.parse_mb = peak_of_process_mb();
  const Stopwatch find_watch;
  const auto found = find(parsed);
  result.find_ms.push_back(find_watch.cpu_ms());
  if (first) result.find_mb = peak_of_process_mb();
  result.at_risk = ids(found);
}

template <class Parse, class Find, class Ids>
Answered repeat_for(double seconds, Parse&& parse, Find&& find, Ids&& ids) {
  Answered result;
  const Stopwatch all;
  for (int i = 0; i < kMostRepetitions && all.wall_ms() < 1e3 * seconds; ++i) {
    repeat(result, parse, find, ids);
  }
  std::sort(result.at_risk.begin(), result.at_risk.end());
  return result;
}

// Calls take(point) for each line, on the paper's own metres.
template <class Take>
void read_lines(const std::string& path, Take&& take) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::size_t used = 0;
    const double longitude = std::stod(line, &used);
    std::size_t from = used + 1;
    const double latitude = std::stod(line.substr(from), &used);
    from += used + 1;
    take(Point{longitude * kMetresPerDegree, latitude * kMetresPerDegree,
               std::stod(line.substr(from))});
  }
}

template <class Method>
Answered measure(const std::string& path, double seconds) {
  const auto parse = [&] {
    Method method(kThreshold_m);
    PointId id = 0;
    read_lines(path, [&](const Point& point) { method.insert(point, id++); });
    if constexpr (requires { method.finish(); }) method.finish();
    return method;
  };
  return repeat_for(
      seconds, parse, [](const Method& method) { return method.find(); },
      [](const auto& found) { return Method::ids(found); });
}

io::LoadedPoints load(const std::string& path) {
  auto loaded = io::load_points(path, {.frame = io::Frame::kWgs84});
  if (!loaded) fail(to_string(loaded.error()));
  return std::move(loaded).value();
}

std::vector<PointId> exact(const std::vector<Point>& points) {
  auto found = find_at_risk(points, {.threshold_m = kThreshold_m});
  if (!found) fail(to_string(found.error()));
  return std::move(found).value();
}

Answered measure_beespace(const std::string& path, double seconds) {
  return repeat_for(
      seconds, [&] { return load(path); },
      [](const io::LoadedPoints& loaded) { return exact(loaded.points); },
      [](const std::vector<PointId>& found) { return found; });
}

std::string json_times(const std::vector<double>& times) {
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  char text[128];
  std::snprintf(text, sizeof text, "{\"mean\": %.4f, \"max\": %.4f, \"min\": %.4f}",
                sum / static_cast<double>(times.size()),
                *std::max_element(times.begin(), times.end()),
                *std::min_element(times.begin(), times.end()));
  return text;
}

std::string json_difference(const std::vector<PointId>& found, const std::vector<PointId>& right) {
  const Difference wrong = difference(found, right);
  return "{\"right\": " + std::to_string(right.size()) +
         ", \"spurious\": " + std::to_string(wrong.spurious) +
         ", \"missed\": " + std::to_string(wrong.missed) + "}";
}

void print(const Answered& result, const std::string& path, bool own_metres) {
  const std::vector<Point> earth = load(path).points;
  std::vector<Point> points;
  if (own_metres) {
    read_lines(path, [&](const Point& point) { points.push_back(point); });
  }
  std::printf(
      "{\"points\": %zu, \"repetitions\": %zu, \"parse_ms\": %s, \"find_ms\": %s, "
      "\"parse_mb\": %.1f, \"find_mb\": %.1f, \"found\": %zu, \"own_metres\": %s, \"earth\": %s}\n",
      earth.size(), result.parse_ms.size(), json_times(result.parse_ms).c_str(),
      json_times(result.find_ms).c_str(), result.parse_mb, result.find_mb, result.at_risk.size(),
      json_difference(result.at_risk, exact(own_metres ? points : earth)).c_str(),
      json_difference(result.at_risk, exact(earth)).c_str());
}

}  // namespace
}  // namespace beespace::compare

int main(int argc, char** argv) {
  using namespace beespace::compare;
  if (argc != 4) fail("usage: compare_paper_table hash|kdtree|octree|beespace FILE SECONDS");
  const std::string method = argv[1];
  const std::string path = argv[2];
  const double seconds = std::atof(argv[3]);
  if (method == "beespace") {
    print(measure_beespace(path, seconds), path, false);
  } else if (method == "hash") {
    print(measure<TextKeyHash>(path, seconds), path, true);
  } else if (method == "kdtree") {
    print(measure<TextbookKdTree>(path, seconds), path, true);
  } else if (method == "octree") {
    print(measure<TextbookOctree>(path, seconds), path, true);
  } else {
    fail("no method '" + method + "'");
  }
  return 0;
}
