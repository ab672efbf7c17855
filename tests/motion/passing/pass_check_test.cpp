// The pass check, on four pairs at a time, compared with doubles: pairs that it calls near are
// near; pairs that it calls far are far, by more than earlier rounding; and it decides almost all
// pairs.
#include "motion/passing/pass_check.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace beespace::motion {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
Vector along(const Vector& from, const Vector& way, double t) {
  return {from[0] + way[0] * t, from[1] + way[1] * t, from[2] + way[2] * t};
}

// Two balls as seen from the first, in units.
struct Relative {
  Vector middle;
  Vector move;
  double radii;

  Relative(const BallInGrid& a, const BallInGrid& b)
      : middle{double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z},
        move{double{b.move_x} - a.move_x, double{b.move_y} - a.move_y, double{b.move_z} - a.move_z},
        radii(double{a.radius} + b.radius) {}

  [[nodiscard]] double closest() const {
    const double squared = dot(move, move);
    const double t = squared > 0.0 ? std::clamp(-dot(middle, move) / squared, -1.0, 1.0) : 0.0;
    return length(along(middle, move, t));
  }
  [[nodiscard]] double before() const { return length(along(middle, move, -1.0)); }
};

// The query, in units.
struct Question {
  unsigned fraction_bits;
  double clearance;
  double surely;
  bool follows_another;

  [[nodiscard]] double cell() const { return std::ldexp(1.0, static_cast<int>(fraction_bits)); }
  // The error of positions and moves when they entered the grid. Pairs that are called near or far
  // are so by more than this.
  [[nodiscard]] double rounded_before() const { return std::sqrt(3.0) + 0x1p-19 * cell(); }
  // Closer than this to the limit, the check may leave a pair open.
  [[nodiscard]] double margin() const { return 3.01 + 0x1p-16 * cell(); }

  friend std::ostream& operator<<(std::ostream& out, const Question& q) {
    return out << "fraction bits " << q.fraction_bits << ", clearance " << q.clearance
               << ", surely " << q.surely << (q.follows_another ? ", follows another" : "");
  }
};

// How many pairs were decided, and of how many that was possible.
struct Tally {
  std::size_t near = 0;
  std::size_t far = 0;
  std::size_t before = 0;
  std::size_t open = 0;
};

class Checked {
 public:
  explicit Checked(const Question& question) : question_(question), grid_(memory_) {
    grid_.fraction_bits = question.fraction_bits;
    grid_.units_per_m = 0.37;
  }

