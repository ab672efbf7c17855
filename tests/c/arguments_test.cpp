// What callers of C can get wrong becomes a code and a message: sizes of structures, pointers,
// strides, flags. What they may do otherwise works: strides of all kinds, floats, planes, older and
// later headers.
#include "tests/c/c_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

class CArguments : public testing::Test {
 protected:
  beespace_code ask() {
    error_ = c_error();
    return beespace_pairs(nullptr, &points_, nullptr, &search_, run_, result_.get(), &error_);
  }
  void expect_refused(const std::string& place) {
    ASSERT_EQ(ask(), BEESPACE_INVALID_ARGUMENT);
    EXPECT_EQ(error_.code, BEESPACE_INVALID_ARGUMENT);
    EXPECT_EQ(error_.place, place);
    EXPECT_STRNE(error_.message, "");
    EXPECT_EQ(columns(result_), Columns());
  }
  void expect_one_pair() {
    ASSERT_EQ(ask(), BEESPACE_OK) << error_.message;
    EXPECT_EQ(columns(result_), columns_of(std::vector<Pair>{{0, 1}}));
  }

  std::array<double, 9> xyz_ = {0, 0, 0, 3, 4, 0, 100, 0, 0};
  beespace_points points_ = beespace_points_interleaved(xyz_.data(), 3);
  beespace_search search_ = c_search(6.0);
  const beespace_run* run_ = nullptr;
  beespace_error error_ = c_error();
  Owned<beespace_result> result_{beespace_result_create()};
};

TEST_F(CArguments, SizesOfStructuresThatWereNeverSetAreRefused) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, sizeof(beespace_points) - 1,
                                 std::size_t{5000}, std::numeric_limits<std::size_t>::max()}) {
    points_.struct_size = size;
    expect_refused("points");
  }
  points_ = beespace_points_interleaved(xyz_.data(), 3);
  search_.struct_size = sizeof search_ - 8;
  expect_refused("search");
  search_ = c_search(6.0);
  beespace_run run{};
  run_ = &run;
  expect_refused("run");
  run.struct_size = sizeof run;
  expect_one_pair();
}

TEST_F(CArguments, LaterStructuresAreReadWhereTheyAskForNothingMore) {
  struct Later {
    beespace_search search;
    std::uint64_t more;
  };
  Later later{search_, 0};
  later.search.struct_size = sizeof later;
  EXPECT_EQ(
      beespace_pairs(nullptr, &points_, nullptr, &later.search, nullptr, result_.get(), nullptr),
      BEESPACE_OK);
  later.more = 1;
  EXPECT_EQ(
      beespace_pairs(nullptr, &points_, nullptr, &later.search, nullptr, result_.get(), &error_),
      BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "search");
}

TEST_F(CArguments, ErrorsAreWrittenOnlyWhereThereIsRoom) {
  search_.threshold_m = 0.0;
  beespace_error small = c_error();
  small.struct_size = 16;
  EXPECT_EQ(beespace_pairs(nullptr, &points_, nullptr, &search_, nullptr, result_.get(), &small),
            BEESPACE_INVALID_THRESHOLD);
  EXPECT_EQ(small.code, BEESPACE_OK);
  EXPECT_EQ(beespace_pairs(nullptr, &points_, nullptr, &search_, nullptr, result_.get(), nullptr),
            BEESPACE_INVALID_THRESHOLD);
}

