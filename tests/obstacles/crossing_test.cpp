// Whether an outline crosses itself: made by hand, and whole numbers against plain arithmetic on
// them, which is exact.
#include "obstacles/crossing.hpp"

#include "tests/obstacles/outlines.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace beespace::obstacles {
namespace {

using scenes::RandomStream;
using test::Corners;

bool crosses(const Corners& corners) {
  return first_crossing(corners).has_value();
}

TEST(Crossing, OfOutlinesThatDoNot) {
  for (const Corners& corners : {test::square(), test::letter_l(), test::letter_u(), test::star(),
                                 test::spiral(), test::comb()}) {
    EXPECT_FALSE(crosses(corners)) << corners.size() << " corners";
    EXPECT_FALSE(crosses({corners.rbegin(), corners.rend()}));
  }
  EXPECT_FALSE(crosses({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(crosses({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}}));  // straight on at two corners
}

TEST(Crossing, OfOutlinesThatDo) {
  EXPECT_TRUE(crosses({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));                  // a bow tie
  EXPECT_TRUE(crosses({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));          // a corner on an edge
  EXPECT_TRUE(crosses({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}));  // a corner on a corner
  EXPECT_TRUE(crosses({{0, 0}, {4, 0}, {2, 0}, {2, 4}}));                  // back along an edge
  EXPECT_TRUE(crosses({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}}));  // out and back
  EXPECT_TRUE(crosses({{0, 0}, {9, 0}, {9, 3}, {6, 3}, {6, 0}, {3, 0}, {3, 3}, {0, 3}}));
}

TEST(Crossing, NamesTheTwoEdges) {
  const Corners corners{{0, 0}, {9, 0}, {9, 9}, {5, 9}, {5, -1}, {0, 9}};
  const auto crossing = first_crossing(corners);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, 0U);
  EXPECT_EQ(crossing->second, 3U);
}

TEST(Crossing, IsSeenAtTheLastBit) {
  const double beside = 0x1p-52;
  const auto notched = [](double x) { return Corners{{0, 0}, {1, 0}, {1, 1}, {x, 0.5}, {0, 1}}; };
  EXPECT_FALSE(crosses(notched(0x1p-99)));  // all but on the edge from (0, 1) to (0, 0)
  EXPECT_TRUE(crosses(notched(0.0)));
  EXPECT_TRUE(crosses(notched(-0x1p-99)));
  // On the diagonal, and a step beside it.
  const auto wedge = [](double x) { return Corners{{0, 0}, {3, 3}, {3, 4}, {x, 1.0}, {0, 4}}; };
  EXPECT_TRUE(crosses(wedge(1.0)));
  EXPECT_TRUE(crosses(wedge(1.0 + beside)));
  EXPECT_FALSE(crosses(wedge(1.0 - beside)));
}

// All tours of whole numbers that never stand still.
TEST(Crossing, OfRandomTours) {
  RandomStream random(1);
  int simple = 0;
  int crossed = 0;
  for (int round = 0; round < test::rounds(200'000); ++round) {
    Corners corners;
    for (std::uint32_t left = 4 + random.index(5); left > 0; --left) {
      corners.push_back(
          {static_cast<double>(random.index(5)), static_cast<double>(random.index(5))});
    }
    const auto& [x, y] = corners.front();
    bool stands = corners.back().x == x && corners.back().y == y;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      stands |= corners[i].x == corners[i - 1].x && corners[i].y == corners[i - 1].y;
    }
    if (stands) continue;
    const auto expected = test::any_crossing(corners);
    const auto found = first_crossing(corners);
    ASSERT_EQ(found.has_value(), expected.has_value()) << "round " << round;
    ++(expected ? crossed : simple);
    if (!expected) continue;
    ASSERT_EQ(std::pair(found->first, found->second), *expected) << "round " << round;
  }
  EXPECT_GT(simple, test::rounds(200'000) / 100);
  EXPECT_GT(crossed, test::rounds(200'000) / 4);
}

TEST(Crossing, DetectsCornersOnOneLine) {
  EXPECT_TRUE(all_on_one_line(Corners{{0, 0}, {1, 3}, {2, 6}, {-1, -3}}));
  EXPECT_FALSE(all_on_one_line(Corners{{0, 0}, {1, 3}, {2, 6}, {-1, -3.0000000000000004}}));
}

}  // namespace
}  // namespace beespace::obstacles
