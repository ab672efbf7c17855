// Properties that hold for any right answer.
#include "tests/support/search_scenes.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace beespace::test {
namespace {

using Ids = std::vector<PointId>;
using Pairs = std::vector<Pair>;

constexpr unsigned kThreads = 2;

// Equal real distances may be reported some roundings apart.
constexpr double kRounding = 1.0 + 0x1p-50;

SearchOptions options_of(const SearchScene& scene, bool inclusive = true) {
  return {scene.threshold_m, inclusive, kThreads};
}

Pairs upper_half(const IdRows& rows) {
  Pairs pairs;
  for (PointId i = 0; i < rows.size(); ++i) {
    for (const PointId j : rows[i]) {
      if (i < j) pairs.push_back({i, j});
    }
  }
  return pairs;
}

// The name of each point in a shuffled scene, and the scene.
struct Shuffled {
  Ids new_id;
  std::vector<Point> points;
};

Shuffled shuffled(const std::vector<Point>& points) {
  SceneMaker make(77);
  Ids old_id(points.size());
  std::iota(old_id.begin(), old_id.end(), PointId{0});
  for (std::size_t left = old_id.size(); left > 1; --left) {
    std::swap(old_id[left - 1], old_id[make.below(left)]);
  }
  Shuffled result{Ids(points.size()), {}};
  for (PointId id = 0; id < old_id.size(); ++id) {
    result.new_id[old_id[id]] = id;
    result.points.push_back(points[old_id[id]]);
  }
  return result;
}

class Properties : public testing::Test {
 protected:
  template <class Check>
  static void on_every_scene(Check&& check) {
    for (const SearchScene& scene : search_scenes()) {
      SCOPED_TRACE(scene.name);
      check(scene);
      if (HasFatalFailure()) return;
    }
  }
};

TEST_F(Properties, RenamingThePointsRenamesTheAnswer) {
  on_every_scene([](const SearchScene& scene) {
    const Shuffled other = shuffled(scene.points);
    Pairs expected = *find_pairs(scene.points, options_of(scene));
    for (Pair& pair : expected) {
      const auto [low, high] = std::minmax(other.new_id[pair.first], other.new_id[pair.second]);
      pair = {low, high};
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(*find_pairs(other.points, options_of(scene)), expected);
    Ids at_risk = *find_at_risk(scene.points, options_of(scene));
    for (PointId& id : at_risk) id = other.new_id[id];
    std::sort(at_risk.begin(), at_risk.end());
    EXPECT_EQ(*find_at_risk(other.points, options_of(scene)), at_risk);
    const auto nearest = *find_nearest(scene.points, kThreads);
    const auto renamed = *find_nearest(other.points, kThreads);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      EXPECT_LE(renamed[other.new_id[i]].distance_m, nearest[i].distance_m * kRounding) << i;
      EXPECT_GE(renamed[other.new_id[i]].distance_m * kRounding, nearest[i].distance_m) << i;
    }
  });
}

TEST_F(Properties, NeighboursAreMutualAndInOrder) {
  on_every_scene([](const SearchScene& scene) {
    const IdRows rows = *find_neighbors(scene.points, options_of(scene));
    ASSERT_EQ(rows.size(), scene.points.size());
    for (PointId i = 0; i < rows.size(); ++i) {
      ASSERT_TRUE(std::adjacent_find(rows[i].begin(), rows[i].end(), std::greater_equal<>()) ==
                  rows[i].end());
      for (const PointId j : rows[i]) {
        ASSERT_NE(i, j);
        ASSERT_TRUE(std::binary_search(rows[j].begin(), rows[j].end(), i)) << i << " " << j;
      }
    }
  });
}

TEST_F(Properties, TheQuestionsAgreeWithEachOther) {
  on_every_scene([](const SearchScene& scene) {
    for (const bool inclusive : {false, true}) {
      const SearchOptions options = options_of(scene, inclusive);
      const IdRows rows = *find_neighbors(scene.points, options);
      EXPECT_EQ(*find_pairs(scene.points, options), upper_half(rows));
      std::vector<std::uint32_t> lengths;
      Ids not_empty;
      for (PointId i = 0; i < rows.size(); ++i) {
        lengths.push_back(static_cast<std::uint32_t>(rows[i].size()));
        if (!rows[i].empty()) not_empty.push_back(i);
      }
      EXPECT_EQ(*count_neighbors(scene.points, options), lengths);
      EXPECT_EQ(*find_at_risk(scene.points, options), not_empty);
      const auto nearest = *find_nearest_within(scene.points, options);
      for (PointId i = 0; i < rows.size(); ++i) {
        const bool is_neighbour = std::binary_search(rows[i].begin(), rows[i].end(), nearest[i].id);
        ASSERT_EQ(nearest[i].id != Nearest::kNone, is_neighbour) << i;
        ASSERT_EQ(nearest[i].id == Nearest::kNone, rows[i].empty()) << i;
      }
    }
  });
}

// Every group is connected, no pair leads out of one, and no point at risk is missing.
TEST_F(Properties, GroupsAreTheComponentsOfThePairs) {
  on_every_scene([](const SearchScene& scene) {
    const Pairs pairs = *find_pairs(scene.points, options_of(scene));
    const IdRows groups = *find_conflict_groups(scene.points, options_of(scene));
    std::vector<std::size_t> group_of(scene.points.size(), groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      ASSERT_GE(groups[g].size(), 2U);
      ASSERT_TRUE(g == 0 || groups[g - 1].front() < groups[g].front());
      for (const PointId id : groups[g]) {
        ASSERT_EQ(group_of[id], groups.size()) << id << " is in two groups";
        group_of[id] = g;
      }
    }
    Ids all = groups.ids;
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, *find_at_risk(scene.points, options_of(scene)));
    // A component of n points is held together by n - 1 joins that each join two parts.
    Ids part(scene.points.size());
    std::iota(part.begin(), part.end(), PointId{0});
    const auto part_of = [&](PointId id) {
      while (part[id] != id) id = part[id];
      return id;
    };
    std::size_t joins = 0;
    for (const Pair& pair : pairs) {
      ASSERT_EQ(group_of[pair.first], group_of[pair.second]);
      const PointId a = part_of(pair.first);
      const PointId b = part_of(pair.second);
      part[std::max(a, b)] = std::min(a, b);
      joins += a != b ? 1U : 0U;
    }
    EXPECT_EQ(joins, groups.ids.size() - groups.size());
  });
}

