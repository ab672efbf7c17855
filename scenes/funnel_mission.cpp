#include "scenes/jittered_grid.hpp"
#include "scenes/missions.hpp"
#include "scenes/random_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace beespace::scenes {

namespace {

constexpr std::size_t kLayers = 2;
constexpr double kNarrower = 5.0;
constexpr double kCrowd = 2.0;  // in the column, times the clear distance

// The column, from its end on; along x, around the axis at `middle_m`.
std::vector<Point> column_from_its_end(std::size_t count, std::size_t across, double mouth_m,
                                       double middle_m, double spacing_m) {
  const std::size_t slice = across * across;
  const std::size_t slices = (count + slice - 1) / slice;
  const double first_m = middle_m - 0.5 * static_cast<double>(across - 1) * spacing_m;
  std::vector<Point> places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from_mouth = slices - 1 - i / slice;
    const std::size_t up = i % slice / across;
    places.push_back({mouth_m + static_cast<double>(from_mouth) * spacing_m,
                      first_m + static_cast<double>(i % across) * spacing_m,
                      first_m + static_cast<double>(up) * spacing_m});
  }
  return places;
}

}  // namespace

Mission funnel(std::size_t count, double spacing_m, double clear_m, std::uint64_t seed) {
  RandomStream random(seed);
  GridShape field{kLayers, 1, 1};
  while (kLayers * field.y * field.z < count) field.y = ++field.z;
  const double width_m = static_cast<double>(field.y) * spacing_m;
  Mission mission;
  mission.starts = jittered_grid(count, field, {}, spacing_m, clear_m, random);

  const double crowd_m = std::min(spacing_m, kCrowd * clear_m);
  const auto across =
      std::max<std::size_t>(1, static_cast<std::size_t>(width_m / (kNarrower * crowd_m)));
  const double middle_m = 0.5 * (width_m - spacing_m);
  const double mouth_m = static_cast<double>(kLayers) * spacing_m + width_m;
  const auto places = column_from_its_end(count, across, mouth_m, middle_m, crowd_m);

  std::vector<double> to_mouth(count);  // squared
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = mission.starts[i];
    const double x = p.x - mouth_m;
    const double y = p.y - middle_m;
    const double z = p.z - middle_m;
    to_mouth[i] = x * x + y * y + z * z;
  }
  std::vector<std::size_t> nearest_first(count);
  std::iota(nearest_first.begin(), nearest_first.end(), std::size_t{0});
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [&](std::size_t a, std::size_t b) { return to_mouth[a] < to_mouth[b]; });
  mission.goals.resize(count);
  for (std::size_t i = 0; i < count; ++i) mission.goals[nearest_first[i]] = places[i];
  return mission;
}

}  // namespace beespace::scenes
