// `beespace detect --vertical`: horizontal distance and height compared apart.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

// On the ground: a and d at the same place, b and c 4 m from there. In height: a and b 0, c 3, d 9.
constexpr std::string_view kFour = "id,x,y,z\na,0,0,0\nb,0,4,0\nc,0,4,3\nd,0,0,9\n";

Finished asked(const Arguments& more, std::string_view input = kFour) {
  return run(Arguments{"detect"} + more, input);
}

TEST(Vertical, OnlyBeesCloseOnTheGroundAndInHeightAreAtRisk) {
  EXPECT_EQ(asked({"--threshold", "5", "--vertical", "4"}).out, "a\nb\nc\n");
  EXPECT_EQ(asked({"--threshold", "5", "--vertical", "3"}).out, "a\nb\n");
  EXPECT_EQ(asked({"--threshold", "4", "--vertical", "4"}).out, "b\nc\n");
  EXPECT_EQ(asked({"--threshold", "4", "--vertical", "3"}).out, "");
  EXPECT_EQ(asked({"--threshold", "1", "--vertical", "9.5"}).out, "a\nb\nc\nd\n");
}

TEST(Vertical, ExactlyTheThresholdsCountsOnlyWhenInclusive) {
  const Arguments exactly = {"--threshold", "4", "--vertical", "3", "--report", "pairs"};
  EXPECT_EQ(below_header(asked(exactly).out), "");
  EXPECT_EQ(below_header(asked(exactly + Arguments{"--inclusive"}).out),
            "a\tb\t4\t4\t0\na\tc\t5\t4\t3\nb\tc\t3\t0\t3\n");
}

TEST(Vertical, EveryReportThatTakesItAgrees) {
  const Arguments question = {"--threshold", "5", "--vertical", "4", "--report"};
  EXPECT_EQ(below_header(asked(question + Arguments{"pairs"}).out),
            "a\tb\t4\t4\t0\na\tc\t5\t4\t3\nb\tc\t3\t0\t3\n");
  EXPECT_EQ(below_header(asked(question + Arguments{"neighbors"}).out),
            "a\t2\tb\tc\nb\t2\ta\tc\nc\t2\ta\tb\nd\t0\n");
  EXPECT_EQ(below_header(asked(question + Arguments{"counts"}).out), "a\t2\nb\t2\nc\t2\nd\t0\n");
  EXPECT_EQ(below_header(asked(question + Arguments{"groups"}).out), "0\t3\ta\tb\tc\n");
  // d is 9 m from a, and its cylinder is empty.
  EXPECT_EQ(below_header(asked(question + Arguments{"nearest"}).out),
            "a\tb\t4\nb\tc\t3\nc\tb\t3\nd\t\t\n");
  EXPECT_EQ(below_header(asked(question + Arguments{"nearest", "--at-risk-only"}).out),
            "a\tb\t4\nb\tc\t3\nc\tb\t3\n");
  EXPECT_EQ(asked(question + Arguments{"pairs", "--csv"}).out,
            "first,second,distance_m,horizontal_m,vertical_m\na,b,4,4,0\na,c,5,4,3\nb,c,3,0,3\n");
}

// On the equator a thousandth of a degree is 111.319 m; c is at height 0.
constexpr std::string_view kAircraft =
    "id,lon,lat,alt_ft\na,0,0,1000\nb,0.001,0,1600\nc,0.001,0,0\nd,5,0,1000\n";

TEST(Vertical, PairsOfAircraftAreInNauticalMilesAndFeetToo) {
  const Arguments question = {"--separation", "enroute", "--report", "pairs"};
  const auto rows = rows_of(asked(question + Arguments{"--csv"}, kAircraft).out, ',');
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"first", "second", "distance_m", "horizontal_m",
                                               "vertical_m", "horizontal_NM", "vertical_ft"}));
  EXPECT_EQ(rows[1][0] + rows[1][1], "ab");
  EXPECT_NEAR(std::stod(rows[1][3]), 111.31949, 1e-4);
  EXPECT_NEAR(std::stod(rows[1][5]), 111.31949 / 1852, 1e-7);
  EXPECT_NEAR(std::stod(rows[1][4]), 182.88, 1e-9);
  EXPECT_EQ(rows[1][6], "600");
  const std::string json = asked(question + Arguments{"--json"}, kAircraft).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("vertical_ft": 600})"});
  const auto metric =
      rows_of(asked(question + Arguments{"--csv", "--units", "metric"}, kAircraft).out, ',');
  EXPECT_EQ(metric.at(0).size(), 5u);
}

