// Requests that cannot all be met are relaxed by the same share, and the least: compared with
// trying all shares.
#include "avoidance/constraints/relaxed_qp.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;

struct Program {
  Vector3 wish;
  std::vector<HalfSpace> firm;
  std::vector<Request> requests;
  Ball ball;

  [[nodiscard]] std::optional<Vector3> solved() const {
    RelaxedQp program;
    return program.nearest(wish, firm, requests, ball);
  }
  // The half-space at this share; never beyond 0.999 of the ball's radius.
  [[nodiscard]] HalfSpace asked(const Request& request, double share) const {
    const double most = dot(request.side.normal, ball.center) + 0.999 * ball.radius;
    const double least = request.side.offset - request.yields;
    const double offset = std::min(request.side.offset, most);
    return {request.side.normal, offset - share * std::max(0.0, offset - least)};
  }
  [[nodiscard]] std::optional<Vector3> at(double share) const {
    std::vector<HalfSpace> all = firm;
    for (const Request& request : requests) all.push_back(asked(request, share));
    return nearest_place(wish, all, ball);
  }
  // The greatest share that any request is relaxed by at a point.
  [[nodiscard]] double share_at(const Vector3& place) const {
    double most = 0.0;
    for (const Request& request : requests) {
      const HalfSpace all = asked(request, 0.0);
      const double yields = all.offset - asked(request, 1.0).offset;
      const double missing = -all.inside_by(place);
      if (missing <= 1e-9 * ball.radius) continue;
      most = std::max(most, yields > 0.0 ? missing / yields : 2.0);
    }
    return most;
  }
};

Program random_program(RandomStream& random) {
  Program program;
  program.ball = {direction(random) * random.uniform(0.0, 3.0), random.uniform(0.1, 2.0)};
  program.wish = program.ball.center + direction(random) * random.uniform(0.0, 4.0);
  // Some point satisfies all hard constraints.
  const Vector3 place = program.ball.center + direction(random) * (0.9 * program.ball.radius);
  const auto side = [&](double from, double to) {
    const Vector3 n = direction(random);
    return HalfSpace{n, dot(n, place) + random.uniform(from, to)};
  };
  for (std::size_t k = random.index(4); k > 0; --k) program.firm.push_back(side(-1.0, -0.01));
  for (std::size_t k = random.index(5); k > 0; --k) {
    const HalfSpace asked = side(-0.5, random.index(4) == 0 ? 200.0 : 1.5);
    // Relaxed until the point satisfies it.
    const double yields = std::max(0.0, -asked.inside_by(place)) + random.uniform(0.01, 1.0);
    program.requests.push_back({asked, yields});
  }
  return program;
}

TEST(RelaxedQp, GivesUpTheLeastShareThatWillDo) {
  RandomStream random(1);
  int shared = 0;
  int met = 0;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    SCOPED_TRACE(round);
    const Program program = random_program(random);
    const auto found = program.solved();
    ASSERT_TRUE(found.has_value());
    ASSERT_LE(length(*found - program.ball.center), program.ball.radius * (1.0 + 1e-9));
    for (const HalfSpace& side : program.firm) ASSERT_GE(side.inside_by(*found), -1e-8);
    const double share = program.share_at(*found);
    ASSERT_LE(share, 1.0 + 1e-9);
    if (share <= 0.0) {
      ++met;
      const auto all = program.at(0.0);
      if (all) {
        ASSERT_LE(length(*all - *found), 1e-7);
      }
      continue;
    }
    ++shared;
    // A five-hundredth less is too little.
    ASSERT_FALSE(program.at(std::max(0.0, share - 1.0 / 400.0)).has_value());
  }
  EXPECT_GT(shared, test::rounds(20'000) / 20);
  EXPECT_GT(met, test::rounds(20'000) / 5);
}

// The least share by brute force: all of 500, each decided by the convex program.
TEST(RelaxedQp, IsAsTryingAllShares) {
  RandomStream random(2);
  int shared = 0;
  for (int round = 0; round < test::rounds(600); ++round) {
    const Program program = random_program(random);
    int least = 0;
    while (least < 512 && !program.at(least / 512.0)) ++least;
    const auto found = program.solved();
    ASSERT_TRUE(found.has_value());
    const auto expected = program.at(least / 512.0);
    ASSERT_TRUE(expected.has_value());
    if (least > 0) ++shared;
    ASSERT_LE(length(*found - *expected), 1e-7) << "round " << round << ", share " << least;
  }
  EXPECT_GT(shared, test::rounds(600) / 20);
}

TEST(RelaxedQp, SimpleCases) {
  RelaxedQp program;
  const Ball ball{{0, 0, 0}, 1.0};
  // No requests: the nearest point.
  EXPECT_EQ(program.nearest({0.5, 0, 0}, {}, {}, ball), (Vector3{0.5, 0, 0}));
  // One request, which is met.
  const std::vector<Request> one = {{{{1, 0, 0}, 0.75}, 10.0}};
  EXPECT_EQ(program.nearest({0.5, 0, 0}, {}, one, ball), (Vector3{0.75, 0, 0}));
  // Two opposed requests are relaxed equally.
  const std::vector<Request> two = {{{{1, 0, 0}, 0.75}, 1.5}, {{{-1, 0, 0}, 0.75}, 1.5}};
  const auto middle = program.nearest({0, 0.5, 0}, {}, two, ball);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->x, 0.0, 2.0 / 500.0);
  EXPECT_NEAR(middle->y, 0.5, 1e-9);
  // Requests far beyond the ball: met as far as possible.
  const std::vector<Request> far = {{{{1, 0, 0}, 1e6}, 1e6 + 1.0}};
  const auto most = program.nearest({0, 0, 0}, {}, far, ball);
  ASSERT_TRUE(most.has_value());
  EXPECT_NEAR(most->x, 0.999, 1e-9);
  // Hard constraints are not relaxed; where they cannot be met, there is no answer.
  const std::vector<HalfSpace> firm = {{{-1, 0, 0}, 0.25}};
  const auto kept = program.nearest({0, 0, 0}, firm, far, ball);
  ASSERT_TRUE(kept.has_value());
  EXPECT_LE(kept->x, -0.25 + 1e-9);
  EXPECT_FALSE(program.nearest({0, 0, 0}, std::vector<HalfSpace>{{{1, 0, 0}, 1.5}}, one, ball));
  // Or where a request may be relaxed too little.
  const std::vector<Request> proud = {{{{1, 0, 0}, 0.75}, 0.25}, {{{-1, 0, 0}, 0.75}, 0.25}};
  EXPECT_FALSE(program.nearest({0, 0, 0}, {}, proud, ball));
}

}  // namespace
}  // namespace beespace::avoidance
