// The index of C answers as that of C++, whatever was inserted, moved and removed before.
#include "tests/c/c_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace beespace::test {
namespace {

struct Both {
  explicit Both(const std::vector<Point>& points) : reference(*Index::build(points)) {
    const beespace_points given = c_points(points);
    beespace_index* made = nullptr;
    EXPECT_EQ(beespace_index_create(&given, nullptr, &made, nullptr), BEESPACE_OK);
    index.reset(made);
  }
  Index reference;
  Owned<beespace_index> index;
  Owned<beespace_result> result{beespace_result_create()};
};

void expect_same_answers(Both& both, const std::vector<Point>& places) {
  const beespace_points given = c_points(places);
  const beespace_search search = c_search(30.0, BEESPACE_INCLUSIVE);
  ASSERT_EQ(
      beespace_index_around(both.index.get(), &given, &search, nullptr, both.result.get(), nullptr),
      BEESPACE_OK);
  EXPECT_EQ(columns(both.result),
            columns_of(*both.reference.find_around(places, {.radius_m = 30.0, .inclusive = true})));
  std::vector<double> radii;
  for (std::size_t i = 0; i < places.size(); ++i) radii.push_back(static_cast<double>(i % 40));
  const beespace_search each = c_search(0.0, BEESPACE_INCLUSIVE);
  ASSERT_EQ(beespace_index_around_each(both.index.get(), &given, radii.data(), &each, nullptr,
                                       both.result.get(), nullptr),
            BEESPACE_OK);
  EXPECT_EQ(columns(both.result),
            columns_of(*both.reference.find_around(places, radii, {.inclusive = true})));
  ASSERT_EQ(
      beespace_index_nearest(both.index.get(), &given, 3, nullptr, both.result.get(), nullptr),
      BEESPACE_OK);
  Columns nearest = columns(both.result);
  EXPECT_EQ(nearest.offsets.size(), places.size() + 1);
  nearest.offsets.clear();
  const NearestRows expected = *both.reference.k_nearest(places, 3);
  EXPECT_EQ(nearest, columns_of(expected.entries));
  EXPECT_EQ(beespace_index_size(both.index.get()),
            static_cast<std::int64_t>(both.reference.size()));
}

TEST(CIndex, AnswersAsThatOfCpp) {
  SceneMaker make(18);
  const std::vector<Point> points = make.box(300, {0, 0, 0}, {200, 200, 200});
  const std::vector<Point> places = make.box(100, {0, 0, 0}, {200, 200, 200});
  Both both(points);
  expect_same_answers(both, places);
  for (std::int64_t id = 0; id < 50; ++id) {
    const Point to = places[static_cast<std::size_t>(id)];
    const double position[3] = {to.x, to.y, to.z};
    std::int64_t added = -1;
    ASSERT_EQ(beespace_index_insert(both.index.get(), position, &added, nullptr), BEESPACE_OK);
    ASSERT_EQ(added, static_cast<std::int64_t>(*both.reference.insert(to)));
    const auto known = static_cast<PointId>(id);
    ASSERT_EQ(beespace_index_move(both.index.get(), id, position, nullptr), BEESPACE_OK);
    ASSERT_TRUE(both.reference.move(known, to));
    ASSERT_EQ(beespace_index_remove(both.index.get(), id + 100, nullptr), BEESPACE_OK);
    ASSERT_TRUE(both.reference.remove(known + 100));
  }
  expect_same_answers(both, places);
  double position[3] = {};
  ASSERT_EQ(beespace_index_position(both.index.get(), 7, position, nullptr), BEESPACE_OK);
  EXPECT_EQ(*both.reference.point(7), (Point{position[0], position[1], position[2]}));
}

TEST(CIndex, KnowsNoPointThatIsNotThere) {
  Both both({{1, 2, 3}});
  beespace_index* const index = both.index.get();
  double position[3] = {};
  for (const std::int64_t id : {std::int64_t{-1}, std::int64_t{1}, std::int64_t{1} << 32}) {
    beespace_error error = c_error();
    EXPECT_EQ(beespace_index_remove(index, id, &error), BEESPACE_INVALID_ARGUMENT);
    EXPECT_STRNE(error.message, "");
    EXPECT_EQ(beespace_index_move(index, id, position, nullptr), BEESPACE_INVALID_ARGUMENT);
    EXPECT_EQ(beespace_index_position(index, id, position, nullptr), BEESPACE_INVALID_ARGUMENT);
  }
  EXPECT_EQ(beespace_index_size(index), 1);
}

TEST(CIndex, RefusesNullAndWhatIsNoPosition) {
  Both both({{1, 2, 3}});
  const double nowhere[3] = {NAN, 0, 0};
  EXPECT_EQ(beespace_index_insert(both.index.get(), nowhere, nullptr, nullptr),
            BEESPACE_NOT_FINITE);
  EXPECT_EQ(beespace_index_insert(both.index.get(), nullptr, nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_index_insert(nullptr, nowhere, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  const beespace_points given = c_points({});
  EXPECT_EQ(beespace_index_create(&given, nullptr, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_index_nearest(nullptr, &given, 1, nullptr, both.result.get(), nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(
      beespace_index_nearest(both.index.get(), &given, -1, nullptr, both.result.get(), nullptr),
      BEESPACE_INVALID_ARGUMENT);
  beespace_search vertical = c_search(1.0, BEESPACE_VERTICAL);
  EXPECT_EQ(beespace_index_around(both.index.get(), &given, &vertical, nullptr, both.result.get(),
                                  nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_index_size(nullptr), 0);
}

TEST(CIndex, RefusesRadiiThatMakeNoSense) {
  Both both({{1, 2, 3}, {4, 5, 6}});
  const std::vector<Point> places = {{1, 2, 3}, {4, 5, 6}};
  const beespace_points given = c_points(places);
  const beespace_search none = c_search(0.0);
  const beespace_search one = c_search(1.0);
  const double radii[2] = {1.0, -1.0};
  beespace_error error = c_error();
  const auto ask = [&](const double* each, const beespace_search& search) {
    return beespace_index_around_each(both.index.get(), &given, each, &search, nullptr,
                                      both.result.get(), &error);
  };
  EXPECT_EQ(ask(radii, none), BEESPACE_INVALID_THRESHOLD);
  EXPECT_STREQ(error.place, "radii");
  EXPECT_EQ(error.record, 1);
  EXPECT_EQ(ask(nullptr, none), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(ask(radii, one), BEESPACE_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace beespace::test
