// The Verifier's findings about separation, compared with sampling.
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/support/rounds.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;

constexpr double kThreshold = 5.0;
constexpr double kMillionth = 1e-6;

using Fixes = std::vector<std::vector<Mover>>;

Verdict verdict_of(const Fixes& fixes, double step_s,
                   VerifyOptions options = {.threshold_m = 5.0}) {
  Verifier verifier(options);
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const Status added = verifier.add(static_cast<double>(i) * step_s, fixes[i]);
    EXPECT_TRUE(added) << added.error().message;
  }
  EXPECT_EQ(verifier.verdict().steps, fixes.empty() ? 0 : fixes.size() - 1);
  return verifier.verdict();
}

Point moved(const Point& p, const Velocity& v, double by) {
  return {p.x + v.x * by, p.y + v.y * by, p.z + v.z * by};
}

// Evenly accelerated, or on any curve of third degree.
Mover later(const Mover& mover, double step_s, bool even, double speed, RandomStream& random) {
  const auto [x, y, z] = scenes::random_direction(random);
  const Velocity next{x * speed, y * speed, z * speed};
  const auto& [p, v] = mover;
  Point q{p.x + 0.5 * (v.x + next.x) * step_s, p.y + 0.5 * (v.y + next.y) * step_s,
          p.z + 0.5 * (v.z + next.z) * step_s};
  if (!even) q = moved(q, {y, z, x}, speed * step_s * random.uniform(-0.5, 0.5));
  return {q, next};
}

std::vector<Mover> random_movers(std::size_t size, double side_m, double speed, const Point& offset,
                                 RandomStream& random) {
  std::vector<Mover> movers;
  for (std::size_t i = 0; i < size; ++i) {
    const auto at = [&](double middle) { return middle + random.uniform(-0.5, 0.5) * side_m; };
    const auto [x, y, z] = scenes::random_direction(random);
    movers.push_back(
        {{at(offset.x), at(offset.y), at(offset.z)}, {x * speed, y * speed, z * speed}});
  }
  return movers;
}

struct Closest {
  double distance_m = std::numeric_limits<double>::infinity();
  Pair pair;
};

// Every pair by the oracle: all losses, and only those, closest of all.
void expect_as_sampled(const std::vector<Mover>& from, const std::vector<Mover>& to, double step_s,
                       const VerifyOptions& options, double rounded_m) {
  const Verdict verdict = verdict_of({from, to}, step_s, options);
  const double threshold_m = options.threshold_m;
  const double slack_m = kMillionth * threshold_m + rounded_m;
  Closest least;
  std::size_t at = 0;
  for (PointId i = 0; i < from.size(); ++i) {
    for (PointId j = i + 1; j < from.size(); ++j) {
      const double apart = test::oracle_closest({from[i], from[j]}, {to[i], to[j]}, step_s);
      if (apart < least.distance_m) least = {apart, {i, j}};
      const bool is_next =
          at < verdict.first_losses.size() && verdict.first_losses[at].pair == Pair{i, j};
      if (!is_next) {
        ASSERT_GE(apart, threshold_m) << "a loss is missed: " << i << ", " << j;
        continue;
      }
      const Loss& loss = verdict.first_losses[at++];
      ASSERT_LE(apart, threshold_m + slack_m) << "no loss: " << i << ", " << j;
      ASSERT_EQ(loss.begins_s, 0.0);
      ASSERT_EQ(loss.ends_s, step_s);
      ASSERT_LE(loss.closest_m, apart + 1e-15 * apart);
      ASSERT_GE(loss.closest_m, apart - slack_m);
    }
  }
  ASSERT_EQ(at, verdict.losses);
  ASSERT_EQ(verdict.holds(), verdict.losses == 0);
  if (least.distance_m >= 2.0 * threshold_m + slack_m) {
    ASSERT_FALSE(verdict.closest_m.has_value());
    return;
  }
  ASSERT_TRUE(verdict.closest_m.has_value());
  ASSERT_LE(*verdict.closest_m, least.distance_m * (1.0 + 1e-15));
  ASSERT_GE(*verdict.closest_m, least.distance_m - slack_m);
  ASSERT_EQ(*verdict.closest_pair, least.pair);
}

class AnyMotion : public testing::TestWithParam<bool> {};

