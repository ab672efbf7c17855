// Points beyond memory: C answers as a search in memory does, block by block, and refuses what
// makes no sense.
#include "tests/c/c_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

const std::string& folder() {
  static const std::string path = std::filesystem::temp_directory_path().string();
  return path;
}

beespace_out_of_core_options least() {
  beespace_out_of_core_options options{};
  options.struct_size = sizeof options;
  options.memory_bytes = std::uint64_t{16} << 20U;
  options.folder = folder().c_str();
  return options;
}

// What visitors have seen.
struct Seen {
  Numbers ids;
  Numbers counts;
  std::vector<Pair> pairs;
  std::vector<double> distances_m;
  std::int64_t length = 0;
  int calls = 0;
  int end_at = std::numeric_limits<int>::max();

  int called() { return ++calls >= end_at ? 0 : 1; }
};

int see_ids(void* data, const std::int64_t* ids, std::int64_t count) {
  auto& seen = *static_cast<Seen*>(data);
  seen.ids.insert(seen.ids.end(), ids, ids + count);
  return seen.called();
}

int see_counts(void* data, const std::int64_t* ids, const std::int64_t* counts,
               std::int64_t count) {
  auto& seen = *static_cast<Seen*>(data);
  seen.counts.insert(seen.counts.end(), counts, counts + count);
  return see_ids(data, ids, count);
}

int see_pairs(void* data, const std::int64_t* first, const std::int64_t* second,
              const double* distances_m, std::int64_t count) {
  auto& seen = *static_cast<Seen*>(data);
  for (std::int64_t i = 0; i < count; ++i) {
    seen.pairs.push_back({static_cast<PointId>(first[i]), static_cast<PointId>(second[i])});
    if (distances_m != nullptr) seen.distances_m.push_back(distances_m[i]);
  }
  return seen.called();
}

int see_nearest(void* data, const std::int64_t* ids, std::int64_t rows, const std::int64_t* nearest,
                const double* distances_m, std::int64_t length) {
  auto& seen = *static_cast<Seen*>(data);
  seen.length = length;
  seen.counts.insert(seen.counts.end(), nearest, nearest + rows * length);
  seen.distances_m.insert(seen.distances_m.end(), distances_m, distances_m + rows * length);
  return see_ids(data, ids, rows);
}

