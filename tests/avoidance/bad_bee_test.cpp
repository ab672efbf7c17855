// One bee with invalid values never stops the advice. It is named and gets none, and no other bee
// is certified until a ball that contains it is given.
#include "tests/avoidance/flock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> kBadValues = {kNan, test::kNoLimit, -test::kNoLimit,
                                        std::nextafter(kLargestInMotion, test::kNoLimit), -1e200};
constexpr std::size_t kBees = 5;

struct Question {
  std::vector<Mover> movers;
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits = std::vector<FlightLimits>(kBees, FlightLimits{10.0, 5.0});
  AdviseOptions options{.threshold_m = 5.0};

  Question() {
    for (std::size_t bee = 0; bee < kBees; ++bee) {
      const auto x = 20.0 * static_cast<double>(bee);
      movers.push_back({{x, 1.0, -2.0}, {1, 0, 0.5}});
      preferred.push_back({0, static_cast<double>(bee), 1});
    }
  }
  [[nodiscard]] Advised ask() const {
    const auto advised = advise(movers, preferred, limits, options);
    EXPECT_TRUE(advised);
    return advised ? *advised : Advised{};
  }
  // The same question without a bee.
  [[nodiscard]] Question without(std::size_t bee) const {
    Question rest = *this;
    const auto at = static_cast<std::ptrdiff_t>(bee);
    rest.movers.erase(rest.movers.begin() + at);
    rest.preferred.erase(rest.preferred.begin() + at);
    rest.limits.erase(rest.limits.begin() + at);
    return rest;
  }
};

// The others get the advice that they get without the bee, except for what they are clear of.
void expect_others_advised(const Advised& advised, const Question& question, std::size_t bee,
                           bool clear) {
  const Advised rest = question.without(bee).ask();
  ASSERT_EQ(advised.advice.size(), kBees);
  for (std::size_t other = 0; other < kBees; ++other) {
    SCOPED_TRACE("bee " + std::to_string(other));
    const Advice& given = advised.advice[other];
    if (other == bee) {
      EXPECT_EQ(given, Advice{});
      EXPECT_EQ(given.kind, AdviceKind::kNone);
      continue;
    }
    const Advice& alone = rest.advice[other < bee ? other : other - 1];
    EXPECT_EQ(given.velocity, alone.velocity);
    EXPECT_EQ(given.kind, alone.kind);
    EXPECT_EQ(given.keeps_apart, alone.keeps_apart);
    EXPECT_TRUE(alone.certified);
    EXPECT_EQ(given.certified, clear);
    EXPECT_EQ(given.clear_of_unknown, clear);
    EXPECT_EQ(given.clear_of_unknown_s > 0.0, clear);
    EXPECT_TRUE(given.clear_of_intruders);
  }
}

struct Field {
  const char* words;
  double& (*of)(Question&, std::size_t bee);
};
const Field kStateFields[] = {
    {"position x", [](Question& q, std::size_t i) -> double& { return q.movers[i].position.x; }},
    {"position y", [](Question& q, std::size_t i) -> double& { return q.movers[i].position.y; }},
    {"position z", [](Question& q, std::size_t i) -> double& { return q.movers[i].position.z; }},
    {"velocity x", [](Question& q, std::size_t i) -> double& { return q.movers[i].velocity.x; }},
    {"velocity y", [](Question& q, std::size_t i) -> double& { return q.movers[i].velocity.y; }},
    {"velocity z", [](Question& q, std::size_t i) -> double& { return q.movers[i].velocity.z; }},
    {"the greatest speed",
     [](Question& q, std::size_t i) -> double& { return q.limits[i].max_speed_mps; }}};

TEST(BadBee, IsNamedAndTheOthersAreAdvised) {
  for (const Field& field : kStateFields) {
    for (const std::size_t bee : {std::size_t{0}, std::size_t{2}, kBees - 1}) {
      for (const double bad : kBadValues) {
        SCOPED_TRACE(testing::Message() << field.words << ' ' << bad << " bee " << bee);
        Question question;
        field.of(question, bee) = bad;
        const Advised advised = question.ask();
        ASSERT_EQ(advised.refused.size(), 1U);
        EXPECT_EQ(advised.refused[0].kind, RefusedKind::kState);
        EXPECT_EQ(advised.refused[0].index, bee);
        EXPECT_EQ(advised.refused[0].error.location.record, bee);
        EXPECT_NE(advised.refused[0].error.message.find(field.words), std::string::npos);
        expect_others_advised(advised, question, bee, false);
      }
    }
  }
}

TEST(BadBee, AnInvalidLimitOfAcceleration) {
  for (const double bad : {0.0, -1.0, kNan, 1e-320}) {
    Question question;
    question.limits[1].max_acceleration_mps2 = bad;
    const Advised advised = question.ask();
    ASSERT_EQ(advised.refused.size(), 1U);
    expect_others_advised(advised, question, 1, false);
  }
}