TEST(Vertical, PairsBeyondMemoryAreTheSame) {
  const Arguments memory = {"--memory", "100MB", "--threads", "1"};
  for (const std::string& input :
       {std::string(kFour), std::string(kAircraft),
        std::string("id,lon,lat,height\na,0,0,0\nb,0.001,0,0\nc,0.001,0,3\n"),
        std::string("id,x,y,z_ft\na,0,0,0\nb,3,4,0\nc,3,4,8\n")}) {
    for (const Arguments& form : {Arguments{"--csv"}, Arguments{}}) {
      for (const Arguments& height :
           {Arguments{"--vertical", "5"}, Arguments{"--vertical", "900ft"},
            Arguments{"--vertical", "9ft"}}) {
        Arguments question = Arguments{"--threshold", "200", "--report", "pairs"} + height + form;
        if (input.find("z_ft") != std::string::npos) {
          question = question + Arguments{"--units", "position=m"};
        }
        const Finished in_memory = asked(question, input);
        const Finished beyond = asked(question + memory, input);
        ASSERT_EQ(in_memory.exit_code, 0) << in_memory.err;
        EXPECT_EQ(beyond.out, in_memory.out) << input << beyond.err;
        EXPECT_NE(in_memory.out.find("horizontal_m"), std::string::npos);
      }
    }
  }
}

