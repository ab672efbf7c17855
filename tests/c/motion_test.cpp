// Movers of C: predictions have the answer of brute force, closest approaches are in conflict
// exactly when fractions of any size say so; and what cannot be becomes an error that says where.
#include "tests/c/c_scenes.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/mover_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

beespace_points strided(const double* first, std::size_t count) {
  constexpr auto kStride = static_cast<std::ptrdiff_t>(sizeof(Mover));
  const double* const at = count == 0 ? nullptr : first;
  return {sizeof(beespace_points),
          BEESPACE_FLOAT64,
          0,
          static_cast<std::int64_t>(count),
          at,
          at == nullptr ? nullptr : at + 1,
          at == nullptr ? nullptr : at + 2,
          kStride,
          kStride,
          kStride};
}

struct CMovers {
  explicit CMovers(std::span<const Mover> movers)
      : positions(strided(movers.empty() ? nullptr : &movers.front().position.x, movers.size())),
        velocities(strided(movers.empty() ? nullptr : &movers.front().velocity.x, movers.size())) {}
  beespace_points positions;
  beespace_points velocities;
};

std::vector<double> reals(const double* first, std::int64_t count) {
  return first == nullptr ? std::vector<double>() : std::vector<double>(first, first + count);
}

std::vector<Conflict> conflicts_of(const beespace_result* from) {
  const std::int64_t size = beespace_result_size(from);
  std::vector<Conflict> all;
  for (std::int64_t i = 0; i < size; ++i) {
    all.push_back({static_cast<PointId>(beespace_result_first(from)[i]),
                   static_cast<PointId>(beespace_result_second(from)[i]),
                   beespace_result_begins_s(from)[i], beespace_result_closest_s(from)[i],
                   beespace_result_ends_s(from)[i], beespace_result_distances_m(from)[i]});
  }
  return all;
}

beespace_search search_of_scene(const MoverScene& scene, Shape shape, bool inclusive) {
  beespace_search search = c_search(scene.threshold_m);
  if (inclusive) search.flags |= BEESPACE_INCLUSIVE;
  if (shape == Shape::kCylinder) {
    search.flags |= BEESPACE_VERTICAL;
    search.vertical_m = scene.vertical_m;
  }
  return search;
}

// Of heights that are kept apart C knows nothing.
template <class Ask>
void for_each_question_of_c(Ask&& ask) {
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder}) {
    for (const bool inclusive : {false, true}) ask(shape, inclusive);
  }
}

