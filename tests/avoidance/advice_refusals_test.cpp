// What advise() refuses: the error's code, place and sentence.
#include <beespace/advise.hpp>

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
constexpr std::size_t kBees = 5;

struct Question {
  std::vector<Mover> movers;
  std::vector<Velocity> preferred = std::vector<Velocity>(kBees, Velocity{1, 2, 3});
  std::vector<FlightLimits> limits = std::vector<FlightLimits>(kBees);
  AdviseOptions options{.threshold_m = 5.0, .clearance_m = 1.0};

  Question() {
    for (std::size_t bee = 0; bee < kBees; ++bee) {
      movers.push_back({{10.0 * static_cast<double>(bee), 0, 0}, {1, 0, 0}});
    }
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Both functions refuse: advise() and an Adviser, which has answered before and answers after.
void expect_refused(const Question& question, ErrorCode code, std::optional<std::uint64_t> record,
                    const std::string& words) {
  const auto check = [&](const Error& error) {
    EXPECT_EQ(error.code, code);
    EXPECT_EQ(error.location.record, record);
    EXPECT_TRUE(contains(error.message, words)) << error.message;
  };
  const auto& [movers, preferred, limits, options] = question;
  const auto once = advise(movers, preferred, limits, options);
  ASSERT_FALSE(once);
  check(once.error());
  const Question good;
  Adviser adviser;
  Advised advised;
  ASSERT_TRUE(adviser.advise(good.movers, good.preferred, good.limits, good.options, advised));
  ASSERT_TRUE(advised.advice[0].certified);
  const Status again = adviser.advise(movers, preferred, limits, options, advised);
  ASSERT_FALSE(again);
  check(again.error());
  // No certificate is left of an earlier answer.
  EXPECT_TRUE(advised.advice.empty());
  EXPECT_TRUE(advised.too_close.empty() && advised.refused.empty());
  ASSERT_TRUE(adviser.advise(good.movers, good.preferred, good.limits, good.options, advised));
  EXPECT_EQ(advised.advice.size(), kBees);
}

void expect_refused(const Question& question, const std::string& words) {
  expect_refused(question, ErrorCode::kInvalidArgument, std::nullopt, words);
}

TEST(AdviceRefusal, AnInvalidThreshold) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    Question question;
    question.options.threshold_m = bad;
    expect_refused(question, ErrorCode::kInvalidThreshold, std::nullopt, "the threshold is ");
  }
}

TEST(AdviceRefusal, AnInvalidStepOrUncertainty) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    Question question;
    question.options.step_s = bad;
    expect_refused(question, "the step is ");
    if (bad == 0.0) continue;
    question = {};
    question.options.uncertainty_m = bad;
    expect_refused(question, "the uncertainty is ");
  }
}

// With and without obstacles, intruders and unknown bees.
TEST(AdviceRefusal, AnInvalidClearanceOrHorizon) {
  const ObstacleMap map;
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    for (const ObstacleMap* obstacles : {static_cast<const ObstacleMap*>(nullptr), &map}) {
      Question question;
      question.options.obstacles = obstacles;
      question.options.clearance_m = bad;
      if (std::isnan(bad)) {  // not given: without obstacles it need not be
        if (obstacles != nullptr) expect_refused(question, "the clearance from them is not given");
      } else {
        expect_refused(question, "the clearance is ");
      }
      question.options.clearance_m = 1.0;
      question.options.intruder_horizon_s = bad;
      expect_refused(question, "the horizon of intruders is ");
      question.options.intruder_horizon_s = 1.0;
      question.options.unknown_horizon_s = bad;
      expect_refused(question, "the horizon of unknown bees is ");
    }
  }
}

TEST(AdviceRefusal, IntrudersWithHeightsApartFromPositions) {
  const std::vector<Mover> intruders(3, Mover{{1e3, 0, 0}, {}});
  const MoversView plain(intruders);
  const std::vector<double> heights(3, 1.0);
  Question question;
  question.options.intruders = MoversView(plain.positions(), plain.velocities(), heights, heights);
  expect_refused(question, "heights");
}

