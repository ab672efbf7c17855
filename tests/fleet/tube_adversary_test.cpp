// The worst that can happen to the loop, found by flying it: never beyond the tube, and close to
// it.
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/fleet/flown_loop.hpp"

#include <beespace/fleet.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flown;
using test::kParts;
using test::Long3;
using test::LoopCase;

LoopCase random_case(RandomStream& random, LoopPlace place) {
  LoopCase made;
  FleetFigures& figures = made.figures;
  figures.loop = place;
  figures.deviation_mps = random.uniform(0.05, 1.0);
  figures.correction_mps = figures.deviation_mps + random.uniform(0.3, 1.5);
  figures.correction_mps2 = random.uniform(0.5, 3.0);
  made.measured_error_m = random.uniform(0.0, 0.5);
  made.period_s = std::exp(random.uniform(-3.0, -0.7));
  const double part_s = made.period_s / static_cast<double>(kParts);
  const std::size_t aged = random.index(2 * kParts);
  if (place == LoopPlace::kOnboard) {
    figures.sensing_error_m = made.measured_error_m;
    figures.loop_period_s = made.period_s;
    figures.loop_delay_s = static_cast<double>(aged) * part_s;
    made.delay_parts = aged;
  } else {
    figures.report_error_m = made.measured_error_m;
    figures.report_age_s = static_cast<double>(aged) * part_s;
    made.link.period_s = made.period_s;
    made.link.command_delay = 1 + static_cast<int>(random.index(3));
    made.delay_parts = aged + static_cast<std::size_t>(made.link.command_delay) * kParts;
  }
  return made;
}

// So long that what comes before is forgotten.
std::size_t periods_of(const LoopCase& loop_case, const Tube& tube) {
  return static_cast<std::size_t>(45.0 / (tube.gain_per_s * loop_case.period_s)) + 50 +
         2 * loop_case.delay_parts / kParts;
}

// How the flight answers one gust in each part of a period, and one error of a measurement.
struct Answers {
  std::vector<Flown> to_gust;
  Flown to_error;
};

constexpr long double kNudge = 1e-3L;  // so small that no bound is met

Answers answers_of(const LoopCase& loop_case, const Tube& tube) {
  const std::size_t periods = periods_of(loop_case, tube);
  std::vector<Long3> gusts(periods * kParts);
  std::vector<Long3> errors(periods);
  // Measurements before the first are of the first: so it begins after the delay.
  const std::size_t start = loop_case.delay_parts / kParts + 1;
  Answers answers;
  for (std::size_t part = 0; part < kParts; ++part) {
    gusts[start * kParts + part].x = kNudge;
    answers.to_gust.push_back(fly(loop_case, tube, gusts, errors));
    gusts[start * kParts + part].x = 0.0L;
  }
  errors[start].x = kNudge;
  answers.to_error = fly(loop_case, tube, gusts, errors);
  return answers;
}

struct Worst {
  std::vector<Long3> gusts;
  std::vector<Long3> errors;
};

long double sign(long double value) {
  return value < 0.0L ? -1.0L : 1.0L;
}

// The gusts and errors that drive an output up: its answer to each has a sign. `output(flown,
// lag)`: of a flight, as many periods after the nudge; only what comes until `last` acts on it.
template <class Output>
Worst worst_for(const LoopCase& loop_case, const Tube& tube, const Answers& answers,
                const Output& output) {
  const std::size_t start = loop_case.delay_parts / kParts + 1;
  const std::size_t periods = periods_of(loop_case, tube);
  const std::size_t last = periods - start - 1;  // the period of the output
  Worst worst{std::vector<Long3>(periods * kParts), std::vector<Long3>(periods)};
  for (std::size_t period = 0; period <= last; ++period) {
    const std::size_t then = start + last - period;
    for (std::size_t part = 0; part < kParts; ++part) {
      worst.gusts[period * kParts + part].x =
          sign(output(answers.to_gust[part], then)) *
          static_cast<long double>(loop_case.figures.deviation_mps);
    }
    worst.errors[period].x =
        sign(output(answers.to_error, then)) * static_cast<long double>(loop_case.measured_error_m);
  }
  return worst;
}

struct Extremes {
  long double deviation_m = 0.0L;
  long double velocity_mps = 0.0L;
  long double acceleration_mps2 = 0.0L;

  void take(const Flown& flown) {
    for (const Long3& x : flown.deviations) deviation_m = std::max(deviation_m, length_of(x));
    for (const Long3& u : flown.velocities) velocity_mps = std::max(velocity_mps, length_of(u));
    for (const Long3& a : flown.accelerations) {
      acceleration_mps2 = std::max(acceleration_mps2, length_of(a));
    }
  }
};

