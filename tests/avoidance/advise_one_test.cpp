// One agent that is advised alone, from what it knows of those around it, gets the same bits as in
// the call for all.
#include "tests/avoidance/claimed_flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::ClaimedFlock;

struct Round {
  std::vector<Mover> movers;
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits;
  std::vector<Claim> claims;
  Advised advised;

  [[nodiscard]] AgentInRound agent(PointId id) const {
    AgentInRound agent{id, movers[id], preferred[id], limits[id]};
    if (!claims.empty()) agent.claim = &claims[id];
    agent.too_close = std::any_of(
        advised.too_close.begin(), advised.too_close.end(),
        [&](const TooClose& close) { return close.pair.first == id || close.pair.second == id; });
    return agent;
  }
  // Those near it, and a few others: these change nothing.
  [[nodiscard]] std::vector<AgentInRound> others(PointId id, double within_m,
                                                 RandomStream& random) const {
    std::vector<AgentInRound> others;
    for (PointId other = 0; other < movers.size(); ++other) {
      if (other == id) continue;
      const double far_m = test::distance_of(movers[id].position, movers[other].position);
      if (far_m < within_m || random.index(10) == 0) others.push_back(agent(other));
    }
    for (std::size_t k = others.size(); k > 1; --k) {
      std::swap(others[k - 1], others[random.index(static_cast<std::uint32_t>(k))]);
    }
    return others;
  }
};

Separation shape_of(std::size_t which) {
  if (which == 1) return {SeparationShape::kEllipsoid, 3.0};
  if (which == 2) return {SeparationShape::kCylinder, 1.0, 3.0};
  return {};
}

// Dense, so that some are too close; with claims or without.
TEST(AdviseOne, GivesTheSameBitsAsTheCallForAll) {
  std::size_t deflected = 0;
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 6U : 60U); ++seed) {
    RandomStream random(seed);
    const std::size_t bees = 60;
    const bool has_claims = random.index(3) != 0;
    AdviseOptions options{.threshold_m = 3.0, .separation = shape_of(random.index(3))};
    options.step_s = 0.2;
    options.threads = 1 + static_cast<unsigned>(random.index(3));
    const double side_m = random.uniform(40.0, 200.0);
    const double off_m = random.index(2) == 0 ? 0.0 : 1e6;
    const std::vector<Mover> intruders = {{{off_m + 5.0, 5.0, 5.0}, {3.0, 4.0, 0.0}}};
    if (random.index(2) == 0) options.intruders = intruders;
    const std::vector<UnknownAgent> unknown = {{{off_m + 20.0, 20.0, 20.0}, 1.0, 1.0}};
    if (random.index(2) == 0) options.unknown = unknown;
    const std::vector<Fence> fences = {{{1.0, 0.0, 0.0}, off_m - 5.0}};
    if (random.index(2) == 0) options.fences = fences, options.clearance_m = 1.0;
    Round round;
    std::vector<std::vector<Point>> places(bees);
    const auto at = [&](double from) { return from + random.uniform(0.0, side_m); };
    for (std::size_t k = 0; k < bees; ++k) {
      round.movers.push_back({{at(off_m), at(0.0), at(0.0)}, test::random_velocity(random, 5.0)});
      round.limits.push_back({random.uniform(3.0, 10.0), random.uniform(2.0, 8.0)});
      if (random.index(15) == 0) round.limits.back().max_acceleration_mps2 = test::kNoLimit;
    }
    const bool one_is_far = random.index(3) == 0;
    if (one_is_far) round.movers[3].velocity = {200.0, 10.0, 0.0};  // reaches far
    PlaneMemory memory;
    std::vector<PlaneMemory> own(bees);
    Adviser adviser;
    Adviser alone;
    for (int step = 0; step < 6; ++step) {
      round.preferred.clear();
      round.claims.clear();
      for (std::size_t k = 0; k < bees; ++k) {
        const bool idle = random.index(4) == 0;
        round.preferred.push_back(test::random_velocity(random, idle ? 0.5 : 10.0));
        places[k].clear();
        for (std::size_t p = random.index(6); p > 0; --p) {
          places[k].push_back(
              test::plus(round.movers[k].position, test::random_velocity(random, 4.0), 1.0));
        }
        if (!has_claims) continue;
        round.claims.push_back(
            {places[k], random.uniform(0.0, 0.5), random.uniform(0.0, 3.0), random.index(10) == 0});
      }
      options.claims = round.claims;
      options.planes = &memory;
      ASSERT_TRUE(
          adviser.advise(round.movers, round.preferred, round.limits, options, round.advised));
      AdviseOptions on_board = options;
      on_board.claims = {};
      for (PointId id = 0; id < bees; ++id) {
        on_board.planes = &own[id];
        Advice advice;
        const Status status = alone.advise_one(
            round.agent(id), round.others(id, one_is_far ? 1e6 : 100.0, random), on_board, advice);
        ASSERT_TRUE(status) << status.error().message;
        ASSERT_EQ(advice, round.advised.advice[id]) << "seed " << seed << ", agent " << id;
        deflected += advice.kind == AdviceKind::kDeflected ? 1U : 0U;
      }
      for (std::size_t k = 0; k < bees; ++k) {
        round.movers[k] =
            test::flown(round.movers[k], round.advised.advice[k].velocity,
                        std::isinf(round.limits[k].max_acceleration_mps2), options.step_s);
      }
    }
  }
  EXPECT_GT(deflected, 100U);
}

TEST(AdviseOne, RefusesTwoOfOneIdAndClaimsOfSomeOnly) {
  Adviser adviser;
  Advice advice;
  AdviseOptions options{.threshold_m = 5.0};
  const AgentInRound agent{3, {}, {}, {}};
  const std::vector<AgentInRound> same = {{3, {{20, 0, 0}, {}}, {}, {}}};
  const Status twice = adviser.advise_one(agent, same, options, advice);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().message, "agent 3 is there twice; give each agent once");
  const Claim claim;
  const std::vector<AgentInRound> other = {{4, {{20, 0, 0}, {}}, {}, {}, &claim}};
  const Status some = adviser.advise_one(agent, other, options, advice);
  ASSERT_FALSE(some);
  EXPECT_EQ(some.error().message,
            "agent 4 has a claim, unlike agent 3; give the claims of all, or of none");
}

}  // namespace
}  // namespace beespace
