// What a Verifier refuses; and that it continues from its last valid state.
#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<Mover> plain_movers() {
  return {{{0, 0, 0}, {1, 0, 0}}, {{100, 0, 0}, {0, 1, 0}}, {{0, 200, 0}, {0, 0, 1}}};
}

void expect_refused(const Status& status, ErrorCode code,
                    std::optional<std::uint64_t> record = std::nullopt) {
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, code) << status.error().message;
  EXPECT_EQ(status.error().location.record, record) << status.error().message;
  EXPECT_FALSE(status.error().message.empty());
}

TEST(VerifierRefusal, AnInvalidThreshold) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    VerifyOptions options;
    options.threshold_m = bad;
    Verifier verifier(options);
    expect_refused(verifier.add(0.0, plain_movers()), ErrorCode::kInvalidThreshold);
    expect_refused(verifier.add(1.0, plain_movers()), ErrorCode::kInvalidThreshold);
    expect_refused(Verifier(options).add(0.0, {}), ErrorCode::kInvalidThreshold);
    EXPECT_EQ(verifier.verdict().steps, 0U);
  }
}

TEST(VerifierRefusal, LimitsBelowZero) {
  for (const double bad : {-1.0, -0x1p-1000, kNan, -kInfinity}) {
    VerifyOptions options{.threshold_m = 5.0};
    options.max_speed_mps = bad;
    expect_refused(Verifier(options).add(0.0, plain_movers()), ErrorCode::kInvalidArgument);
    options = {.threshold_m = 5.0};
    options.max_acceleration_mps2 = bad;
    expect_refused(Verifier(options).add(0.0, plain_movers()), ErrorCode::kInvalidArgument);
  }
}

// Whether or not there are obstacles; but where there are none it need not be given.
TEST(VerifierRefusal, AnInvalidClearance) {
  const ObstacleMap map;
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p+101}) {
    SCOPED_TRACE(bad);
    VerifyOptions options{.threshold_m = 5.0};
    options.clearance_m = bad;
    EXPECT_EQ(Verifier(options).add(0.0, plain_movers()).has_value(), std::isnan(bad));
    options.obstacles = &map;
    expect_refused(Verifier(options).add(0.0, {}), ErrorCode::kInvalidArgument);
  }
}

TEST(VerifierRefusal, TimesThatDoNotGoOn) {
  Verifier verifier({.threshold_m = 5.0});
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    expect_refused(verifier.add(bad, plain_movers()), ErrorCode::kNotFinite);
  }
  ASSERT_TRUE(verifier.add(7.0, plain_movers()));
  for (const double bad : {7.0, 6.999, -1.0}) {
    expect_refused(verifier.add(bad, plain_movers()), ErrorCode::kTimeOrder);
  }
  for (const double bad : {kNan, kInfinity}) {
    expect_refused(verifier.add(bad, plain_movers()), ErrorCode::kNotFinite);
  }
  EXPECT_TRUE(verifier.add(7.5, plain_movers()));
  EXPECT_EQ(verifier.verdict().steps, 1U);
}

TEST(VerifierRefusal, AnotherNumberOfMovers) {
  Verifier verifier({.threshold_m = 5.0});
  ASSERT_TRUE(verifier.add(0.0, plain_movers()));
  std::vector<Mover> others = plain_movers();
  others.pop_back();
  expect_refused(verifier.add(1.0, others), ErrorCode::kInvalidArgument);
  others.resize(4);
  expect_refused(verifier.add(1.0, others), ErrorCode::kInvalidArgument);
  expect_refused(verifier.add(1.0, {}), ErrorCode::kInvalidArgument);
  EXPECT_TRUE(verifier.add(1.0, plain_movers()));
}

struct Field {
  const char* name;
  double& (*of)(Mover&);
};
const Field kFields[] = {{"position x", [](Mover& mover) -> double& { return mover.position.x; }},
                         {"position y", [](Mover& mover) -> double& { return mover.position.y; }},
                         {"position z", [](Mover& mover) -> double& { return mover.position.z; }},
                         {"velocity x", [](Mover& mover) -> double& { return mover.velocity.x; }},
                         {"velocity y", [](Mover& mover) -> double& { return mover.velocity.y; }},
                         {"velocity z", [](Mover& mover) -> double& { return mover.velocity.z; }}};