  // Checks all pairs (2 k, 2 k + 1), as many at a time as there can be.
  void look_at(const std::vector<BallInGrid>& balls) {
    Step step{1.0, question_.clearance / grid_.units_per_m};
    step.surely_m = question_.surely / grid_.units_per_m;
    step.follows_another = question_.follows_another;
    const PassCheck check(grid_, balls.data(), step);
    ASSERT_EQ(balls.size() % (2 * PassCheck::kAtOnce), 0U);
    for (std::uint32_t k = 0; k < balls.size(); k += 2 * PassCheck::kAtOnce) {
      std::array<std::uint32_t, PassCheck::kAtOnce> first{};
      std::array<std::uint32_t, PassCheck::kAtOnce> second{};
      for (std::uint32_t lane = 0; lane < PassCheck::kAtOnce; ++lane) {
        first[lane] = k + 2 * lane;
        second[lane] = k + 2 * lane + 1;
        ASSERT_EQ(check.id_of(first[lane]), balls[first[lane]].id);
      }
      const PassCheck::Known known = check({first.data(), second.data()});
      ASSERT_EQ((known.possible | known.near | known.known_before) >> PassCheck::kAtOnce, 0U);
      for (std::uint32_t lane = 0; lane < PassCheck::kAtOnce; ++lane) {
        expect(Relative(balls[first[lane]], balls[second[lane]]), known.possible >> lane & 1U,
               known.near >> lane & 1U, known.known_before >> lane & 1U);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }

  Tally tally;

 private:
  void expect(const Relative& two, bool possible, bool near, bool known_before) {
    const double rounded = question_.rounded_before();
    const double margin = question_.margin();
    const double closest = two.closest();
    const double before = two.before();
    const double clear = question_.clearance + two.radii;
    if (near) {
      ASSERT_LT(closest + rounded, question_.surely);
    }
    if (!possible) {
      ASSERT_GT(closest - rounded, clear);
    }
    if (known_before) {
      ASSERT_TRUE(question_.follows_another);
      ASSERT_LT(before + rounded, question_.surely);
    }
    if (closest < question_.surely - margin) {
      ASSERT_TRUE(near) << closest;
      ++tally.near;
    } else if (closest > clear + margin) {
      ASSERT_FALSE(possible) << closest << " of " << clear;
      ++tally.far;
    } else {
      ++tally.open;
    }
    if (question_.follows_another && before < question_.surely - margin) {
      ASSERT_TRUE(known_before) << before;
      ++tally.before;
    }
  }

  Question question_;
  core::Memory memory_;
  core::SortedGrid grid_;
};

class Maker {
 public:
  Maker(const Question& question, std::uint32_t seed) : question_(question), make_(seed) {}

  // As many pairs whose balls around all of their step meet, within the reach of a cell.
  std::vector<BallInGrid> pairs(std::size_t count) {
    std::vector<BallInGrid> balls;
    while (balls.size() < 2 * count) {
      const auto pair = two();
      if (!pair) continue;
      balls.push_back((*pair)[0]);
      balls.push_back((*pair)[1]);
      balls[balls.size() - 2].id = static_cast<PointId>(7 * balls.size());
      balls.back().id = static_cast<PointId>(7 * balls.size() + 1);
    }
    return balls;
  }

 private:
  Vector direction() {
    Vector way{make_.between(-1, 1), make_.between(-1, 1), make_.between(-1, 1)};
    if (make_.below(4) == 0) {
      way = {};
      way[make_.below(3)] = make_.below(2) == 0 ? -1.0 : 1.0;
    }
    const double norm = length(way) + 1e-12;
    return {way[0] / norm, way[1] / norm, way[2] / norm};
  }

  // Their distance at the chosen time: random, or about the queried one.
  double miss(double radii, double most) {
    const double about = 4.0 * question_.margin();
    switch (make_.below(4)) {
      case 0:
        return make_.between(0.0, most);
      case 1:
        return std::abs(question_.surely + make_.between(-about, about));
      case 2:
        return question_.clearance + radii + make_.between(-about, about);
      default:
        return make_.between(0.0, question_.clearance);
    }
  }

  std::optional<std::array<BallInGrid, 2>> two() {
    const double left = 0.5 * (question_.cell() - question_.clearance);  // for one ball
    const std::size_t kind = make_.below(5);
    std::array<Vector, 2> moves{};
    std::array<double, 2> radii{};
    for (std::size_t k = 0; k < 2; ++k) {
      radii[k] = make_.below(2) == 0 ? 0.0 : make_.between(0.0, 0.3 * left);
      const double speed = kind == 0 ? 1e-9 * left : make_.between(0.0, left - radii[k]);
      moves[k] = along({}, direction(), speed);
    }
    if (kind == 1) moves[1] = moves[0];  // at rest to each other
    if (kind == 2) moves[1] = {-moves[0][0], -moves[0][1], -moves[0][2]};
    std::array<BallInGrid, 2> balls{};
    for (std::size_t k = 0; k < 2; ++k) {
      balls[k].move_x = static_cast<float>(moves[k][0]);
      balls[k].move_y = static_cast<float>(moves[k][1]);
      balls[k].move_z = static_cast<float>(moves[k][2]);
      balls[k].radius = static_cast<float>(radii[k]);
    }
    const Relative still(balls[0], balls[1]);
    // Closest at a time within the step or beside it, or as far apart as wanted when it begins.
    const double t = make_.below(4) == 0 ? -1.0 : make_.between(-1.6, 1.6);
    Vector aside = direction();
    const double squared = dot(still.move, still.move);
    if (squared > 0.0 && make_.below(5) != 0) {
      aside = along(aside, still.move, -dot(aside, still.move) / squared);
      const double norm = length(aside) + 1e-12;
      aside = {aside[0] / norm, aside[1] / norm, aside[2] / norm};
    }
    const Vector r = along(along({}, aside, miss(still.radii, question_.cell())), still.move, -t);
    const double reach = question_.clearance + still.radii + length(moves[0]) + length(moves[1]);
    if (length(r) > reach) return std::nullopt;
    const auto highest =
        static_cast<std::int32_t>((1 << 30) - 1 - 2 * (1 << question_.fraction_bits));
    const auto place = [&] {
      // In most cases near the end of all positions.
      const std::int32_t low =
          make_.below(4) == 0 ? (1 << question_.fraction_bits) : highest - 1000;
      return static_cast<std::int32_t>(make_.between(low, highest));
    };
    balls[0].x = place();
    balls[0].y = place();
    balls[0].z = place();
    balls[1].x = balls[0].x + static_cast<std::int32_t>(std::lround(r[0]));
    balls[1].y = balls[0].y + static_cast<std::int32_t>(std::lround(r[1]));
    balls[1].z = balls[0].z + static_cast<std::int32_t>(std::lround(r[2]));
    if (make_.below(2) == 0) std::swap(balls[0], balls[1]);
    return balls;
  }

  Question question_;
  test::SceneMaker make_;
};

TEST(PassCheck, TellsNearFromFarByMoreThanRounding) {
  std::uint32_t seed = 0;
  Tally all;
  for (const unsigned fraction_bits : {4U, 10U, 22U}) {
    const double cell = std::ldexp(1.0, static_cast<int>(fraction_bits));
    for (const double share : {0.98, 0.6, 0.1, 1e-3}) {
      for (const double of_clearance : {1.0, 0.5, 0.0}) {
        for (const bool follows : {false, true}) {
          const double clearance = share * cell;
          const Question question{fraction_bits, clearance, of_clearance * clearance, follows};
          std::ostringstream shown;
          shown << question;
          SCOPED_TRACE(shown.str());
          Checked checked(question);
          checked.look_at(
              Maker(question, ++seed).pairs(static_cast<std::size_t>(test::rounds(4000))));
          ASSERT_FALSE(HasFatalFailure());
          all.near += checked.tally.near;
          all.far += checked.tally.far;
          all.before += checked.tally.before;
          all.open += checked.tally.open;
          // Where a few units are little, and no pair is between surely near and surely far.
          if (clearance < 50.0 || of_clearance < 1.0) continue;
          EXPECT_GT(checked.tally.near + checked.tally.far, checked.tally.open / 2);
        }
      }
    }
  }
  EXPECT_GT(all.near, static_cast<std::size_t>(test::rounds(20'000)));
  EXPECT_GT(all.far, static_cast<std::size_t>(test::rounds(20'000)));
  EXPECT_GT(all.before, static_cast<std::size_t>(test::rounds(3'000)));
}

// With a limit below zero, or within the margin of it, no pair is surely near, not even at one
// place.
TEST(PassCheck, NoPairIsSurelyNearWhereNoneCanBe) {
  for (const unsigned fraction_bits : {4U, 10U, 22U}) {
    for (const double surely : {-1.0, -0.37, -1e6, 0.0, 1.0, 2.9}) {
      const Question question{fraction_bits, 5.0, surely, true};
      std::vector<BallInGrid> same(8, BallInGrid{5, 6, 7, 8, 0.25F, 0.5F, -1.0F, 0.0F});
      Checked checked(question);
      checked.look_at(same);
      checked.look_at(Maker(question, fraction_bits).pairs(400));
      ASSERT_FALSE(HasFatalFailure());
      EXPECT_EQ(checked.tally.near + checked.tally.before, 0U);
    }
  }
}

// Each of the four pairs has a bit of its own.
TEST(PassCheck, EachOfFourHasItsOwnBit) {
  core::Memory memory;
  core::SortedGrid grid(memory);
  grid.fraction_bits = 10;
  grid.units_per_m = 1.0;
  Step step{1.0, 100.0};
  step.surely_m = 50.0;
  step.follows_another = true;
  // Itself; beside it for good; far for good; comes near; was near and is gone.
  const std::vector<BallInGrid> balls = {{0, 0, 0, 10, 0, 0, 0, 0},
                                         {0, 70, 0, 11, 0, 0, 0, 0},
                                         {0, 0, 300, 12, 0, 0, 0, 0},
                                         {200, 0, 0, 13, -200, 0, 0, 0},
                                         {0, 200, 0, 14, 0, 200, 0, 0}};
  const PassCheck check(grid, balls.data(), step);
  const std::array<unsigned, 5> possible = {1, 1, 0, 1, 1};
  const std::array<unsigned, 5> near = {1, 0, 0, 1, 1};
  const std::array<unsigned, 5> before = {1, 0, 0, 0, 1};
  for (std::uint32_t turn = 0; turn < 625; ++turn) {
    const std::array<std::uint32_t, 4> second = {turn % 5, turn / 5 % 5, turn / 25 % 5, turn / 125};
    const std::array<std::uint32_t, 4> first{};
    for (const bool other_way : {false, true}) {
      const PassCheck::Known known =
          other_way ? check({second.data(), first.data()}) : check({first.data(), second.data()});
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        ASSERT_EQ(known.possible >> lane & 1U, possible[second[lane]]) << turn << " " << lane;
        ASSERT_EQ(known.near >> lane & 1U, near[second[lane]]) << turn << " " << lane;
        ASSERT_EQ(known.known_before >> lane & 1U, before[second[lane]]) << turn << " " << lane;
      }
    }
  }
}

}  // namespace
}  // namespace beespace::motion
