// Every report of `beespace detect`, in every form, checked as text.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

// At 100 m 0-1 and 1-3 are too close, 4 and 5 are a group of their own, and 2 is alone.
constexpr std::string_view kMetres =
    "x,y,z\n0,0,0\n60,0,0\n1000,0,0\n60,80,0\n5000,0,0\n5000,0,5\n";
constexpr std::string_view kNamed =
    "id;x;y;z\nmaya;0;0;0\n\"wil\"\"li\";60;0;0\nflip;1000;0;0\nthekla;60;80;0\n";
constexpr std::string_view kDegrees =
    "longitude,latitude,height\n-75.5,6.25,1500\n-75.5,6.25,1530\n-75.4,6.25,1500\n";

Finished report(const std::string& name, std::string_view input, Arguments more = {}) {
  Arguments arguments = {"detect", "--report", name};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments, input);
}

void expect_json(const std::string& name, std::string_view input, const std::string& part,
                 Arguments more = {}) {
  more.emplace_back("--json");
  const Finished finished = report(name, input, more);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find("\"report\": \"" + name + "\""), std::string::npos);
  EXPECT_NE(finished.out.find(part), std::string::npos) << part << " in\n" << finished.out;
}

void expect_geojson(const std::string& name, const std::string& part) {
  const Finished finished = report(name, kDegrees, {"--geojson"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(part), std::string::npos) << part << " in\n" << finished.out;
}

TEST(Reports, AtRiskIsTheDefault) {
  EXPECT_EQ(report("at-risk", kMetres).out, "0\n1\n3\n4\n5\n");
  EXPECT_EQ(report("at-risk", kMetres, {"--csv"}).out, run({"detect", "--csv"}, kMetres).out);
}

TEST(Reports, PairsHaveTwoIdsAndADistance) {
  EXPECT_EQ(below_header(report("pairs", kMetres).out), "0\t1\t60\n1\t3\t80\n4\t5\t5\n");
  EXPECT_EQ(report("pairs", kMetres, {"--csv"}).out,
            "first,second,distance_m\n0,1,60\n1,3,80\n4,5,5\n");
  EXPECT_EQ(report("pairs", kNamed, {"--csv"}).out,
            "first;second;distance_m\nmaya;\"wil\"\"li\";60\n\"wil\"\"li\";thekla;80\n");
  expect_json("pairs", kNamed,
              "\"pair_count\": 2,\n  \"pairs\": [\n    "
              R"({"first": "maya", "second": "wil\"li", "distance_m": 60},)");
  expect_geojson("pairs", R"({"type": "LineString", "coordinates": [[-75.5, 6.25, 1500], )"
                          R"([-75.5, 6.25, 1530]]}, "properties": {"first": 0, "second": 1, )"
                          R"("distance_m": )");
}

TEST(Reports, NeighborsOfEveryBeeAreCountedAndNamed) {
  EXPECT_EQ(below_header(report("neighbors", kMetres).out),
            "0\t1\t1\n1\t2\t0\t3\n2\t0\n3\t1\t1\n4\t1\t5\n5\t1\t4\n");
  EXPECT_EQ(below_header(report("neighbors", kMetres, {"--at-risk-only"}).out),
            "0\t1\t1\n1\t2\t0\t3\n3\t1\t1\n4\t1\t5\n5\t1\t4\n");
  EXPECT_EQ(report("neighbors", kNamed, {"--csv"}).out,
            "id;x;y;z;neighbor_count;neighbors\nmaya;0;0;0;1;\"wil\"\"li\"\n"
            "\"wil\"\"li\";60;0;0;2;maya,thekla\nflip;1000;0;0;0;\n"
            "thekla;60;80;0;1;\"wil\"\"li\"\n");
  EXPECT_EQ(report("neighbors", "x,y,z\n0,0,0\n1,0,0\n2,0,0\n", {"--csv"}).out,
            "x,y,z,row,neighbor_count,neighbors\n0,0,0,0,2,1;2\n1,0,0,1,2,0;2\n2,0,0,2,2,0;1\n");
  expect_json("neighbors", kNamed,
              R"({"id": "wil\"li", "neighbor_count": 2, "neighbors": ["maya", "thekla"]},)");
  expect_json("neighbors", kNamed, R"({"id": "flip", "neighbor_count": 0, "neighbors": []},)");
  expect_geojson("neighbors", R"("properties": {"id": 2, "neighbor_count": 0, "neighbors": []}})");
}