class COutOfCore : public testing::Test {
 protected:
  void SetUp() override {
    const beespace_out_of_core_options options = least();
    beespace_out_of_core* made = nullptr;
    ASSERT_EQ(beespace_out_of_core_create(&options, &made, &error_), BEESPACE_OK);
    search_.reset(made);
  }
  // Half of them on the disk, the others where they are.
  void give_all(const double* heights_m = nullptr) {
    const std::vector<Point> part(points_.begin(), points_.begin() + 60'000);
    const beespace_points first = c_points(part);
    ASSERT_EQ(beespace_out_of_core_add(search_.get(), &first, heights_m, &error_), BEESPACE_OK);
    beespace_points rest = c_points(points_);
    rest.count -= first.count;
    rest.x = &points_[part.size()].x;
    rest.y = &points_[part.size()].y;
    rest.z = &points_[part.size()].z;
    const double* const heights = heights_m == nullptr ? nullptr : heights_m + part.size();
    ASSERT_EQ(beespace_out_of_core_refer(search_.get(), &rest, heights, &error_), BEESPACE_OK);
    EXPECT_EQ(beespace_out_of_core_size(search_.get()), 120'000);
  }

  std::vector<Point> points_ = SceneMaker(5).box(120'000, {0, 0, 0}, {50, 50, 50});
  Owned<beespace_out_of_core> search_;
  beespace_error error_ = c_error();
};

TEST_F(COutOfCore, AnswersAsASearchInMemory) {
  give_all();
  const beespace_search asked = c_search(1.0, BEESPACE_DISTANCES);
  const beespace_search plain = c_search(1.0);
  const SearchOptions options{.threshold_m = 1.0};

  Seen at_risk;
  ASSERT_EQ(
      beespace_out_of_core_at_risk(search_.get(), &plain, nullptr, see_ids, &at_risk, &error_),
      BEESPACE_OK);
  std::sort(at_risk.ids.begin(), at_risk.ids.end());
  EXPECT_EQ(at_risk.ids, wide(*find_at_risk(points_, options)));
  EXPECT_GT(at_risk.calls, 1);

  beespace_out_of_core_facts facts{};
  facts.struct_size = sizeof facts;
  ASSERT_EQ(beespace_out_of_core_facts_of(search_.get(), &facts, &error_), BEESPACE_OK);
  EXPECT_GT(facts.cells, 1);
  EXPECT_GT(facts.copies, 0);
  EXPECT_GT(facts.largest_cell, 0);

  Seen pairs;
  ASSERT_EQ(beespace_out_of_core_pairs(search_.get(), &asked, nullptr, see_pairs, &pairs, &error_),
            BEESPACE_OK);
  ASSERT_EQ(pairs.distances_m.size(), pairs.pairs.size());
  for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
    const auto [first, second] = pairs.pairs[i];
    ASSERT_EQ(pairs.distances_m[i], distance(points_[first], points_[second]));
  }
  std::sort(pairs.pairs.begin(), pairs.pairs.end());
  EXPECT_EQ(pairs.pairs, *find_pairs(points_, options));
  Seen bare;
  ASSERT_EQ(beespace_out_of_core_pairs(search_.get(), &plain, nullptr, see_pairs, &bare, &error_),
            BEESPACE_OK);
  EXPECT_EQ(bare.pairs.size(), pairs.pairs.size());
  EXPECT_TRUE(bare.distances_m.empty());

  Seen counted;
  ASSERT_EQ(
      beespace_out_of_core_count(search_.get(), &plain, nullptr, see_counts, &counted, &error_),
      BEESPACE_OK);
  Numbers counts(points_.size(), -1);
  for (std::size_t i = 0; i < counted.ids.size(); ++i) {
    counts[static_cast<std::size_t>(counted.ids[i])] = counted.counts[i];
  }
  EXPECT_EQ(counts, wide(*count_neighbors(points_, options)));

  // So many that the rows of a block come in several calls.
  Seen near;
  ASSERT_EQ(beespace_out_of_core_nearest(search_.get(), 20, nullptr, see_nearest, &near, &error_),
            BEESPACE_OK);
  ASSERT_EQ(near.length, 20);
  ASSERT_EQ(near.ids.size(), points_.size());
  const NearestRows expected = *find_k_nearest(points_, 20);
  for (std::size_t entry = 0; entry < near.counts.size(); ++entry) {
    const Nearest& wanted = expected[static_cast<std::size_t>(near.ids[entry / 20])][entry % 20];
    ASSERT_EQ(near.counts[entry], static_cast<std::int64_t>(wanted.id));
    ASSERT_EQ(near.distances_m[entry], wanted.distance_m);
  }

  const Owned<beespace_result> result(beespace_result_create());
  ASSERT_EQ(beespace_out_of_core_closest_pair(search_.get(), nullptr, result.get(), &error_),
            BEESPACE_OK);
  const ClosestPair closest = **find_closest_pair(points_);
  EXPECT_EQ(columns(result).first, Numbers{closest.first});
  EXPECT_EQ(columns(result).second, Numbers{closest.second});
  EXPECT_EQ(columns(result).distances_m, std::vector<double>{closest.distance_m});
}

TEST_F(COutOfCore, ComparesHeightsApart) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    heights.push_back(static_cast<double>(i % 7));
  }
  give_all(heights.data());
  beespace_search asked = c_search(1.5, BEESPACE_VERTICAL);
  asked.vertical_m = 2.0;
  SearchOptions options{.threshold_m = 1.5};
  options.vertical_m = 2.0;
  beespace_run run{};
  run.struct_size = sizeof run;
  Seen pairs;
  ASSERT_EQ(beespace_out_of_core_pairs(search_.get(), &asked, &run, see_pairs, &pairs, &error_),
            BEESPACE_OK);
  std::sort(pairs.pairs.begin(), pairs.pairs.end());
  EXPECT_EQ(pairs.pairs, *find_pairs(PointsView(points_).with_heights(heights), options));
  const Owned<beespace_result> result(beespace_result_create());
  EXPECT_EQ(beespace_out_of_core_closest_pair(search_.get(), nullptr, result.get(), &error_),
            BEESPACE_INVALID_ARGUMENT);
}

