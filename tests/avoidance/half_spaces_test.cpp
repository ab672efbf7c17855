// The convex program, compared with one that tries every set of half-spaces that may bind.
#include "avoidance/constraints/half_spaces.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
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
using test::long_of;
using test::LongVector;

struct Program {
  Vector3 wish;
  std::vector<HalfSpace> half_spaces;
  Ball ball;
};

// The nearest point on the planes of up to three half-spaces, in or on the ball. `slack` enlarges
// all of them and the ball (below zero: shrinks).
class EveryActiveSet {
 public:
  EveryActiveSet(const Program& program, double slack)
      : program_(program),
        wish_(long_of(program.wish)),
        center_(long_of(program.ball.center)),
        radius_(static_cast<long double>(program.ball.radius) + static_cast<long double>(slack)),
        slack_(static_cast<long double>(slack)) {
    if (radius_ < 0.0L) return;
    const std::size_t size = program.half_spaces.size();
    try_place(into_ball(wish_, center_, radius_));
    for (std::size_t i = 0; i < size; ++i) {
      try_plane(i);
      for (std::size_t j = i + 1; j < size; ++j) {
        try_line(i, j);
        for (std::size_t k = j + 1; k < size; ++k) try_corner(i, j, k);
      }
    }
  }

  [[nodiscard]] const std::optional<LongVector>& best() const { return best_; }
  [[nodiscard]] double distance() const { return static_cast<double>(length(*best_ - wish_)); }

 private:
  static LongVector into_ball(const LongVector& x, const LongVector& center, long double radius) {
    const LongVector from = x - center;
    const long double far = length(from);
    return far > radius ? center + from * (radius / far) : x;
  }
  [[nodiscard]] LongVector normal(std::size_t i) const {
    const LongVector n = long_of(program_.half_spaces[i].normal);
    return n * (1.0L / length(n));
  }
  [[nodiscard]] long double offset(std::size_t i) const {
    return static_cast<long double>(program_.half_spaces[i].offset) - slack_;
  }

  void try_place(const LongVector& x) {
    constexpr long double kRounding = 1e-13L;
    if (length(x - center_) > radius_ + kRounding) return;
    for (std::size_t i = 0; i < program_.half_spaces.size(); ++i) {
      if (test::dot(normal(i), x) < offset(i) - kRounding) return;
    }
    if (!best_ || length(x - wish_) < length(*best_ - wish_)) best_ = x;
  }

  void try_plane(std::size_t i) {
    const LongVector n = normal(i);
    const long double height = offset(i) - test::dot(n, center_);
    const long double squared = radius_ * radius_ - height * height;
    if (squared < 0.0L) return;
    const LongVector on_plane = wish_ + n * (offset(i) - test::dot(n, wish_));
    try_place(into_ball(on_plane, center_ + n * height, std::sqrt(squared)));
  }

  void try_line(std::size_t i, std::size_t j) {
    const LongVector way = test::cross(normal(i), normal(j));
    const long double squared = test::dot(way, way);
    if (squared < 1e-24L) return;
    const LongVector point =
        (test::cross(normal(j), way) * offset(i) + test::cross(way, normal(i)) * offset(j)) *
        (1.0L / squared);
    const LongVector unit = way * (1.0L / std::sqrt(squared));
    const long double along = test::dot(point - center_, unit);
    const LongVector middle = point - unit * along;
    const LongVector off = middle - center_;
    const long double half = radius_ * radius_ - test::dot(off, off);
    if (half < 0.0L) return;
    const long double reach = std::sqrt(half);
    try_place(middle + unit * std::clamp(test::dot(wish_ - middle, unit), -reach, reach));
  }

  void try_corner(std::size_t i, std::size_t j, std::size_t k) {
    const LongVector ij = test::cross(normal(i), normal(j));
    const LongVector jk = test::cross(normal(j), normal(k));
    const LongVector ki = test::cross(normal(k), normal(i));
    const long double volume = test::dot(ij, normal(k));
    if (std::abs(volume) < 1e-12L) return;
    try_place((jk * offset(i) + ki * offset(j) + ij * offset(k)) * (1.0L / volume));
  }

  const Program& program_;
  LongVector wish_;
  LongVector center_;
  long double radius_;
  long double slack_;
  std::optional<LongVector> best_;
};

// Half-spaces whose planes lie `depth` inside the ball's surface at most, or outside it.
Program random_program(RandomStream& random, std::size_t size, double depth) {
  Program program;
  program.ball = {direction(random) * random.uniform(0.0, 2.0), 1.0};
  program.wish = program.ball.center + direction(random) * random.uniform(0.0, 3.0);
  for (std::size_t i = 0; i < size; ++i) {
    const Vector3 n = direction(random);
    program.half_spaces.push_back(
        {n, dot(n, program.ball.center) + random.uniform(-1.2, depth - 1.0)});
  }
  return program;
}

struct Tally {
  int found = 0;
  int none = 0;
};

// An answer is at most `outside` of any half-space. It is missing only where the feasible set has
// less room than `tolerance`. The optimum is known where no planes are nearly parallel: lines and
// corners of such planes are not tried.
void check(const Program& program, double tolerance, double outside, Tally& tally) {
  const auto found = nearest_place(program.wish, program.half_spaces, program.ball);
  const EveryActiveSet relaxed(program, tolerance);
  const EveryActiveSet tight(program, -tolerance);
  ++(found ? tally.found : tally.none);
  if (!found) {
    ASSERT_FALSE(tight.best()) << "there is a place, with room around it";
    return;
  }
  for (const HalfSpace& side : program.half_spaces) ASSERT_GE(side.inside_by(*found), -outside);
  ASSERT_LE(length(*found - program.ball.center), program.ball.radius * (1.0 + 1e-12));
  const double distance = length(*found - program.wish);
  if (outside <= tolerance * 1e-3) {
    ASSERT_TRUE(relaxed.best()) << "there is no place";
    ASSERT_GE(distance, relaxed.distance() - 1e-12);
  }
  if (tight.best()) {
    ASSERT_LE(distance, tight.distance() + 1e-12);
  }
}