TEST(Reports, CountsSayHowMany) {
  EXPECT_EQ(below_header(report("counts", kMetres).out), "0\t1\n1\t2\n2\t0\n3\t1\n4\t1\n5\t1\n");
  EXPECT_EQ(below_header(report("counts", kNamed, {"--at-risk-only"}).out),
            "maya\t1\nwil\"li\t2\nthekla\t1\n");
  EXPECT_EQ(report("counts", kNamed, {"--csv", "--at-risk-only"}).out,
            "id;x;y;z;neighbor_count\nmaya;0;0;0;1\n\"wil\"\"li\";60;0;0;2\nthekla;60;80;0;1\n");
  expect_json("counts", kNamed, R"({"id": "flip", "neighbor_count": 0},)");
  expect_geojson("counts", R"("properties": {"id": 1, "neighbor_count": 1}})");
}

TEST(Reports, NearestIsUnboundedUnlessOnlyThoseAtRiskAreAskedFor) {
  EXPECT_EQ(below_header(report("nearest", kNamed).out),
            "maya\twil\"li\t60\nwil\"li\tmaya\t60\nflip\twil\"li\t940\nthekla\twil\"li\t80\n");
  EXPECT_EQ(below_header(report("nearest", kNamed, {"--at-risk-only"}).out),
            "maya\twil\"li\t60\nwil\"li\tmaya\t60\nthekla\twil\"li\t80\n");
  EXPECT_EQ(report("nearest", kMetres, {"--csv", "--at-risk-only", "--threshold", "50"}).out,
            "x,y,z,row,nearest,distance_m\n5000,0,0,4,5,5\n5000,0,5,5,4,5\n");
  expect_json("nearest", kNamed, R"({"id": "flip", "nearest": "wil\"li", "distance_m": 940},)");
  expect_geojson("nearest", R"("properties": {"id": 2, "nearest": 0, "distance_m": )");
}

TEST(Reports, ABeeThatIsAloneHasNoNearest) {
  constexpr std::string_view kAlone = "x,y,z\n1,2,3\n";
  EXPECT_EQ(below_header(report("nearest", kAlone).out), "0\t\t\n");
  EXPECT_EQ(report("nearest", kAlone, {"--csv"}).out, "x,y,z,row,nearest,distance_m\n1,2,3,0,,\n");
  EXPECT_EQ(report("nearest", "x y z\n1 2 3\n", {"--csv"}).out,
            "x y z row nearest distance_m\n1 2 3 0 \"\" \"\"\n");
  expect_json("nearest", kAlone, R"({"id": 0, "nearest": null, "distance_m": null})");
  EXPECT_EQ(below_header(report("closest-pair", kAlone).out), "");
  EXPECT_EQ(report("pairs", kAlone, {"--csv"}).out, "first,second,distance_m\n");
  EXPECT_NE(report("groups", kAlone).err.find("groups     none"), std::string::npos);
}

TEST(Reports, GroupsHaveANumberASizeAndMembers) {
  EXPECT_EQ(below_header(report("groups", kMetres).out), "0\t3\t0\t1\t3\n1\t2\t4\t5\n");
  EXPECT_EQ(report("groups", kMetres, {"--csv"}).out,
            "x,y,z,group,group_size\n0,0,0,0,3\n60,0,0,0,3\n60,80,0,0,3\n5000,0,0,1,2\n"
            "5000,0,5,1,2\n");
  expect_json("groups", kMetres,
              "\"group_count\": 2,\n  \"groups\": [\n    "
              R"({"group": 0, "size": 3, "members": [0, 1, 3]},)");
  expect_geojson("groups", R"("properties": {"id": 1, "group": 0, "group_size": 2}})");
}

