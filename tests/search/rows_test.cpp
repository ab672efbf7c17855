// Rows are read in loops, and there is one way to have none.
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <span>
#include <vector>

namespace beespace {
namespace {

static_assert(std::random_access_iterator<RowIterator<IdRows>>);
static_assert(std::random_access_iterator<RowIterator<NearestRows>>);

using Lists = std::vector<std::vector<PointId>>;

Lists lists(const IdRows& rows) {
  Lists all;
  for (const std::span<const PointId> row : rows) all.emplace_back(row.begin(), row.end());
  return all;
}

// On a line, at 0, 1, 2 and 10.
const std::vector<Point> kPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {10, 0, 0}};
const std::vector<Point> kNone;

TEST(IdRows, ALoopSeesEachRowOnce) {
  EXPECT_EQ(lists(*find_neighbors(kPoints, {1.5})), (Lists{{1}, {0, 2}, {1}, {}}));
  EXPECT_EQ(lists(*find_conflict_groups(kPoints, {1.5})), (Lists{{0, 1, 2}}));
  EXPECT_EQ(lists(IdRows{}), Lists{});
  EXPECT_EQ(lists({{0, 0, 0}, {}}), (Lists{{}, {}}));
}

TEST(IdRows, IteratorsGoToAnyRow) {
  const IdRows rows = *find_neighbors(kPoints, {1.5});
  EXPECT_EQ(rows.end() - rows.begin(), 4);
  EXPECT_EQ(rows.begin()[1].size(), 2U);
  EXPECT_EQ((*(rows.end() - 2)).front(), 1U);
  auto at = rows.begin();
  EXPECT_EQ((*at++).size(), 1U);
  EXPECT_EQ((*at--).size(), 2U);
  EXPECT_TRUE(at == rows.begin());
  EXPECT_TRUE(at < rows.end());
  EXPECT_TRUE(1 + at == at + 1);
}

// No row is a default-constructed object, from whichever function.
TEST(IdRows, NoRowsAreAlwaysTheSame) {
  const SearchOptions plain = {.threshold_m = 0.5};
  const SearchOptions cylinder = {.threshold_m = 0.5, .vertical_m = 0.5};
  for (const SearchOptions& options : {plain, cylinder}) {
    EXPECT_EQ(*find_neighbors(kNone, options), IdRows{});
    EXPECT_EQ(*find_neighbors_between(kNone, kPoints, options), IdRows{});
    EXPECT_EQ(*brute_force::find_neighbors(kNone, options), IdRows{});
    EXPECT_EQ(*brute_force::find_neighbors_between(kNone, kPoints, options), IdRows{});
    EXPECT_EQ(*find_conflict_groups(kNone, options), IdRows{});
    EXPECT_EQ(*find_conflict_groups(kPoints, options), IdRows{});
    EXPECT_EQ(*brute_force::find_conflict_groups(kNone, options), IdRows{});
    EXPECT_EQ(*brute_force::find_conflict_groups(kPoints, options), IdRows{});
  }
  EXPECT_EQ(*Index::build(kPoints).value().find_around(PointsView(kNone), {0.5}), IdRows{});
  EXPECT_TRUE(IdRows{}.empty());
  EXPECT_FALSE(find_neighbors(kPoints, plain).value().empty());
}

TEST(IdRows, AnEngineLeavesNoRowsOfTheFrameBefore) {
  Engine engine;
  IdRows rows;
  ASSERT_TRUE(engine.find_neighbors(kPoints, {1.5}, rows));
  ASSERT_TRUE(engine.find_neighbors(kNone, {1.5}, rows));
  EXPECT_EQ(rows, IdRows{});
  ASSERT_TRUE(engine.find_conflict_groups(kPoints, {1.5}, rows));
  ASSERT_TRUE(engine.find_conflict_groups(kPoints, {0.5}, rows));
  EXPECT_EQ(rows, IdRows{});
}

TEST(NearestRows, ALoopSeesEachRowOnce) {
  const Index index = *Index::build(kPoints);
  const std::vector<Point> places = {{0.4, 0, 0}, {9, 0, 0}};
  const NearestRows rows = *index.k_nearest(places, 2);
  Lists all;
  for (const std::span<const Nearest> row : rows) all.push_back({row[0].id, row[1].id});
  EXPECT_EQ(all, (Lists{{0, 1}, {3, 2}}));
}

TEST(NearestRows, NoRowsAreAlwaysTheSame) {
  const Index index = *Index::build(kPoints);
  EXPECT_EQ(*index.k_nearest(PointsView(kNone), 2), NearestRows{});
  EXPECT_EQ(*index.k_nearest(kPoints, 0), NearestRows{});
  EXPECT_EQ(*Index().k_nearest(kPoints, 2), NearestRows{});
  for (const std::span<const Nearest> row : NearestRows{}) ADD_FAILURE() << row.size();
  EXPECT_TRUE(NearestRows{}.empty());
}

}  // namespace
}  // namespace beespace
