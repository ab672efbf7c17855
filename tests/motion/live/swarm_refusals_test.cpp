// What a live swarm refuses, with which code and at which place; and that it goes on afterwards.
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_unusable(const SwarmOptions& options, ErrorCode code) {
  Swarm swarm(options);
  for (int again = 0; again < 2; ++again) {
    const Status taken = swarm.update({1, 0.0, {0, 0, 0}});
    ASSERT_FALSE(taken.has_value());
    EXPECT_EQ(taken.error().code, code);
    const auto events = swarm.advance(0.0);
    ASSERT_FALSE(events.has_value());
    EXPECT_EQ(events.error().code, code);
    EXPECT_FALSE(events.error().message.empty());
  }
  swarm.remove(1);
  EXPECT_EQ(swarm.counts().taken, 0U);
}

TEST(SwarmRefusal, InvalidOptions) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, 0x1.1p+100, 0x1p-101}) {
    SwarmOptions options;
    options.threshold_m = bad;
    expect_unusable(options, ErrorCode::kInvalidThreshold);
    options = {.threshold_m = 100.0};
    options.vertical_m = bad;
    expect_unusable(options, ErrorCode::kInvalidThreshold);
    options = {.threshold_m = 100.0};
    options.max_age_s = bad;
    expect_unusable(options, ErrorCode::kInvalidArgument);
    options = {.threshold_m = 100.0};
    options.leave_factor = bad;
    expect_unusable(options, ErrorCode::kInvalidArgument);
    if (bad == 0.0) continue;
    options = {.threshold_m = 100.0};
    options.horizon_s = bad;
    expect_unusable(options, ErrorCode::kInvalidArgument);
  }
  SwarmOptions options{.threshold_m = 100.0};
  options.leave_factor = std::nextafter(1.0, 0.0);
  expect_unusable(options, ErrorCode::kInvalidArgument);
  options = {.threshold_m = 100.0};
  options.heights_apart = true;  // apart from what?
  expect_unusable(options, ErrorCode::kInvalidArgument);
}

struct Field {
  const char* name;
  std::function<void(PositionReport&, double)> set;
};

std::vector<Field> fields() {
  return {{"time", [](PositionReport& report, double value) { report.time_s = value; }},
          {"x", [](PositionReport& report, double value) { report.position.x = value; }},
          {"y", [](PositionReport& report, double value) { report.position.y = value; }},
          {"z", [](PositionReport& report, double value) { report.position.z = value; }},
          {"velocity",
           [](PositionReport& report, double value) {
             report.velocity = Velocity{0, value, 0};
           }},
          {"height", [](PositionReport& report, double value) { report.height_m = value; }},
          {"climb", [](PositionReport& report, double value) { report.climb_mps = value; }}};
}

TEST(SwarmRefusal, ReportsThatAreNotFiniteOrOutsideTheDomainAreLeftOut) {
  SwarmOptions options{.threshold_m = 100.0};
  options.vertical_m = 5.0;
  options.heights_apart = true;
  Swarm swarm(options);
  for (const Field& field : fields()) {
    for (const double bad : {kNan, kInfinity, -kInfinity, 0x1.1p+100, -0x1.1p+100}) {
      SCOPED_TRACE(field.name);
      PositionReport report{42, 1.0, {1, 2, 3}};
      field.set(report, bad);
      const Status taken = swarm.update(report);
      ASSERT_FALSE(taken.has_value()) << bad;
      EXPECT_EQ(taken.error().code,
                std::isfinite(bad) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite);
      EXPECT_EQ(taken.error().location.record, 42U);
    }
  }
  EXPECT_EQ(swarm.counts().taken, 0U);
  EXPECT_EQ(swarm.counts().agents, 0U);
  EXPECT_TRUE(swarm.update({42, 1.0, {1, 2, 3}}).has_value());
  EXPECT_EQ(swarm.counts().agents, 1U);
}

TEST(SwarmRefusal, TimeDoesNotGoBack) {
  Swarm swarm({.threshold_m = 100.0});
  ASSERT_TRUE(swarm.advance(10.0).has_value());
  ASSERT_TRUE(swarm.advance(10.0).has_value()) << "the same time again";
  const auto back = swarm.advance(std::nextafter(10.0, 0.0));
  ASSERT_FALSE(back.has_value());
  EXPECT_EQ(back.error().code, ErrorCode::kTimeOrder);
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    const auto never = swarm.advance(bad);
    ASSERT_FALSE(never.has_value());
    EXPECT_EQ(never.error().code, ErrorCode::kNotFinite);
  }
  EXPECT_EQ(swarm.advance(1e200).error().code, ErrorCode::kOutsideDomain);
  EXPECT_EQ(swarm.begin_anew(10.0, 1e200).error().code, ErrorCode::kOutsideDomain);
  EXPECT_EQ(swarm.begin_anew(10.0, kNan).error().code, ErrorCode::kNotFinite);
  EXPECT_TRUE(swarm.advance(11.0).has_value()) << "as if nothing had been asked";
}

}  // namespace
}  // namespace beespace
