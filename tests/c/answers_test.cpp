// Each question of C has the answer of brute force, at the threshold and one ulp beside it, with an
// engine and without, of one set and of two.
#include "tests/c/c_scenes.hpp"
#include "tests/support/search_scenes.hpp"
#include "tests/support/two_set_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

// Asks with no engine, with one that was used before, and of two threads.
class CAnswers : public testing::TestWithParam<SearchScene> {
 protected:
  template <class Ask>
  void expect(const Columns& expected, Ask&& ask) {
    beespace_run two{};
    two.struct_size = sizeof two;
    two.threads = 2;
    const std::vector<std::pair<beespace_engine*, const beespace_run*>> ways = {
        {nullptr, nullptr}, {engine_.get(), nullptr}, {engine_.get(), &two}};
    for (const auto& [engine, run] : ways) {
      beespace_error error = c_error();
      const beespace_code code = ask(engine, run, result_.get(), &error);
      ASSERT_EQ(code, BEESPACE_OK) << error.message;
      EXPECT_EQ(columns(result_), expected);
    }
  }

  Owned<beespace_engine> engine_{beespace_engine_create()};
  Owned<beespace_result> result_{beespace_result_create()};
};

// The smaller ones: that searches are right on all of them is for tests/contract to show.
std::vector<SearchScene> scenes() {
  std::vector<SearchScene> all = plain_scenes();
  const std::vector<SearchScene> more = lattice_scenes();
  all.insert(all.end(), more.begin(), more.end());
  std::erase_if(all, [](const SearchScene& scene) { return scene.points.size() > 300; });
  return all;
}

struct Within {
  double threshold_m;
  bool inclusive;
  std::optional<double> vertical_m;
};

std::vector<Within> thresholds(double threshold) {
  return {{threshold, false, {}},
          {threshold, true, {}},
          {std::nextafter(threshold, 0.0), false, {}},
          {std::nextafter(threshold, 2.0 * threshold), false, {}},
          {threshold, false, threshold / 2.0}};
}

beespace_search search_within(const Within& within, std::uint32_t flags = 0) {
  beespace_search search = c_search(within.threshold_m, flags);
  if (within.inclusive) search.flags |= BEESPACE_INCLUSIVE;
  if (within.vertical_m) search.flags |= BEESPACE_VERTICAL;
  search.vertical_m = within.vertical_m.value_or(0.0);
  return search;
}

SearchOptions options_of(const Within& within) {
  return {.threshold_m = within.threshold_m,
          .inclusive = within.inclusive,
          .vertical_m = within.vertical_m};
}

std::vector<double> distances(const std::vector<Point>& points, const std::vector<Point>& others,
                              const std::vector<Pair>& pairs) {
  return pair_distances_between(points, others, pairs);
}

Columns with_row_distances(Columns rows, const std::vector<Point>& points,
                           const std::vector<Point>& others) {
  for (std::size_t row = 0; row + 1 < rows.offsets.size(); ++row) {
    for (auto i = rows.offsets[row]; i < rows.offsets[row + 1]; ++i) {
      const auto id = static_cast<std::size_t>(rows.ids[static_cast<std::size_t>(i)]);
      rows.distances_m.push_back(distance(points[row], others[id]));
    }
  }
  return rows;
}

Columns with_self(const IdRows& rows, std::size_t count) {
  Columns all;
  all.offsets = {0};
  for (std::size_t row = 0; row < count; ++row) {
    Numbers ids = wide(rows[row]);
    ids.push_back(static_cast<std::int64_t>(row));
    std::sort(ids.begin(), ids.end());
    all.ids.insert(all.ids.end(), ids.begin(), ids.end());
    all.offsets.push_back(static_cast<std::int64_t>(all.ids.size()));
  }
  return all;
}