TEST_F(Properties, AnswersGrowWithTheThresholdAndWithInclusion) {
  on_every_scene([](const SearchScene& scene) {
    Pairs smaller;
    const double threshold = scene.threshold_m;
    for (const double one : {0.5 * threshold, std::nextafter(threshold, 0.0), threshold,
                             std::nextafter(threshold, 2.0 * threshold), 1.5 * threshold}) {
      if (one < kSmallestCoordinate_m || one > kLargestCoordinate_m) continue;
      for (const bool inclusive : {false, true}) {
        const Pairs larger = *find_pairs(scene.points, {one, inclusive, kThreads});
        EXPECT_TRUE(std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end()));
        smaller = larger;
      }
    }
  });
}

TEST_F(Properties, TheClosestPairIsThatOfTheNearestOfAll) {
  on_every_scene([](const SearchScene& scene) {
    const auto closest = *find_closest_pair(scene.points, kThreads);
    ASSERT_EQ(closest.has_value(), scene.points.size() >= 2);
    if (!closest) return;
    const auto nearest = *find_nearest(scene.points, kThreads);
    EXPECT_LT(closest->first, closest->second);
    EXPECT_EQ(nearest[closest->first].id, closest->second);
    for (const Nearest& one : nearest) EXPECT_GE(one.distance_m * kRounding, closest->distance_m);
  });
}

// A set against itself has the pairs of the set twice, and each point with itself.
TEST_F(Properties, ASetAgainstItselfIsTheSetAndItsOwnReflection) {
  on_every_scene([](const SearchScene& scene) {
    const IdRows alone = *find_neighbors(scene.points, options_of(scene));
    const IdRows between = *find_neighbors_between(scene.points, scene.points, options_of(scene));
    ASSERT_EQ(between.size(), alone.size());
    for (PointId i = 0; i < alone.size(); ++i) {
      Ids expected(alone[i].begin(), alone[i].end());
      expected.insert(std::lower_bound(expected.begin(), expected.end(), i), i);
      ASSERT_TRUE(
          std::equal(expected.begin(), expected.end(), between[i].begin(), between[i].end()))
          << i;
    }
  });
}

TEST_F(Properties, PairDistancesAreThoseOfThePoints) {
  on_every_scene([](const SearchScene& scene) {
    const Pairs pairs = *find_pairs(scene.points, options_of(scene));
    const std::vector<double> distances = pair_distances(scene.points, pairs);
    ASSERT_EQ(distances.size(), pairs.size());
    EXPECT_EQ(pair_distances_between(scene.points, scene.points, pairs), distances);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      ASSERT_EQ(distances[k],
                distance(scene.points[pairs[k].first], scene.points[pairs[k].second]));
    }
  });
}

TEST_F(Properties, AVisitEndsWhenTheVisitorReturnsFalse) {
  on_every_scene([](const SearchScene& scene) {
    const std::size_t all = find_pairs(scene.points, options_of(scene)).value().size();
    std::size_t calls = 0;
    const auto finished =
        visit_pairs(scene.points, options_of(scene), [&](std::span<const Pair> batch) {
          EXPECT_LE(batch.size(), kMostPairsAtOnce);
          ++calls;
          return false;
        });
    EXPECT_EQ(*finished, all == 0);
    EXPECT_EQ(calls, all == 0 ? 0U : 1U);
  });
}

// Also where a buffer is full when the limit is reached: they have room for powers of two.
TEST(Limits, AnyLimitBelowTheNumberOfResultsIsTooLow) {
  const std::vector<Point> crowd(300, Point{1, 2, 3});
  constexpr std::uint64_t kPairs = 300 * 299 / 2;
  for (std::uint64_t power = 64; power < kPairs; power *= 2) {
    for (std::uint64_t limit = power - 20; limit <= power + 1; ++limit) {
      const auto pairs = find_pairs(crowd, {1.0, false, 1, limit});
      ASSERT_FALSE(pairs.has_value()) << limit;
      EXPECT_EQ(pairs.error().code, ErrorCode::kTooManyResults);
      EXPECT_FALSE(find_neighbors(crowd, {1.0, false, 1, 2 * limit}).has_value()) << limit;
      EXPECT_FALSE(find_pairs_between(crowd, crowd, {1.0, false, 1, limit}).has_value()) << limit;
    }
  }
  EXPECT_EQ(find_pairs(crowd, {1.0, false, 1, kPairs}).value().size(), kPairs);
}

}  // namespace
}  // namespace beespace::test
