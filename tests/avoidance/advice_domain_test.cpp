// advise() answers at the limits of the motion domain too.
#include <beespace/advise.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ends {
  double size;
  double speed;
  double acceleration;
};

std::vector<Ends> all_ends() {
  std::vector<Ends> all;
  for (const double size : {kSmallestInMotion, 1.0, kLargestInMotion}) {
    for (const double speed : {kSmallestInMotion, 1.0, kLargestInMotion}) {
      for (const double acceleration : {kSmallestInMotion, 1.0, kLargestInMotion, kInfinity}) {
        all.push_back({size, speed, acceleration});
      }
    }
  }
  return all;
}

void expect_flyable(const Ends& ends, const AdviseOptions& options) {
  const auto& [size, speed, acceleration] = ends;
  SCOPED_TRACE(testing::Message() << size << ' ' << speed << ' ' << acceleration);
  const std::vector<Mover> movers = {
      {{size, 0, 0}, {speed, 0, 0}}, {{-size, 0, 0}, {0, -speed, 0}}, {{0, size, 0}, {0, 0, 0}}};
  const std::vector<Velocity> preferred = {{-speed, 0, 0}, {speed, speed, 0}, {0, 0, speed}};
  const FlightLimits limits{speed, acceleration};
  const auto advised = advise(movers, preferred, {&limits, 1}, options);
  ASSERT_TRUE(advised) << advised.error().message;
  for (const Advice& advice : advised->advice) {
    const auto& [x, y, z] = advice.velocity;
    ASSERT_LE(std::hypot(x, y, z), speed * (1.0 + 1e-12));
  }
}

// At the limits of the domain there is an answer, and a bee can fly it.
TEST(AdviceDomain, ItsLimitsAreInsideIt) {
  for (const Ends& ends : all_ends()) {
    AdviseOptions options;
    options.threshold_m = ends.size;
    for (const AdviseMethod method :
         {AdviseMethod::kCertified, AdviseMethod::kOrca, AdviseMethod::kMvp}) {
      options.method = method;
      ASSERT_NO_FATAL_FAILURE(expect_flyable(ends, options)) << static_cast<int>(method);
    }
  }
}

TEST(AdviceDomain, OfObstaclesAndIntrudersToo) {
  for (const Ends& ends : all_ends()) {
    const double size = ends.size;
    const auto map = ObstacleMap::of({Sphere{{size, size, size}, size}, Ground{-size},
                                      Box{{-size, -size, -size}, {-size, size, size}},
                                      UprightPrism{{{0, 0}, {size, 0}, {0, size}}, {}}});
    ASSERT_TRUE(map);
    const std::vector<Mover> intruders = {{{size, 0, 0}, {ends.speed, 0, 0}},
                                          {{0, -size, 0}, {0, ends.speed, -ends.speed}}};
    AdviseOptions options;
    options.threshold_m = size;
    options.obstacles = &*map;
    options.clearance_m = size;
    options.intruders = intruders;
    for (const double horizon_s : {kSmallestInMotion, 1.0, kLargestInMotion}) {
      options.intruder_horizon_s = horizon_s;
      ASSERT_NO_FATAL_FAILURE(expect_flyable(ends, options)) << horizon_s;
    }
  }
}

}  // namespace
}  // namespace beespace