TEST(Vertical, TheSummaryAndTheDocumentSayIt) {
  const Finished finished = asked({"--threshold", "5", "--vertical", "4", "--json"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out,
               {R"("threshold_m": 5)", R"("vertical_m": 4)", R"("at_risk_count": 3)"});
  expect_parts(finished.err,
               {"threshold  horizontally 5 m (closer than), and in height 4 m (closer than)\n",
                "at risk    3 (75.0 %)\n"});
  expect_parts(asked({"--threshold", "5", "--json"}).out, {R"("vertical_m": null)"});
}

TEST(Vertical, FailOnRiskIsAboutBoth) {
  EXPECT_EQ(asked({"--threshold", "4", "--vertical", "4", "--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(asked({"--threshold", "4", "--vertical", "3", "--fail-on-risk"}).exit_code, 0);
}

// Whole coordinates, so that squares are exact here, and many distances are exactly a threshold.
struct Bee {
  int x, y, z;
};

std::vector<Bee> some_bees() {
  std::vector<Bee> bees;
  unsigned state = 12'345;
  const auto next = [&state](int below) {
    state = state * 1'103'515'245u + 12'345u;
    return static_cast<int>((state >> 16) % static_cast<unsigned>(below));
  };
  for (int i = 0; i < 300; ++i) {
    const int x = next(60);
    const int y = next(60);
    bees.push_back({x, y, next(40)});
  }
  return bees;
}

bool near(const Bee& a, const Bee& b, int threshold, int vertical, bool inclusive) {
  const int square = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  const int rise = std::abs(a.z - b.z);
  if (inclusive) return square <= threshold * threshold && rise <= vertical;
  return square < threshold * threshold && rise < vertical;
}

TEST(Vertical, AgreesWithComparingAllPairs) {
  const auto bees = some_bees();
  std::string table = "x,y,z\n";
  for (const Bee& bee : bees) {
    table +=
        std::to_string(bee.x) + "," + std::to_string(bee.y) + "," + std::to_string(bee.z) + "\n";
  }
  for (const bool inclusive : {false, true}) {
    for (const auto& [threshold, vertical] :
         {std::pair{5, 3}, std::pair{3, 10}, std::pair{1, 40}}) {
      Arguments question = {"--threshold", std::to_string(threshold), "--vertical",
                            std::to_string(vertical), "--quiet"};
      if (inclusive) question.emplace_back("--inclusive");
      std::string pairs;
      std::string counts;
      for (std::size_t i = 0; i < bees.size(); ++i) {
        std::size_t count = 0;
        for (std::size_t j = 0; j < bees.size(); ++j) {
          if (j == i || !near(bees[i], bees[j], threshold, vertical, inclusive)) continue;
          ++count;
          if (j > i) pairs += std::to_string(i) + "\t" + std::to_string(j) + "\n";
        }
        counts += std::to_string(i) + "\t" + std::to_string(count) + "\n";
      }
      EXPECT_EQ(asked(question + Arguments{"--report", "counts"}, table).out,
                "id\tneighbor_count\n" + counts);
      std::string found;
      for (const auto& row : rows_of(asked(question + Arguments{"--report", "pairs"}, table).out)) {
        found += row.at(0) + "\t" + row.at(1) + "\n";
      }
      EXPECT_EQ(found, pairs) << threshold << " m, " << vertical << " m";
      EXPECT_FALSE(pairs.empty());
    }
  }
}

// Three above the equator, 0.01 degrees from one to the next, at 10,000 m and more.
class VerticalOverTheEarth : public testing::Test {
 protected:
  static constexpr std::string_view kAircraft =
      "id,longitude,latitude,height\nlow,0,0,10000\nhigh,0.01,0,10250\nhigher,0.02,0,10600\n";
  static constexpr double kRadius_m = 6'378'137.0;
  // What is between two neighbours at height 0, in a straight line; about 1113.2 m.
  const double apart_m_ = 2.0 * kRadius_m * std::sin(0.005 * std::numbers::pi / 180.0);
};

TEST_F(VerticalOverTheEarth, DistancesAreThoseOnTheGround) {
  const Arguments question = {"--report", "pairs", "--vertical", "300", "--quiet", "--threshold"};
  EXPECT_EQ(
      below_header(asked(question + Arguments{std::to_string(apart_m_ - 0.01)}, kAircraft).out),
      "");
  // Up there they are 1.7 m farther from each other.
  const auto rows =
      rows_of(asked(question + Arguments{std::to_string(apart_m_ + 0.01)}, kAircraft).out);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].at(0), "low");
  EXPECT_EQ(rows[0].at(1), "high");
  // The distance that is shown is the one in space.
  constexpr double kLow_m = kRadius_m + 10'000.0;
  constexpr double kHigh_m = kRadius_m + 10'250.0;
  const double across_m = apart_m_ / kRadius_m * std::sqrt(kLow_m * kHigh_m);
  EXPECT_NEAR(std::stod(rows[0].at(2)), std::hypot(across_m, kHigh_m - kLow_m), 1e-6);
}

TEST_F(VerticalOverTheEarth, HeightsAreThoseOfTheInput) {
  const Arguments question = {"--report", "pairs", "--threshold", "1200", "--quiet", "--vertical"};
  EXPECT_EQ(below_header(asked(question + Arguments{"250"}, kAircraft).out), "");
  EXPECT_EQ(rows_of(asked(question + Arguments{"250", "--inclusive"}, kAircraft).out).size(), 1u);
  EXPECT_EQ(rows_of(asked(question + Arguments{"351"}, kAircraft).out).size(), 2u);
}

TEST_F(VerticalOverTheEarth, RecordsThatAreSkippedTakeTheirHeightsWithThem) {
  std::string input(kAircraft);
  input.insert(input.find("high,"), "bad,0,95,10000\nworse,0,0,high\n");
  EXPECT_EQ(asked({"--skip-bad", "--threshold", "1200", "--vertical", "300"}, input).out,
            "low\nhigh\n");
}

TEST(Vertical, WhatDoesNotGoWithItIsRefused) {
  expect_usage_error({"detect", "--report", "closest-pair", "--vertical", "5"},
                     "--vertical does not apply to --report closest-pair");
  for (const std::string bad : {"0", "-5", "nan", "inf", "high", "5 m/s"}) {
    expect_usage_error({"detect", "--vertical=" + bad},
                       "--vertical '" + bad + "' is not a number of metres above 0");
  }
  expect_usage_error({"detect", "--vertical", ""}, "--vertical: the value is empty");
}

}  // namespace
}  // namespace beespace::cli_test