TEST_P(CAnswers, OfOneSetAreThoseOfBruteForce) {
  const std::vector<Point>& points = GetParam().points;
  const beespace_points given = c_points(points);
  for (const Within& within : thresholds(GetParam().threshold_m)) {
    const SearchOptions options = options_of(within);
    const beespace_search plain = search_within(within);
    const beespace_search measured = search_within(within, BEESPACE_DISTANCES);
    const beespace_search self = search_within(within, BEESPACE_WITH_SELF);

    Columns at_risk;
    at_risk.ids = wide(*brute_force::find_at_risk(points, options));
    expect(at_risk, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_at_risk(engine, &given, nullptr, &plain, run, result, error);
    });
    const std::vector<Pair> pairs = *brute_force::find_pairs(points, options);
    Columns found = columns_of(pairs);
    expect(found, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_pairs(engine, &given, nullptr, &plain, run, result, error);
    });
    found.distances_m = distances(points, points, pairs);
    expect(found, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_pairs(engine, &given, nullptr, &measured, run, result, error);
    });
    const IdRows rows = *brute_force::find_neighbors(points, options);
    expect(with_row_distances(columns_of(rows), points, points),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_neighbors(engine, &given, nullptr, &measured, run, result, error);
           });
    const Columns selves = with_self(rows, points.size());
    expect(selves, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_neighbors(engine, &given, nullptr, &self, run, result, error);
    });
    Columns counts;
    counts.counts = wide(*brute_force::count_neighbors(points, options));
    expect(counts, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_count(engine, &given, nullptr, &plain, run, result, error);
    });
    for (auto& count : counts.counts) ++count;
    expect(counts, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_count(engine, &given, nullptr, &self, run, result, error);
    });
    expect(columns_of(*brute_force::find_conflict_groups(points, options)),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_groups(engine, &given, &plain, run, result, error);
           });
    expect(columns_of(*brute_force::find_nearest_within(points, options)),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_nearest_within(engine, &given, nullptr, &plain, run, result, error);
           });
  }
}

Columns nearest_rows(const NearestRows& rows, std::size_t count) {
  Columns all = columns_of(rows.entries);
  for (std::size_t row = 0; row <= count; ++row) {
    all.offsets.push_back(static_cast<std::int64_t>(row * rows.length));
  }
  return all;
}

Columns closest(const std::optional<ClosestPair>& pair) {
  Columns all;
  if (pair) {
    all.first = {pair->first};
    all.second = {pair->second};
    all.distances_m = {pair->distance_m};
  }
  return all;
}

TEST_P(CAnswers, OfTheNearestAreThoseOfBruteForce) {
  const std::vector<Point>& points = GetParam().points;
  const beespace_points given = c_points(points);
  for (const std::int64_t k : {0, 1, 2, 7}) {
    const NearestRows rows = *brute_force::find_k_nearest(points, static_cast<std::size_t>(k));
    expect(nearest_rows(rows, points.size()),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_nearest(engine, &given, nullptr, k, run, result, error);
           });
  }
  expect(closest(*brute_force::find_closest_pair(points)),
         [&](auto* engine, auto* run, auto* result, auto* error) {
           return beespace_closest_pair(engine, &given, nullptr, run, result, error);
         });
}

// The k nearest of each of `points` among `others`: the nearest one, then that of those that are
// left.
Columns nearest_between(const std::vector<Point>& points, const std::vector<Point>& others,
                        std::size_t k) {
  Columns all;
  all.offsets = {0};
  for (const Point& point : points) {
    std::vector<Point> left = others;
    Numbers ids(others.size());
    std::iota(ids.begin(), ids.end(), std::int64_t{0});
    for (std::size_t found = 0; found < k && !left.empty(); ++found) {
      const std::vector<Point> one = {point};
      const auto entries = brute_force::find_nearest_between(one, left);
      const Nearest nearest = entries->front();
      const auto at = static_cast<std::ptrdiff_t>(nearest.id);
      all.ids.push_back(ids[nearest.id]);
      all.distances_m.push_back(nearest.distance_m);
      left.erase(left.begin() + at);
      ids.erase(ids.begin() + at);
    }
    all.offsets.push_back(static_cast<std::int64_t>(all.ids.size()));
  }
  return all;
}