// At the beginning, and in the middle of a flight that goes on.
void expect_refused_anywhere(const Field& field, double bad, ErrorCode code) {
  for (const std::size_t record : {std::size_t{0}, std::size_t{2}}) {
    SCOPED_TRACE(testing::Message() << field.name << " of " << record << " is " << bad);
    std::vector<Mover> movers = plain_movers();
    field.of(movers[record]) = bad;
    Verifier verifier({.threshold_m = 5.0});
    expect_refused(verifier.add(0.0, movers), code, record);
    ASSERT_TRUE(verifier.add(0.0, plain_movers()));
    expect_refused(verifier.add(1.0, movers), code, record);
    EXPECT_EQ(verifier.verdict().steps, 0U);
    EXPECT_TRUE(verifier.verdict().holds());
    EXPECT_TRUE(verifier.add(1.0, plain_movers()));
    EXPECT_EQ(verifier.verdict().steps, 1U);
  }
}

TEST(VerifierRefusal, NumbersThatAreNotFinite) {
  for (const Field& field : kFields) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
      expect_refused_anywhere(field, bad, ErrorCode::kNotFinite);
    }
  }
}

TEST(VerifierRefusal, NumbersOutsideTheDomain) {
  for (const Field& field : kFields) {
    for (const double bad : {0x1p+101, -0x1p+101, 1e200}) {
      expect_refused_anywhere(field, bad, ErrorCode::kOutsideDomain);
    }
  }
}

// Values too small for the domain are checked as they are.
TEST(VerifierRefusal, TinyNumbersAreNone) {
  for (const double tiny : {0x1p-101, -9e-32, 1e-320}) {
    Verifier verifier({.threshold_m = 5.0});
    std::vector<Mover> movers = plain_movers();
    movers[0] = {{tiny, tiny, -tiny}, {-tiny, tiny, tiny}};
    EXPECT_TRUE(verifier.add(0.0, movers));
    movers[0].position = {-tiny, 0, tiny};
    EXPECT_TRUE(verifier.add(1.0, movers));
    EXPECT_TRUE(verifier.verdict().holds());
    EXPECT_FALSE(verifier.verdict().closest_m);
  }
  // Nor is a loss between two that are tiny distances apart.
  Verifier verifier({.threshold_m = 0x1p-100});
  const std::vector<Mover> close = {{{0x1p-103, 0, 0}, {}}, {{0, 0x1p-102, 0}, {}}};
  EXPECT_TRUE(verifier.add(0.0, close));
  EXPECT_TRUE(verifier.add(0x1p+90, close));
  EXPECT_EQ(verifier.verdict().losses, 1U);
}

// Steps that no time in the domain lasts.
TEST(VerifierRefusal, StepsThatLastNextToNothing) {
  for (const double time_s : {1e-320, 0x1p-101, 1e200}) {
    Verifier verifier({.threshold_m = 5.0});
    EXPECT_TRUE(verifier.add(0.0, plain_movers()));
    expect_refused(verifier.add(time_s, plain_movers()), ErrorCode::kInvalidArgument);
    EXPECT_TRUE(verifier.add(1.0, plain_movers()));
    EXPECT_EQ(verifier.verdict().steps, 1U);
  }
}

// Velocities of straight flights are not used.
TEST(VerifierRefusal, VelocitiesOfStraightFlightsAreNotLookedAt) {
  VerifyOptions options{.threshold_m = 5.0};
  options.straight = true;
  Verifier verifier(options);
  std::vector<Mover> movers = plain_movers();
  movers[1].velocity = {kNan, 0, 0};
  EXPECT_TRUE(verifier.add(0.0, movers));
  EXPECT_TRUE(verifier.add(1.0, movers));
}

// The input lies in the domain; if results computed from it do not, the input is not at fault.
TEST(VerifierRefusal, ALittleMoveInALongTimeCountsAsNone) {
  Verifier verifier({.threshold_m = 5.0});
  ASSERT_TRUE(verifier.add(0.0, std::vector<Mover>{{{0, 0, 0}, {}}}));
  const Status slow = verifier.add(1e6, std::vector<Mover>{{{1e-29, 0, 0}, {}}});
  EXPECT_TRUE(slow) << slow.error().message;
}

TEST(VerifierRefusal, AVerifierCanBeMoved) {
  Verifier verifier({.threshold_m = 5.0});
  ASSERT_TRUE(verifier.add(0.0, plain_movers()));
  Verifier other = std::move(verifier);
  ASSERT_TRUE(other.add(1.0, plain_movers()));
  EXPECT_EQ(other.verdict().steps, 1U);
}

}  // namespace
}  // namespace beespace
