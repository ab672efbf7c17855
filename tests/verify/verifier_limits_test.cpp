// The Verifier on speeds and accelerations.
#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beespace {
namespace {

struct Flight {
  Mover from;
  Mover to;
  double lasts_s;
};

// From the origin with a velocity, evenly accelerated.
Flight even(const Velocity& v, const Velocity& a, double lasts_s, const Point& p = {}) {
  const double half = 0.5 * lasts_s * lasts_s;
  return {{p, v},
          {{p.x + v.x * lasts_s + a.x * half, p.y + v.y * lasts_s + a.y * half,
            p.z + v.z * lasts_s + a.z * half},
           {v.x + a.x * lasts_s, v.y + a.y * lasts_s, v.z + a.z * lasts_s}},
          lasts_s};
}

Verdict verdict_of(const Flight& flight, const VerifyOptions& options) {
  Verifier verifier(options);
  EXPECT_TRUE(verifier.add(10.0, std::vector<Mover>{flight.from}));
  EXPECT_TRUE(verifier.add(10.0 + flight.lasts_s, std::vector<Mover>{flight.to}));
  return verifier.verdict();
}

VerifyOptions limits(double speed, double acceleration) {
  VerifyOptions options{.threshold_m = 5.0};
  options.max_speed_mps = speed;
  options.max_acceleration_mps2 = acceleration;
  return options;
}

TEST(VerifierLimits, OfEvenAccelerationAreMetExactly) {
  const Flight flight = even({3, 0, 0}, {0, 8, 0}, 0.5);  // from 3 to 5 m/s, at 8 m/s^2
  for (const Point& p : {Point{}, Point{1e6, -1e6, 1e6}}) {
    const Flight moved = even({3, 0, 0}, {0, 8, 0}, 0.5, p);
    const Verdict verdict = verdict_of(moved, limits(5.0, 8.0));
    EXPECT_TRUE(verdict.holds());
    EXPECT_NEAR(verdict.peak_speed_mps, 5.0, 1e-8);
    EXPECT_NEAR(verdict.peak_acceleration_mps2, 8.0, 1e-7);
  }
  Verdict verdict = verdict_of(flight, limits(5.0 - 1e-6, 8.0));
  EXPECT_EQ(verdict.breaches, 1U);
  ASSERT_EQ(verdict.first_breaches.size(), 1U);
  EXPECT_EQ(verdict.first_breaches[0].agent, 0U);
  EXPECT_EQ(verdict.first_breaches[0].kind, BreachKind::kSpeed);
  EXPECT_EQ(verdict.first_breaches[0].begins_s, 10.0);
  EXPECT_NEAR(verdict.first_breaches[0].value, 5.0, 1e-12);
  EXPECT_FALSE(verdict.holds());
  verdict = verdict_of(flight, limits(5.0, 8.0 - 1e-6));
  EXPECT_EQ(verdict.breaches, 1U);
  ASSERT_EQ(verdict.first_breaches.size(), 1U);
  EXPECT_EQ(verdict.first_breaches[0].kind, BreachKind::kAcceleration);
  EXPECT_NEAR(verdict.first_breaches[0].value, 8.0, 1e-12);
  EXPECT_EQ(verdict_of(flight, limits(1.0, 1.0)).breaches, 2U);
  EXPECT_EQ(verdict_of(flight, {.threshold_m = 5.0}).breaches, 0U);
}

// At rest at both ends, and somewhere else: the peak is in between. 1.5 times the mean speed, and
// six times what even acceleration to it would be at the ends.
const Flight kHop{{{0, 0, 0}, {}}, {{2, 0, 0}, {}}, 1.0};

TEST(VerifierLimits, SeeAPeakInsideAStep) {
  Verdict verdict = verdict_of(kHop, limits(2.99, 100.0));
  EXPECT_EQ(verdict.breaches, 1U);
  EXPECT_EQ(verdict.first_breaches.at(0).kind, BreachKind::kSpeed);
  EXPECT_GE(verdict.first_breaches.at(0).value, 3.0 - 1e-9);
  verdict = verdict_of(kHop, limits(100.0, 11.99));
  EXPECT_EQ(verdict.breaches, 1U);
  EXPECT_EQ(verdict.first_breaches.at(0).kind, BreachKind::kAcceleration);
  EXPECT_NEAR(verdict.first_breaches.at(0).value, 12.0, 1e-9);
}

// Its speed is that of the curve: 6 u (1 - u) of 2 m/s, 3 m/s at most.
TEST(VerifierLimits, SayNoMoreThanThePeakInsideAStep) {
  const Verdict verdict = verdict_of(kHop, limits(3.01, 12.01));
  EXPECT_TRUE(verdict.holds());
  EXPECT_NEAR(verdict.peak_speed_mps, 3.0, 1e-6);
  EXPECT_NEAR(verdict.peak_acceleration_mps2, 12.0, 1e-6);
}

// A velocity that does not fit the positions shows as an acceleration that was not flown.
TEST(VerifierLimits, VelocitiesThatDoNotFitThePositionsAreABreach) {
  const double step_s = 0.1;
  const Flight honest = even({5, 0, 0}, {1, 0, 0}, step_s);
  EXPECT_TRUE(verdict_of(honest, limits(10.0, 1.0)).holds());
  Flight lying = honest;
  lying.to.velocity = {};
  EXPECT_FALSE(verdict_of(lying, limits(10.0, 1.0)).holds());
  lying = honest;
  lying.from.velocity = lying.to.velocity = {0, 5, 0};
  EXPECT_FALSE(verdict_of(lying, limits(10.0, 1.0)).holds());
  lying = honest;
  lying.to.position.x += 0.01;
  EXPECT_FALSE(verdict_of(lying, limits(10.0, 1.0)).holds());
}

// Straight: neither velocities nor what would be an acceleration are looked at.
TEST(VerifierLimits, StraightFlightsHaveTheSpeedOfTheirChord) {
  VerifyOptions options = limits(2.0, 0.0);
  options.straight = true;
  Flight flight = kHop;
  flight.from.velocity = {1e6, 0, 0};
  flight.to.velocity = {0, -1e6, 0};
  Verdict verdict = verdict_of(flight, options);
  EXPECT_TRUE(verdict.holds());
  EXPECT_NEAR(verdict.peak_speed_mps, 2.0, 1e-12);
  EXPECT_EQ(verdict.peak_acceleration_mps2, 0.0);
  options.max_speed_mps = 2.0 - 1e-6;
  verdict = verdict_of(flight, options);
  EXPECT_EQ(verdict.breaches, 1U);
}

// Exactly at its limits, a hundred steps a second, a thousand kilometres off.
TEST(VerifierLimits, RoundingOfFarPositionsIsNoBreach) {
  const double step_s = 0.01;
  const double turn = 0.005;  // in each step, at 10 m/s
  const double acceleration = 20.0 * std::sin(0.5 * turn) / step_s;
  VerifyOptions options = limits(10.0, acceleration);
  Verifier verifier(options);
  Mover mover{{1e6, -1e6, 1e6}, {10, 0, 0}};
  for (int step = 0; step <= 500; ++step) {
    ASSERT_TRUE(verifier.add(step * step_s, std::vector<Mover>{mover}));
    const double turned = turn * (step + 1);
    const Velocity next{10 * std::cos(turned), 10 * std::sin(turned), 0};
    const auto& [p, v] = mover;
    mover = {{p.x + 0.5 * (v.x + next.x) * step_s, p.y + 0.5 * (v.y + next.y) * step_s, p.z}, next};
  }
  EXPECT_TRUE(verifier.verdict().holds());
  EXPECT_NEAR(verifier.verdict().peak_speed_mps, 10.0, 1e-6);
  EXPECT_NEAR(verifier.verdict().peak_acceleration_mps2, acceleration, 1e-3);
}

TEST(VerifierLimits, NoSpeedAtAllIsALimitToo) {
  const Flight standing = even({}, {}, 1.0);
  EXPECT_TRUE(verdict_of(standing, limits(0.0, 0.0)).holds());
  EXPECT_EQ(verdict_of(even({1e-3, 0, 0}, {}, 1.0), limits(0.0, 0.0)).breaches, 1U);
}

}  // namespace
}  // namespace beespace