// One set of limits for all bees. (Where each bee has its own, the bee with bad ones is named: see
// bad_bee_test.)
TEST(AdviceRefusal, InvalidLimits) {
  for (const double bad : {-1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    Question question;
    question.limits = {{bad, 1.0}};
    expect_refused(question, "the greatest speed is ");
  }
  for (const double bad : {0.0, -1.0, kNan, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    Question question;
    question.limits = {{1.0, bad}};
    expect_refused(question, "the greatest acceleration is ");
  }
}

TEST(AdviceRefusal, AnInvalidMethod) {
  for (const int number : {3, 4, 77, 255}) {
    Question question;
    question.options.method = static_cast<AdviseMethod>(number);
    expect_refused(question, "the method is number " + std::to_string(number) + ", which is none");
  }
}

TEST(AdviceRefusal, AnUnknownBeeThatIsNotAmongTheMovers) {
  for (const PointId bee : {PointId{kBees}, PointId{0xFFFFFFFF}}) {
    const std::vector<UnknownAgent> unknown = {{{}, 1.0, 1.0, PointId{0}}, {{}, 1.0, 1.0, bee}};
    Question question;
    question.options.unknown = unknown;
    expect_refused(question, "unknown bee 1 is said to be mover " + std::to_string(bee) + " of 5");
  }
}

// Data that does not fit together is refused, not dropped silently.
TEST(AdviceRefusal, ViewsWhoseArraysDoNotFitTogether) {
  const std::vector<Point> places(kBees, Point{});
  const std::vector<Point> fewer(kBees - 1);
  const std::vector<double> three = {1, 2, 3};
  const std::span<const double> numbers(three);
  const PointsView ragged = PointsView::separate(numbers, numbers.first(2), numbers.first(1));
  struct Case {
    MoversView view;
    const char* words;
  };
  const Case cases[] = {{{places, fewer}, "5 positions and 4 velocities"},
                        {{fewer, places}, "4 positions and 5 velocities"},
                        {{ragged, ragged}, "positions: 3 numbers for x, 2 for y and 1 for z"},
                        {{std::span(fewer).first(1), ragged}, "velocities: 3 numbers for x"}};
  for (const auto& [view, words] : cases) {
    Question question;
    question.options.intruders = view;
    expect_refused(question, std::string("intruders: ") + words);
    question = {};
    question.preferred.resize(view.size());
    const auto refused =
        advise(view, question.preferred, {question.limits.data(), 1}, question.options);
    ASSERT_FALSE(refused) << words;
    EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
    EXPECT_TRUE(contains(refused.error().message, words)) << refused.error().message;
  }
}

TEST(AdviceRefusal, SpansOfTheWrongLength) {
  for (const std::size_t size : {std::size_t{0}, kBees - 1, kBees + 1}) {
    Question question;
    question.preferred.resize(size);
    expect_refused(question, " preferred velocities for 5 movers");
    question = {};
    question.limits.resize(size);
    expect_refused(question, " sets of limits for 5 movers");
  }
  const FlightLimits two[2];
  const AdviseOptions options{.threshold_m = 5.0};
  EXPECT_FALSE(advise({}, {}, two, options));
  const Velocity wish;
  EXPECT_FALSE(advise({}, {&wish, 1}, two, options));
}

// A claim that cannot be is refused alone; the others are advised as without that agent.
TEST(AdviceRefusal, AClaimThatCannotBe) {
  const Point nowhere[] = {{20, 0, 0}, {20, kNan, 0}};
  const std::vector<std::pair<Claim, std::string>> bad = {
      {{.places = nowhere}, "claim: place 1: "},
      {{.tube_m = -0.5}, "claim: the radius of the tube is -0.5 m; give a finite distance"},
      {{.tube_m = kInfinity}, "claim: the radius of the tube is inf m"},
      {{.radius_m = kNan}, "claim: the agent's radius is nan m"}};
  for (const auto& [claim, words] : bad) {
    Question question;
    std::vector<Claim> claims(kBees);
    claims[2] = claim;
    question.options.claims = claims;
    const auto& [movers, preferred, limits, options] = question;
    const auto advised = advise(movers, preferred, limits, options);
    ASSERT_TRUE(advised) << advised.error().message;
    ASSERT_EQ(advised->refused.size(), 1U) << words;
    EXPECT_EQ(advised->refused[0].index, 2U);
    EXPECT_EQ(advised->refused[0].error.location.array, "claims");
    EXPECT_TRUE(contains(advised->refused[0].error.message, words))
        << advised->refused[0].error.message;
    for (std::size_t bee = 0; bee < kBees; ++bee) {
      EXPECT_EQ(advised->advice[bee].kind == AdviceKind::kNone, bee == 2) << words << bee;
    }
  }
  Question question;
  const std::vector<Claim> claims(kBees - 1);
  question.options.claims = claims;
  expect_refused(question, ErrorCode::kInvalidArgument, std::nullopt, "4 claims for 5 movers");
}

TEST(AdviceRefusal, HeightsApartFromPositions) {
  const Question question;
  const MoversView plain(question.movers);
  const std::vector<double> heights(kBees, 1.0);
  const MoversView view(plain.positions(), plain.velocities(), heights, heights);
  const auto refused = advise(view, question.preferred, question.limits, question.options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
  EXPECT_TRUE(contains(refused.error().message, "heights")) << refused.error().message;
}

// More movers than ids: the view constrains them, and its size is checked before they are.
TEST(AdviceRefusal, MoreMoversThanIds) {
  const double x = 0.0;
  const PointsView many = PointsView::strided(&x, &x, &x, kMaxPoints + 1, 0);
  const auto refused =
      advise(MoversView(many, many), {}, std::vector<FlightLimits>(1), {.threshold_m = 5.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kTooManyPoints);
}

}  // namespace
}  // namespace beespace