TEST(Reports, TheClosestPairIsFoundWhateverTheThreshold) {
  for (const std::string threshold : {"1", "70", "1e6"}) {
    EXPECT_EQ(
        below_header(report("closest-pair", kMetres, {"--threshold", threshold, "--quiet"}).out),
        "4\t5\t5\n");
  }
  EXPECT_EQ(report("closest-pair", kNamed, {"--csv"}).out,
            "first;second;distance_m\nmaya;\"wil\"\"li\";60\n");
  expect_json("closest-pair", kMetres, R"("closest_pair": {"first": 4, "second": 5, "distance)");
  expect_geojson("closest-pair", R"("type": "LineString")");
}

TEST(Reports, RowsStayThoseOfTheFileWhenRecordsAreSkipped) {
  constexpr std::string_view kInput = "x,y,z\noops,0,0\n0,0,0\n60,0,0\n";
  EXPECT_EQ(below_header(report("pairs", kInput, {"--skip-bad"}).out), "1\t2\t60\n");
  EXPECT_EQ(below_header(report("groups", kInput, {"--skip-bad"}).out), "0\t2\t1\t2\n");
  EXPECT_EQ(report("nearest", kInput, {"--skip-bad", "--csv"}).out,
            "x,y,z,row,nearest,distance_m\n0,0,0,1,2,60\n60,0,0,2,1,60\n");
}

TEST(Reports, MoreResultsThanAllowedAreAnErrorAndNoAnswer) {
  EXPECT_EQ(report("pairs", kMetres, {"--max-results", "3"}).exit_code, 0);
  const Finished finished = report("pairs", kMetres, {"--max-results", "2", "--json"});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.err.find("there are more than 2 pairs; raise --max-results, or lower the "
                              "threshold"),
            std::string::npos)
      << finished.err;
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(R"("code": "too_many_results")"), std::string::npos);
  EXPECT_EQ(report("neighbors", kMetres, {"--max-results", "6"}).exit_code, 0);
  const Finished neighbours = report("neighbors", kMetres, {"--max-results", "5"});
  EXPECT_EQ(neighbours.exit_code, 3);
  EXPECT_NE(neighbours.err.find("there are more than 5 neighbours"), std::string::npos);
  EXPECT_EQ(neighbours.out, "");
}

TEST(Reports, FailOnRiskMeansTheSameInEveryReport) {
  for (const std::string name :
       {"at-risk", "pairs", "neighbors", "counts", "nearest", "groups", "closest-pair"}) {
    EXPECT_EQ(report(name, kMetres, {"--fail-on-risk", "--quiet"}).exit_code, 1) << name;
    EXPECT_EQ(report(name, kMetres, {"--fail-on-risk", "--threshold", "5"}).exit_code, 0) << name;
    EXPECT_EQ(report(name, kMetres).exit_code, 0) << name;
  }
}

TEST(Reports, QuietSaysNothingAndChangesNothing) {
  for (const std::string name :
       {"at-risk", "pairs", "neighbors", "counts", "nearest", "groups", "closest-pair"}) {
    const Finished quiet = report(name, kMetres, {"--quiet"});
    EXPECT_EQ(quiet.err, "") << name;
    EXPECT_EQ(quiet.out, report(name, kMetres).out) << name;
  }
}

TEST(Reports, TheSummarySaysWhatTheyFound) {
  const auto expect_said = [](const std::string& name, const std::string& line) {
    const std::string said = report(name, kMetres).err;
    EXPECT_NE(said.find(line), std::string::npos) << line << " in\n" << said;
    EXPECT_NE(said.find("at risk    5 (83.3 %)"), std::string::npos) << said;
  };
  expect_said("pairs", "\n  pairs      3\n");
  expect_said("neighbors", "\n  neighbours 1.00 a bee on average, 2 at most\n");
  expect_said("counts", "\n  neighbours 1.00 a bee on average, 2 at most\n");
  expect_said("nearest", "\n  nearest    60.000 m is the median, 940.000 m the farthest\n");
  expect_said("groups", "\n  groups     2, the largest of 3 bees\n");
  expect_said("closest-pair", "\n  closest    4 and 5, 5.000 m apart\n");
}

TEST(Reports, TheColourOfTheSummaryRespectsNoColor) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  const Arguments arguments = {"detect", BEESPACE_EXAMPLE_DATA, "--report", "groups"};
  EXPECT_NE(run_on_terminal(arguments).err.find('\x1b'), std::string::npos);
  EXPECT_EQ(run_on_terminal(arguments, "1").err.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