TEST_P(CAnswers, OfTwoSetsAreThoseOfBruteForce) {
  for (const Split how : kSplits) {
    const TwoSets sets = split(GetParam().points, how);
    const beespace_points points = c_points(sets.points);
    const beespace_points others = c_points(sets.others);
    const Within within{GetParam().threshold_m, true, {}};
    const SearchOptions options = options_of(within);
    const beespace_search plain = search_within(within);
    const beespace_search measured = search_within(within, BEESPACE_DISTANCES);
    SCOPED_TRACE(name_of(how));

    Columns at_risk;
    at_risk.ids = wide(*brute_force::find_at_risk_between(sets.points, sets.others, options));
    expect(at_risk, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_at_risk(engine, &points, &others, &plain, run, result, error);
    });
    const auto pairs = *brute_force::find_pairs_between(sets.points, sets.others, options);
    Columns found = columns_of(pairs);
    found.distances_m = distances(sets.points, sets.others, pairs);
    expect(found, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_pairs(engine, &points, &others, &measured, run, result, error);
    });
    IdRows rows = *brute_force::find_neighbors_between(sets.points, sets.others, options);
    rows.offsets.resize(sets.points.size() + 1);
    expect(with_row_distances(columns_of(rows), sets.points, sets.others),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_neighbors(engine, &points, &others, &measured, run, result, error);
           });
    Columns counts;
    counts.counts = wide(*brute_force::count_neighbors_between(sets.points, sets.others, options));
    expect(counts, [&](auto* engine, auto* run, auto* result, auto* error) {
      return beespace_count(engine, &points, &others, &plain, run, result, error);
    });
    expect(columns_of(*brute_force::find_nearest_within_between(sets.points, sets.others, options)),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_nearest_within(engine, &points, &others, &plain, run, result, error);
           });
    if (how != Split::kAgainstItself && how != Split::kHalves) {
      for (const std::int64_t k : {1, 3}) {
        expect(nearest_between(sets.points, sets.others, static_cast<std::size_t>(k)),
               [&](auto* engine, auto* run, auto* result, auto* error) {
                 return beespace_nearest(engine, &points, &others, k, run, result, error);
               });
      }
    }
    expect(closest(*brute_force::find_closest_pair_between(sets.points, sets.others)),
           [&](auto* engine, auto* run, auto* result, auto* error) {
             return beespace_closest_pair(engine, &points, &others, run, result, error);
           });
  }
}

struct Visited {
  std::vector<Pair> pairs;
  std::vector<double> distances_m;
  std::size_t batches_left = 1'000'000;
};

int note(void* data, const std::int64_t* first, const std::int64_t* second, const double* distances,
         std::int64_t count) {
  auto& visited = *static_cast<Visited*>(data);
  for (std::int64_t i = 0; i < count; ++i) {
    visited.pairs.push_back({static_cast<PointId>(first[i]), static_cast<PointId>(second[i])});
    if (distances != nullptr) visited.distances_m.push_back(distances[i]);
  }
  return --visited.batches_left == 0 ? 0 : 1;
}

TEST_P(CAnswers, VisitorsSeeEachPairOnceWithItsDistance) {
  const std::vector<Point>& points = GetParam().points;
  const beespace_points given = c_points(points);
  const beespace_search search = c_search(GetParam().threshold_m, BEESPACE_DISTANCES);
  Visited visited;
  beespace_error error = c_error();
  ASSERT_EQ(beespace_visit_pairs(engine_.get(), &given, &search, nullptr, note, &visited, &error),
            BEESPACE_OK)
      << error.message;
  EXPECT_EQ(visited.distances_m, pair_distances(points, visited.pairs));
  std::sort(visited.pairs.begin(), visited.pairs.end());
  EXPECT_EQ(visited.pairs,
            *brute_force::find_pairs(points, {.threshold_m = GetParam().threshold_m}));
}

INSTANTIATE_TEST_SUITE_P(Scenes, CAnswers, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(CVisitor, EndsTheSearchWithoutAnError) {
  const std::vector<Point> points(1000);
  const beespace_points given = c_points(points);
  const beespace_search search = c_search(1.0);
  Visited visited;
  visited.batches_left = 1;
  EXPECT_EQ(beespace_visit_pairs(nullptr, &given, &search, nullptr, note, &visited, nullptr),
            BEESPACE_OK);
  EXPECT_GT(visited.pairs.size(), 0U);
  EXPECT_LE(visited.pairs.size(), kMostPairsAtOnce);
}

// The column of the first answer has room for one distance only.
TEST(CColumns, AResultUsedAgainHasNoDistancesThatAreNotAskedFor) {
  const std::vector<Point> two = {{0, 0, 0}, {0, 0, 1}};
  const std::vector<Point> many(600);
  const beespace_points few_given = c_points(two);
  const beespace_points many_given = c_points(many);
  const beespace_search measured = c_search(2.0, BEESPACE_DISTANCES);
  const beespace_search plain = c_search(2.0);
  beespace_result* const result = beespace_result_create();
  for (const auto ask : {beespace_pairs, beespace_neighbors}) {
    EXPECT_EQ(ask(nullptr, &few_given, nullptr, &measured, nullptr, result, nullptr), BEESPACE_OK);
    EXPECT_EQ(beespace_result_distances_m(result)[0], 1.0);
    EXPECT_EQ(ask(nullptr, &many_given, nullptr, &plain, nullptr, result, nullptr), BEESPACE_OK);
    EXPECT_EQ(beespace_result_size(result), ask == beespace_pairs ? 600 * 599 / 2 : 600 * 599);
    EXPECT_EQ(beespace_result_distances_m(result), nullptr);
  }
  beespace_result_free(result);
}

}  // namespace
}  // namespace beespace::test
