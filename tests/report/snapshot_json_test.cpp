// The data of a page agree with the facts of a snapshot.
#include "report/snapshot_json.hpp"

#include "tests/report/page_reader.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/engine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::report {
namespace {

using report_test::has;
using report_test::Json;
using report_test::numbers_of;
using report_test::ParsedJson;
using report_test::text_of;
using report_test::values_of;
using test::rounds;
using test::SceneMaker;

std::string json_of(const SnapshotFacts& facts, Columns& columns) {
  std::string text;
  io::JsonWriter json(text);
  write_swarm(json, facts, columns);
  return text;
}

// As a page has it.
struct Read {
  explicit Read(const SnapshotFacts& facts) : json(json_of(facts, columns)) {}

  Json operator[](std::string_view key) const { return json[key]; }
  [[nodiscard]] std::vector<double> values(Json column) const {
    return values_of(column, columns.elements());
  }
  [[nodiscard]] std::vector<std::uint64_t> numbers(Json column) const {
    return numbers_of(column, columns.elements());
  }

  Columns columns;
  ParsedJson json;
};

// Bees all about; only their positions are known.
SnapshotFacts somewhere(std::size_t count) {
  SceneMaker make(5);
  SnapshotFacts facts;
  facts.swarm.threshold_m = 5.0;
  facts.positions = make.ragged_box(count, {-100, 20, 7}, {300, 21, 7});
  facts.nearest.assign(count, {0, 1.0});
  return facts;
}

double position_error(const Read& read, const std::vector<Point>& positions) {
  const auto x = read.values(read["positions"]["x"]);
  const auto y = read.values(read["positions"]["y"]);
  const auto z = read.values(read["positions"]["z"]);
  EXPECT_EQ(x.size(), positions.size());
  double worst_m = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst_m = std::max(worst_m, distance({x[i], y.at(i), z.at(i)}, positions[i]));
  }
  return worst_m;
}

void expect_positions(const Read& read, const std::vector<Point>& positions) {
  const double error_m = double(read["position_error_m"]);
  const double worst_m = position_error(read, positions);
  EXPECT_LE(worst_m, error_m * (1.0 + 1e-12));
  EXPECT_GE(worst_m, 0.1 * error_m);
}

