// Points in float arrays are read in place: each question gives the answers for the same values as
// doubles.
#include "tests/support/rounds.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace {
namespace {

// The values of floats, as floats and as doubles.
struct Scene {
  std::string name;
  double threshold_m = 0.0;
  std::vector<float> xyz;
  std::vector<Point> points;
};

Scene rounded(const test::SearchScene& scene) {
  Scene made{scene.name, scene.threshold_m, {}, {}};
  for (const Point& point : scene.points) {
    for (const double value : {point.x, point.y, point.z}) {
      made.xyz.push_back(static_cast<float>(value));
    }
  }
  // From memory, in a loop of its own: GCC 12 at -O3 leaves out the rounding where both are
  // together.
  for (std::size_t i = 0; i < made.xyz.size(); i += 3) {
    made.points.push_back({double{made.xyz[i]}, double{made.xyz[i + 1]}, double{made.xyz[i + 2]}});
  }
  return made;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const test::SearchScene& scene : test::search_scenes()) {
    Scene made = rounded(scene);
    // What lies beyond the floats is infinite.
    if (brute_force::find_at_risk(made.points, {made.threshold_m})) all.push_back(std::move(made));
  }
  test::SceneMaker make(4);
  const std::size_t many = test::kSanitized ? 2'000 : 20'000;
  all.push_back(rounded({"Box", make.box(many, {0, 0, 0}, {900, 900, 90}), 8.0}));
  // A crowd, and its twin far away.
  const std::size_t crowd = test::kSanitized ? 600 : 3'000;
  auto clumps = make.box(crowd, {0, 0, 0}, {1, 1, 1});
  for (const Point& point : make.box(crowd, {0, 0, 0}, {1, 1, 1})) {
    clumps.push_back({point.x + 1e6, point.y, point.z});
  }
  all.push_back(rounded({"Clumps", clumps, 2.0}));
  return all;
}

// The layouts of one scene: x0 y0 z0 x1 ..., one array an axis, members of a structure backwards.
struct Layouts {
  struct Bee {
    double battery;
    float east;
    float north;
    float height;
  };

  explicit Layouts(const Scene& scene) : interleaved(PointsView::interleaved(scene.xyz)) {
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) axes[axis].push_back(scene.xyz[3 * i + axis]);
    }
    for (std::size_t i = scene.points.size(); i-- > 0;) {
      bees.push_back({0.5, axes[0][i], axes[1][i], axes[2][i]});
    }
    separate = PointsView::separate(axes[0], axes[1], axes[2]);
    if (bees.empty()) return;
    backwards = PointsView::strided(&bees.back().east, &bees.back().north, &bees.back().height,
                                    bees.size(), -static_cast<std::ptrdiff_t>(sizeof(Bee)));
  }

  std::array<std::vector<float>, 3> axes;
  std::vector<Bee> bees;
  PointsView interleaved;
  PointsView separate;
  PointsView backwards;
};

TEST(FloatPoints, HaveTheirValuesAsDoubles) {
  const std::vector<float> xyz = {0.1F, -2.5F, 1e-45F, 3e38F, 5.0F, 6.0F};
  const PointsView view = PointsView::interleaved(xyz);
  ASSERT_EQ(view.size(), 2U);
  EXPECT_TRUE(view.holds_floats());
  EXPECT_EQ(view[0], (Point{double{0.1F}, -2.5, double{1e-45F}}));
  EXPECT_EQ(view[1].x, double{3e38F});
  EXPECT_EQ(view.with_axes({2, 0, 1})[1], (Point{6.0, double{3e38F}, 5.0}));
  EXPECT_FALSE(PointsView(std::vector<Point>{}).holds_floats());
}

