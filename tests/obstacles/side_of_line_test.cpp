// Which side, against fractions that do not round.
#include "obstacles/side_of_line.hpp"

#include "scenes/random_stream.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::obstacles {
namespace {

using scenes::RandomStream;
using test::Fraction;

int exact_side(const Corner& a, const Corner& b, const Corner& p) {
  const Fraction area = (Fraction(b.x) - Fraction(a.x)) * (Fraction(p.y) - Fraction(a.y)) -
                        (Fraction(b.y) - Fraction(a.y)) * (Fraction(p.x) - Fraction(a.x));
  return area.sign();
}

struct Tally {
  int left = 0;
  int on = 0;
  int right = 0;
};

void expect_exact(const Corner& a, const Corner& b, const Corner& p, Tally& tally) {
  const int expected = exact_side(a, b, p);
  ASSERT_EQ(side_of_line(a, b, p), expected);
  ASSERT_EQ(side_of_line(b, p, a), expected);
  ASSERT_EQ(side_of_line(p, a, b), expected);
  ASSERT_EQ(side_of_line(b, a, p), -expected);
  ++(expected > 0 ? tally.left : expected < 0 ? tally.right : tally.on);
}

TEST(SideOfLine, IsExactAllButOnTheLine) {
  RandomStream random(1);
  Tally tally;
  for (int round = 0; round < test::rounds(40'000); ++round) {
    const double scale = std::exp(random.uniform(-60.0, 60.0));
    const auto coordinate = [&] { return scale * random.uniform(-1.0, 1.0); };
    const Corner a{coordinate(), coordinate()};
    const Corner b{coordinate(), coordinate()};
    const double share = random.uniform(-1.0, 2.0);
    Corner p{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    // As near to the line as doubles get; and now and then a few of their steps beside it.
    for (std::uint32_t steps = random.index(3); steps > 0; --steps) {
      p.x = std::nextafter(p.x, random.uniform(-2.0, 2.0) * scale);
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(a, b, p, tally)) << "round " << round;
  }
  EXPECT_GT(tally.left, test::rounds(40'000) / 4);
  EXPECT_GT(tally.right, test::rounds(40'000) / 4);
}

TEST(SideOfLine, OfCornersOnOneLine) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    const auto whole = [&] { return static_cast<double>(random.index(2000)) - 1000.0; };
    const double scale = std::ldexp(1.0, static_cast<int>(random.index(180)) - 95);
    const Corner a{whole() * scale, whole() * scale};
    const Corner way{whole() * scale, whole() * scale};
    const double times = whole();
    const Corner b{a.x + way.x, a.y + way.y};
    const Corner p{a.x + times * way.x, a.y + times * way.y};
    ASSERT_NO_FATAL_FAILURE(expect_exact(a, b, p, tally)) << "round " << round;
  }
  EXPECT_EQ(tally.on, test::rounds(20'000));
}

TEST(SideOfLine, AtTheEndsOfTheDomain) {
  RandomStream random(3);
  Tally tally;
  const double sizes[] = {0.0, kSmallestInMotion, 1e-10, 1.0, 3.0, 1e10, kLargestInMotion};
  for (int round = 0; round < test::rounds(40'000); ++round) {
    const auto any = [&] {
      const double size = sizes[random.index(7)];
      return random.index(2) == 0 ? size : -size;
    };
    const Corner a{any(), any()};
    const Corner b{any(), any()};
    const Corner p{any(), any()};
    ASSERT_NO_FATAL_FAILURE(expect_exact(a, b, p, tally)) << "round " << round;
  }
  EXPECT_GT(tally.on, test::rounds(40'000) / 40);
  EXPECT_GT(tally.left, test::rounds(40'000) / 4);
}

}  // namespace
}  // namespace beespace::obstacles
