// How close is too close is never guessed: every question refuses options without a threshold.
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

const std::vector<Point> kPoints = {{0, 0, 0}, {1, 0, 0}, {50, 0, 0}};
const std::vector<Mover> kMovers = {{{0, 0, 0}, {1, 0, 0}}, {{9, 0, 0}, {-1, 0, 0}}};

template <class Answer>
void expect_refused(const Answer& answer) {
  ASSERT_FALSE(answer.has_value());
  EXPECT_EQ(answer.error().code, ErrorCode::kInvalidThreshold);
  EXPECT_NE(answer.error().message.find("the threshold is not given"), std::string::npos)
      << answer.error().message;
}

TEST(ForgottenThreshold, IsRefusedInASnapshot) {
  for (const bool vertical : {false, true}) {
    SCOPED_TRACE(vertical);
    SearchOptions options;
    if (vertical) options.vertical_m = 5.0;
    expect_refused(find_at_risk(kPoints, options));
    expect_refused(find_pairs(kPoints, options));
    expect_refused(visit_pairs(kPoints, options, [](auto) { return true; }));
    expect_refused(find_neighbors(kPoints, options));
    expect_refused(count_neighbors(kPoints, options));
    expect_refused(find_conflict_groups(kPoints, options));
    expect_refused(find_nearest_within(kPoints, options));
    expect_refused(find_at_risk_between(kPoints, kPoints, options));
    expect_refused(find_pairs_between(kPoints, kPoints, options));
    expect_refused(find_neighbors_between(kPoints, kPoints, options));
    expect_refused(count_neighbors_between(kPoints, kPoints, options));
    expect_refused(find_nearest_within_between(kPoints, kPoints, options));
  }
}

TEST(ForgottenThreshold, IsRefusedByBruteForce) {
  const SearchOptions options;
  expect_refused(brute_force::find_at_risk(kPoints, options));
  expect_refused(brute_force::find_pairs(kPoints, options));
  expect_refused(brute_force::find_neighbors(kPoints, options));
  expect_refused(brute_force::count_neighbors(kPoints, options));
  expect_refused(brute_force::find_conflict_groups(kPoints, options));
  expect_refused(brute_force::find_nearest_within(kPoints, options));
  expect_refused(brute_force::find_at_risk_between(kPoints, kPoints, options));
  expect_refused(brute_force::find_pairs_between(kPoints, kPoints, options));
  expect_refused(brute_force::find_neighbors_between(kPoints, kPoints, options));
  expect_refused(brute_force::count_neighbors_between(kPoints, kPoints, options));
  expect_refused(brute_force::find_nearest_within_between(kPoints, kPoints, options));
  expect_refused(brute_force::predict_conflicts(kMovers, {}));
  expect_refused(brute_force::find_conflicts({}, {}));
}

TEST(ForgottenThreshold, IsRefusedByAnIndex) {
  const Index index = *Index::build(kPoints);
  expect_refused(index.find_around(kPoints, AroundOptions{}));
}

TEST(ForgottenThreshold, IsRefusedInMotion) {
  expect_refused(closest_approach(kMovers[0], kMovers[1], {}));
  expect_refused(predict_conflicts(kMovers, {}));
  expect_refused(predict_pairs(kMovers, {}));
  expect_refused(find_conflicts({}, {}));
  Swarm swarm{SwarmOptions{}};
  expect_refused(swarm.update({0, 0.0, {0, 0, 0}}));
  expect_refused(swarm.advance(1.0));
}

TEST(ForgottenThreshold, IsRefusedInAdviceAndVerification) {
  expect_refused(advise(kMovers, std::vector<Velocity>(2), std::vector<FlightLimits>(1), {}));
  expect_refused(Verifier(VerifyOptions{}).add(0.0, kMovers));
}

// The clearance of obstacles is required too, if there are any.
TEST(ForgottenThreshold, OfObstaclesIsRefused) {
  const ObstacleMap map;
  const auto advised = advise(kMovers, std::vector<Velocity>(2), std::vector<FlightLimits>(1),
                              {.threshold_m = 5.0, .obstacles = &map});
  ASSERT_FALSE(advised.has_value());
  EXPECT_NE(advised.error().message.find("clearance"), std::string::npos);
  const Status added = Verifier({.threshold_m = 5.0, .obstacles = &map}).add(0.0, kMovers);
  ASSERT_FALSE(added.has_value());
  EXPECT_NE(added.error().message.find("clearance"), std::string::npos);
}

TEST(ForgottenThreshold, NeedsNotBeGivenWhereNoneIsAskedFor) {
  EXPECT_TRUE(find_nearest(kPoints).has_value());
  EXPECT_TRUE(find_closest_pair(kPoints).has_value());
  EXPECT_TRUE(find_nearest_between(kPoints, kPoints).has_value());
  EXPECT_TRUE(find_closest_pair_between(kPoints, kPoints).has_value());
  EXPECT_TRUE(brute_force::find_nearest(kPoints).has_value());
  EXPECT_TRUE(brute_force::find_closest_pair(kPoints).has_value());
  EXPECT_TRUE(find_closest_encounter({}).has_value());
}

}  // namespace
}  // namespace beespace
