// Which aircraft are about to lose separation: 9,260 m (5 NM) horizontally and 300 m in height?
#include <beespace/beespace.hpp>

#include <cstdio>
#include <vector>

int main() {
  // Metres and metres per second, x east, y north, z up.
  const std::vector<beespace::Mover> aircraft{
      {{-40'000.0, 0.0, 10'000.0}, {230.0, 0.0, 0.0}},
      {{0.0, -42'000.0, 9'400.0}, {0.0, 225.0, 3.0}},    // climbs towards the level of the first
      {{0.0, -42'000.0, 12'000.0}, {0.0, 225.0, 0.0}}};  // the same way, two kilometres higher

  beespace::PredictOptions options;
  options.threshold_m = 9'260.0;
  options.vertical_m = 300.0;
  options.horizon_s = 300.0;
  const auto conflicts = beespace::predict_conflicts(aircraft, options);
  if (!conflicts) {
    std::fprintf(stderr, "%s\n", to_string(conflicts.error()).c_str());
    return 1;
  }
  for (const beespace::Conflict& conflict : *conflicts) {
    std::printf("%u and %u: from %.1f s to %.1f s, closest %.0f m at %.1f s\n", conflict.first,
                conflict.second, conflict.begins_s, conflict.ends_s, conflict.closest_m,
                conflict.closest_s);
  }
}
