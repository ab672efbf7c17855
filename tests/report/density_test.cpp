// Many bees as counts in cells.
#include "report/figure/density.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace beespace::report {
namespace {

std::uint32_t total(const Density& density) {
  return std::accumulate(density.counts().begin(), density.counts().end(), std::uint32_t{0});
}

TEST(Density, CountsEachBeeOnceInTheRightCell) {
  Density density({100.0, 50.0}, 30.0, 20.0, 10.0);
  ASSERT_EQ(density.columns(), 3u);
  ASSERT_EQ(density.counts().size(), 6u);
  density.add({100.0, 50.0});
  density.add({109.9, 59.9});
  density.add({110.0, 60.0});
  density.add({130.0, 70.0});  // the far corner belongs to the last cell
  density.add({-5.0, 1e9});    // beyond: to the nearest one
  EXPECT_EQ(density.counts(), (std::vector<std::uint32_t>{2, 0, 0, 1, 1, 1}));
  EXPECT_EQ(density.most(), 2u);
}

TEST(Density, AWayCountsOnceInEachCellThatItCrosses) {
  Density density({0.0, 0.0}, 100.0, 10.0, 10.0);
  density.add_way({5.0, 5.0}, {95.0, 5.0});
  EXPECT_EQ(density.counts(), std::vector<std::uint32_t>(10, 1));
  density.add_way({5.0, 5.0}, {6.0, 6.0});
  EXPECT_EQ(density.counts().front(), 2u);
  EXPECT_EQ(total(density), 11u);
}

TEST(Density, ShadesGrowWithTheCountAndEmptyCellsHaveNone) {
  Density density({0.0, 0.0}, 40.0, 10.0, 10.0);
  density.add({15.0, 5.0});
  for (int i = 0; i < 10; ++i) density.add({25.0, 5.0});
  for (int i = 0; i < 100; ++i) density.add({35.0, 5.0});
  const Cells cells = density.cells({{1}, {2}, {3}, {4}});
  EXPECT_EQ(cells.levels, (std::vector<std::uint8_t>{0, 1, 3, 4}));
}

TEST(Density, DiamondsHaveAreasInProportion) {
  Density density({0.0, 0.0}, 24.0, 12.0, 12.0);
  for (int i = 0; i < 100; ++i) density.add({6.0, 6.0});
  for (int i = 0; i < 36; ++i) density.add({18.0, 6.0});
  const Diamonds diamonds = density.diamonds({});
  ASSERT_EQ(diamonds.marks.size(), 2u);
  EXPECT_DOUBLE_EQ(diamonds.marks[1].radius / diamonds.marks[0].radius, 0.6);
  EXPECT_DOUBLE_EQ(diamonds.marks[1].centre.x, 18.0);
}

}  // namespace
}  // namespace beespace::report
