// Our swarm against theirs: `beespace detect --others`.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Ours are close to each other, which does not count; theirs likewise.
constexpr std::string_view kOurs = "id;x;y;z\nmaya;0;0;0\nwilli;60;0;0\nflip;2000;0;0\n";
constexpr std::string_view kTheirs = "name,x,y,z\nwasp,0,0,50\nhornet,0,0,99\n";
constexpr std::string_view kDegrees = "longitude,latitude,height\n-75.5,6.25,1500\n";
constexpr std::string_view kDegreesNearby =
    "longitude,latitude,height\n-75.5,6.25,9000\n-75.5,6.25,1540\n";

class Others : public testing::Test {
 protected:
  Finished report(const std::string& name, Arguments more = {}) {
    Arguments arguments = {"detect", ours_, "--others", theirs_, "--report", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  void expect_refused(const std::string& others, int exit_code, const std::string& message,
                      const Surroundings& surroundings = {}) {
    const Finished finished = run({"detect", ours_, "--others", others}, {}, surroundings);
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                             << finished.err;
  }

  TemporaryFolder folder_;
  std::string ours_ = folder_.file("ours.csv", kOurs);
  std::string theirs_ = folder_.file("theirs.csv", kTheirs);
};

TEST_F(Others, AtRiskAreOursWhoAreCloseToTheirs) {
  EXPECT_EQ(report("at-risk").out, "maya\nwilli\n");
  EXPECT_EQ(report("at-risk", {"--threshold", "60"}).out, "maya\n");
  EXPECT_EQ(report("at-risk", {"--threshold", "50"}).out, "");
  EXPECT_EQ(report("at-risk", {"--threshold", "50", "--inclusive"}).out, "maya\n");
  EXPECT_EQ(report("at-risk", {"--csv"}).out, "id;x;y;z\nmaya;0;0;0\nwilli;60;0;0\n");
}

TEST_F(Others, PairsAreOneOfOursAndOneOfTheirs) {
  EXPECT_EQ(below_header(report("pairs").out),
            "maya\twasp\t50\nmaya\thornet\t99\nwilli\twasp\t78.10249675906654\n");
  EXPECT_EQ(report("pairs", {"--csv", "--threshold", "60"}).out,
            "first;second;distance_m\nmaya;wasp;50\n");
}

TEST_F(Others, NeighborsCountsAndNearestAreTheirs) {
  EXPECT_EQ(below_header(report("neighbors").out),
            "maya\t2\twasp\thornet\nwilli\t1\twasp\nflip\t0\n");
  EXPECT_EQ(below_header(report("counts").out), "maya\t2\nwilli\t1\nflip\t0\n");
  EXPECT_EQ(below_header(report("nearest", {"--at-risk-only"}).out),
            "maya\twasp\t50\nwilli\twasp\t78.10249675906654\n");
  EXPECT_EQ(below_header(report("nearest").out),
            "maya\twasp\t50\nwilli\twasp\t78.10249675906654\nflip\twasp\t2000.6249023742557\n");
}

TEST_F(Others, WithAVerticalThresholdHeightsCountOnTheirOwn) {
  const Arguments low = {"--threshold", "100", "--vertical", "51"};
  EXPECT_EQ(report("at-risk", low).out, "maya\nwilli\n");
  EXPECT_EQ(below_header(report("pairs", low).out),
            "maya\twasp\t50\t0\t50\nwilli\twasp\t78.10249675906654\t60\t50\n");
  EXPECT_EQ(below_header(report("neighbors", low).out), "maya\t1\twasp\nwilli\t1\twasp\nflip\t0\n");
  EXPECT_EQ(below_header(report("counts", low).out), "maya\t1\nwilli\t1\nflip\t0\n");
  EXPECT_EQ(below_header(report("nearest", low).out),
            "maya\twasp\t50\nwilli\twasp\t78.10249675906654\nflip\t\t\n");
  EXPECT_EQ(report("at-risk", {"--vertical", "50"}).out, "");
  EXPECT_EQ(report("at-risk", {"--vertical", "50", "--inclusive"}).out, "maya\nwilli\n");
  EXPECT_NE(report("at-risk", low).err.find("closest    maya and their wasp, 50.000 m apart"),
            std::string::npos)
      << report("at-risk", low).err;
}

// 2 km above each other, at the same place on the ground.
TEST_F(Others, WithAVerticalThresholdPlacesInDegreesAreBroughtToTheGround) {
  const std::string ours =
      folder_.file("up.csv", "id,longitude,latitude,height\nlow,0,0,9000\nhigh,0.01,0,11000\n");
  const std::string theirs =
      folder_.file("there.csv", "id,longitude,latitude,height\nx,0.01,0,9200\n");
  const auto found = [&](const std::string& metres, const std::string& vertical) {
    return run({"detect", ours, "--others", theirs, "--threshold", metres, "--vertical", vertical})
        .out;
  };
  EXPECT_EQ(found("1113.1", "201"), "");  // at that height 1114.8 m
  EXPECT_EQ(found("1113.3", "201"), "low\n");
  EXPECT_EQ(found("1113.3", "200"), "");
  EXPECT_EQ(found("1113.3", "1801"), "low\nhigh\n");
}

TEST_F(Others, TheClosestPairIsBetweenTheTwo) {
  EXPECT_EQ(below_header(report("closest-pair", {"--quiet"}).out), "maya\twasp\t50\n");
  EXPECT_EQ(below_header(report("closest-pair", {"--threshold", "1"}).out), "maya\twasp\t50\n");
}

TEST_F(Others, JsonDescribesBothInputs) {
  const Finished finished = report("pairs", {"--json"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  for (const char* part :
       {R"("others": {)", R"(theirs.csv")", R"("points": 2)", R"("at_risk_count": 2)",
        R"("closest_pair": {"first": "maya", "second": "wasp", "distance_m": 50})",
        R"({"first": "maya", "second": "hornet", "distance_m": 99})"}) {
    EXPECT_NE(finished.out.find(part), std::string::npos) << part << " in\n" << finished.out;
  }
}

TEST_F(Others, GeoJsonDrawsLinesBetweenTheTwo) {
  folder_.file("ours.csv", kDegrees);
  folder_.file("theirs.csv", kDegreesNearby);
  const Finished finished = report("pairs", {"--geojson"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find("[[-75.5, 6.25, 1500], [-75.5, 6.25, 1540]]"), std::string::npos)
      << finished.out;
  EXPECT_NE(finished.out.find(R"("first": 0, "second": 1, )"), std::string::npos) << finished.out;
}

TEST_F(Others, TheSummaryDistinguishesThem) {
  const Finished finished = report("at-risk");
  for (const char* part : {"\n  others     ", "\n  points     3\n", "\n  points     2\n",
                           "at risk    2 (66.7 %)", "closest    maya and their wasp, 50.000 m"}) {
    EXPECT_NE(finished.err.find(part), std::string::npos) << part << " in\n" << finished.err;
  }
}

TEST_F(Others, FailOnRiskIsAboutTheTwoSwarms) {
  EXPECT_EQ(report("counts", {"--fail-on-risk", "--quiet"}).exit_code, 1);
  EXPECT_EQ(report("counts", {"--fail-on-risk", "--threshold", "50"}).exit_code, 0)
      << "ours among each other, or theirs, were counted";
}

TEST_F(Others, EitherMayComeFromStandardInput) {
  EXPECT_EQ(run({"detect", ours_, "--others", "-"}, kTheirs).out, "maya\nwilli\n");
  EXPECT_EQ(run({"detect", "--others", theirs_}, kOurs).out, "maya\nwilli\n");
}

TEST_F(Others, FilesThatCannotBeReadAreNamed) {
  expect_refused(folder_.path("missing.csv"), 4, "missing.csv: there is no such file");
  expect_refused(folder_.file("empty.csv", ""), 3, "empty.csv: the input is empty");
  expect_refused(folder_.file("header.csv", "x,y,z\n"), 3, "no record after it");
  expect_refused(folder_.file("bad.csv", "x,y,z\n1,2,oops\n"), 3, "bad.csv:2:3: 'oops'");
  expect_refused(folder_.file("bare.csv", "1,2,3\n4,5,6\n"), 3, "degrees or metres?");
}

TEST_F(Others, AnUnreadableFileIsNamed) {
  Surroundings unprivileged;
  unprivileged.unprivileged = true;
  ASSERT_EQ(chmod(folder_.path(".").c_str(), 0777), 0);
  const std::string secret = folder_.file("secret.csv", kTheirs);
  ASSERT_EQ(chmod(secret.c_str(), 0), 0);
  expect_refused(secret, 4, "secret.csv: not allowed to read this file", unprivileged);
}

TEST_F(Others, OneSideWithoutHeightsIsNotAtZeroMetres) {
  const std::string ours = folder_.file("high.csv", "id,lat,lon,alt\na,48,11,1000\n");
  const std::string flat = folder_.file("flat.csv", "id,lat,lon\nb,48,11\n");
  for (const Arguments& both : {Arguments{ours, "--others", flat}, {flat, "--others", ours}}) {
    const Finished finished = run(Arguments{"detect"} + both);
    EXPECT_EQ(finished.exit_code, 2);
    expect_parts(finished.err, {"flat.csv' has no height column, and '", "add it to the first"});
  }
  EXPECT_EQ(run({"detect", flat, "--others", flat, "--quiet"}).exit_code, 0);
  expect_refused(folder_.file("xy.csv", "id,x,y\na,1,2\n"), 2, "has no z column");
}

TEST_F(Others, ColumnsByNumberAreThoseOfBothFilesOrRefused) {
  const std::string ours = folder_.file("a.csv", "id,lon,lat,alt\na,11,48,1000\n");
  const std::string turned = folder_.file("b.csv", "id,lat,lon,alt\nb,48,11,1000\n");
  const std::string alike = folder_.file("c.csv", "name,longitude,latitude,h\nb,11,48,1000\n");
  const auto ask = [&ours](const std::string& others, const char* columns) {
    return run({"detect", ours, "--others", others, "--columns", columns, "--fail-on-risk"});
  };
  const Finished refused = ask(turned, "lon=2,lat=3,height=4");
  EXPECT_EQ(refused.exit_code, 2);
  expect_parts(refused.err, {"column 2 is 'lon' in '", "' and 'lat' in '"});
  EXPECT_EQ(ask(turned, "lon=lon,lat=lat,height=alt").exit_code, 1);
  EXPECT_EQ(ask(alike, "lon=2,lat=3").exit_code, 1);
}

TEST_F(Others, DegreesAndMetresAreNotMixed) {
  const std::string degrees = folder_.file("degrees.csv", kDegrees);
  expect_refused(degrees, 2, "the two swarms are not in the same frame: ");
  expect_refused(degrees, 2, "degrees.csv' was taken for degrees (");
  const Finished json = run({"detect", degrees, "--others", theirs_, "--json"});
  EXPECT_EQ(json.exit_code, 2);
  EXPECT_TRUE(is_json(json.out)) << json.out;
}

}  // namespace
}  // namespace beespace::cli_test
