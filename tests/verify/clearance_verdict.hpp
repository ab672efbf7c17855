// The Verifier's verdict on flights among obstacles.
#pragma once

#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::test {

using Fixes = std::vector<std::vector<Mover>>;

inline ObstacleMap map_of(std::vector<Obstacle> obstacles) {
  auto map = ObstacleMap::of(std::move(obstacles));
  EXPECT_TRUE(map) << map.error().message;
  return *map;
}

inline VerifyOptions options_of(const ObstacleMap& map, double clearance_m) {
  VerifyOptions options;
  options.threshold_m = 1e-3;
  options.obstacles = &map;
  options.clearance_m = clearance_m;
  return options;
}

inline Verdict verdict_of(const Fixes& fixes, double step_s, const VerifyOptions& options) {
  Verifier verifier(options);
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const Status added = verifier.add(static_cast<double>(i) * step_s, fixes[i]);
    EXPECT_TRUE(added) << added.error().message;
  }
  return verifier.verdict();
}

inline std::uint64_t losses_of(const Mover& from, const Mover& to, double step_s,
                               const VerifyOptions& options) {
  return verdict_of({{from}, {to}}, step_s, options).clearance_losses;
}

}  // namespace beespace::test