TEST(NearestPlace, OfRandomProgramsIsTheOptimum) {
  RandomStream random(11);
  Tally tally;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    const std::size_t size = random.index(9);
    const Program program = random_program(random, size, random.uniform(0.2, 1.8));
    ASSERT_NO_FATAL_FAILURE(check(program, 1e-9, 1e-12, tally)) << "round " << round;
    const EveryActiveSet exact(program, 0.0);
    const auto found = nearest_place(program.wish, program.half_spaces, program.ball);
    if (!exact.best() || !found) continue;
    ASSERT_LE(static_cast<double>(test::length(long_of(*found) - *exact.best())), 1e-6)
        << "round " << round;
  }
  EXPECT_GT(tally.found, test::rounds(20'000) / 4);
  EXPECT_GT(tally.none, test::rounds(20'000) / 40);
}

TEST(NearestPlace, OfManyHalfSpaces) {
  RandomStream random(12);
  Tally tally;
  for (int round = 0; round < test::rounds(200); ++round) {
    const Program program = random_program(random, 30, random.uniform(0.2, 1.0));
    ASSERT_NO_FATAL_FAILURE(check(program, 1e-9, 1e-12, tally)) << "round " << round;
  }
  EXPECT_GT(tally.found, 0);
}

// Planes that are equal, opposed, or turned a little, as neighbours in rows cause.
TEST(NearestPlace, OfNearlyParallelPlanes) {
  RandomStream random(13);
  Tally tally;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    Program program = random_program(random, 2, 1.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfSpace like = program.half_spaces[random.index(2)];
      const double angle = random.index(3) == 0 ? 0.0 : std::exp(random.uniform(-40.0, -2.0));
      Vector3 n = like.normal + direction(random) * angle;
      n = n * (1.0 / length(n));
      if (random.index(3) == 0) n = -n;
      const double at = dot(n, program.ball.center) + random.uniform(-1.0, 0.3);
      program.half_spaces.push_back(
          {n, random.index(3) == 0 ? dot(n, like.normal) * like.offset : at});
    }
    // Planes count as parallel up to an angle of 1e-9. The line in which two planes meet at such an
    // angle is known to a rounding divided by the angle.
    ASSERT_NO_FATAL_FAILURE(check(program, 1e-6, 1e-6, tally)) << "round " << round;
  }
  EXPECT_GT(tally.found, 0);
  EXPECT_GT(tally.none, 0);
}

TEST(NearestPlace, WithoutHalfSpacesIsTheBallAlone) {
  const Ball ball{{1, 2, 3}, 2.0};
  EXPECT_EQ(nearest_place({1, 2, 4}, {}, ball), (Vector3{1, 2, 4}));
  EXPECT_EQ(nearest_place({1, 2, 13}, {}, ball), (Vector3{1, 2, 5}));
  EXPECT_EQ(nearest_place({1, 2, 13}, {}, {{1, 2, 3}, 0.0}), (Vector3{1, 2, 3}));
}

TEST(NearestPlace, OnAPlaneALineAndACorner) {
  const Ball ball{{0, 0, 0}, 10.0};
  const HalfSpace x{{-1, 0, 0}, -1.0};  // x <= 1
  const HalfSpace y{{0, -1, 0}, -2.0};
  const HalfSpace z{{0, 0, -1}, -3.0};
  EXPECT_EQ(nearest_place({5, 5, 5}, std::vector{x}, ball), (Vector3{1, 5, 5}));
  EXPECT_EQ(nearest_place({5, 5, 5}, std::vector{x, y}, ball), (Vector3{1, 2, 5}));
  EXPECT_EQ(nearest_place({5, 5, 5}, std::vector{x, y, z}, ball), (Vector3{1, 2, 3}));
  EXPECT_EQ(nearest_place({0, 0, 0}, std::vector{x, y, z}, ball), (Vector3{0, 0, 0}));
}

TEST(NearestPlace, IsReportedMissingWhereThereIsNone) {
  const Ball ball{{0, 0, 0}, 1.0};
  EXPECT_FALSE(nearest_place({0, 0, 0}, std::vector<HalfSpace>{{{1, 0, 0}, 1.5}}, ball));
  EXPECT_FALSE(nearest_place({0, 0, 0},
                             std::vector<HalfSpace>{{{1, 0, 0}, 0.5}, {{-1, 0, 0}, -0.25}}, ball));
  // Each two have points in common.
  const double s = std::sqrt(0.75);
  EXPECT_FALSE(nearest_place(
      {0, 0, 0},
      std::vector<HalfSpace>{{{1, 0, 0}, 0.25}, {{-0.5, s, 0}, 0.25}, {{-0.5, -s, 0}, 0.25}},
      ball));
}

// Half-spaces are ordered by id. In any order the answer is the same except for rounding.
TEST(NearestPlace, IsTheSameInEveryOrder) {
  RandomStream random(14);
  for (int round = 0; round < test::rounds(2'000); ++round) {
    Program program = random_program(random, 8, random.uniform(0.2, 0.9));
    const auto found = nearest_place(program.wish, program.half_spaces, program.ball);
    std::reverse(program.half_spaces.begin(), program.half_spaces.end());
    const auto other = nearest_place(program.wish, program.half_spaces, program.ball);
    ASSERT_EQ(found.has_value(), other.has_value()) << "round " << round;
    if (found) {
      ASSERT_LE(length(*found - *other), 1e-7) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace beespace::avoidance
