// One snapshot: which drones are too close, to which others, and which is the nearest of each.
#include <beespace/beespace.hpp>

#include <cstdio>
#include <vector>

namespace {

// Positions stay where they are: a view reads them inside the caller's own structs.
struct Drone {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  int battery_percent = 100;
};

}  // namespace

int main() {
  const std::vector<Drone> drones{
      {0.0, 0.0, 50.0, 81}, {3.0, 4.0, 50.0, 76}, {3.0, 4.0, 54.0, 92}, {40.0, 0.0, 50.0, 60}};
  const auto view = beespace::PointsView::strided(&drones[0].x, &drones[0].y, &drones[0].z,
                                                  drones.size(), sizeof(Drone));

  const beespace::SearchOptions options{.threshold_m = 5.0};
  const auto pairs = beespace::find_pairs(view, options);
  const auto nearest = beespace::find_nearest(view);
  if (!pairs || !nearest) {
    std::fprintf(stderr, "%s\n", to_string(pairs ? nearest.error() : pairs.error()).c_str());
    return 1;
  }

  // Drones 0 and 1 are exactly 5 m apart: not closer than 5 m.
  for (const beespace::Pair& pair : *pairs) {
    std::printf("%u and %u are closer than 5 m\n", pair.first, pair.second);
  }
  for (std::size_t i = 0; i < nearest->size(); ++i) {
    std::printf("nearest to %zu: %u, %.2f m\n", i, (*nearest)[i].id, (*nearest)[i].distance_m);
  }
}
