// Frame after frame: an Engine keeps its memory and threads, and fills the caller's own vector.
#include <beespace/beespace.hpp>

#include <cstddef>
#include <cstdio>
#include <vector>

int main() {
  constexpr std::size_t kDrones = 1000;
  std::vector<beespace::Point> drones(kDrones);
  std::vector<beespace::PointId> at_risk;
  beespace::Engine engine;
  const beespace::SearchOptions options{.threshold_m = 3.0, .threads = 2};

  for (int frame = 0; frame < 4; ++frame) {
    // A lattice 4 m wide that is pressed together, a little more in each frame.
    const double width_m = 4.0 - 0.4 * frame;
    for (std::size_t i = 0; i < kDrones; ++i) {
      const std::size_t column = i % 10;
      const std::size_t row = i / 10 % 10;
      const std::size_t layer = i / 100;
      drones[i] = {width_m * static_cast<double>(column), 4.0 * static_cast<double>(row),
                   4.0 * static_cast<double>(layer)};
    }
    const beespace::Status status = engine.find_at_risk(drones, options, at_risk);
    if (!status) {
      std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
      return 1;
    }
    std::printf("frame %d, %.1f m apart: %zu at risk\n", frame, width_m, at_risk.size());
  }
}