TEST_P(AnyMotion, IsJudgedAsBySampling) {
  RandomStream random(1);
  std::uint64_t losses = 0;
  for (int round = 0; round < test::rounds(160); ++round) {
    const double step_s = std::exp(random.uniform(-4.0, 1.0));
    const double speed = kThreshold / step_s * std::exp(random.uniform(-3.0, 2.0));
    VerifyOptions options;
    options.threshold_m = kThreshold;
    options.threads = 1 + random.index(3);
    const Point offset = round % 2 == 0 ? Point{} : Point{1e6, -1e6, 3e5};
    const auto from = random_movers(2 + random.index(4), 30.0, speed, offset, random);
    std::vector<Mover> to;
    for (const Mover& mover : from) to.push_back(later(mover, step_s, GetParam(), speed, random));
    const double rounded_m = round % 2 == 0 ? 1e-12 : 1e-8;
    ASSERT_NO_FATAL_FAILURE(expect_as_sampled(from, to, step_s, options, rounded_m))
        << "round " << round;
    losses += verdict_of({from, to}, step_s, options).losses;
  }
  EXPECT_GT(losses, 0U);
}

INSTANTIATE_TEST_SUITE_P(Verifier, AnyMotion, testing::Bool(), [](const auto& motion) {
  return std::string(motion.param ? "EvenlyAccelerated" : "OfThirdDegree");
});

// Placed so that the closest is a little below or above the threshold, in mid-flight.
TEST(Verifier, KnowsALittleLessFromALittleMore) {
  RandomStream random(3);
  VerifyOptions options;
  options.threshold_m = kThreshold;
  for (int round = 0; round < test::rounds(300); ++round) {
    const double step_s = random.uniform(0.1, 2.0);
    const auto from = random_movers(2, 0.0, 20.0, {}, random);
    std::array<Mover, 2> begins = {from[0], from[1]};
    std::array<Mover, 2> ends = {later(from[0], step_s, round % 2 == 0, 20.0, random),
                                 later(from[1], step_s, round % 2 == 0, 20.0, random)};
    // Shifted across: closest at the shift that the oracle finds by halving.
    const Point aside = scenes::random_direction(random);
    const auto shifted = [&](std::array<Mover, 2> movers, double by) {
      movers[1].position = moved(movers[1].position, {aside.x, aside.y, aside.z}, by);
      return movers;
    };
    double low = 0.0;
    double high = 200.0;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      const bool is_near =
          test::oracle_closest(shifted(begins, middle), shifted(ends, middle), step_s) < kThreshold;
      (is_near ? low : high) = middle;
      if (high - low < 1e-12) break;
    }
    const auto losses = [&](double by) {
      const auto a = shifted(begins, by);
      const auto b = shifted(ends, by);
      return verdict_of({{a[0], a[1]}, {b[0], b[1]}}, step_s, options).losses;
    };
    // The shift is longer than what it adds to the distance.
    const auto closest = [&](double by) {
      return test::oracle_closest(shifted(begins, by), shifted(ends, by), step_s);
    };
    for (const double off : {1e-7, 1e-5, 1e-3}) {
      if (closest(low - off) < kThreshold) {
        ASSERT_EQ(losses(low - off), 1U) << "round " << round << ", " << off;
      }
      if (closest(high + off) > kThreshold * (1.0 + kMillionth)) {
        ASSERT_EQ(losses(high + off), 0U) << "round " << round << ", " << off;
      }
    }
  }
}