TEST(FloatPoints, ThatDoNotFitAreRefused) {
  const std::vector<float> xyz = {1, 2, 3, 4};
  const auto refused = find_at_risk(PointsView::interleaved(xyz), {1.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
}

// 0.1F is a little more than 0.1, so the two are a little more than 0.1 apart.
TEST(FloatPoints, AreComparedExactly) {
  const std::vector<float> xyz = {0, 0, 0, 0.1F, 0, 0};
  const PointsView view = PointsView::interleaved(xyz);
  EXPECT_EQ(find_pairs(view, {.threshold_m = 0.1, .inclusive = true}).value().size(), 0U);
  EXPECT_EQ(find_pairs(view, {.threshold_m = double{0.1F}}).value().size(), 0U);
  EXPECT_EQ(find_pairs(view, {.threshold_m = double{0.1F}, .inclusive = true}).value().size(), 1U);
}

TEST(FloatPoints, GiveTheAnswersOfDoublesToEachQuestion) {
  for (const Scene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const Layouts layouts(scene);
    const PointsView doubles = scene.points;
    for (const unsigned threads : {1U, 3U}) {
      const SearchOptions options{scene.threshold_m, false, threads};
      const auto at_risk = *find_at_risk(doubles, options);
      const auto pairs = *find_pairs(doubles, options);
      const auto neighbors = *find_neighbors(doubles, options);
      const auto counts = *count_neighbors(doubles, options);
      const auto groups = *find_conflict_groups(doubles, options);
      const auto nearest = *find_nearest(doubles, threads);
      const auto within = *find_nearest_within(doubles, options);
      const auto closest = *find_closest_pair(doubles, threads);
      for (const PointsView& floats : {layouts.interleaved, layouts.separate, layouts.backwards}) {
        EXPECT_EQ(*find_at_risk(floats, options), at_risk);
        EXPECT_EQ(*find_pairs(floats, options), pairs);
        EXPECT_EQ(*find_neighbors(floats, options), neighbors);
        EXPECT_EQ(*count_neighbors(floats, options), counts);
        EXPECT_EQ(*find_conflict_groups(floats, options), groups);
        EXPECT_EQ(*find_nearest(floats, threads), nearest);
        EXPECT_EQ(*find_nearest_within(floats, options), within);
        EXPECT_EQ(*find_closest_pair(floats, threads), closest);
        EXPECT_EQ(pair_distances(floats, pairs), pair_distances(doubles, pairs));
      }
    }
  }
}

TEST(FloatPoints, GiveTheAnswersOfDoublesInCylindersAndBetweenTwoSets) {
  for (const Scene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const PointsView floats = PointsView::interleaved(scene.xyz);
    const PointsView doubles = scene.points;
    SearchOptions cylinder{scene.threshold_m};
    cylinder.vertical_m = scene.threshold_m / 2;
    const auto pairs = find_pairs(doubles, cylinder);
    ASSERT_EQ(find_pairs(floats, cylinder).has_value(), pairs.has_value());
    if (pairs) {
      EXPECT_EQ(*find_pairs(floats, cylinder), *pairs);
      EXPECT_EQ(*find_nearest_within(floats, cylinder), *find_nearest_within(doubles, cylinder));
    }
    for (const PointsView& others : {doubles, floats}) {
      EXPECT_EQ(*find_at_risk_between(floats, others, {scene.threshold_m}),
                *find_at_risk_between(doubles, doubles, {scene.threshold_m}));
      EXPECT_EQ(*find_nearest_between(floats, others), *find_nearest_between(doubles, doubles));
    }
    if (scene.points.size() <= 2'000) {
      EXPECT_EQ(*brute_force::find_neighbors(floats, {scene.threshold_m}),
                *brute_force::find_neighbors(doubles, {scene.threshold_m}));
    }
    const Index index = *Index::build(floats);
    EXPECT_EQ(*index.k_nearest(floats, 3), *Index::build(doubles).value().k_nearest(doubles, 3));
    EXPECT_EQ(*index.find_around(floats, {scene.threshold_m}),
              *index.find_around(doubles, {scene.threshold_m}));
  }
}

TEST(FloatPoints, MoveAndLieOnTheEarthAsDoubles) {
  test::SceneMaker make(5);
  const Scene positions = rounded({"", make.box(2'000, {0, 0, 0}, {900, 900, 90}), 8.0});
  const Scene velocities = rounded({"", make.box(2'000, {-9, -9, -9}, {9, 9, 9}), 8.0});
  PredictOptions options;
  options.threshold_m = 8.0;
  const MoversView floats(PointsView::interleaved(positions.xyz),
                          PointsView::interleaved(velocities.xyz));
  const MoversView doubles(positions.points, velocities.points);
  EXPECT_EQ(*predict_conflicts(floats, options), *predict_conflicts(doubles, options));
  EXPECT_EQ(*predict_pairs(floats, options), *predict_pairs(doubles, options));

  const Scene places = rounded({"", make.box(1'000, {-180, -90, 0}, {180, 90, 900}), 8.0});
  std::vector<Point> of_floats(1'000);
  std::vector<Point> of_doubles(1'000);
  ASSERT_TRUE(to_ecef(PointsView::interleaved(places.xyz), of_floats));
  ASSERT_TRUE(to_ecef(places.points, of_doubles));
  EXPECT_EQ(of_floats, of_doubles);
}

}  // namespace
}  // namespace beespace
