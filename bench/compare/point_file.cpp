#include "bench/compare/point_file.hpp"

#include "bench/compare/fail.hpp"

#include <fstream>

namespace beespace::compare {

std::vector<Point> read_points(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) fail("cannot open " + path);
  std::vector<Point> points(static_cast<std::size_t>(file.tellg()) / sizeof(Point));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(points.data()),
            static_cast<std::streamsize>(points.size() * sizeof(Point)));
  if (!file) fail("cannot read " + path);
  return points;
}

void write_points(const std::string& path, const std::vector<Point>& points) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(points.data()),
             static_cast<std::streamsize>(points.size() * sizeof(Point)));
  if (!file.flush()) fail("cannot write " + path);
}

}  // namespace beespace::compare