// A thousand kilometres off, with a threshold of a centimetre: rounding of the curves is ten times
// the tolerance. The closest is never more than it was.
TEST(Verifier, FarAwayTheClosestIsNeverMoreThanItWas) {
  RandomStream random(5);
  VerifyOptions options;
  options.threshold_m = 0.01;
  int reported = 0;
  for (int round = 0; round < test::rounds(1'000); ++round) {
    const double step_s = random.uniform(0.1, 1.0);
    const auto from = random_movers(2, 0.02, 0.02, {1e6, -1e6, 3e5}, random);
    const std::vector<Mover> to = {later(from[0], step_s, true, 0.02, random),
                                   later(from[1], step_s, true, 0.02, random)};
    const Verdict verdict = verdict_of({from, to}, step_s, options);
    if (!verdict.closest_m) {
      continue;
    }
    ++reported;
    const double truth = test::oracle_closest({from[0], from[1]}, {to[0], to[1]}, step_s);
    ASSERT_LE(*verdict.closest_m, truth + 1e-12) << "round " << round;
    ASSERT_GE(*verdict.closest_m, truth - 1e-6 * options.threshold_m) << "round " << round;
  }
  EXPECT_GT(reported, test::rounds(1'000) / 4);
}

// At both fixes far apart, in between not: one flies past the other in a step.
TEST(Verifier, FindsLossesBetweenTwoFixes) {
  VerifyOptions options;
  options.threshold_m = kThreshold;
  const std::vector<Mover> from = {{{-1000, 0, 0}, {2000, 0, 0}}, {{0, 3, 0}, {0, 0, 0}}};
  const std::vector<Mover> to = {{{1000, 0, 0}, {2000, 0, 0}}, {{0, 3, 0}, {0, 0, 0}}};
  for (const bool straight : {false, true}) {
    options.straight = straight;
    const Verdict verdict = verdict_of({from, to}, 1.0, options);
    EXPECT_EQ(verdict.losses, 1U);
    ASSERT_EQ(verdict.first_losses.size(), 1U);
    EXPECT_NEAR(verdict.first_losses[0].closest_m, 3.0, 1e-6);
    EXPECT_NEAR(verdict.closest_m.value(), 3.0, 1e-6);
    EXPECT_EQ(verdict.closest_pair, (Pair{0, 1}));
  }
}

// Only the bend brings them together; the straight ways are far apart.
TEST(Verifier, FindsLossesOnTheBend) {
  const double step_s = 2.0;
  // Up and back again with an acceleration of 20: 10 m at the middle of the step.
  const std::vector<Mover> from = {{{0, 0, 0}, {0, 20, 0}}, {{0, 14, 0}, {}}};
  const std::vector<Mover> to = {{{0, 0, 0}, {0, -20, 0}}, {{0, 14, 0}, {}}};
  VerifyOptions options;
  options.threshold_m = kThreshold;
  const Verdict bent = verdict_of({from, to}, step_s, options);
  EXPECT_EQ(bent.losses, 1U);
  EXPECT_NEAR(bent.closest_m.value(), 4.0, 1e-6);
  options.straight = true;
  EXPECT_EQ(verdict_of({from, to}, step_s, options).losses, 0U);
}

// Exactly the threshold apart is no loss; a reported loss would be within the tolerance.
TEST(Verifier, ExactlyTheThresholdIsDecidedWithinTheTolerance) {
  VerifyOptions options;
  options.threshold_m = kThreshold;
  const auto standing = [](double apart_m) {
    return std::vector<Mover>{{{1, 2, 3}, {}}, {{1 + apart_m, 2, 3}, {}}};
  };
  const auto flying = [](double apart_m) {
    return Fixes{{{{-10, 0, 0}, {20, 0, 0}}, {{0, apart_m, 0}, {}}},
                 {{{10, 0, 0}, {20, 0, 0}}, {{0, apart_m, 0}, {}}}};
  };
  const double above = kThreshold * (1.0 + kMillionth);
  const double below = kThreshold * (1.0 - kMillionth);
  for (const bool straight : {false, true}) {
    options.straight = straight;
    EXPECT_TRUE(verdict_of({standing(above), standing(above)}, 1.0, options).holds());
    EXPECT_FALSE(verdict_of({standing(below), standing(below)}, 1.0, options).holds());
    EXPECT_TRUE(verdict_of(flying(above), 1.0, options).holds());
    EXPECT_FALSE(verdict_of(flying(below), 1.0, options).holds());
    for (const Fixes& fixes :
         {Fixes{standing(kThreshold), standing(kThreshold)}, flying(kThreshold)}) {
      const Verdict verdict = verdict_of(fixes, 1.0, options);
      ASSERT_TRUE(verdict.closest_m.has_value());
      EXPECT_GE(*verdict.closest_m, below);
      EXPECT_LE(*verdict.closest_m, kThreshold);
    }
  }
}

TEST(Verifier, OfNoneAndOfOne) {
  VerifyOptions options{.threshold_m = kThreshold};
  options.max_speed_mps = 10.0;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}}) {
    const std::vector<Mover> movers(size, {{1, 2, 3}, {}});
    const Verdict verdict = verdict_of({movers, movers, movers}, 1.0, options);
    EXPECT_EQ(verdict.steps, 2U);
    EXPECT_TRUE(verdict.holds());
    EXPECT_FALSE(verdict.closest_m.has_value());
    EXPECT_FALSE(verdict.closest_pair.has_value());
    EXPECT_EQ(verdict.peak_speed_mps, 0.0);
  }
  EXPECT_TRUE(Verifier(options).verdict().holds());
  EXPECT_EQ(Verifier(options).verdict().steps, 0U);
}