TEST(SnapshotJson, DescribesTheSwarm) {
  SnapshotFacts facts = somewhere(3);
  facts.swarm = {.title = "a.csv",
                 .source = "text",
                 .origin = GeographicPosition{-75.5, 6.25, 0.0},
                 .threshold_m = 0.1,
                 .vertical_m = 2.5,
                 .inclusive = true,
                 .names = {.texts = {"p", "q"}, .bees = {0, 2}},
                 .notes = {"one", "two"}};
  const Read read(facts);
  EXPECT_EQ(text_of(read["kind"]), "snapshot");
  EXPECT_EQ(text_of(read["title"]), "a.csv");
  EXPECT_EQ(text_of(read["source"]), "text");
  EXPECT_EQ(std::uint64_t(read["count"]), 3u);
  EXPECT_EQ(report_test::texts_of(read["axes"]),
            (std::vector<std::string>{"east", "north", "height"}));
  EXPECT_EQ(double(read["origin"]["longitude_deg"]), -75.5);
  EXPECT_EQ(double(read["origin"]["latitude_deg"]), 6.25);
  EXPECT_EQ(double(read["origin"]["height_m"]), 0.0);
  EXPECT_EQ(double(read["threshold_m"]), 0.1);
  EXPECT_EQ(double(read["vertical_m"]), 2.5);
  EXPECT_TRUE(bool(read["inclusive"]));
  EXPECT_EQ(report_test::texts_of(read["notes"]), (std::vector<std::string>{"one", "two"}));
  const auto names = report_test::column_of(read["names"]["texts"], read.columns.elements());
  EXPECT_EQ(names.texts, (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(read.numbers(read["names"]["bees"]), (std::vector<std::uint64_t>{0, 2}));
}

TEST(SnapshotJson, OmitsWhatIsAbsent) {
  const Read read(somewhere(2));
  EXPECT_EQ(report_test::texts_of(read["axes"]), (std::vector<std::string>{"x", "y", "z"}));
  for (const char* key : {"origin", "vertical_m", "names"}) {
    EXPECT_FALSE(has(read.json.root(), key)) << key;
  }
  EXPECT_FALSE(bool(read["inclusive"]));
  EXPECT_TRUE(simdjson::dom::array(read["notes"]).begin() ==
              simdjson::dom::array(read["notes"]).end());
}

TEST(SnapshotJson, NamesOfAllNeedNoNumbers) {
  SnapshotFacts facts = somewhere(2);
  facts.swarm.names.texts = {"p", "q"};
  EXPECT_FALSE(has(Read(facts)["names"], "bees"));
}

TEST(SnapshotJson, AtRiskIsABitOfEachBee) {
  SceneMaker make(6);
  for (std::size_t count = 0; count < 60; ++count) {
    SnapshotFacts facts = somewhere(count);
    for (PointId bee = 0; bee < count; ++bee) {
      if (make.below(3) == 0) facts.at_risk.push_back(bee);
    }
    const Read read(facts);
    const auto bits = read.numbers(read["at_risk"]);
    EXPECT_EQ(bits.size(), (count + 7) / 8);
    std::vector<PointId> at_risk;
    for (PointId bee = 0; bee < 8 * bits.size(); ++bee) {
      if (((bits[bee / 8] >> (bee % 8)) & 1u) != 0) at_risk.push_back(bee);
    }
    EXPECT_EQ(at_risk, facts.at_risk);
    EXPECT_EQ(std::uint64_t(read["risk"]["at_risk"]), facts.at_risk.size());
  }
}

void expect_nearest(const SnapshotFacts& facts) {
  const Read read(facts);
  const auto codes = read.numbers(read["nearest"]["code"]);
  const double least_m = double(read["nearest"]["least_m"]);
  const double ratio = double(read["nearest"]["ratio"]);
  ASSERT_EQ(codes.size(), facts.nearest.size());
  ASSERT_GE(ratio, 1.0);
  const double half = std::sqrt(ratio) * (1.0 + 1e-9);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const double true_m = facts.nearest[i].distance_m;
    ASSERT_EQ(codes[i] == 0, true_m == 0.0);
    if (codes[i] == 0) continue;
    const double decoded_m = least_m * std::pow(ratio, static_cast<double>(codes[i]) - 1.0);
    ASSERT_LE(decoded_m, true_m * half);
    ASSERT_GE(decoded_m, true_m / half);
  }
}

SnapshotFacts with_nearest(const std::vector<double>& distances_m) {
  SnapshotFacts facts = somewhere(distances_m.size());
  for (std::size_t i = 0; i < distances_m.size(); ++i) facts.nearest[i] = {0, distances_m[i]};
  return facts;
}

TEST(SnapshotJson, TheNearestAreExactOverManyPowersOfTen) {
  SceneMaker make(8);
  for (int round = 0; round < rounds(100); ++round) {
    const double low = make.between(-14.0, 2.0);
    const double powers = make.below(4) == 0 ? 1e-9 : make.between(0.0, 14.0);
    std::vector<double> distances_m(2 + make.below(500));
    for (double& to_m : distances_m) {
      to_m = make.below(9) == 0 ? 0.0 : std::pow(10.0, low + make.between(0.0, powers));
    }
    expect_nearest(with_nearest(distances_m));
  }
}

TEST(SnapshotJson, NearestDistancesAreWrittenInInvisiblySmallSteps) {
  const Read read(with_nearest({1e-6, 1e6, 1.0}));
  EXPECT_LT(double(read["nearest"]["ratio"]), 1.0005);
  EXPECT_EQ(read.numbers(read["nearest"]["code"]), (std::vector<std::uint64_t>{1, 65'535, 32'768}));
}

TEST(SnapshotJson, TheNearestMayAllBeEquallyFar) {
  expect_nearest(with_nearest({3.0, 3.0, 3.0}));
  expect_nearest(with_nearest({0.0, 0.0}));
  expect_nearest(with_nearest({0.0, 7.0, 0.0}));
  expect_nearest(with_nearest({0x1p-400, 0x1p+401}));
}

TEST(SnapshotJson, ASingleBeeHasNoneNear) {
  SnapshotFacts facts = somewhere(1);
  facts.nearest = {Nearest{}};
  const Read read(facts);
  EXPECT_FALSE(has(read.json.root(), "nearest"));
  EXPECT_FALSE(has(read["risk"], "closest"));
  EXPECT_EQ(position_error(read, facts.positions), 0.0);
}

TEST(SnapshotJson, ThereMayBeNoBees) {
  const Read read(SnapshotFacts{});
  EXPECT_EQ(std::uint64_t(read["count"]), 0u);
  EXPECT_FALSE(has(read.json.root(), "nearest"));
  EXPECT_TRUE(read.values(read["positions"]["x"]).empty());
  EXPECT_TRUE(read.numbers(read["pairs"]["first"]).empty());
}

TEST(SnapshotJson, TheRiskIsThatOfAll) {
  SnapshotFacts facts = somewhere(2);
  facts.pair_count = 12'345'678'901'234;
  facts.group_count = 17;
  facts.largest_group = 9;
  facts.closest = ClosestPair{0, 1, 0.1};
  const Read read(facts);
  EXPECT_EQ(std::uint64_t(read["risk"]["pairs"]), facts.pair_count);
  EXPECT_EQ(std::uint64_t(read["risk"]["groups"]), 17u);
  EXPECT_EQ(std::uint64_t(read["risk"]["largest_group"]), 9u);
  EXPECT_EQ(std::uint64_t(read["risk"]["closest"]["first"]), 0u);
  EXPECT_EQ(std::uint64_t(read["risk"]["closest"]["second"]), 1u);
  EXPECT_EQ(double(read["risk"]["closest"]["distance_m"]), 0.1);
}

// So many pairs, with these distances at first and last, ascending.
SnapshotFacts with_pairs(std::size_t count, double first_m, double last_m) {
  SnapshotFacts facts = somewhere(2);
  for (std::size_t i = 0; i < count; ++i) {
    const double share =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, count - 1));
    facts.pairs.push_back({static_cast<PointId>(i * 7), 4'294'000'000u - static_cast<PointId>(i)});
    facts.distances_m.push_back(first_m + share * share * (last_m - first_m));
  }
  return facts;
}

void expect_pairs(const SnapshotFacts& facts, const char* type, double error_m) {
  const Read read(facts);
  const Json pairs = read["pairs"];
  const auto firsts = read.numbers(pairs["first"]);
  const auto seconds = read.numbers(pairs["second"]);
  const auto distances_m = read.values(pairs["distance_m"]);
  EXPECT_EQ(text_of(pairs["distance_m"]["type"]), type);
  ASSERT_EQ(firsts.size(), facts.pairs.size());
  ASSERT_EQ(seconds.size(), facts.pairs.size());
  ASSERT_EQ(distances_m.size(), facts.pairs.size());
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    ASSERT_EQ(firsts[i], facts.pairs[i].first);
    ASSERT_EQ(seconds[i], facts.pairs[i].second);
    ASSERT_NEAR(distances_m[i], facts.distances_m[i], error_m);
  }
  EXPECT_TRUE(std::is_sorted(distances_m.begin(), distances_m.end()));
}

