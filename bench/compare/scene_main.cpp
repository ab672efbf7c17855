// Writes a swarm to a file of doubles, or, for the paper's table, to a text file in degrees.
//
//   compare_scene OUTPUT COUNT SCENE [NUMBER...]
//
// The scenes and their numbers (metres) are in the table below.
#include "bench/compare/fail.hpp"
#include "bench/compare/point_file.hpp"

#include "scenes/random_stream.hpp"
#include "scenes/swarm_scenes.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace beespace::compare {
namespace {

using Numbers = std::vector<double>;

struct Scene {
  const char* name;
  std::size_t numbers;
  std::function<std::vector<Point>(std::size_t count, const Numbers& numbers)> make;
};

constexpr std::uint64_t kSeed = 1;

std::vector<Point> uniform(std::size_t count, const Numbers& sides) {
  return scenes::uniform_box(count, {sides[0], sides[1], sides[2]}, kSeed);
}

std::vector<Point> clusters(std::size_t count, const Numbers& numbers) {
  return scenes::gaussian_clusters(count, static_cast<std::uint32_t>(numbers[0]), numbers[1],
                                   numbers[2], kSeed);
}

// Along the diagonal of a cube, so that no axis alone separates them.
std::vector<Point> line(std::size_t count, const Numbers& length) {
  scenes::RandomStream random(kSeed);
  std::vector<Point> points(count);
  for (Point& point : points) {
    const double along = random.uniform(0.0, length[0]);
    point = {along, along, along};
  }
  return points;
}

// In a few places, many at each.
std::vector<Point> duplicates(std::size_t count, const Numbers& numbers) {
  const auto places = static_cast<std::uint32_t>(numbers[0]);
  const auto distinct = scenes::uniform_box(places, {numbers[1], numbers[1], numbers[1]}, kSeed);
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = distinct[i % places];
  return points;
}

std::vector<Point> clump_and_outlier(std::size_t count, const Numbers& numbers) {
  auto points = scenes::uniform_box(count, {numbers[0], numbers[0], numbers[0]}, kSeed);
  points.back() = {numbers[1], numbers[1], numbers[1]};
  return points;
}

const Scene kScenes[] = {
    {"uniform", 3, uniform},                      // the box's sides
    {"clusters", 3, clusters},                    // how many, their sigma, the cube's side
    {"line", 1, line},                            // its length along each axis
    {"duplicates", 2, duplicates},                // how many places, the cube's side
    {"clump_and_outlier", 2, clump_and_outlier},  // the clump's side, how far the outlier is
};

// The region of the course files, `widening` times as wide, deep and high, as a text table in
// their format: longitude, latitude (degrees), height (metres).
void write_degrees(const std::string& path, std::size_t count, double widening) {
  scenes::Area area = scenes::kMedellin;
  area.east_deg = area.west_deg + widening * (area.east_deg - area.west_deg);
  area.north_deg = area.south_deg + widening * (area.north_deg - area.south_deg);
  area.highest_m = area.lowest_m + widening * (area.highest_m - area.lowest_m);
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) fail("cannot write " + path);
  std::fputs("longitude,latitude,height\n", file);
  for (const Point& point : scenes::geographic_area(count, area, kSeed)) {
    std::fprintf(file, "%.11f,%.11f,%.2f\n", point.x, point.y, point.z);
  }
  if (std::fclose(file) != 0) fail("cannot write " + path);
}

void write_scene(const std::string& path, std::size_t count, const std::string& name,
                 const Numbers& numbers) {
  if (name == "degrees" && numbers.size() == 1) return write_degrees(path, count, numbers[0]);
  for (const Scene& scene : kScenes) {
    if (scene.name != name || scene.numbers != numbers.size()) continue;
    return write_points(path, scene.make(count, numbers));
  }
  fail("no scene '" + name + "' of " + std::to_string(numbers.size()) + " numbers");
}

}  // namespace
}  // namespace beespace::compare

int main(int argc, char** argv) {
  using namespace beespace::compare;
  if (argc < 4) fail("usage: compare_scene OUTPUT COUNT SCENE [NUMBER...]");
  std::vector<double> numbers;
  for (int i = 4; i < argc; ++i) numbers.push_back(std::atof(argv[i]));
  write_scene(argv[1], std::strtoull(argv[2], nullptr, 10), argv[3], numbers);
  return 0;
}
