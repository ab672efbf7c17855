// A bee that is at its goal makes way for the bees that want through. A bee that cannot get through
// waits.
#include "tests/avoidance/obstacle_course.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace {
namespace {

using test::Flock;

// 7 m apart, with a threshold of 5 m; the second bee prefers to stand, or almost.
Flock two_in_a_line() {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.options.step_s = 1.0;
  flock.limits.assign(2, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {}}, {{7, 0, 0}, {}}};
  return flock;
}

TEST(MakingWay, AnIdleBeeLeavesMostOfTheFreeSpace) {
  const Flock flock = two_in_a_line();
  const std::vector<Velocity> wishes = {{3.1, 0, 0}, {}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  // All but a twentieth of the 2 m that are free.
  EXPECT_EQ(advised->advice[0].kind, AdviceKind::kDeflected);
  EXPECT_NEAR(advised->advice[0].velocity.x, 1.9, 1e-5);
  EXPECT_NEAR(advised->advice[0].velocity.y, 0.0, 1e-9);
  // The other way round too.
  const std::vector<Velocity> turned = {{}, {-3.1, 0, 0}};
  const auto other = advise(flock.movers, turned, flock.limits, flock.options);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->advice[1].velocity.x, -1.9, 1e-5);
}

TEST(MakingWay, AnIdleBeeStepsAsideForOneThatWantsThrough) {
  const Flock flock = two_in_a_line();
  const std::vector<Velocity> wishes = {{3.1, 0, 0}, {}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  // A third of the 3 m within which it is pressed, at half of its speed.
  EXPECT_EQ(advised->advice[1].kind, AdviceKind::kDeflected);
  EXPECT_NEAR(advised->advice[1].velocity.x, 10.0 * 0.5 / 3.0, 1e-5);
  EXPECT_TRUE(test::all_certified(*advised));
  // A bee does not press others if it wants something else, wants nothing, or is far away.
  for (const Velocity& wish : {Velocity{-3, 0, 0}, Velocity{0, 0, 0}, Velocity{2, 0, 0}}) {
    const auto left =
        advise(flock.movers, std::vector<Velocity>{wish, {}}, flock.limits, flock.options);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->advice[1], test::certified({}));
  }
  Flock far = flock;
  far.movers[1].position.x = 8.1;
  const auto left = advise(far.movers, wishes, far.limits, far.options);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->advice[1], test::certified({}));
}

// Walled in on all sides, with hardly more room than the clearance.
TEST(MakingWay, ABeeThatCannotGetOutWaits) {
  test::Course course;
  const double far_m = 1.0 + 1e-6;
  course.map = test::map_of({Box{{far_m, -9, -9}, {9, 9, 9}}, Box{{-9, -9, -9}, {-far_m, 9, 9}},
                             Box{{-9, far_m, -9}, {9, 9, 9}}, Box{{-9, -9, -9}, {9, -far_m, 9}},
                             Box{{-9, -9, far_m}, {9, 9, 9}}, Ground{-far_m}});
  course.flock.options.clearance_m = 1.0;
  course.flock.movers = {{{0, 0, 0}, {}}};
  for (const double acceleration : {test::kNoLimit, 5.0}) {
    course.flock.limits = {{10.0, acceleration}};
    const auto kind_of = [&](const Velocity& wish) {
      const auto advised = advise(course.flock.movers, std::vector<Velocity>{wish},
                                  course.flock.limits, course.flock.options);
      EXPECT_TRUE(advised);
      EXPECT_TRUE(test::all_certified(*advised));
      EXPECT_LT(test::length_of(advised->advice[0].velocity), 1e-4);
      return advised->advice[0].kind;
    };
    EXPECT_EQ(kind_of({8, 0, 0}), AdviceKind::kWaiting);
    EXPECT_EQ(kind_of({2, -3, 4}), AdviceKind::kWaiting);
    EXPECT_EQ(kind_of({0, 0, 0}), AdviceKind::kAsPreferred);
    // A bee that would hardly move anyway does not wait.
    EXPECT_NE(kind_of({0, 1, 0}), AdviceKind::kWaiting);
  }
}

}  // namespace
}  // namespace beespace