TEST(SnapshotJson, FewPairsAreWrittenExactly) {
  expect_pairs(with_pairs(0, 0, 0), "f64", 0.0);
  expect_pairs(with_pairs(1, 0.1, 0.1), "f64", 0.0);
  expect_pairs(with_pairs(10'000, 1e-9, 123.456), "f64", 0.0);
}

TEST(SnapshotJson, DistancesOfManyPairsAreWrittenInSmallSteps) {
  const double half_a_step = 0.5 / 16'777'215.0;
  expect_pairs(with_pairs(10'001, 0.0, 123.456), "u32", 123.456 * half_a_step * (1.0 + 1e-6));
  expect_pairs(with_pairs(10'001, 5.0, 5.0), "u32", 1e-14);
  expect_pairs(with_pairs(10'001, 0.0, 0.0), "u32", 0.0);
}

TEST(SnapshotJson, PositionsAreWithinTheStatedError) {
  for (const std::size_t count : {2u, 1'000u}) {
    const SnapshotFacts facts = somewhere(count);
    expect_positions(Read(facts), facts.positions);
  }
}

TEST(SnapshotJson, OfVeryManyAFewBitsLessAreWrittenAndThatIsStated) {
  constexpr std::size_t kMany = 250'000;
  const SnapshotFacts enough = somewhere(kMany);
  const SnapshotFacts more = somewhere(kMany + 1);
  const Read with_all(enough);
  const Read with_fewer(more);
  expect_positions(with_all, enough.positions);
  expect_positions(with_fewer, more.positions);
  EXPECT_NEAR(double(with_fewer["position_error_m"]) / double(with_all["position_error_m"]), 2.0,
              0.01);
  std::vector<double> distances_m(kMany + 1);
  for (std::size_t i = 0; i < distances_m.size(); ++i) {
    distances_m[i] = std::pow(10.0, 12.0 * static_cast<double>(i) / kMany - 6.0);
  }
  expect_nearest(with_nearest(distances_m));
}

}  // namespace
}  // namespace beespace::report