// The three outputs: a deviation within a period, the velocity and the acceleration of corrections.
Extremes extremes_of(const LoopCase& loop_case, const Tube& tube) {
  const Answers answers = answers_of(loop_case, tube);
  Extremes extremes;
  for (const std::size_t part : {std::size_t{0}, kParts / 3, kParts / 2, kParts - 1}) {
    const Worst worst = worst_for(loop_case, tube, answers, [&](const Flown& f, std::size_t n) {
      return f.deviations[n * kParts + part].x;
    });
    extremes.take(fly(loop_case, tube, worst.gusts, worst.errors));
  }
  const Worst fast = worst_for(loop_case, tube, answers,
                               [](const Flown& f, std::size_t n) { return f.velocities[n].x; });
  extremes.take(fly(loop_case, tube, fast.gusts, fast.errors));
  const Worst hard = worst_for(loop_case, tube, answers,
                               [](const Flown& f, std::size_t n) { return f.accelerations[n].x; });
  extremes.take(fly(loop_case, tube, hard.gusts, hard.errors));
  return extremes;
}

void expect_within(const Extremes& extremes, const Tube& tube) {
  EXPECT_LE(extremes.deviation_m, static_cast<long double>(tube.radius_m));
  EXPECT_LE(extremes.velocity_mps, static_cast<long double>(tube.correction_mps) + 1e-12L);
  EXPECT_LE(extremes.acceleration_mps2, static_cast<long double>(tube.correction_mps2) + 1e-12L);
}

TEST(TubeAdversary, TheWorstThatCanHappenOnBoardStaysInTheTubeAndReachesIt) {
  RandomStream random(1);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    LoopCase loop_case = random_case(random, LoopPlace::kOnboard);
    const Result<Tube> tube = tube_of(loop_case.figures, loop_case.link, loop_case.limits);
    ASSERT_TRUE(tube) << tube.error().message;
    const Extremes extremes = extremes_of(loop_case, *tube);
    expect_within(extremes, *tube);
    // A constant wind and a constant error reach the tube, delays included.
    EXPECT_GE(extremes.deviation_m, 0.999L * static_cast<long double>(tube->radius_m));
    if (loop_case.delay_parts == 0) {
      EXPECT_GE(extremes.velocity_mps, 0.999L * static_cast<long double>(tube->correction_mps));
      EXPECT_GE(extremes.acceleration_mps2,
                0.999L * static_cast<long double>(tube->correction_mps2));
    }
  }
}

TEST(TubeAdversary, TheWorstThatCanHappenOnTheGroundStaysInTheTubeAndReachesIt) {
  RandomStream random(2);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    LoopCase loop_case = random_case(random, LoopPlace::kGround);
    const Result<Tube> tube = tube_of(loop_case.figures, loop_case.link, loop_case.limits);
    ASSERT_TRUE(tube) << tube.error().message;
    const Extremes extremes = extremes_of(loop_case, *tube);
    expect_within(extremes, *tube);
    EXPECT_GE(extremes.deviation_m, 0.999L * static_cast<long double>(tube->radius_m));
  }
}

Long3 in_direction(RandomStream& random, double length) {
  const Point d = scenes::random_direction(random);
  return {d.x * length, d.y * length, d.z * length};
}

// Gusts that keep their direction for a while, and then take another, or flip.
TEST(TubeAdversary, InSpaceNoGustLeadsOutOfTheTube) {
  RandomStream random(3);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    const LoopCase loop_case =
        random_case(random, round % 2 == 0 ? LoopPlace::kOnboard : LoopPlace::kGround);
    const Result<Tube> tube = tube_of(loop_case.figures, loop_case.link, loop_case.limits);
    ASSERT_TRUE(tube) << tube.error().message;
    std::vector<Long3> gusts(400 * kParts);
    std::vector<Long3> errors(400);
    Long3 gust;
    const double flips = random.uniform(0.0, 0.2);
    for (Long3& one : gusts) {
      if (random.uniform() < flips) gust = gust * -1.0L;
      if (random.uniform() < 0.01) {
        gust = in_direction(random, loop_case.figures.deviation_mps);
      }
      one = gust;
    }
    for (Long3& one : errors) one = in_direction(random, loop_case.measured_error_m);
    Extremes extremes;
    extremes.take(fly(loop_case, *tube, gusts, errors));
    expect_within(extremes, *tube);
  }
}

// An agent stands as far from where it is said to stand as reports may be off, in a wind that it
// holds already.
TEST(TubeAdversary, AnAgentThatJoinsIsInItsTubeFromTheStart) {
  RandomStream random(4);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const LoopCase loop_case = random_case(random, LoopPlace::kGround);
    const Result<Tube> tube = tube_of(loop_case.figures, loop_case.link, loop_case.limits);
    ASSERT_TRUE(tube) << tube.error().message;
    // As after a constant error of the other sign, and no wind: it stands where the error leads.
    std::vector<Long3> gusts(2000 * kParts);
    std::vector<Long3> errors(2000);
    for (std::size_t n = 0; n < errors.size(); ++n) {
      const bool joined = n >= 1000;
      errors[n].x = static_cast<long double>(loop_case.measured_error_m) * (joined ? 1.0L : -1.0L);
      for (std::size_t part = 0; part < kParts; ++part) {
        if (joined) {
          gusts[n * kParts + part].x =
              static_cast<long double>(loop_case.figures.deviation_mps) *
              (n / (1 + static_cast<std::size_t>(round)) % 2 == 0 ? 1.0L : -1.0L);
        }
      }
    }
    Extremes extremes;
    extremes.take(fly(loop_case, *tube, gusts, errors));
    expect_within(extremes, *tube);
  }
}

}  // namespace
}  // namespace beespace