// If a ball that contains it is given, the others are certified, and nothing else is wrong.
TEST(BadBee, ThatIsKnownToBeInABallLeavesTheOthersCertified) {
  for (const std::size_t bee : {std::size_t{0}, std::size_t{2}, kBees - 1}) {
    Question question;
    question.movers[bee].position.x = kNan;
    const std::vector<UnknownAgent> unknown = {
        {{1e4, 0, 0}, 30.0, 12.0, static_cast<PointId>(bee)}};
    question.options.unknown = unknown;
    const Advised advised = question.ask();
    EXPECT_TRUE(advised.refused.empty());
    Question none = question;
    none.options.unknown = {};
    ASSERT_EQ(advised.advice.size(), kBees);
    for (std::size_t other = 0; other < kBees; ++other) {
      EXPECT_EQ(advised.advice[other].certified, other != bee);
      EXPECT_EQ(advised.advice[other].kind == AdviceKind::kNone, other == bee);
    }
  }
}

// An invalid ball carries no information.
TEST(BadBee, AnInvalidBallIsNamed) {
  for (const double bad : kBadValues) {
    for (const int field : {0, 1, 2}) {
      UnknownAgent ball{{1e4, 0, 0}, 1.0, 1.0, PointId{3}};
      (field == 0 ? ball.center.y : field == 1 ? ball.radius_m : ball.growth_mps) = bad;
      const std::vector<UnknownAgent> unknown = {{{9e3, 0, 0}, 1.0, 0.0, {}}, ball};
      Question question;
      question.options.unknown = unknown;
      const Advised advised = question.ask();
      ASSERT_EQ(advised.refused.size(), 1U);
      EXPECT_EQ(advised.refused[0].kind, RefusedKind::kUnknown);
      EXPECT_EQ(advised.refused[0].index, 1U);
      Question rest = question;
      rest.options.unknown = {};
      expect_others_advised(advised, rest, 3, false);
    }
  }
}

TEST(BadBee, AnInvalidWishCountsAsStanding) {
  for (const double bad : kBadValues) {
    Question question;
    question.preferred[2].y = bad;
    const Advised advised = question.ask();
    ASSERT_EQ(advised.refused.size(), 1U);
    EXPECT_EQ(advised.refused[0].kind, RefusedKind::kPreferred);
    EXPECT_EQ(advised.refused[0].index, 2U);
    question.preferred[2] = {};
    EXPECT_EQ(advised.advice, question.ask().advice);
  }
}

TEST(BadBee, AnInvalidIntruderLeavesNoBeeClear) {
  for (const double bad : kBadValues) {
    for (const bool is_velocity : {false, true}) {
      std::vector<Mover> intruders(3, Mover{{1e4, 0, 0}, {0, 1, 0}});
      intruders[2].position = {80.0, 2.0, 1.0};  // close to the last bee
      (is_velocity ? intruders[1].velocity.y : intruders[1].position.y) = bad;
      Question question;
      question.options.intruders = intruders;
      const Advised advised = question.ask();
      ASSERT_EQ(advised.refused.size(), 1U);
      EXPECT_EQ(advised.refused[0].kind, RefusedKind::kIntruder);
      EXPECT_EQ(advised.refused[0].index, 1U);
      ASSERT_FALSE(advised.intruder_conflicts.empty());
      EXPECT_EQ(advised.intruder_conflicts[0].intruder, 2U);
      for (const Advice& advice : advised.advice) {
        EXPECT_FALSE(advice.certified);
        EXPECT_FALSE(advice.clear_of_intruders);
        EXPECT_TRUE(advice.keeps_apart);
        EXPECT_TRUE(advice.clear_of_unknown);
      }
    }
  }
}

// The numbers of the others stay those of the input, where some bees are left out.
TEST(BadBee, TheOthersKeepTheirNumbers) {
  Question question;
  question.movers[0].velocity.z = kNan;
  question.movers[2].position.x = kNan;
  question.movers[4].position = question.movers[3].position;
  question.movers[4].position.y += 2.0;
  const Advised advised = question.ask();
  ASSERT_EQ(advised.refused.size(), 2U);
  ASSERT_EQ(advised.too_close.size(), 1U);
  EXPECT_EQ(advised.too_close[0].pair, (Pair{3, 4}));
  EXPECT_EQ(advised.advice[2], Advice{});
  EXPECT_NE(advised.advice[1].kind, AdviceKind::kNone);
  EXPECT_TRUE(advised.advice[1].keeps_apart);
  EXPECT_FALSE(advised.advice[3].keeps_apart);
}

// A bee at the limit of the domain does not affect the bees that are together.
TEST(BadBee, AFarAwayBeeWidensNothing) {
  for (const double far : {1e12, 1e20, kLargestInMotion}) {
    Question question;
    question.movers[4].position = {far, -far, far};
    const Advised advised = question.ask();
    const Advised rest = question.without(4).ask();
    EXPECT_TRUE(advised.too_close.empty()) << far;
    for (std::size_t bee = 0; bee + 1 < kBees; ++bee) {
      EXPECT_TRUE(advised.advice[bee].certified) << far;
      EXPECT_EQ(advised.advice[bee], rest.advice[bee]) << far;
    }
  }
}

}  // namespace
}  // namespace beespace