TEST_F(COutOfCore, AVisitorOrAStopEndsACallAndTheNextOneIsWhole) {
  give_all();
  const beespace_search asked = c_search(1.0);
  Seen some;
  some.end_at = 1;
  EXPECT_EQ(beespace_out_of_core_pairs(search_.get(), &asked, nullptr, see_pairs, &some, &error_),
            BEESPACE_OK);
  EXPECT_EQ(some.calls, 1);
  const Owned<beespace_stop> stop(beespace_stop_create());
  beespace_stop_request(stop.get());
  beespace_run run{};
  run.struct_size = sizeof run;
  run.stop = stop.get();
  EXPECT_EQ(beespace_out_of_core_at_risk(search_.get(), &asked, &run, see_ids, &some, &error_),
            BEESPACE_STOPPED);
  run.stop = nullptr;
  run.poll = [](void*) { return 1; };
  EXPECT_EQ(beespace_out_of_core_nearest(search_.get(), 8, &run, see_nearest, &some, &error_),
            BEESPACE_STOPPED);
  Seen all;
  EXPECT_EQ(beespace_out_of_core_at_risk(search_.get(), &asked, nullptr, see_ids, &all, &error_),
            BEESPACE_OK);
  const auto expected = find_at_risk(points_, {.threshold_m = 1.0});
  EXPECT_EQ(all.ids.size(), expected->size());
}

TEST_F(COutOfCore, RefusesWhatMakesNoSense) {
  beespace_out_of_core* made = nullptr;
  const auto create = [&](const beespace_out_of_core_options& options) {
    return beespace_out_of_core_create(&options, &made, &error_);
  };
  auto options = least();
  options.memory_bytes = 1000;
  EXPECT_EQ(create(options), BEESPACE_INVALID_ARGUMENT);
  EXPECT_NE(std::string(error_.message).find("16 MiB"), std::string::npos);
  options = least();
  options.folder = nullptr;
  EXPECT_EQ(create(options), BEESPACE_INVALID_ARGUMENT);
  options = least();
  options.struct_size = 3;
  EXPECT_EQ(create(options), BEESPACE_INVALID_ARGUMENT);
  options = least();
  options.reserved = 1;
  EXPECT_EQ(create(options), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_create(nullptr, &made, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_create(&options, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  beespace_out_of_core_free(nullptr);
  EXPECT_EQ(beespace_out_of_core_size(nullptr), 0);

  beespace_out_of_core* const used = search_.get();
  const beespace_search asked = c_search(1.0);
  const beespace_search none = c_search(0.0);
  Seen seen;
  EXPECT_EQ(beespace_out_of_core_at_risk(nullptr, &asked, nullptr, see_ids, &seen, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_at_risk(used, nullptr, nullptr, see_ids, &seen, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_at_risk(used, &asked, nullptr, nullptr, &seen, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_at_risk(used, &none, nullptr, see_ids, &seen, nullptr),
            BEESPACE_INVALID_THRESHOLD);
  EXPECT_EQ(beespace_out_of_core_nearest(used, -1, nullptr, see_nearest, &seen, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_closest_pair(used, nullptr, nullptr, nullptr),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_facts_of(used, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_out_of_core_add(used, nullptr, nullptr, nullptr), BEESPACE_INVALID_ARGUMENT);

  beespace_run four{};
  four.struct_size = sizeof four;
  four.threads = 4;
  EXPECT_EQ(beespace_out_of_core_at_risk(used, &asked, &four, see_ids, &seen, &error_),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_NE(std::string(error_.message).find("64 MiB"), std::string::npos);

  points_[7].y = std::numeric_limits<double>::quiet_NaN();
  const beespace_points wrong = c_points(points_);
  EXPECT_EQ(beespace_out_of_core_add(used, &wrong, nullptr, &error_), BEESPACE_NOT_FINITE);
  EXPECT_EQ(error_.record, 7);
  EXPECT_EQ(beespace_out_of_core_size(used), 0);
  alignas(8) const char bytes[32] = {};
  const std::vector<Point> one(1);
  const beespace_points given = c_points(one);
  const auto* const askew = reinterpret_cast<const double*>(bytes + 1);
  EXPECT_EQ(beespace_out_of_core_add(used, &given, askew, &error_), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(std::string(error_.place), "heights");
  EXPECT_EQ(seen.calls, 0);

  options = least();
  options.folder = "/no/such/folder";
  ASSERT_EQ(create(options), BEESPACE_OK);
  const Owned<beespace_out_of_core> nowhere(made);
  EXPECT_EQ(beespace_out_of_core_add(made, &given, nullptr, &error_), BEESPACE_WRITE_FAILED);
}

}  // namespace
}  // namespace beespace::test
