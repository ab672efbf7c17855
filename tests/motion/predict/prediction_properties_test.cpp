// Properties of predictions that hold for any input.
#include "tests/motion/recorded/conflict_lists.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/pairs.hpp>
#include <beespace/predict_conflicts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using test::Conflicts;
using test::expect_same;
using test::MoverScene;
using test::pairs_of;

bool ascending(const Conflicts& conflicts) {
  const std::vector<Pair> pairs = pairs_of(conflicts);
  return std::all_of(pairs.begin(), pairs.end(),
                     [](const Pair& p) { return p.first < p.second; }) &&
         std::adjacent_find(pairs.begin(), pairs.end(), std::greater_equal<>()) == pairs.end();
}

using test::Shape;

// Calls check(scene, options, shape) for every scene and all options.
template <class Check>
void on_every_question(Check&& check) {
  for (const MoverScene& scene : test::mover_scenes()) {
    test::for_each_question([&](Shape shape, bool inclusive) {
      if (testing::Test::HasFatalFailure()) return;
      SCOPED_TRACE(scene.name + ", " + name_of(shape) + (inclusive ? ", inclusive" : ", strict"));
      check(scene, scene.options(shape, inclusive), shape);
    });
  }
}

// The two movers may be swapped: not even the last bit of a time changes.
TEST(PredictionProperties, RenamingTheMoversRenamesTheAnswer) {
  on_every_question([](const MoverScene& scene, const PredictOptions& options, Shape shape) {
    test::SceneMaker make(3);
    MoverScene renamed = scene;
    std::vector<PointId> new_id(scene.movers.size());
    std::iota(new_id.begin(), new_id.end(), PointId{0});
    for (std::size_t left = new_id.size(); left > 1; --left) {
      std::swap(new_id[left - 1], new_id[make.below(left)]);
    }
    for (PointId id = 0; id < new_id.size(); ++id) {
      renamed.movers[new_id[id]] = scene.movers[id];
      renamed.heights_m[new_id[id]] = scene.heights_m[id];
      renamed.climbs_mps[new_id[id]] = scene.climbs_mps[id];
    }
    Conflicts expected = *predict_conflicts(scene.view(shape), options);
    ASSERT_TRUE(ascending(expected));
    for (Conflict& c : expected) {
      const auto [low, high] = std::minmax(new_id[c.first], new_id[c.second]);
      c.first = low;
      c.second = high;
    }
    std::sort(expected.begin(), expected.end(), [](const Conflict& a, const Conflict& b) {
      return Pair{a.first, a.second} < Pair{b.first, b.second};
    });
    expect_same(*predict_conflicts(renamed.view(shape), options), expected);
  });
}

TEST(PredictionProperties, EveryConflictIsTheApproachOfTheTwo) {
  on_every_question([](const MoverScene& scene, const PredictOptions& options, Shape shape) {
    if (shape == Shape::kHeightsApart) return;  // an approach is of positions in space
    for (const Conflict& c : *predict_conflicts(scene.movers, options)) {
      const Approach approach =
          *closest_approach(scene.movers[c.first], scene.movers[c.second], options.approach());
      ASSERT_EQ(approach.conflict, (TimeSpan{c.begins_s, c.ends_s}));
      ASSERT_TRUE(c.certain);
      if (shape == Shape::kCylinder) continue;
      ASSERT_EQ(approach.closest_s, c.closest_s);
      ASSERT_EQ(approach.closest_m, c.closest_m);
    }
  });
}

// The third axis is as good a height as one that is kept apart from it.
TEST(PredictionProperties, HeightsApartFromThePlaneAreThoseOfSpace) {
  for (const MoverScene& scene : test::mover_scenes()) {
    MoverScene apart = scene;
    for (std::size_t i = 0; i < apart.movers.size(); ++i) {
      apart.heights_m[i] = std::exchange(apart.movers[i].position.z, 0.0);
      apart.climbs_mps[i] = std::exchange(apart.movers[i].velocity.z, 0.0);
    }
    for (const bool inclusive : {false, true}) {
      SCOPED_TRACE(scene.name + (inclusive ? ", inclusive" : ", strict"));
      const PredictOptions options = scene.options(Shape::kCylinder, inclusive);
      expect_same(*predict_conflicts(apart.view(Shape::kHeightsApart), options),
                  *predict_conflicts(scene.view(Shape::kCylinder), options));
    }
  }
}

TEST(PredictionProperties, WithoutAHorizonItIsTheSearchForPairs) {
  for (const MoverScene& scene : test::mover_scenes()) {
    SCOPED_TRACE(scene.name);
    for (const bool inclusive : {false, true}) {
      PredictOptions options = scene.options(Shape::kSphere, inclusive);
      options.horizon_s = 0.0;
      const Conflicts found = *predict_conflicts(scene.movers, options);
      const MoversView movers(scene.movers);
      const auto pairs = *find_pairs(movers.positions(), {scene.threshold_m, inclusive});
      EXPECT_TRUE(pairs_of(found) == pairs) << found.size() << ", not " << pairs.size();
      for (const Conflict& c : found) {
        ASSERT_EQ(c.begins_s, 0.0);
        ASSERT_EQ(c.closest_s, 0.0);
        ASSERT_EQ(c.ends_s, 0.0);
      }
    }
  }
}

