// What closest_approach and the predictions refuse: the error's code, place and sentence; and that
// the limits of the domain are inside it.
#include "tests/motion/recorded/conflict_lists.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/closest_approach.hpp>
#include <beespace/engine.hpp>
#include <beespace/predict_conflicts.hpp>

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

const PredictOptions kSome{.threshold_m = 100.0};
const std::vector<double> kNotFiniteValues = {kNan, kInfinity, -kInfinity};
const std::vector<double> kOutsideValues = {
    std::nextafter(kLargestInMotion, kInfinity), -std::nextafter(kLargestInMotion, kInfinity),
    -std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

std::vector<Mover> plain_movers(std::size_t size) {
  test::SceneMaker make(7);
  std::vector<Mover> movers;
  for (const Point& p : make.box(size, {-5, -5, -5}, {5, 5, 5})) movers.push_back({p, {1, 2, 3}});
  return movers;
}

struct Field {
  const char* name;
  const char* unit;
  double& (*of)(Mover&);
};
const Field kFields[] = {
    {"position x", "m", [](Mover& mover) -> double& { return mover.position.x; }},
    {"position y", "m", [](Mover& mover) -> double& { return mover.position.y; }},
    {"position z", "m", [](Mover& mover) -> double& { return mover.position.z; }},
    {"velocity x", "m/s", [](Mover& mover) -> double& { return mover.velocity.x; }},
    {"velocity y", "m/s", [](Mover& mover) -> double& { return mover.velocity.y; }},
    {"velocity z", "m/s", [](Mover& mover) -> double& { return mover.velocity.z; }}};

// The error of one function.
using Refusal = std::optional<Error>;
template <class Answer>
Refusal error_of(const Answer& answer) {
  return answer.has_value() ? Refusal() : Refusal(answer.error());
}

// The error of all predictions, which is the same; an Engine has answered before.
std::vector<Refusal> prediction_refusals(const MoversView& movers, const PredictOptions& options) {
  static Engine engine;
  static std::vector<Conflict> conflicts;
  static std::vector<Pair> pairs;
  const std::vector<Mover> plain = plain_movers(20);
  EXPECT_TRUE(engine.predict_pairs(plain, kSome, pairs));
  return {error_of(predict_conflicts(movers, options)), error_of(predict_pairs(movers, options)),
          error_of(engine.predict_conflicts(movers, options, conflicts)),
          error_of(engine.predict_pairs(movers, options, pairs)),
          error_of(brute_force::predict_conflicts(movers, options))};
}

// The errors of all functions, which are the same.
template <class Check>
void for_each_error(const std::vector<Mover>& movers, const PredictOptions& options,
                    Check&& check) {
  ASSERT_GE(movers.size(), 2U);
  const auto approach = closest_approach(movers[0], movers[1], options.approach());
  if (movers.size() == 2) {
    ASSERT_FALSE(approach.has_value());
    check(approach.error());
  }
  for (const Refusal& refusal : prediction_refusals(movers, options)) {
    ASSERT_TRUE(refusal.has_value());
    check(*refusal);
  }
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_option_error(const PredictOptions& options, ErrorCode code, const std::string& words) {
  for_each_error(plain_movers(2), options, [&](const Error& error) {
    EXPECT_EQ(error.code, code);
    EXPECT_FALSE(error.location.record.has_value());
    EXPECT_TRUE(contains(error.message, words)) << error.message;
    EXPECT_TRUE(contains(error.message, "give a finite") ||
                contains(error.message, "not given (or is not a number)"))
        << error.message;
  });
}

TEST(MotionRefusal, AnInvalidThreshold) {
  for (const double bad :
       {0.0, -1.0, kNan, kInfinity, -kInfinity, std::nextafter(kSmallestInMotion, 0.0),
        std::nextafter(kLargestInMotion, kInfinity)}) {
    SCOPED_TRACE(bad);
    PredictOptions options;
    options.threshold_m = bad;
    expect_option_error(options, ErrorCode::kInvalidThreshold, "the threshold is ");
    options.threshold_m = 1.0;
    options.vertical_m = bad;
    expect_option_error(options, ErrorCode::kInvalidThreshold, "the vertical threshold is ");
  }
}

TEST(MotionRefusal, AnInvalidHorizon) {
  for (const double bad :
       {-1.0, -0x1p-100, kNan, kInfinity, -kInfinity, std::nextafter(kSmallestInMotion, 0.0),
        std::nextafter(kLargestInMotion, kInfinity)}) {
    SCOPED_TRACE(bad);
    PredictOptions options{.threshold_m = 100.0};
    options.horizon_s = bad;
    expect_option_error(options, ErrorCode::kInvalidArgument, "the horizon is ");
  }
}

// Every field, of the first, one in the middle and the last, alone or before another wrong one.
void expect_refused(double bad, ErrorCode code) {
  for (const Field& field : kFields) {
    for (const std::size_t size : {std::size_t{2}, std::size_t{100}}) {
      for (const std::size_t record : {std::size_t{0}, std::size_t{1}, size / 2, size - 1}) {
        std::vector<Mover> movers = plain_movers(size);
        field.of(movers[record]) = bad;
        field.of(movers.back()) = bad;
        for_each_error(movers, kSome, [&](const Error& error) {
          EXPECT_EQ(error.code, code) << field.name;
          EXPECT_EQ(error.location.record, record) << field.name;
          EXPECT_TRUE(contains(error.message, field.name)) << error.message;
          const bool says_unit = contains(error.message, std::string(" ") + field.unit + ",");
          EXPECT_EQ(says_unit, code == ErrorCode::kOutsideDomain) << error.message;
        });
      }
    }
  }
}

TEST(MotionRefusal, WhatIsNotFiniteIsReportedWithItsPlace) {
  for (const double bad : kNotFiniteValues) expect_refused(bad, ErrorCode::kNotFinite);
}

TEST(MotionRefusal, WhatLiesOutsideTheMotionDomainIsReportedWithItsPlace) {
  for (const double bad : kOutsideValues) expect_refused(bad, ErrorCode::kOutsideDomain);
}

// Workers share the check of movers before the search. No invalid mover is missed in any share, and
// the first one is reported.
TEST(MotionRefusal, WhatIsWrongIsFoundInEveryWorkersShare) {
  const std::size_t size = test::kSanitized ? 17'000 : 40'000;  // enough to be shared
  std::vector<Mover> movers = plain_movers(size);
  for (Mover& mover : movers) mover.position.x *= 1e6;
  const std::vector<double> heights(size, 1.0);
  Engine engine;
  std::vector<Conflict> conflicts;
  std::vector<Pair> pairs;
  PredictOptions options{.threshold_m = 1.0, .horizon_s = 1.0};
  const auto expect_error = [&](const MoversView& view, double bad, std::size_t record) {
    for (const unsigned threads : {1U, 3U}) {
      options.threads = threads;
      for (const Refusal& refusal : {error_of(engine.predict_conflicts(view, options, conflicts)),
                                     error_of(engine.predict_pairs(view, options, pairs))}) {
        ASSERT_TRUE(refusal.has_value());
        EXPECT_EQ(refusal->code,
                  std::isfinite(bad) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite);
        EXPECT_EQ(refusal->location.record, record);
      }
    }
  };
  for (const double bad : {kNan, kInfinity, -kInfinity, 0x1.1p+100, -0x1.1p+100, 0x1p+1000}) {
    for (const Field& field : kFields) {
      for (const std::size_t record : {std::size_t{0}, size / 2, size - 1}) {
        SCOPED_TRACE(std::string(field.name) + " of " + std::to_string(record));
        const double good = std::exchange(field.of(movers[record]), bad);
        expect_error(movers, bad, record);
        const MoversView view(movers);
        options.vertical_m = 2.0;
        expect_error({view.positions(), view.velocities(), heights, heights}, bad, record);
        options.vertical_m.reset();
        field.of(movers[record]) = good;
        if (HasFatalFailure()) return;
      }
    }
  }
  EXPECT_TRUE(engine.predict_pairs(movers, options, pairs)) << "nothing is wrong any more";
}

// Of several errors, options come first, then the first mover, then its position.
TEST(MotionRefusal, TheFirstErrorIsReported) {
  std::vector<Mover> movers = plain_movers(2);
  movers[0].velocity.y = kNan;
  movers[1].position.x = kInfinity;
  for_each_error(movers, kSome, [](const Error& error) { EXPECT_EQ(error.location.record, 0U); });
  movers[0].position.z = 1e31;
  for_each_error(movers, kSome, [](const Error& error) {
    EXPECT_EQ(error.code, ErrorCode::kOutsideDomain);
    EXPECT_TRUE(contains(error.message, "position z is ")) << error.message;
    EXPECT_TRUE(contains(error.message, "7.9e-31 to 1.3e+30 in magnitude")) << error.message;
  });
  PredictOptions options = kSome;
  options.horizon_s = -1.0;
  for_each_error(movers, options,
                 [](const Error& error) { EXPECT_EQ(error.code, ErrorCode::kInvalidArgument); });
}

TEST(MotionRefusal, TheEndsOfTheDomainAreInsideIt) {
  for (const double magnitude : {kSmallestInMotion, kLargestInMotion, 0.0}) {
    for (const double value : {magnitude, -magnitude}) {
      const Mover all{{value, value, value}, {value, value, value}};
      for (const double limit : {kSmallestInMotion, kLargestInMotion}) {
        for (const double horizon : {0.0, kSmallestInMotion, kLargestInMotion}) {
          PredictOptions options;
          options.threshold_m = limit;
          options.vertical_m = limit;
          options.horizon_s = horizon;
          const std::vector<Mover> movers = {all, all, {{1, 2, 3}, {}}};
          EXPECT_TRUE(closest_approach(all, movers[2], options.approach()).has_value());
          const auto brute = brute_force::predict_conflicts(movers, options);
          ASSERT_TRUE(brute.has_value());
          EXPECT_GE(brute->size(), 1U) << "two are at one place";
          test::expect_same(*predict_conflicts(movers, options), *brute);
          test::expect_same(*predict_pairs(movers, options), test::pairs_of(*brute));
        }
      }
    }
  }
}

TEST(MotionRefusal, OneResultMoreThanAllowed) {
  PredictOptions options{.threshold_m = 100.0};  // 100 m: all pairs
  const std::vector<Mover> movers = plain_movers(30);
  options.max_results = 30 * 29 / 2;
  EXPECT_EQ(predict_conflicts(movers, options).value().size(), options.max_results);
  EXPECT_EQ(predict_pairs(movers, options).value().size(), options.max_results);
  EXPECT_EQ(brute_force::predict_conflicts(movers, options).value().size(), options.max_results);
  --options.max_results;
  for (const Refusal& refusal : prediction_refusals(movers, options)) {
    ASSERT_TRUE(refusal.has_value());
    EXPECT_EQ(refusal->code, ErrorCode::kTooManyResults);
    EXPECT_TRUE(contains(refusal->message, "more than 434 results")) << refusal->message;
  }
}

TEST(MotionRefusal, HeightsWithoutAQuestionOrOfTheWrongNumber) {
  const std::vector<Mover> movers = plain_movers(10);
  const MoversView plain(movers);
  const auto expect_error = [&](std::size_t heights, std::size_t climbs, bool vertical,
                                const std::string& words) {
    const std::vector<double> heights_m(heights, 1.0);
    const std::vector<double> climbs_mps(climbs, 1.0);
    const MoversView view(plain.positions(), plain.velocities(), heights_m, climbs_mps);
    PredictOptions options{.threshold_m = 100.0};
    if (vertical) options.vertical_m = 2.0;
    for (const Refusal& refusal : prediction_refusals(view, options)) {
      ASSERT_TRUE(refusal.has_value()) << heights << " heights, " << climbs << " climb rates";
      EXPECT_EQ(refusal->code, ErrorCode::kInvalidArgument);
      EXPECT_TRUE(contains(refusal->message, words)) << refusal->message;
    }
  };
  expect_error(10, 10, false, "no vertical threshold");
  expect_error(9, 10, true, "9 heights and 10 climb rates for 10 movers");
  expect_error(10, 11, true, "10 heights and 11 climb rates for 10 movers");
  expect_error(10, 0, true, "10 heights and 0 climb rates for 10 movers");
  expect_error(0, 10, true, "0 heights and 10 climb rates for 10 movers");
}

TEST(MotionRefusal, HeightsAndClimbRatesOutsideTheDomain) {
  const std::vector<Mover> movers = plain_movers(10);
  const MoversView plain(movers);
  PredictOptions options{.threshold_m = 100.0};
  options.vertical_m = 2.0;
  for (const double bad : {kNan, kInfinity, 0x1.1p+100, -0x1.1p+100}) {
    for (const bool climbing : {false, true}) {
      std::vector<double> heights(10, 1.0);
      std::vector<double> climbs(10, -0.0);
      (climbing ? climbs : heights)[7] = bad;
      const MoversView view(plain.positions(), plain.velocities(), heights, climbs);
      for (const Refusal& refusal : prediction_refusals(view, options)) {
        ASSERT_TRUE(refusal.has_value());
        EXPECT_EQ(refusal->code,
                  std::isfinite(bad) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite);
        EXPECT_EQ(refusal->location.record, 7U);
        EXPECT_TRUE(contains(refusal->message, climbing ? "climb" : "height"));
      }
    }
  }
}

// More movers than ids: the view is that large, and its size is checked before its elements.
TEST(MotionRefusal, MoreMoversThanIds) {
  const Mover one;
  const double& x = one.position.x;
  const PointsView many = PointsView::strided(&x, &x, &x, kMaxPoints + 1, 0);
  const MoversView movers(many, many);
  for (const Refusal& refusal : prediction_refusals(movers, kSome)) {
    ASSERT_TRUE(refusal.has_value());
    EXPECT_EQ(refusal->code, ErrorCode::kTooManyPoints);
  }
}

}  // namespace
}  // namespace beespace
