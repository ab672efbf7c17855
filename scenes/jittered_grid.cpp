#include "scenes/jittered_grid.hpp"

#include <numeric>
#include <utility>

namespace beespace::scenes {

GridShape cube_for(std::size_t count) {
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  return {side, side, side};
}

std::vector<Point> jittered_grid(std::size_t count, const GridShape& shape, const GridCell& first,
                                 double spacing_m, double clear_m, RandomStream& random) {
  // A little less than half, for rounding.
  const double stir_m = 0.5 * (spacing_m - clear_m) * (1.0 - 0x1p-20);
  const auto at = [&](std::int64_t begin, std::size_t cell) {
    const auto middle = static_cast<double>(begin + static_cast<std::int64_t>(cell));
    return middle * spacing_m + random.uniform(-stir_m, stir_m);
  };
  std::vector<Point> places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = at(first.x, i % shape.x);
    const double y = at(first.y, i / shape.x % shape.y);
    const double z = at(first.z, i / (shape.x * shape.y));
    places.push_back({x, y, z});
  }
  return places;
}

std::vector<std::size_t> shuffled(std::size_t count, RandomStream& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[random.index(static_cast<std::uint32_t>(i))]);
  }
  return order;
}

}  // namespace beespace::scenes