TEST_F(CArguments, NullPointersAreRefused) {
  EXPECT_EQ(beespace_pairs(nullptr, nullptr, nullptr, &search_, nullptr, result_.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "points");
  EXPECT_EQ(beespace_pairs(nullptr, &points_, nullptr, nullptr, nullptr, result_.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "search");
  EXPECT_EQ(beespace_pairs(nullptr, &points_, nullptr, &search_, nullptr, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "result");
  EXPECT_EQ(beespace_visit_pairs(nullptr, &points_, &search_, nullptr, nullptr, nullptr, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error_.place, "visit");
  points_.y = nullptr;
  expect_refused("points");
  beespace_engine_free(nullptr);
  beespace_engine_release_memory(nullptr);
  beespace_result_free(nullptr);
  beespace_index_free(nullptr);
  beespace_stop_free(nullptr);
  beespace_stop_request(nullptr);
  EXPECT_EQ(beespace_result_size(nullptr), 0);
  EXPECT_EQ(beespace_result_rows(nullptr), 0);
  EXPECT_EQ(beespace_result_ids(nullptr), nullptr);
}

TEST_F(CArguments, PointsThatCannotBeAreRefused) {
  points_.count = -1;
  expect_refused("points");
  points_.count = 3;
  points_.type = 2;
  expect_refused("points");
  points_.type = BEESPACE_FLOAT64;
  points_.reserved = 1;
  expect_refused("points");
  points_.reserved = 0;
  points_.x_stride = 12;
  expect_refused("points");
  points_.x_stride = std::numeric_limits<std::ptrdiff_t>::min();
  expect_refused("points");
  points_.x_stride = 24;
  points_.x = reinterpret_cast<const char*>(xyz_.data()) + 4;
  expect_refused("points");
  points_.x = xyz_.data();
  expect_one_pair();
}

TEST_F(CArguments, ReservedFieldsMustBeZeroAndStridesMustNotOverflow) {
  search_.reserved = 1;
  expect_refused("search");
  search_.reserved = 0;
  beespace_run run{};
  run.struct_size = sizeof run;
  run.reserved = 1;
  run_ = &run;
  expect_refused("run");
  run_ = nullptr;
  for (const std::ptrdiff_t stride : {std::numeric_limits<std::ptrdiff_t>::max() / 8 * 8,
                                      std::numeric_limits<std::ptrdiff_t>::max() / 16 * 8,
                                      -(std::numeric_limits<std::ptrdiff_t>::max() / 16 * 8)}) {
    points_.z_stride = stride;
    expect_refused("points");
  }
  points_.z_stride = 24;
  points_.x = nullptr;
  expect_refused("points");
}

TEST_F(CArguments, TooManyPointsAreRefusedBeforeOneIsRead) {
  points_.count = std::int64_t{1} << 33;
  points_.x_stride = points_.y_stride = points_.z_stride = 0;
  for (const std::int64_t count :
       {std::int64_t{1} << 33, std::numeric_limits<std::int64_t>::max()}) {
    points_.count = count;
    EXPECT_EQ(ask(), BEESPACE_TOO_MANY_POINTS);
    EXPECT_STREQ(error_.place, "points");
  }
}

// Each would go on for ages, or until memory is gone.
TEST_F(CArguments, TooManyReportsMomentsAndIntrudersAreRefusedBeforeOneIsRead) {
  points_.count = std::numeric_limits<std::int64_t>::max();
  points_.x_stride = points_.y_stride = points_.z_stride = 0;
  const auto expect_too_many = [&](beespace_code code) {
    EXPECT_EQ(code, BEESPACE_TOO_MANY_POINTS);
    EXPECT_STREQ(error_.place, "positions");
    error_ = c_error();
  };
  beespace_swarm_options of_swarm{};
  of_swarm.struct_size = sizeof of_swarm;
  of_swarm.threshold_m = 5.0;
  beespace_swarm* swarm = nullptr;
  ASSERT_EQ(beespace_swarm_create(&of_swarm, &swarm, nullptr), BEESPACE_OK);
  const std::int64_t agent = 1;
  const double time_s = 0.0;
  beespace_fixes fixes{};
  fixes.struct_size = sizeof fixes;
  fixes.agents = &agent;
  fixes.times_s = &time_s;
  expect_too_many(beespace_swarm_update(swarm, &fixes, &points_, nullptr, nullptr, &error_));
  beespace_swarm_free(swarm);
  beespace_verify_options of_verifier{};
  of_verifier.struct_size = sizeof of_verifier;
  of_verifier.flags = BEESPACE_VERIFY_STRAIGHT;
  of_verifier.threshold_m = 5.0;
  beespace_verifier* verifier = nullptr;
  ASSERT_EQ(beespace_verifier_create(&of_verifier, &verifier, nullptr), BEESPACE_OK);
  expect_too_many(beespace_verifier_add(verifier, 0.0, &points_, nullptr, nullptr, &error_));
  beespace_verifier_free(verifier);
  beespace_guide_options of_guide{};
  of_guide.struct_size = sizeof of_guide;
  of_guide.threshold_m = 2.0;
  of_guide.max_speed_mps = 6.0;
  of_guide.max_acceleration_mps2 = 4.0;
  beespace_guide* guide = nullptr;
  ASSERT_EQ(beespace_guide_create(&of_guide, &guide, nullptr), BEESPACE_OK);
  expect_too_many(
      beespace_guide_set_intruders(guide, &points_, &points_, nullptr, nullptr, nullptr, &error_));
  beespace_guide_free(guide);
}

TEST_F(CArguments, AValueWithoutItsFlagIsRefused) {
  search_.vertical_m = 3.0;
  expect_refused("search");
  search_.vertical_m = 0.0;
  search_.max_results = 1;
  expect_refused("search");
  search_.max_results = 0;
  expect_one_pair();
}

TEST_F(CArguments, FlagsThatAFunctionDoesNotKnowAreRefused) {
  search_.flags = BEESPACE_WITH_SELF;
  expect_refused("search");
  search_.flags = 1U << 31;
  expect_refused("search");
  search_.flags = BEESPACE_DISTANCES;
  EXPECT_EQ(beespace_at_risk(nullptr, &points_, nullptr, &search_, nullptr, result_.get(), nullptr),
            BEESPACE_INVALID_ARGUMENT);
  search_.flags = BEESPACE_WITH_SELF;
  EXPECT_EQ(
      beespace_neighbors(nullptr, &points_, &points_, &search_, nullptr, result_.get(), nullptr),
      BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_count(nullptr, &points_, &points_, &search_, nullptr, result_.get(), nullptr),
            BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CArguments, ErrorsNameTheSetAndThePoint) {
  search_.threshold_m = NAN;
  EXPECT_EQ(ask(), BEESPACE_INVALID_THRESHOLD);
  EXPECT_EQ(error_.record, -1);
  search_.threshold_m = 6.0;
  std::array<double, 9> other = xyz_;
  other[5] = NAN;
  const beespace_points others = beespace_points_interleaved(other.data(), 3);
  EXPECT_EQ(beespace_pairs(nullptr, &points_, &others, &search_, nullptr, result_.get(), &error_),
            BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "others");
  EXPECT_EQ(error_.record, 1);
  EXPECT_EQ(beespace_nearest(nullptr, &points_, &others, 2, nullptr, result_.get(), &error_),
            BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "others");
  EXPECT_EQ(beespace_nearest(nullptr, &others, &points_, 2, nullptr, result_.get(), &error_),
            BEESPACE_NOT_FINITE);
  EXPECT_STREQ(error_.place, "points");
  EXPECT_EQ(error_.record, 1);
  xyz_[0] = 0x1p500;
  EXPECT_EQ(ask(), BEESPACE_OUTSIDE_DOMAIN);
  EXPECT_EQ(error_.record, 0);
}

TEST_F(CArguments, LimitsAreErrorsAndNeverCutAnAnswer) {
  search_.flags = BEESPACE_MAX_RESULTS;
  search_.max_results = 1;
  expect_one_pair();
  search_.max_results = 0;
  EXPECT_EQ(ask(), BEESPACE_TOO_MANY_RESULTS);
  EXPECT_EQ(columns(result_), Columns());
  // Two neighbours and three points that are their own.
  search_.flags |= BEESPACE_WITH_SELF;
  for (const std::uint64_t limit : {2U, 4U, 5U}) {
    search_.max_results = limit;
    EXPECT_EQ(
        beespace_neighbors(nullptr, &points_, nullptr, &search_, nullptr, result_.get(), &error_),
        limit == 5 ? BEESPACE_OK : BEESPACE_TOO_MANY_RESULTS);
    if (limit == 5) continue;
    const std::string message = error_.message;
    EXPECT_EQ(message.find("more than " + std::to_string(limit) + " results"), 10) << message;
  }
  EXPECT_EQ(beespace_result_size(result_.get()), 5);
}

TEST_F(CArguments, AnyStridesFloatsAndPlanesAreRead) {
  // Backwards: the far point is the first one.
  points_ = beespace_points_interleaved(xyz_.data(), 3);
  points_.x = xyz_.data() + 6;
  points_.y = xyz_.data() + 7;
  points_.z = xyz_.data() + 8;
  points_.x_stride = points_.y_stride = points_.z_stride = -24;
  ASSERT_EQ(ask(), BEESPACE_OK);
  EXPECT_EQ(columns(result_), columns_of(std::vector<Pair>{{1, 2}}));

  const std::array<float, 3> x = {0, 3, 100};
  const std::array<float, 6> y = {0, -1, 4, -1, 0, -1};
  points_ = {sizeof points_, BEESPACE_FLOAT32, 0, 3, x.data(), y.data(), nullptr, 4, 8, 0};
  expect_one_pair();
  const float one_y = 4;
  points_.y = &one_y;
  points_.y_stride = 0;
  expect_one_pair();

  const std::array<double, 3> wide_x = {0, 3, 100};
  const std::array<double, 3> wide_y = {0, 4, 0};
  points_ = beespace_points_separate(wide_x.data(), wide_y.data(), nullptr, 3);
  expect_one_pair();
  points_ = beespace_points_interleaved(xyz_.data(), 1);
  points_.x_stride = 13;
  ASSERT_EQ(ask(), BEESPACE_OK) << error_.message;
  points_ = beespace_points_separate(nullptr, nullptr, nullptr, 0);
  ASSERT_EQ(ask(), BEESPACE_OK);
  EXPECT_EQ(columns(result_), Columns());
}

TEST(CCodes, HaveTheNamesOfTheCommand) {
  EXPECT_STREQ(beespace_code_name(BEESPACE_OK), "ok");
  EXPECT_STREQ(beespace_code_name(BEESPACE_INVALID_THRESHOLD), "invalid_threshold");
  EXPECT_STREQ(beespace_code_name(BEESPACE_STOPPED), "stopped");
  EXPECT_STREQ(beespace_code_name(BEESPACE_OUT_OF_MEMORY), "out_of_memory");
  EXPECT_STREQ(beespace_code_name(BEESPACE_INTERNAL), "internal");
  EXPECT_STREQ(beespace_code_name(24), "unknown");
  EXPECT_STREQ(beespace_code_name(-1), "unknown");
  for (beespace_code code = 1; code <= BEESPACE_STOPPED; ++code) {
    EXPECT_EQ(beespace_code_name(code), to_string(static_cast<ErrorCode>(code - 1)));
  }
  EXPECT_EQ(beespace_version(), version());
}

}  // namespace
}  // namespace beespace::test
