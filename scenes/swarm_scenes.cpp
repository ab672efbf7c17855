#include "scenes/swarm_scenes.hpp"

#include "scenes/random_stream.hpp"

namespace beespace::scenes {

std::vector<Point> uniform_box(std::size_t count, const Point& size, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.x = size.x * random.uniform();
    point.y = size.y * random.uniform();
    point.z = size.z * random.uniform();
  }
  return points;
}

std::vector<Point> gaussian_clusters(std::size_t count, std::uint32_t clusters, double sigma,
                                     double side, std::uint64_t seed) {
  const std::vector<Point> centres = uniform_box(clusters, {side, side, side}, seed);
  // The bees' stream is not the centres' stream, nor that of the next seed.
  RandomStream random(RandomStream(~seed).bits());
  std::vector<Point> points(count);
  for (Point& point : points) {
    const Point& centre = centres[random.index(clusters)];
    const double x = sigma * random.nearly_normal();
    const double y = sigma * random.nearly_normal();
    const double z = sigma * random.nearly_normal();
    point = {centre.x + x, centre.y + y, centre.z + z};
  }
  return points;
}

std::optional<Area> find_area(std::string_view name) {
  if (name == kMedellin.name) return kMedellin;
  return std::nullopt;
}

std::vector<Point> geographic_area(std::size_t count, const Area& area, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.x = random.uniform(area.west_deg, area.east_deg);
    point.y = random.uniform(area.south_deg, area.north_deg);
    point.z = random.uniform(area.lowest_m, area.highest_m);
  }
  return points;
}

}  // namespace beespace::scenes
