// What every query refuses, in every variant, and the place that the error names.
#include "tests/contract/backward_crew.hpp"
#include "tests/contract/variants.hpp"

#include <beespace/point.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr Question kOneSet[] = {
    Question::kAtRisk,    Question::kPairs,         Question::kVisitedPairs,
    Question::kNeighbors, Question::kCounts,        Question::kGroups,
    Question::kNearest,   Question::kNearestWithin, Question::kClosestPair};
constexpr Question kTwoSets[] = {Question::kAtRiskBetween,     Question::kPairsBetween,
                                 Question::kNeighborsBetween,  Question::kCountsBetween,
                                 Question::kNearestBetween,    Question::kNearestWithinBetween,
                                 Question::kClosestPairBetween};

bool needs_threshold(Question question) {
  return question != Question::kNearest && question != Question::kClosestPair &&
         question != Question::kNearestBetween && question != Question::kClosestPairBetween;
}

Answer refusal(ErrorCode code, std::optional<std::uint64_t> record = {}, const char* array = "") {
  ErrorLocation location;
  location.array = array;
  location.record = record;
  return flat(Error{code, {}, location});
}

std::vector<Point> plain_points() {
  SceneMaker make(4);
  return make.box(60, {-5, -5, -5}, {5, 5, 5});
}

std::vector<Variant> all_variants() {
  return {brute_force_reference(),
          public_functions(1),
          public_functions(8),
          public_functions_of_strided_points(),
          engine_with_threads(2),
          engine_with_crew("EngineWithCrew", std::make_shared<BackwardCrew>(5))};
}

class Refusals : public testing::TestWithParam<Variant> {
 protected:
  template <std::size_t kSize>
  static void expect(const Subject& subject, const Question (&questions)[kSize],
                     const Answer& expected) {
    for (const Question question : questions) {
      EXPECT_EQ(GetParam().ask({&subject, question, {2.0}}), expected) << name_of(question);
    }
  }

  // `value` is wrong on any axis, in either set, also behind another wrong one.
  static void expect_refusal(double value, ErrorCode code) {
    for (double Point::*axis : {&Point::x, &Point::y, &Point::z}) {
      Subject bad{"", plain_points(), {}, false, {}};
      bad.points[47].*axis = value;
      bad.points[31].*axis = value;
      expect(bad, kOneSet, refusal(code, 31, "points"));
      const Subject ours{"", bad.points, plain_points(), true, {}};
      expect(ours, kTwoSets, refusal(code, 31, "points"));
      const Subject theirs{"", plain_points(), bad.points, true, {}};
      expect(theirs, kTwoSets, refusal(code, 31, "others"));
    }
  }
};

TEST_P(Refusals, WhatIsNotFiniteIsReportedWithItsPlace) {
  for (const double value : {kNan, kInfinity, -kInfinity}) {
    expect_refusal(value, ErrorCode::kNotFinite);
  }
}

TEST_P(Refusals, SubnormalsAndAllBelowAndAboveTheDomainAreReportedWithTheirPlace) {
  for (const double value :
       {std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::min(),
        std::nextafter(kSmallestCoordinate_m, 0.0),
        -std::nextafter(kLargestCoordinate_m, kInfinity), std::numeric_limits<double>::max()}) {
    expect_refusal(value, ErrorCode::kOutsideDomain);
  }
}

TEST_P(Refusals, TheEndsOfTheDomainAreInsideIt) {
  Subject ends{"", plain_points(), {}, false, {}};
  ends.points[3] = {kSmallestCoordinate_m, -kSmallestCoordinate_m, -0.0};
  ends.points[9] = {kLargestCoordinate_m, -kLargestCoordinate_m, kLargestCoordinate_m};
  ends.others = ends.points;
  for (const Question question : kOneSet) {
    const Inquiry inquiry{&ends, question, {2.0}};
    EXPECT_EQ(GetParam().ask(inquiry), brute_force_reference().ask(inquiry)) << name_of(question);
  }
  ends.two_sets = true;
  for (const Question question : kTwoSets) {
    const Inquiry inquiry{&ends, question, {2.0}};
    EXPECT_EQ(GetParam().ask(inquiry), brute_force_reference().ask(inquiry)) << name_of(question);
  }
}

TEST_P(Refusals, AnInvalidThreshold) {
  for (const double threshold : {0.0, -1.0, kNan, kInfinity, std::nextafter(0x1p-400, 0.0),
                                 std::nextafter(0x1p+400, kInfinity)}) {
    const Subject one{"", plain_points(), {}, false, {}};
    for (const Question question : kOneSet) {
      if (!needs_threshold(question)) continue;
      EXPECT_EQ(GetParam().ask({&one, question, {threshold}}),
                refusal(ErrorCode::kInvalidThreshold))
          << name_of(question) << " " << threshold;
    }
    const Subject two{"", plain_points(), plain_points(), true, {}};
    for (const Question question : kTwoSets) {
      if (!needs_threshold(question)) continue;
      EXPECT_EQ(GetParam().ask({&two, question, {threshold}}),
                refusal(ErrorCode::kInvalidThreshold))
          << name_of(question) << " " << threshold;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Everything, Refusals, testing::ValuesIn(all_variants()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace beespace::test
