// Parts of an outline cover it, all of it, and nothing twice; and none has a dent.
#include "obstacles/convex_parts.hpp"

#include "tests/obstacles/outlines.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::obstacles {
namespace {

using scenes::RandomStream;
using test::Corners;
using test::Real;
using test::real;

Real area(const Corners& corners) {
  Real doubled = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    doubled += real(a.x) * real(b.y) - real(a.y) * real(b.x);
  }
  return 0.5L * doubled;
}

std::size_t count(const Corners& corners) {
  return convex_parts(Outline(corners)).size();
}

TEST(ConvexParts, AreFew) {
  EXPECT_EQ(count(test::square()), 1U);
  EXPECT_EQ(count({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}), 1U);  // straight on at two
  EXPECT_EQ(count(test::letter_l()), 2U);
  EXPECT_EQ(count(test::letter_u()), 3U);
  EXPECT_LE(count(test::star()), 6U);
  EXPECT_LE(count(test::spiral()), 12U);
  EXPECT_LE(count(test::comb()), 6U);
}

// In the order of the outline, turning left at each corner, and all of them the outline's.
void expect_convex(const Outline& part, const Corners& outline) {
  const Corners& corners = part.corners();
  ASSERT_GE(corners.size(), 3U);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const Corner& c = corners[(i + 2) % corners.size()];
    ASSERT_GT((real(b.x) - real(a.x)) * (real(c.y) - real(b.y)),
              (real(b.y) - real(a.y)) * (real(c.x) - real(b.x)));
    const auto is_a = [&](const Corner& corner) { return corner.x == a.x && corner.y == a.y; };
    ASSERT_TRUE(std::any_of(outline.begin(), outline.end(), is_a));
  }
}

struct Tally {
  int inside = 0;
  int outside = 0;
  int dented = 0;
};

void expect_covered(const Corners& outline, RandomStream& random, Tally& tally) {
  const std::vector<Outline> parts = convex_parts(Outline(outline));
  Real sum = 0.0L;
  for (const Outline& part : parts) {
    ASSERT_NO_FATAL_FAILURE(expect_convex(part, outline));
    sum += area(part.corners());
  }
  ASSERT_NEAR(static_cast<double>(sum), std::abs(static_cast<double>(area(outline))), 1e-13);
  ASSERT_LE(parts.size(), outline.size() - 2);
  tally.dented += parts.size() > 1 ? 1 : 0;
  for (int tries = 0; tries < 20; ++tries) {
    const Corner place = test::random_corner(random, 7.0);
    const bool inside = test::winds_around(outline, {real(place.x), real(place.y)});
    const auto within = std::count_if(parts.begin(), parts.end(),
                                      [&](const Outline& part) { return part.contains(place); });
    ASSERT_EQ(within, inside ? 1 : 0);
    ASSERT_EQ(Outline(outline).contains(place), inside);
    ++(inside ? tally.inside : tally.outside);
  }
}

TEST(ConvexParts, CoverTheOutline) {
  RandomStream random(1);
  Tally tally;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    ASSERT_NO_FATAL_FAILURE(expect_covered(test::random_outline(random), random, tally))
        << "round " << round;
  }
  EXPECT_GT(tally.inside, test::rounds(20'000));
  EXPECT_GT(tally.outside, test::rounds(20'000));
  EXPECT_GT(tally.dented, test::rounds(20'000) / 2);
}

TEST(ConvexParts, OfManyCornersOnOneLine) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(5'000); ++round) {
    const Corners corners = test::random_lattice(random, 8 + random.index(12));
    ASSERT_NO_FATAL_FAILURE(expect_covered(test::begun_anywhere(corners, random), random, tally))
        << "round " << round;
  }
  EXPECT_GT(tally.dented, test::rounds(5'000) * 9 / 10);
}

TEST(ConvexParts, OfHundredsOfCorners) {
  RandomStream random(3);
  Tally tally;
  for (int round = 0; round < test::rounds(100); ++round) {
    ASSERT_NO_FATAL_FAILURE(expect_covered(test::random_star(random, 300), random, tally))
        << "round " << round;
  }
  EXPECT_EQ(tally.dented, test::rounds(100));
}

}  // namespace
}  // namespace beespace::obstacles
