// What advise() refuses: with which code, at which place, in which words.
#include <beespace/advise.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kBees = 5;

const std::vector<double> kOutsideValues = {
    std::nextafter(kLargestInMotion, kInfinity), -std::nextafter(kLargestInMotion, kInfinity),
    std::nextafter(kSmallestInMotion, 0.0), std::numeric_limits<double>::denorm_min()};

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

// Of both ways to ask; the Adviser has answered before, and answers after.
void expect_refused(const Question& question, ErrorCode code, std::optional<std::uint64_t> record,
                    const std::string& words) {
  const auto check = [&](const Error& error) {
    EXPECT_EQ(error.code, code);
    EXPECT_EQ(error.place.record, record);
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
  const Status again = adviser.advise(movers, preferred, limits, options, advised);
  ASSERT_FALSE(again);
  check(again.error());
  ASSERT_TRUE(adviser.advise(good.movers, good.preferred, good.limits, good.options, advised));
  EXPECT_EQ(advised.advice.size(), kBees);
}

void expect_refused(const Question& question, const std::string& words) {
  expect_refused(question, ErrorCode::kInvalidArgument, std::nullopt, words);
}

TEST(AdviceRefusal, AThresholdThatMakesNoSense) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    Question question;
    question.options.threshold_m = bad;
    expect_refused(question, ErrorCode::kInvalidThreshold, std::nullopt, "the threshold is ");
  }
}

TEST(AdviceRefusal, AStepOrAnUncertaintyThatMakesNoSense) {
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

// Whether or not there are obstacles and intruders.
TEST(AdviceRefusal, AClearanceOrAHorizonThatMakesNoSense) {
  const ObstacleMap map;
  for (const double bad : {0.0, -1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    SCOPED_TRACE(bad);
    for (const ObstacleMap* obstacles : {static_cast<const ObstacleMap*>(nullptr), &map}) {
      Question question;
      question.options.obstacles = obstacles;
      question.options.clearance_m = bad;
      expect_refused(question, "the clearance is ");
      question.options.clearance_m = 1.0;
      question.options.intruder_horizon_s = bad;
      expect_refused(question, "the horizon of intruders is ");
    }
  }
}

TEST(AdviceRefusal, IntrudersThatAreNotFiniteOrOutsideTheDomain) {
  const auto check = [](double bad, ErrorCode code) {
    for (const bool is_velocity : {false, true}) {
      for (const std::size_t intruder : {std::size_t{0}, std::size_t{6}}) {
        SCOPED_TRACE(testing::Message() << bad << ", " << is_velocity << ", " << intruder);
        std::vector<Mover> intruders(7, Mover{{1e3, 0, 0}, {0, 1, 0}});
        (is_velocity ? intruders[intruder].velocity.y : intruders[intruder].position.y) = bad;
        intruders[6].position.z = intruder == 6 ? 0.0 : bad;  // the first is said
        Question question;
        question.options.intruders = intruders;
        expect_refused(question, code, intruder,
                       is_velocity ? "intruder: velocity y" : "intruder: position y");
      }
    }
  };
  for (const double bad : {kNan, kInfinity, -kInfinity}) check(bad, ErrorCode::kNotFinite);
  for (const double bad : kOutsideValues) check(bad, ErrorCode::kOutsideDomain);
}

TEST(AdviceRefusal, IntrudersWithHeightsApartFromPositions) {
  const std::vector<Mover> intruders(3, Mover{{1e3, 0, 0}, {}});
  const MoversView plain(intruders);
  const std::vector<double> heights(3, 1.0);
  Question question;
  question.options.intruders = MoversView(plain.positions(), plain.velocities(), heights, heights);
  expect_refused(question, "heights");
}

TEST(AdviceRefusal, LimitsThatMakeNoSense) {
  for (const double bad : {-1.0, kNan, kInfinity, -kInfinity, 0x1p-101, 0x1p+101}) {
    for (const std::size_t bee : {std::size_t{0}, std::size_t{3}}) {
      SCOPED_TRACE(bad);
      Question question;
      question.limits[bee].max_speed_mps = bad;
      expect_refused(question, ErrorCode::kInvalidArgument, bee, "the greatest speed is ");
      question = {};
      question.limits = {{bad, 1.0}};
      expect_refused(question, "the greatest speed is ");
    }
  }
  for (const double bad : {0.0, -1.0, kNan, -kInfinity, 0x1p-101, 0x1p+101}) {
    for (const std::size_t bee : {std::size_t{0}, std::size_t{3}}) {
      SCOPED_TRACE(bad);
      Question question;
      question.limits[bee].max_acceleration_mps2 = bad;
      expect_refused(question, ErrorCode::kInvalidArgument, bee, "the greatest acceleration is ");
      question = {};
      question.limits = {{1.0, bad}};
      expect_refused(question, "the greatest acceleration is ");
    }
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

struct Field {
  const char* words;
  double& (*of)(Question&, std::size_t bee);
};
const Field kFields[] = {
    {"position x",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].position.x; }},
    {"position y",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].position.y; }},
    {"position z",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].position.z; }},
    {"velocity x",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].velocity.x; }},
    {"velocity y",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].velocity.y; }},
    {"velocity z",
     [](Question& q, std::size_t bee) -> double& { return q.movers[bee].velocity.z; }},
    {"preferred velocity x",
     [](Question& q, std::size_t bee) -> double& { return q.preferred[bee].x; }},
    {"preferred velocity y",
     [](Question& q, std::size_t bee) -> double& { return q.preferred[bee].y; }},
    {"preferred velocity z",
     [](Question& q, std::size_t bee) -> double& { return q.preferred[bee].z; }}};

TEST(AdviceRefusal, NumbersThatAreNotFiniteOrOutsideTheDomain) {
  for (const Field& field : kFields) {
    for (const std::size_t bee : {std::size_t{0}, std::size_t{2}, kBees - 1}) {
      SCOPED_TRACE(field.words);
      for (const double bad : {kNan, kInfinity, -kInfinity}) {
        Question question;
        field.of(question, bee) = bad;
        field.of(question, kBees - 1) = bad;  // the first is said
        expect_refused(question, ErrorCode::kNotFinite, bee, field.words);
      }
      for (const double bad : kOutsideValues) {
        Question question;
        field.of(question, bee) = bad;
        expect_refused(question, ErrorCode::kOutsideDomain, bee, field.words);
      }
    }
  }
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

// More movers than ids: the view claims them, and its size is looked at before they are.
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
