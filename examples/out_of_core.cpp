// More points than fit into memory: they come in parts, and wait on the disk.
#include <beespace/beespace.hpp>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace {

// A sheet of positions, 10 m apart; every tenth of them has another one half a metre beside it.
std::vector<beespace::Point> part(int number) {
  std::vector<beespace::Point> points;
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 1000; ++column) {
      const beespace::Point at{10.0 * column, 10.0 * (100 * number + row), 0.0};
      points.push_back(at);
      if (column % 10 == 0) points.push_back({at.x + 0.5, at.y, at.z});
    }
  }
  return points;
}

}  // namespace

int main() {
  beespace::OutOfCoreOptions options;
  options.memory_bytes = std::uint64_t{20} << 20U;
  options.folder = std::filesystem::temp_directory_path().string();
  beespace::OutOfCore search(options);
  for (int number = 0; number < 10; ++number) {
    if (const auto added = search.add(part(number)); !added) {
      std::fprintf(stderr, "%s\n", to_string(added.error()).c_str());
      return 1;
    }
  }

  std::uint64_t count = 0;
  const auto searched = search.find_at_risk(
      {.threshold_m = 2.0}, [&](std::span<const beespace::LargeId> ids) { count += ids.size(); });
  const auto closest = search.find_closest_pair();
  if (!searched || !closest || !*closest) return 1;
  std::printf("%llu points, %llu of them at risk\n", static_cast<unsigned long long>(search.size()),
              static_cast<unsigned long long>(count));
  const auto& [pair, distance_m] = **closest;
  std::printf("closest: %llu and %llu, %.1f m apart\n", static_cast<unsigned long long>(pair.first),
              static_cast<unsigned long long>(pair.second), distance_m);
  return 0;
}