TEST(PredictionProperties, AnswersGrowWithEveryLimit) {
  const auto includes = [](const Conflicts& more, const Conflicts& fewer) {
    const std::vector<Pair> all = pairs_of(more);
    const std::vector<Pair> some = pairs_of(fewer);
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  on_every_question([&](const MoverScene& scene, const PredictOptions& options, Shape shape) {
    const MoversView movers = scene.view(shape);
    const Conflicts found = *predict_conflicts(movers, options);
    PredictOptions sooner = options;
    sooner.horizon_s *= 0.5;
    EXPECT_TRUE(includes(found, *predict_conflicts(movers, sooner)));
    PredictOptions nearer = options;
    nearer.threshold_m = std::nextafter(0.75 * options.threshold_m, 0.0);
    EXPECT_TRUE(includes(found, *predict_conflicts(movers, nearer)));
    PredictOptions inclusive = options;
    inclusive.inclusive = true;
    EXPECT_TRUE(includes(*predict_conflicts(movers, inclusive), found));
    if (!options.vertical_m) return;
    PredictOptions thinner = options;
    *thinner.vertical_m *= 0.75;
    EXPECT_TRUE(includes(found, *predict_conflicts(movers, thinner)));
  });
}

// On a lattice velocities add up exactly, so a common velocity changes nothing.
TEST(PredictionProperties, ACommonVelocityChangesNothing) {
  test::SceneMaker make(9);
  for (int round = 0; round < test::rounds(60); ++round) {
    const std::vector<Mover> movers = test::lattice_flight(make, 60, 1.0, {0, 0, 0});
    std::vector<Mover> drifting = movers;
    for (Mover& m : drifting) m.velocity = test::faster(m.velocity, {4096, -7, 0x1p+30});
    const Shape shape = round % 2 == 0 ? Shape::kSphere : Shape::kCylinder;
    const PredictOptions options = MoverScene{"", {}, 3, 2, 2.5}.options(shape, round % 3 == 0);
    expect_same(*predict_conflicts(drifting, options), *predict_conflicts(movers, options));
  }
}

TEST(PredictionProperties, NoNumberOfThreadsChangesAnything) {
  test::SceneMaker make(10);
  // Enough for the library to give work to several.
  const std::vector<Mover> movers = test::flying(make, 30'000, {5000, 5000, 500}, 10);
  PredictOptions options = MoverScene{"", {}, 12, 5, 6}.options(Shape::kSphere, false);
  const Conflicts expected = *predict_conflicts(movers, options);
  EXPECT_GT(expected.size(), 1000U);
  for (const unsigned threads : {0U, 2U, 7U}) {
    options.threads = threads;
    SCOPED_TRACE(threads);
    expect_same(*predict_conflicts(movers, options), expected);
  }
}

TEST(PredictionProperties, EveryLayoutIsTheSame) {
  test::SceneMaker make(12);
  const std::vector<Mover> movers = test::flying(make, 200, {300, 300, 60}, 9);
  std::vector<double> xyz;
  std::vector<double> along[3];
  for (const auto& [p, v] : movers) {
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
    along[0].push_back(v.x);
    along[1].push_back(v.y);
    along[2].push_back(v.z);
  }
  const PredictOptions options = MoverScene{"", {}, 15, 5, 9}.options(Shape::kSphere, false);
  const Conflicts expected = *predict_conflicts(movers, options);
  EXPECT_GT(expected.size(), 20U);
  const PointsView velocities = PointsView::separate(along[0], along[1], along[2]);
  const MoversView view(PointsView::interleaved(xyz), velocities);
  ASSERT_EQ(view.size(), movers.size());
  expect_same(*predict_conflicts(view, options), expected);
}

// Relative to each other, a formation stands still. A search that covered the path of each bee
// would compare all bees with all others.
TEST(PredictionProperties, AFormationCostsAboutWhatASwarmAtRestDoes) {
  test::SceneMaker make(13);
  const std::size_t size = test::kSanitized ? 15'000 : 60'000;
  std::vector<Mover> movers = test::flying(make, size, {3000, 3000, 3000}, 0.0);
  PredictOptions options;
  options.threshold_m = 5.0;
  const auto seconds = [&] {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(predict_conflicts(movers, options).has_value());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double at_rest = seconds();
  for (Mover& mover : movers) mover.velocity = {20, 3, 1};
  EXPECT_LT(seconds(), 10.0 * at_rest + 0.1);
}

}  // namespace
}  // namespace beespace
