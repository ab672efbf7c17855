// The Verifier's findings about obstacles, for cases computed by hand.
#include "tests/verify/clearance_verdict.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace {
namespace {

// Past one obstacle after the other, in one step: the first is reported, whichever way the path
// bends.
TEST(Clearance, TheFirstOfSeveralIsReported) {
  const ObstacleMap map = test::map_of({Sphere{{300, 0, 0}, 5.0}, Sphere{{-300, 0, 0}, 5.0},
                                        Sphere{{0, 0, 0}, 5.0}, Sphere{{400, 400, 0}, 50.0}});
  VerifyOptions options = test::options_of(map, 1.0);
  const auto first = [&](const Mover& from, const Mover& to) {
    const Verdict verdict = test::verdict_of({{from}, {to}}, 1.0, options);
    EXPECT_EQ(verdict.clearance_losses, 1U);
    return verdict.first_clearance_losses.at(0).obstacle;
  };
  const Velocity right{2000, 0, 0};
  const Velocity left{-2000, 0, 0};
  EXPECT_EQ(first({{-1000, 0, 0}, right}, {{1000, 0, 0}, right}), 1U);
  EXPECT_EQ(first({{1000, 0, 0}, left}, {{-1000, 0, 0}, left}), 0U);
  // Bent a little, so that it is halved.
  EXPECT_EQ(first({{-1000, 0, 0}, {2000, 40, 0}}, {{1000, 0, 0}, {2000, 40, 0}}), 1U);
  EXPECT_EQ(first({{1000, 0, 0}, {-2000, 40, 0}}, {{-1000, 0, 0}, {-2000, 40, 0}}), 0U);
  EXPECT_EQ(first({{1000, 0, 0}, {-1000, 9, 9}}, {{-1000, 0, 0}, {-3000, 9, 9}}), 0U);
  // It ends within the third and bends around by the fourth, which it does not come near to.
  EXPECT_EQ(first({{0, 1500, 0}, {2400, 0, 0}}, {{0, 0, 0}, {-900, -2500, 0}}), 2U);
  options.straight = true;
  EXPECT_EQ(first({{-1000, 0, 0}, {}}, {{1000, 0, 0}, {}}), 1U);
}

// A millimetre thick, and a kilometre a step.
TEST(Clearance, AThinWallIsSeenInAStep) {
  const ObstacleMap map =
      test::map_of({Box{{0, -50, -50}, {0.001, 50, 50}}, UprightCylinder{500, 0, 0.0, {}},
                    UprightPrism{{{-500, -9}, {-499.999, -9}, {-499.999, 9}, {-500, 9}}, {}}});
  for (const bool straight : {false, true}) {
    VerifyOptions options = test::options_of(map, 0.01);
    options.straight = straight;
    const auto losses = [&](const Point& from, const Point& to) {
      const Velocity v{to.x - from.x, to.y - from.y, to.z - from.z};
      return test::losses_of({from, v}, {to, v}, 1.0, options);
    };
    EXPECT_EQ(losses({-300, 1, 2}, {300, 0, 0}), 1U);
    EXPECT_EQ(losses({300, 0, 0}, {700, 0, 0}), 1U);
    EXPECT_EQ(losses({300, 0.1, 0}, {700, 0.1, 0}), 0U);
    EXPECT_EQ(losses({-700, 0, 0}, {-300, 0, 0}), 1U);
    EXPECT_EQ(losses({-700, 9.02, 0}, {-300, 9.02, 0}), 0U);
    EXPECT_EQ(losses({-300, 50.02, 0}, {300, 50.02, 0}), 0U);
    EXPECT_EQ(losses({-300, 50.009, 0}, {300, 50.009, 0}), 1U);
  }
}

// There and back within a step, so that both fixes are clear of it; straight they stay there.
TEST(Clearance, ABendIntoAnObstacleIsSeen) {
  const ObstacleMap map = test::map_of({Ground{0.0}});
  VerifyOptions options = test::options_of(map, 2.0);
  // 10 m down with an acceleration of 20.
  const Mover from{{0, 0, 13}, {0, 0, -20}};
  const Mover to{{0, 0, 13}, {0, 0, 20}};
  EXPECT_EQ(test::losses_of(from, to, 2.0, options), 0U);
  options.clearance_m = 3.001;
  const Verdict verdict = test::verdict_of({{from}, {to}}, 2.0, options);
  ASSERT_EQ(verdict.clearance_losses, 1U);
  EXPECT_NEAR(verdict.first_clearance_losses[0].closest_m, 3.0, 1e-9);
  options.straight = true;
  EXPECT_EQ(test::losses_of(from, to, 2.0, options), 0U);
}

TEST(Clearance, InsideFromTheStartIsLostInEachStep) {
  const ObstacleMap map = test::map_of({Sphere{{0, 0, 0}, 10.0}, Box{{-2, -2, -2}, {2, 2, 2}}});
  const test::Fixes fixes(
      4, {{{100, 0, 0}, {}}, {{0, 0, 0}, {}}, {{0, 50, 0}, {}}, {{10.5, 0, 0}, {}}});
  const Verdict verdict = test::verdict_of(fixes, 0.5, test::options_of(map, 1.0));
  EXPECT_EQ(verdict.losses, 0U);
  ASSERT_EQ(verdict.clearance_losses, 6U);
  EXPECT_FALSE(verdict.holds());
  for (std::size_t k = 0; k < 6; ++k) {
    const ClearanceLoss& loss = verdict.first_clearance_losses[k];
    EXPECT_EQ(loss.agent, k % 2 == 0 ? 1U : 3U);
    EXPECT_EQ(loss.obstacle, 0U);
    const std::size_t step = k / 2;
    EXPECT_EQ(loss.begins_s, 0.5 * static_cast<double>(step));
    EXPECT_EQ(loss.ends_s, 0.5 * static_cast<double>(step + 1));
    EXPECT_NEAR(loss.closest_m, k % 2 == 0 ? -10.0 : 0.5, 1e-12);
  }
}

// Moves smaller than the motion domain's least value, or across half of the domain, are checked
// too.
TEST(Clearance, TheSmallestAndTheLargestWaysAreLookedAt) {
  const ObstacleMap map = test::map_of({Sphere{{0, 0, 0}, 10.0}});
  const VerifyOptions options = test::options_of(map, 1.0);
  EXPECT_EQ(test::losses_of({{1e-30, 0, 0}, {}}, {{1.5e-30, 0, 0}, {}}, 1.0, options), 1U);
  EXPECT_EQ(test::losses_of({{0, 0, 0}, {1e-30, 0, 5}}, {{0, 0, 0}, {1e-30, 0, 4}}, 1e-3, options),
            1U);
  EXPECT_EQ(
      test::losses_of({{20, 0, 0}, {-40, 1e-30, 0}}, {{20, 0, 0}, {40, 1e-30, 0}}, 1.0, options),
      1U);
  // Only its end is near, and its middle is off by next to nothing.
  EXPECT_EQ(
      test::losses_of({{20, 0, 0}, {0, 1e-30, 0}}, {{9, 0, 0}, {-22, -1e-30, 0}}, 1.0, options),
      1U);
  VerifyOptions straight = options;
  straight.straight = true;
  const double far = 0.4 * kLargestInMotion;
  EXPECT_EQ(test::losses_of({{-far, 0, 0}, {}}, {{far, 0, 0}, {}}, 1.0, straight), 1U);
  // Across all of it: the way itself is beyond the domain, so that nothing can be excluded.
  const double farthest = kLargestInMotion;
  EXPECT_EQ(test::losses_of({{-farthest, 0, 0}, {}}, {{farthest, 0, 0}, {}}, 8.0, straight), 1U);
}

TEST(Clearance, CountsMoreThanItShows) {
  const ObstacleMap map = test::map_of({Ground{0.0}});
  std::vector<Mover> movers(90, Mover{{0, 0, 0.5}, {}});
  for (std::size_t i = 0; i < movers.size(); ++i) {
    movers[i].position.x = 10.0 * static_cast<double>(i);
  }
  const Verdict verdict =
      test::verdict_of(test::Fixes(13, movers), 1.0, test::options_of(map, 1.0));
  EXPECT_EQ(verdict.clearance_losses, 12U * 90U);
  EXPECT_EQ(verdict.first_clearance_losses.size(), Verdict::kMostShown);
}

// No obstacles, or an empty map: nothing to keep clear of.
TEST(Clearance, WithoutObstaclesNothingIsLost) {
  const ObstacleMap none;
  const test::Fixes fixes(2, {{{0, 0, 0}, {}}});
  EXPECT_TRUE(test::verdict_of(fixes, 1.0, test::options_of(none, 1.0)).holds());
  EXPECT_TRUE(test::verdict_of(fixes, 1.0, VerifyOptions{.threshold_m = 5.0}).holds());
}

}  // namespace
}  // namespace beespace
