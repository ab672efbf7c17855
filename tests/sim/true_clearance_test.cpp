// Obstacles that true flights come too close to, each agent alone, within instants too.
#include "sim/true_clearance.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::sim {
namespace {

constexpr double kInstant_s = 1.0;

ObstacleMap ball() {
  return ObstacleMap::of({Sphere{{0.0, 0.0, 0.0}, 1.0}}).value();
}

std::vector<std::size_t> lost_in(TrueClearance& check, std::int64_t instant,
                                 const std::vector<Stretch>& stretches, std::size_t each) {
  const auto lost = check.look(instant, stretches, each);
  EXPECT_TRUE(lost) << lost.error().message;
  return lost ? std::vector<std::size_t>(lost->begin(), lost->end()) : std::vector<std::size_t>();
}

TEST(TrueClearance, NoneIsLostWithoutObstacles) {
  TrueClearance check(nullptr, 1.0, kInstant_s);
  EXPECT_TRUE(lost_in(check, 0, {{}}, 1).empty());
}

// It is far at both ends of the instant, and near in between.
TEST(TrueClearance, LooksWithinInstants) {
  const ObstacleMap map = ball();
  TrueClearance check(&map, 1.0, kInstant_s);
  EXPECT_EQ(lost_in(check, 0, {{{-50.0, 1.9, 0.0}, {100.0, 0.0, 0.0}, {}}}, 1),
            std::vector<std::size_t>{0});
  TrueClearance other(&map, 1.0, kInstant_s);
  EXPECT_TRUE(lost_in(other, 0, {{{-50.0, 2.1, 0.0}, {100.0, 0.0, 0.0}, {}}}, 1).empty());
}

// From (-4, 0) it brakes until it stands at (-2 - `off`, 0), and flies back.
TEST(TrueClearance, LooksAtAccelerations) {
  const ObstacleMap map = ball();
  for (const double off_m : {-0.01, 0.01}) {
    const double way_m = 2.0 - off_m;
    const Stretch back{{-4.0, 0.0, 0.0}, {4.0 * way_m, 0.0, 0.0}, {-8.0 * way_m, 0.0, 0.0}};
    TrueClearance check(&map, 1.0, kInstant_s);
    EXPECT_EQ(lost_in(check, 0, {back}, 1).empty(), off_m > 0.0);
  }
}

// One that comes later is looked at from then on, and each is told of in its own ticks only.
TEST(TrueClearance, AgentsJoinLater) {
  const ObstacleMap map = ball();
  TrueClearance check(&map, 1.0, kInstant_s);
  const Stretch far{{9.0, 0.0, 0.0}, {}, {}};
  const Stretch near{{0.0, 1.5, 0.0}, {}, {}};
  EXPECT_TRUE(lost_in(check, 0, {far, far}, 2).empty());
  EXPECT_EQ(lost_in(check, 2, {far, far, near, near}, 2), std::vector<std::size_t>{1});
  EXPECT_EQ(lost_in(check, 4, {far, far, near, near}, 2), std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace beespace::sim