class CMotion : public testing::TestWithParam<MoverScene> {
 protected:
  Owned<beespace_engine> engine_{beespace_engine_create()};
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_P(CMotion, PredictionsAreThoseOfBruteForce) {
  const MoverScene& scene = GetParam();
  const CMovers movers(scene.movers);
  beespace_run two{};
  two.struct_size = sizeof two;
  two.threads = 2;
  for_each_question_of_c([&](Shape shape, bool inclusive) {
    const beespace_search search = search_of_scene(scene, shape, inclusive);
    const auto expected =
        *brute_force::predict_conflicts(scene.view(shape), scene.options(shape, inclusive));
    for (const bool threads : {false, true}) {
      beespace_error error = c_error();
      const beespace_run* const run = threads ? &two : nullptr;
      beespace_engine* const engine = threads ? engine_.get() : nullptr;
      ASSERT_EQ(beespace_predict(engine, &movers.positions, &movers.velocities, &search,
                                 scene.horizon_s, run, result_.get(), &error),
                BEESPACE_OK)
          << error.message;
      EXPECT_EQ(conflicts_of(result_.get()), expected);
      Columns pairs;
      for (const Conflict& conflict : expected) {
        pairs.first.push_back(conflict.first);
        pairs.second.push_back(conflict.second);
      }
      ASSERT_EQ(beespace_predict_pairs(engine, &movers.positions, &movers.velocities, &search,
                                       scene.horizon_s, run, result_.get(), nullptr),
                BEESPACE_OK);
      EXPECT_EQ(columns(result_), pairs);
      EXPECT_EQ(beespace_result_begins_s(result_.get()), nullptr);
    }
  });
}

// Each mover and the next one.
TEST_P(CMotion, ApproachesAreInConflictExactlyWhenFractionsSaySo) {
  const MoverScene& scene = GetParam();
  if (scene.movers.size() < 2) return;
  const std::size_t count = std::min<std::size_t>(scene.movers.size() - 1, 60);
  const std::span<const Mover> all(scene.movers);
  const CMovers first(all.first(count));
  const CMovers second(all.subspan(1, count));
  for_each_question_of_c([&](Shape shape, bool inclusive) {
    const beespace_search search = search_of_scene(scene, shape, inclusive);
    beespace_error error = c_error();
    ASSERT_EQ(beespace_closest_approach(&first.positions, &first.velocities, &second.positions,
                                        &second.velocities, &search, scene.horizon_s, nullptr,
                                        result_.get(), &error),
              BEESPACE_OK)
        << error.message;
    ASSERT_EQ(beespace_result_size(result_.get()), static_cast<std::int64_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const ExactEncounter exact(all[i], all[i + 1], scene.options(shape, inclusive));
      EXPECT_EQ(!std::isnan(beespace_result_begins_s(result_.get())[i]), exact.in_conflict());
      EXPECT_EQ(!std::isnan(beespace_result_ends_s(result_.get())[i]), exact.in_conflict());
      const auto found =
          *closest_approach(all[i], all[i + 1], scene.options(shape, inclusive).approach());
      EXPECT_EQ(beespace_result_closest_s(result_.get())[i], found.closest_s);
      EXPECT_EQ(beespace_result_distances_m(result_.get())[i], found.closest_m);
      if (!found.conflict) continue;
      EXPECT_EQ(beespace_result_begins_s(result_.get())[i], found.conflict->begins_s);
      EXPECT_EQ(beespace_result_ends_s(result_.get())[i], found.conflict->ends_s);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Scenes, CMotion, testing::ValuesIn(mover_scenes()),
                         [](const auto& scene) { return scene.param.name; });

class CMoverArguments : public testing::Test {
 protected:
  beespace_code predict(double horizon_s = 10.0) {
    error_ = c_error();
    return beespace_predict(nullptr, &movers_.positions, &movers_.velocities, &search_, horizon_s,
                            run_, result_.get(), &error_);
  }
  beespace_code approach(const beespace_search* search, double horizon_s = 10.0) {
    error_ = c_error();
    return beespace_closest_approach(&movers_.positions, &movers_.velocities, &others_.positions,
                                     &others_.velocities, search, horizon_s, run_, result_.get(),
                                     &error_);
  }
  void expect_error(beespace_code code, beespace_code expected, const std::string& place,
                    std::int64_t record = -1) {
    EXPECT_EQ(code, expected) << error_.message;
    EXPECT_EQ(error_.place, place) << error_.message;
    EXPECT_EQ(error_.record, record) << error_.message;
    EXPECT_EQ(beespace_result_size(result_.get()), 0);
    EXPECT_EQ(beespace_result_closest_s(result_.get()), nullptr);
  }

  std::vector<Mover> list_ = {{{0, 0, 0}, {1, 0, 0}}, {{9, 0, 0}, {-1, 0, 0}}};
  std::vector<Mover> other_list_ = {{{0, 3, 0}, {1, 0, 0}}, {{0, 4, 0}, {0, 0, 0}}};
  CMovers movers_{list_};
  CMovers others_{other_list_};
  beespace_search search_ = c_search(5.0);
  const beespace_run* run_ = nullptr;
  beespace_error error_ = c_error();
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_F(CMoverArguments, ErrorsSayWhichArrayAndWhichOfIt) {
  list_[1].velocity.y = NAN;
  expect_error(predict(), BEESPACE_NOT_FINITE, "velocities", 1);
  expect_error(approach(&search_), BEESPACE_NOT_FINITE, "velocities", 1);
  list_[0].position.z = -INFINITY;
  expect_error(predict(), BEESPACE_NOT_FINITE, "positions", 0);
  expect_error(approach(&search_), BEESPACE_NOT_FINITE, "positions", 0);
  list_ = {{{1, 0, 0}, {}}, {{3, 0, 0}, {0x1p101, 0, 0}}};
  expect_error(predict(), BEESPACE_OUTSIDE_DOMAIN, "velocities", 1);
  list_ = {{{1, 0, 0}, {}}, {{3, 0, 0}, {}}};
  other_list_[1].position.x = 0x1p101;
  expect_error(approach(&search_), BEESPACE_OUTSIDE_DOMAIN, "other_positions", 1);
  other_list_[1].position.x = 0x1p-400;  // as good as 0
  other_list_[0].velocity.z = NAN;
  expect_error(approach(nullptr), BEESPACE_NOT_FINITE, "other_velocities", 0);
}

TEST_F(CMoverArguments, WhatMakesNoSenseIsRefused) {
  expect_error(predict(-1.0), BEESPACE_INVALID_ARGUMENT, "");
  expect_error(predict(NAN), BEESPACE_INVALID_ARGUMENT, "");
  expect_error(approach(&search_, INFINITY), BEESPACE_INVALID_ARGUMENT, "");
  search_.threshold_m = 0.0;
  expect_error(predict(), BEESPACE_INVALID_THRESHOLD, "");
  expect_error(approach(&search_), BEESPACE_INVALID_THRESHOLD, "");
  search_ = c_search(5.0, BEESPACE_DISTANCES);
  expect_error(predict(), BEESPACE_INVALID_ARGUMENT, "search");
  search_ = c_search(5.0, BEESPACE_MAX_RESULTS);
  expect_error(approach(&search_), BEESPACE_INVALID_ARGUMENT, "search");
  expect_error(predict(), BEESPACE_TOO_MANY_RESULTS, "");
  search_ = c_search(5.0);
  movers_.velocities.count = 1;
  expect_error(predict(), BEESPACE_INVALID_ARGUMENT, "velocities");
  movers_.positions.count = 1;
  expect_error(approach(&search_), BEESPACE_INVALID_ARGUMENT, "other_positions");
  movers_.velocities.struct_size = 7;
  expect_error(predict(), BEESPACE_INVALID_ARGUMENT, "velocities");
  EXPECT_EQ(beespace_predict(nullptr, &others_.positions, &others_.velocities, nullptr, 1.0,
                             nullptr, result_.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "search");
  EXPECT_EQ(beespace_predict(nullptr, &others_.positions, &others_.velocities, &search_, 1.0,
                             nullptr, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "result");
}

TEST_F(CMoverArguments, OptionsOfNoMoversAreCheckedToo) {
  movers_ = CMovers({});
  others_ = CMovers({});
  ASSERT_EQ(approach(&search_), BEESPACE_OK);
  EXPECT_EQ(beespace_result_size(result_.get()), 0);
  expect_error(approach(&search_, -1.0), BEESPACE_INVALID_ARGUMENT, "");
}

TEST_F(CMoverArguments, WithoutAThresholdThereIsNoConflictToTellOf) {
  // The first two fly side by side; the third comes towards one that waits.
  ASSERT_EQ(approach(nullptr), BEESPACE_OK) << error_.message;
  EXPECT_EQ(reals(beespace_result_closest_s(result_.get()), 2), (std::vector<double>{0.0, 9.0}));
  EXPECT_EQ(reals(beespace_result_distances_m(result_.get()), 2), (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(beespace_result_begins_s(result_.get()), nullptr);
  EXPECT_EQ(beespace_result_ends_s(result_.get()), nullptr);
}

TEST_F(CMoverArguments, AStrideOfZeroRepeatsOneAndFloatsAreRead) {
  const std::array<float, 3> at = {0.0F, 4.0F, 0.0F};
  const std::array<float, 3> still = {};
  others_.positions = {
      sizeof(beespace_points), BEESPACE_FLOAT32, 0, 2, &at[0], &at[1], &at[2], 0, 0, 0};
  others_.velocities = {
      sizeof(beespace_points), BEESPACE_FLOAT32, 0, 2, &still[0], &still[1], nullptr, 0, 0, 0};
  ASSERT_EQ(approach(&search_), BEESPACE_OK) << error_.message;
  EXPECT_EQ(reals(beespace_result_closest_s(result_.get()), 2), (std::vector<double>{0.0, 9.0}));
  // Times of conflicts are for reading, and rounded.
  EXPECT_EQ(beespace_result_begins_s(result_.get())[0], 0.0);
  EXPECT_DOUBLE_EQ(beespace_result_ends_s(result_.get())[0], 3.0);
  EXPECT_DOUBLE_EQ(beespace_result_begins_s(result_.get())[1], 6.0);
  EXPECT_EQ(beespace_result_ends_s(result_.get())[1], 10.0);
}

int poll_once(void* data) {
  ++*static_cast<int*>(data);
  return 1;
}

TEST_F(CMoverArguments, StopsAndPollsEndLongCalls) {
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_stop_request(stop.get());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  run_ = &run;
  expect_error(predict(), BEESPACE_STOPPED, "");
  expect_error(approach(&search_), BEESPACE_STOPPED, "");
  // More twos than any machine decides between two polls.
  run.stop = nullptr;
  int polls = 0;
  run.poll = poll_once;
  run.poll_data = &polls;
  for (auto* const each :
       {&movers_.positions, &movers_.velocities, &others_.positions, &others_.velocities}) {
    each->count = 20'000'000;
    each->x_stride = each->y_stride = each->z_stride = 0;
  }
  expect_error(approach(&search_), BEESPACE_STOPPED, "");
  EXPECT_EQ(polls, 1);
  run_ = nullptr;
}

TEST(CGeodesy, ConvertsAsTheLibraryDoes) {
  const std::array<double, 12> degrees = {0, 0, 0, 90, 0, 100, 13.4, 52.5, 34.5, -370, 95, 2e6};
  beespace_points given = beespace_points_interleaved(degrees.data(), 3);
  std::array<double, 12> xyz{};
  beespace_error error = c_error();
  ASSERT_EQ(beespace_to_ecef(&given, xyz.data(), &error), BEESPACE_OK) << error.message;
  EXPECT_EQ(xyz[0], 6378137.0);
  EXPECT_EQ(xyz[4], 6378237.0);
  const Point berlin = *to_ecef(GeographicPosition{13.4, 52.5, 34.5});
  EXPECT_EQ((Point{xyz[6], xyz[7], xyz[8]}), berlin);
  EXPECT_EQ(xyz[9], 0.0);  // nothing is written behind the last one
  given.count = 4;
  EXPECT_EQ(beespace_to_ecef(&given, xyz.data(), &error), BEESPACE_INVALID_LATITUDE);
  EXPECT_STREQ(error.place, "positions");
  EXPECT_EQ(error.record, 3);
}

TEST(CGeodesy, TurnsVelocitiesAsTheLibraryDoes) {
  std::array<double, 6> degrees = {13.4, 52.5, 34.5, 90, 0, 100};
  std::array<double, 6> speeds = {1, 2, 3, -4, 5, -6};
  const beespace_points places = beespace_points_interleaved(degrees.data(), 2);
  beespace_points velocities = beespace_points_interleaved(speeds.data(), 2);
  std::array<double, 7> xyz{};
  beespace_error error = c_error();
  const auto turn = [&] {
    return beespace_to_ecef_velocity(&places, &velocities, xyz.data(), &error);
  };
  ASSERT_EQ(turn(), BEESPACE_OK) << error.message;
  const Velocity first = *to_ecef_velocity({13.4, 52.5, 34.5}, {1, 2, 3});
  const Velocity second = *to_ecef_velocity({90, 0, 100}, {-4, 5, -6});
  EXPECT_EQ((Velocity{xyz[0], xyz[1], xyz[2]}), first);
  EXPECT_EQ((Velocity{xyz[3], xyz[4], xyz[5]}), second);
  EXPECT_EQ(xyz[6], 0.0);
  speeds[4] = NAN;
  EXPECT_EQ(turn(), BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error.place, "velocities");
  EXPECT_EQ(error.record, 1);
  degrees[4] = NAN;
  EXPECT_EQ(turn(), BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error.place, "positions");
  degrees[4] = 91;
  EXPECT_EQ(turn(), BEESPACE_INVALID_LATITUDE);
  EXPECT_EQ(error.record, 1);
  velocities.count = 1;
  EXPECT_EQ(turn(), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "velocities");
  EXPECT_EQ(beespace_to_ecef_velocity(&places, nullptr, xyz.data(), &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_to_ecef_velocity(nullptr, &velocities, xyz.data(), &error),
            BEESPACE_INVALID_ARGUMENT);
  velocities.count = 2;
  EXPECT_EQ(beespace_to_ecef_velocity(&places, &velocities, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "xyz");
}

TEST(CGeodesy, RefusesWhatCannotBe) {
  const std::array<double, 3> degrees = {13.4, 52.5, 34.5};
  std::array<double, 6> xyz{};
  beespace_error error = c_error();
  beespace_points given = beespace_points_interleaved(degrees.data(), 1);
  EXPECT_EQ(beespace_to_ecef(&given, nullptr, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "xyz");
  auto* const crooked = reinterpret_cast<double*>(reinterpret_cast<char*>(xyz.data()) + 4);
  EXPECT_EQ(beespace_to_ecef(&given, crooked, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "xyz");
  given.z = nullptr;
  EXPECT_EQ(beespace_to_ecef(&given, xyz.data(), &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "positions");
  EXPECT_EQ(beespace_to_ecef(nullptr, xyz.data(), &error), BEESPACE_INVALID_ARGUMENT);
  given = beespace_points_interleaved(nullptr, 0);
  EXPECT_EQ(beespace_to_ecef(&given, nullptr, &error), BEESPACE_OK);
}

}  // namespace
}  // namespace beespace::test