// A pair is counted anew in each step; the closest is reported with its pair and step.
TEST(Verifier, CountsLossesAStepAndReportsTheClosest) {
  const auto at = [](double second_x, double third_x) {
    return std::vector<Mover>{{{0, 0, 0}, {}}, {{second_x, 0, 0}, {}}, {{third_x, 0, 0}, {}}};
  };
  VerifyOptions options;
  options.threshold_m = kThreshold;
  options.straight = true;
  const Verdict verdict =
      verdict_of({at(20, 40), at(9, 40), at(4, 40), at(4, 3), at(20, 40)}, 0.5, options);
  EXPECT_EQ(verdict.steps, 4U);
  ASSERT_EQ(verdict.losses, 7U);
  const std::vector<std::pair<double, Pair>> expected = {
      {0.5, {0, 1}}, {1.0, {0, 1}}, {1.0, {0, 2}}, {1.0, {1, 2}},
      {1.5, {0, 1}}, {1.5, {0, 2}}, {1.5, {1, 2}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(verdict.first_losses[i].begins_s, expected[i].first);
    EXPECT_EQ(verdict.first_losses[i].ends_s, expected[i].first + 0.5);
    EXPECT_EQ(verdict.first_losses[i].pair, expected[i].second);
  }
  EXPECT_EQ(verdict.closest_m, 0.0);
  EXPECT_EQ(verdict.closest_pair, (Pair{1, 2}));
  EXPECT_EQ(verdict.closest_step_s, 1.0);
}

TEST(Verifier, TheClosestIsReportedBelowTwiceTheThresholdOnly) {
  const auto apart = [](double far) {
    const std::vector<Mover> movers = {{{0, 0, 0}, {}}, {{far, 0, 0}, {}}};
    VerifyOptions options;
    options.threshold_m = kThreshold;
    return verdict_of({movers, movers}, 1.0, options).closest_m;
  };
  EXPECT_NEAR(apart(9.999).value(), 9.999, 1e-6);
  EXPECT_FALSE(apart(10.001).has_value());
}

TEST(Verifier, CountsMoreThanItShows) {
  // 50 bees at about one place: 1225 pairs.
  std::vector<Mover> movers;
  for (int i = 0; i < 50; ++i) movers.push_back({{0.01 * i, 0, 0}, {100, 0, 0}});
  VerifyOptions options{.threshold_m = 5.0};
  options.max_speed_mps = 1.0;
  options.straight = true;
  Fixes fixes;
  const int steps = 30;
  for (int step = 0; step <= steps; ++step) {
    fixes.push_back(movers);
    for (Mover& mover : movers) mover.position.x += 100.0;
  }
  const Verdict verdict = verdict_of(fixes, 1.0, options);
  EXPECT_EQ(verdict.losses, 1225U * steps);
  EXPECT_EQ(verdict.breaches, 50U * steps);
  EXPECT_EQ(verdict.first_losses.size(), Verdict::kMostShown);
  EXPECT_EQ(verdict.first_breaches.size(), Verdict::kMostShown);
  EXPECT_FALSE(verdict.holds());
  EXPECT_TRUE(verdict.first_losses.back().begins_s == 0.0);
}

TEST(Verifier, ThreadsDoNotChangeTheVerdict) {
  RandomStream random(9);
  Fixes fixes = {random_movers(test::kSanitized ? 1'000 : 5'000, 150.0, 20.0, {}, random)};
  for (int step = 0; step < 3; ++step) {
    std::vector<Mover> next;
    for (const Mover& mover : fixes.back()) next.push_back(later(mover, 0.2, true, 20.0, random));
    fixes.push_back(next);
  }
  VerifyOptions options{.threshold_m = 5.0};
  const Verdict alone = verdict_of(fixes, 0.2, options);
  EXPECT_GT(alone.losses, 100U);
  for (const unsigned threads : {2U, 5U}) {
    options.threads = threads;
    const Verdict verdict = verdict_of(fixes, 0.2, options);
    EXPECT_EQ(verdict.losses, alone.losses);
    EXPECT_EQ(verdict.first_losses, alone.first_losses);
    EXPECT_EQ(verdict.closest_m, alone.closest_m);
    EXPECT_EQ(verdict.closest_pair, alone.closest_pair);
  }
}

}  // namespace
}  // namespace beespace
