#include "scenes/random_stream.hpp"

#include <beespace/fleet.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace beespace {
namespace {

using scenes::RandomStream;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr FlightLimits kLimits{10.0, 5.0};

// That an error says this, or that there is none.
std::string refusal(const FleetFigures& figures, const LinkFigures& link = {},
                    const FlightLimits& limits = kLimits) {
  const Result<Tube> tube = tube_of(figures, link, limits);
  if (tube) return "";
  EXPECT_EQ(tube.error().code, ErrorCode::kInvalidArgument);
  return tube.error().message;
}

TEST(Tube, AFleetWithoutErrorsHasNone) {
  const Result<Tube> tube = tube_of({}, {}, kLimits);
  ASSERT_TRUE(tube);
  EXPECT_EQ(tube->radius_m, 0.0);
  EXPECT_EQ(tube->correction_mps, 0.0);
  EXPECT_EQ(tube->correction_mps2, 0.0);
  EXPECT_EQ(tube->planned, kLimits);
  const Result<Tube> ground = tube_of({.loop = LoopPlace::kGround}, {}, kLimits);
  ASSERT_TRUE(ground);
  EXPECT_EQ(ground->radius_m, 0.0);
}

// 4/e w^2/b: 1.48 w^2/b is that, rounded up.
TEST(Tube, WithoutErrorsOfMeasurementItIsThatOfTheFormula) {
  for (const double w : {0.1, 0.5, 1.0}) {
    for (const double b : {0.5, 1.0, 2.5}) {
      const Result<Tube> tube =
          tube_of({.deviation_mps = w, .correction_mps2 = b, .correction_mps = w}, {}, kLimits);
      ASSERT_TRUE(tube);
      EXPECT_NEAR(tube->radius_m, 4.0 / std::numbers::e * w * w / b, 1e-9);
      EXPECT_LE(tube->radius_m, 1.48 * w * w / b);
      EXPECT_GE(tube->radius_m, 4.0 / std::numbers::e * w * w / b);
      EXPECT_EQ(tube->correction_mps, w);
      EXPECT_NEAR(tube->correction_mps2, b, 1e-9);
      EXPECT_LE(tube->correction_mps2, b);
    }
  }
}

// The figures of docs/prevention.md, whose constants are rounded up.
TEST(Tube, TheContinuousLoopNeedsWhatTheFormulasSay) {
  const FleetFigures figures{.sensing_error_m = 0.1,
                             .loop_delay_s = 0.05,
                             .deviation_mps = 0.5,
                             .correction_mps2 = 1.0,
                             .correction_mps = 1.0};
  const Result<Tube> tube = tube_of(figures, {}, kLimits);
  ASSERT_TRUE(tube);
  const double k = tube->gain_per_s;
  EXPECT_NEAR(tube->error_m, 0.125, 1e-9);
  EXPECT_NEAR(tube->radius_m, 2.0 * 0.5 / k + 0.125, 1e-9);
  EXPECT_NEAR(tube->correction_mps, 0.5 + 2.0 / std::numbers::e * k * 0.125, 1e-9);
  EXPECT_LE(tube->correction_mps2, 2.0 / std::numbers::e * k * 0.5 + 2.28 * k * k * 0.125);
  EXPECT_NEAR(tube->correction_mps2,
              2.0 / std::numbers::e * k * 0.5 + (2.0 + 2.0 * std::exp(-2.0)) * k * k * 0.125, 1e-9);
}

TEST(Tube, AShortPeriodIsAsNone) {
  FleetFigures figures{
      .sensing_error_m = 0.1, .deviation_mps = 0.5, .correction_mps2 = 1.0, .correction_mps = 1.0};
  const Result<Tube> continuous = tube_of(figures, {}, kLimits);
  figures.loop_period_s = 1e-6;
  const Result<Tube> sampled = tube_of(figures, {}, kLimits);
  ASSERT_TRUE(continuous && sampled);
  EXPECT_NEAR(continuous->radius_m, sampled->radius_m, 1e-6);
  EXPECT_NEAR(continuous->gain_per_s, sampled->gain_per_s, 1e-5);
  EXPECT_NEAR(continuous->correction_mps, sampled->correction_mps, 1e-5);
}

TEST(Tube, AClockThatIsOffCountsByThePlannedSpeed) {
  FleetFigures figures{.deviation_mps = 0.5, .correction_mps2 = 1.0, .correction_mps = 1.0};
  const Result<Tube> exact = tube_of(figures, {}, kLimits);
  figures.clock_error_s = 0.02;
  const Result<Tube> off = tube_of(figures, {}, kLimits);
  ASSERT_TRUE(exact && off);
  EXPECT_DOUBLE_EQ(off->clock_m, 9.0 * 0.02);
  EXPECT_NEAR(off->radius_m, exact->radius_m + 9.0 * 0.02, 1e-9);
}

// On the ground the clock says also when a correction takes effect.
TEST(Tube, OnTheGroundAllDelaysCount) {
  const FleetFigures figures{.loop = LoopPlace::kGround,
                             .report_error_m = 0.25,
                             .report_age_s = 0.15,
                             .deviation_mps = 0.2,
                             .clock_error_s = 0.01,
                             .correction_mps2 = 1.0,
                             .correction_mps = 1.0};
  const Result<Tube> tube = tube_of(figures, {.period_s = 0.1, .command_delay = 3}, kLimits);
  ASSERT_TRUE(tube);
  EXPECT_NEAR(tube->error_m, 0.25 + 0.2 * (0.15 + 0.3 + 0.01), 1e-9);
}

// An agent joins where a report says that it stands.
TEST(Tube, ItIsNoNarrowerThanTheErrorOfReports) {
  const Result<Tube> tube = tube_of({.report_error_m = 0.5, .sensing_error_m = 0.1}, {}, kLimits);
  ASSERT_TRUE(tube);
  EXPECT_GE(tube->radius_m, 0.5);
}

TEST(Tube, ItNeverFallsWhenAnErrorGrows) {
  RandomStream random(7);
  for (int round = 0; round < 2000; ++round) {
    FleetFigures figures;
    figures.loop = random.index(2) == 0 ? LoopPlace::kOnboard : LoopPlace::kGround;
    LinkFigures link;
    link.period_s = std::exp(random.uniform(-5.0, 0.0));
    link.command_delay = 1 + static_cast<int>(random.index(8));
    figures.loop_period_s = random.index(2) == 0 ? 0.0 : std::exp(random.uniform(-6.0, 0.0));
    figures.report_error_m = random.uniform(0.0, 1.0);
    figures.report_age_s = random.uniform(0.0, 1.0);
    figures.sensing_error_m = random.uniform(0.0, 1.0);
    figures.loop_delay_s = random.uniform(0.0, 0.5);
    figures.deviation_mps = random.index(10) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    figures.clock_error_s = random.uniform(0.0, 0.1);
    figures.correction_mps = random.uniform(1.6, 5.0);
    figures.correction_mps2 = random.uniform(0.1, 4.0);
    const Result<Tube> before = tube_of(figures, link, kLimits);
    ASSERT_TRUE(before) << before.error().message;
    const auto grow = [&](double& figure) { figure += std::exp(random.uniform(-12.0, -1.0)); };
    switch (random.index(6)) {
      case 0:
        grow(figures.report_error_m);
        break;
      case 1:
        grow(figures.report_age_s);
        break;
      case 2:
        grow(figures.sensing_error_m);
        break;
      case 3:
        grow(figures.loop_delay_s);
        break;
      case 4:
        grow(figures.deviation_mps);
        break;
      default:
        grow(figures.clock_error_s);
        break;
    }
    const Result<Tube> after = tube_of(figures, link, kLimits);
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_GE(after->radius_m * (1.0 + 1e-13), before->radius_m) << round;
    EXPECT_LE(after->correction_mps, figures.correction_mps);
    EXPECT_LE(after->correction_mps2, figures.correction_mps2);
  }
}

TEST(Tube, MoreForCorrectionsMakesItNarrower) {
  double before = kInfinity;
  for (double b = 0.1; b < 4.0; b *= 1.3) {
    const Result<Tube> tube = tube_of({.sensing_error_m = 0.1,
                                       .loop_period_s = 0.05,
                                       .deviation_mps = 0.5,
                                       .correction_mps2 = b,
                                       .correction_mps = 3.0},
                                      {}, kLimits);
    ASSERT_TRUE(tube);
    EXPECT_LT(tube->radius_m, before);
    before = tube->radius_m;
  }
}

TEST(Tube, TinyFiguresGiveATinyTube) {
  const Result<Tube> tube = tube_of({.sensing_error_m = 5e-324,
                                     .deviation_mps = 1e-300,
                                     .correction_mps2 = 1.0,
                                     .correction_mps = 1.0},
                                    {}, kLimits);
  ASSERT_TRUE(tube);
  EXPECT_GT(tube->radius_m, 0.0);
  EXPECT_LT(tube->radius_m, 1e-28);
}

TEST(Tube, FiguresThatContradictEachOtherAreRefusedWithTheNumbers) {
  EXPECT_EQ(refusal({.deviation_mps = 1.2, .correction_mps2 = 1.0, .correction_mps = 1.0}),
            "deviation_mps 1.2 needs correction_mps of at least 1.2, 1 is given: the agent would "
            "be carried off faster than it can fly back; keep more speed for corrections, or fly "
            "in less wind");
  EXPECT_NE(refusal({.sensing_error_m = 0.1,
                     .deviation_mps = 1.0,
                     .correction_mps2 = 1.0,
                     .correction_mps = 1.0})
                .find("needs correction_mps of more than 1, 1 is given"),
            std::string::npos);
  EXPECT_NE(refusal({.deviation_mps = 0.5, .correction_mps = 1.0})
                .find("deviation_mps 0.5 needs correction_mps2 above zero, 0 is given"),
            std::string::npos);
  EXPECT_NE(refusal({.deviation_mps = 0.5, .correction_mps2 = 1.0, .correction_mps = 10.0})
                .find("correction_mps 10 must be below max_speed_mps, which is 10"),
            std::string::npos);
  EXPECT_NE(refusal({.deviation_mps = 0.5, .correction_mps2 = 5.0, .correction_mps = 1.0})
                .find("correction_mps2 5 must be below max_acceleration_mps2, which is 5"),
            std::string::npos);
  EXPECT_NE(refusal({.sensing_error_m = 0.1,
                     .deviation_mps = 1.0 - 1e-13,
                     .correction_mps2 = 1.0,
                     .correction_mps = 1.0})
                .find("the tube would have no bound to speak of"),
            std::string::npos);
}

TEST(Tube, OnTheGroundNoMessageMayGetLost) {
  const std::string said =
      refusal({.loop = LoopPlace::kGround}, {.period_s = 0.1, .longest_loss = 2});
  EXPECT_NE(said.find("longest_loss is 2"), std::string::npos) << said;
  EXPECT_NE(said.find("it must be 0"), std::string::npos) << said;
  EXPECT_NE(said.find("on board"), std::string::npos) << said;
  EXPECT_EQ(refusal({}, {.period_s = 0.1, .longest_loss = 2}), "");
}

TEST(Tube, FiguresThatAreNoneAreRefused) {
  for (const double bad : {-1.0, kNan, kInfinity, 1e31}) {
    EXPECT_NE(refusal({.report_error_m = bad}).find("report_error_m"), std::string::npos);
    EXPECT_NE(refusal({.report_age_s = bad}).find("report_age_s"), std::string::npos);
    EXPECT_NE(refusal({.sensing_error_m = bad}).find("sensing_error_m"), std::string::npos);
    EXPECT_NE(refusal({.loop_period_s = bad}).find("loop_period_s"), std::string::npos);
    EXPECT_NE(refusal({.loop_delay_s = bad}).find("loop_delay_s"), std::string::npos);
    EXPECT_NE(refusal({.deviation_mps = bad}).find("deviation_mps"), std::string::npos);
    EXPECT_NE(refusal({.clock_error_s = bad}).find("clock_error_s"), std::string::npos);
    EXPECT_NE(refusal({.correction_mps2 = bad}).find("correction_mps2"), std::string::npos);
    EXPECT_NE(refusal({.correction_mps = bad}).find("correction_mps"), std::string::npos);
    EXPECT_NE(refusal({}, {.period_s = bad}).find("period_s"), std::string::npos);
    EXPECT_NE(refusal({}, {}, {bad, 5.0}).find("max_speed_mps"), std::string::npos);
  }
  EXPECT_NE(refusal({}, {.period_s = 0.0}).find("period_s is 0"), std::string::npos);
  EXPECT_NE(refusal({}, {.command_delay = 0}).find("command_delay is 0"), std::string::npos);
  EXPECT_NE(refusal({}, {.command_delay = 33}).find("command_delay is 33"), std::string::npos);
  EXPECT_NE(refusal({}, {.longest_loss = -1}).find("longest_loss is -1"), std::string::npos);
  EXPECT_NE(refusal({}, {}, {10.0, 0.0}).find("max_acceleration_mps2 is 0"), std::string::npos);
  EXPECT_NE(refusal({.loop = static_cast<LoopPlace>(7)}).find("loop is number 7"),
            std::string::npos);
  EXPECT_EQ(refusal({}, {}, {10.0, kInfinity}), "");
}

}  // namespace
}  // namespace beespace
