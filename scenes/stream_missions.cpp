// Missions of bees that fly the same way: streams that cross, and one through a forest.
#include "scenes/jittered_grid.hpp"
#include "scenes/missions.hpp"
#include "scenes/random_stream.hpp"

#include <algorithm>
#include <cstdint>

namespace beespace::scenes {

Mission crossing_streams(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed) {
  //                      goals
  //                        ^
  //   starts, east >   they cross    > goals     each a cube of `side` cells, with as many
  //                        ^                     cells between one and the next
  //                  starts, north
  RandomStream random(seed);
  const std::size_t east = count - count / 2;
  const GridShape cube = cube_for(east);
  const auto side = static_cast<std::int64_t>(cube.x);
  const double way_m = static_cast<double>(4 * side) * spacing_m;
  Mission mission;
  const auto add = [&](std::size_t bees, const GridCell& first, const Point& way) {
    for (const Point& p : jittered_grid(bees, cube, first, spacing_m, clear_m, random)) {
      mission.starts.push_back(p);
      mission.goals.push_back({p.x + way.x, p.y + way.y, p.z + way.z});
    }
  };
  add(east, {-2 * side, 0, 0}, {way_m, 0.0, 0.0});
  add(count - east, {0, -2 * side, 0}, {0.0, way_m, 0.0});
  return mission;
}

namespace {

// In cells. Pillars are moved by up to half a cell on each axis, so the middles of two neighbors
// are at least kPitch - 1 apart, and between them there are three cells or more.
constexpr std::int64_t kPitch = 6;
constexpr double kRadius = 1.0;
constexpr double kMoved = 0.5;
// The first row, and all others after it, begin so far behind the bees that those are two cells
// and more away from any pillar.
constexpr std::int64_t kFirstRow = 3;
constexpr std::int64_t kGround = -3;

// Rows along y, one behind the other along x, in quincunx: no straight way leads through.
std::vector<Obstacle> forest(std::int64_t rows, std::int64_t width, double spacing_m,
                             RandomStream& random) {
  std::vector<Obstacle> obstacles;
  for (std::int64_t row = 0; row < rows; ++row) {
    const std::int64_t shift = row % 2 == 0 ? 0 : kPitch / 2;
    // Beyond the bees on both sides.
    for (std::int64_t y = shift - kPitch; y <= width + kPitch; y += kPitch) {
      const auto moved = [&](std::int64_t cell) {
        return (static_cast<double>(cell) + random.uniform(-kMoved, kMoved)) * spacing_m;
      };
      UprightCylinder pillar;
      pillar.x = moved(kFirstRow + row * kPitch);
      pillar.y = moved(y);
      pillar.radius_m = kRadius * spacing_m;
      obstacles.emplace_back(pillar);
    }
  }
  obstacles.emplace_back(Ground{static_cast<double>(kGround) * spacing_m});
  return obstacles;
}

}  // namespace

Mission pillars(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed) {
  RandomStream random(seed);
  const GridShape cube = cube_for(count);
  const auto side = static_cast<std::int64_t>(cube.x);
  // As deep as the cube is wide, and not less than three rows.
  const std::int64_t rows = std::max<std::int64_t>(3, side / kPitch + 1);
  const double depth_m = static_cast<double>(rows * kPitch) * spacing_m;
  Mission mission;
  mission.starts = jittered_grid(count, cube, {-side, 0, 0}, spacing_m, clear_m, random);
  for (const std::size_t other : shuffled(count, random)) {
    const Point& p = mission.starts[other];
    mission.goals.push_back({depth_m - p.x, p.y, p.z});
  }
  mission.obstacles = forest(rows, side, spacing_m, random);
  return mission;
}

}  // namespace beespace::scenes
