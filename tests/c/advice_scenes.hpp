// Advice of C as that of C++.
#pragma once

#include "tests/c/c_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace beespace::test {

struct FreeAdvice {
  void operator()(beespace_adviser* adviser) const { beespace_adviser_free(adviser); }
  void operator()(beespace_advice* advice) const { beespace_advice_free(advice); }
};
template <class Handle>
using OwnedAdvice = std::unique_ptr<Handle, FreeAdvice>;

// Vectors of C++ as points of C: three doubles each.
template <class Three>
beespace_points c_vectors(const std::vector<Three>& all) {
  static_assert(sizeof(Three) == 3 * sizeof(double));
  return beespace_points_interleaved(all.empty() ? nullptr : &all.front().x,
                                     static_cast<std::int64_t>(all.size()));
}

inline beespace_findings c_findings(const beespace_advice* advice, std::int32_t what) {
  beespace_findings findings{};
  findings.struct_size = sizeof findings;
  EXPECT_EQ(beespace_advice_findings(advice, what, &findings, nullptr), BEESPACE_OK);
  return findings;
}

// Bees in a box, which fly and want to fly anywhere.
struct Flock {
  explicit Flock(unsigned seed, std::size_t size, double edge_m) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.0, edge_m);
    std::uniform_real_distribution<double> speed(-3.0, 3.0);
    for (std::size_t i = 0; i < size; ++i) {
      positions.push_back({place(random), place(random), place(random)});
      velocities.push_back({speed(random), speed(random), speed(random)});
      preferred.push_back({speed(random), speed(random), speed(random)});
      limits.push_back({6.0 + speed(random), 5.0 + speed(random)});
    }
  }
  [[nodiscard]] MoversView movers() const {
    return {PointsView(positions),
            PointsView::strided(&velocities.front().x, &velocities.front().y, &velocities.front().z,
                                velocities.size(), sizeof(Velocity))};
  }
  std::vector<Point> positions;
  std::vector<Velocity> velocities;
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits;
};

inline beespace_limits c_limits(const std::vector<FlightLimits>& limits) {
  constexpr auto kStride = static_cast<std::ptrdiff_t>(sizeof(FlightLimits));
  const std::ptrdiff_t stride = limits.size() == 1 ? 0 : kStride;
  return {sizeof(beespace_limits),
          0,
          &limits.front().max_speed_mps,
          &limits.front().max_acceleration_mps2,
          stride,
          stride};
}

inline beespace_advise_options c_advise_options(double threshold_m) {
  beespace_advise_options options{};
  options.struct_size = sizeof options;
  options.threshold_m = threshold_m;
  return options;
}

}  // namespace beespace::test
