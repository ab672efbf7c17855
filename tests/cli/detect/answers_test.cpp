// Every form of the answer of `beespace detect`, checked as text.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Rows 0, 1 and 3 are at risk at 100 m; 1 is the nearest of 0 and 3.
constexpr std::string_view kMetres = "x,y,z\n0,0,0\n60,0,0\n1000,0,0\n60,80,0\n";
constexpr std::string_view kNamed =
    "id;x;y;z\nmaya;0;0;0\n\"wil\"\"li\";60;0;0\nflip;1000;0;0\nthekla;60;80;0\n";
constexpr std::string_view kDegrees =
    "longitude,latitude,height\n-75.5,6.25,1500\n-75.5,6.25,1530\n-75.4,6.25,1500\n";

TEST(Answers, IdsAreTheDataRowsOneALine) {
  const Finished finished = run({"detect", "-"}, kMetres);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "0\n1\n3\n");
}

TEST(Answers, StandardInputIsReadWhenNoFileIsNamed) {
  EXPECT_EQ(run({"detect"}, kMetres).out, "0\n1\n3\n");
}

TEST(Answers, TheIdColumnReplacesTheRows) {
  EXPECT_EQ(run({"detect"}, kNamed).out, "maya\nwil\"li\nthekla\n");
}

TEST(Answers, NearestAddsWhoAndHowFar) {
  EXPECT_EQ(below_header(run({"detect", "--report", "nearest", "--at-risk-only"}, kMetres).out),
            "0\t1\t60\n1\t0\t60\n3\t1\t80\n");
  EXPECT_EQ(below_header(run({"detect", "--report", "nearest", "--at-risk-only"}, kNamed).out),
            "maya\twil\"li\t60\nwil\"li\tmaya\t60\nthekla\twil\"li\t80\n");
}

TEST(Answers, TheThresholdIsStrictUnlessInclusive) {
  constexpr std::string_view kExactlyHundred = "x,y,z\n0,0,0\n60,80,0\n";
  EXPECT_EQ(run({"detect"}, kExactlyHundred).out, "");
  EXPECT_EQ(run({"detect", "--inclusive"}, kExactlyHundred).out, "0\n1\n");
  EXPECT_EQ(run({"detect", "--threshold", "100.0000001"}, kExactlyHundred).out, "0\n1\n");
}

TEST(Answers, EveryThreadCountGivesTheSameBytes) {
  const std::string swarm = run({"generate", "--points", "20000"}).out;
  const Finished one =
      run({"detect", "--threads", "1", "--report", "nearest", "--at-risk-only"}, swarm);
  ASSERT_GT(one.out.size(), 1'000u);
  for (const char* threads : {"0", "2", "5"}) {
    EXPECT_EQ(
        run({"detect", "--threads", threads, "--report", "nearest", "--at-risk-only"}, swarm).out,
        one.out);
  }
}

TEST(Answers, CsvGivesTheRecordsBackAsTheyStood) {
  EXPECT_EQ(run({"detect", "--csv"}, kMetres).out, "x,y,z\n0,0,0\n60,0,0\n60,80,0\n");
  EXPECT_EQ(run({"detect", "--csv", "--report", "nearest", "--at-risk-only"}, kMetres).out,
            "x,y,z,row,nearest,distance_m\n0,0,0,0,1,60\n60,0,0,1,0,60\n60,80,0,3,1,80\n");
  EXPECT_EQ(run({"detect", "--csv", "--report", "nearest", "--at-risk-only"}, kNamed).out,
            "id;x;y;z;nearest;distance_m\nmaya;0;0;0;\"wil\"\"li\";60\n"
            "\"wil\"\"li\";60;0;0;maya;60\nthekla;60;80;0;\"wil\"\"li\";80\n");
}

TEST(Answers, CsvWithoutHeaderStaysWithoutHeader) {
  EXPECT_EQ(run({"detect", "--csv", "--crs", "metres"}, "0\t0\t0\r\n1\t0\t0\r\n").out,
            "0\t0\t0\n1\t0\t0\n");
}

TEST(Answers, CsvOfAnArrayHasAHeader) {
  const TemporaryFolder folder;
  const std::string file = folder.path("swarm.npy");
  ASSERT_EQ(run({"generate", "--points", "50", "--size", "1000", "--output", file}).exit_code, 0);
  const Finished finished = run({"detect", file, "--csv", "--threshold", "5000"});
  EXPECT_EQ(finished.exit_code, 0);
  const std::string as_csv =
      run({"generate", "--points", "50", "--size", "1000", "--format", "csv"}).out;
  EXPECT_EQ(finished.out, "x,y,z" + as_csv.substr(as_csv.find('\n')));
}

TEST(Answers, JsonHoldsEverythingInOneDocument) {
  const Finished finished = run({"detect", "--json", "--quiet"}, kNamed);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  for (const char* part :
       {R"("version": ")", R"("report": "at-risk")", R"("file": "<stdin>")", R"("frame": "metres")",
        R"("points": 4)", R"("skipped": 0)", R"("threshold_m": 100)", R"("inclusive": false)",
        R"("at_risk_count": 3)", R"("share": 0.75)", R"("reason": ")", R"("timings": {)",
        R"("closest_pair": {"first": "maya", "second": "wil\"li", "distance_m": 60})",
        R"("at_risk": ["maya", "wil\"li", "thekla"])"}) {
    EXPECT_NE(finished.out.find(part), std::string::npos) << part << " in\n" << finished.out;
  }
}

TEST(Answers, JsonWithNearestHasAnObjectForEachBee) {
  const Finished finished =
      run({"detect", "--json", "--report", "nearest", "--at-risk-only"}, kMetres);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(R"({"id": 3, "nearest": 1, "distance_m": 80})"), std::string::npos)
      << finished.out;
}

TEST(Answers, JsonOfNoneIsStillADocument) {
  const Finished finished = run({"detect", "--json"}, "x,y,z\n1,2,3\n");
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(R"("closest_pair": null)"), std::string::npos);
  EXPECT_NE(finished.out.find(R"("at_risk": [])"), std::string::npos);
}

TEST(Answers, TheRowReplacesAnEmptyIdAndThatIsReported) {
  constexpr std::string_view kInput = "id,x,y,z\nmaya,0,0,0\n,1,0,0\n\" \",2,0,0\n";
  const Finished finished = run({"detect", "--report", "nearest", "--at-risk-only"}, kInput);
  EXPECT_EQ(below_header(finished.out), "maya\t1\t1\n1\tmaya\t1\n2\t1\t1\n");
  EXPECT_NE(finished.err.find("2 bees of the answer have an empty id: the data row stands for it"),
            std::string::npos)
      << finished.err;
  const std::string json = run({"detect", "--json"}, kInput).out;
  EXPECT_TRUE(is_json(json)) << json;
  EXPECT_NE(json.find(R"("at_risk": ["maya", 1, 2])"), std::string::npos) << json;
  EXPECT_NE(json.find("2 bees of the answer have an empty id"), std::string::npos) << json;
  const std::string geojson =
      run({"detect", "--geojson"}, "id,lon,lat,height\n,5,5,0\nb,5,5,1\n").out;
  EXPECT_NE(geojson.find(R"("id": 0})"), std::string::npos) << geojson;
  EXPECT_NE(geojson.find(R"("id": "b"})"), std::string::npos) << geojson;
}

TEST(Answers, ATabInsideAnIdDoesNotSplitTheLine) {
  constexpr std::string_view kInput = "id,x,y,z\n\"ma\tya\",0,0,0\nwilli,1,0,0\n";
  const Finished finished = run({"detect", "--report", "nearest", "--at-risk-only"}, kInput);
  EXPECT_EQ(below_header(finished.out), "ma ya\twilli\t1\nwilli\tma ya\t1\n");
  EXPECT_NE(finished.err.find("tabs and line ends inside an id are written as blanks (1 id)"),
            std::string::npos)
      << finished.err;
  const Finished json = run({"detect", "--json"}, kInput);
  EXPECT_NE(json.out.find(R"("at_risk": ["ma\tya", "willi"])"), std::string::npos) << json.out;
  EXPECT_EQ(json.err.find("written as blanks"), std::string::npos) << json.err;
}

TEST(Answers, JsonSurvivesHostileIds) {
  const Finished finished = run({"detect", "--json", "--report", "nearest", "--at-risk-only"},
                                "id,x,y,z\n\"a\"\"\\\",0,0,0\n\xF0\x9F\x90\x9D,1,0,0\n");
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(R"("id": "a\"\\")"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("\"id\": \"\xF0\x9F\x90\x9D\""), std::string::npos) << finished.out;
}

TEST(Answers, GeoJsonPlacesTheBeesAsInTheFile) {
  const Finished finished =
      run({"detect", "--geojson", "--report", "nearest", "--at-risk-only"}, kDegrees);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_NE(finished.out.find(R"("type": "FeatureCollection")"), std::string::npos);
  EXPECT_NE(finished.out.find(R"("coordinates": [-75.5, 6.25, 1530])"), std::string::npos);
  EXPECT_NE(finished.out.find(R"("properties": {"id": 1, "nearest": 0, "distance_m": )"),
            std::string::npos);
  EXPECT_EQ(finished.out.find("-75.4"), std::string::npos) << "this one is not at risk";
}

TEST(Answers, GeoJsonWritesLongitudesWithinHalfATurn) {
  const auto written = [](const std::string& longitude) {
    const std::string input =
        "longitude,latitude,height\n" + longitude + ",5,0\n" + longitude + ",5,1\n";
    const std::string text = run({"detect", "--geojson"}, input).out;
    const std::size_t begin = text.find("\"coordinates\": [") + 16;
    return text.substr(begin, text.find(',', begin) - begin);
  };
  EXPECT_EQ(written("200"), "-160");
  EXPECT_EQ(written("-200.5"), "159.5");
  EXPECT_EQ(written("360"), "0");
  EXPECT_EQ(written("-360"), "0");
  EXPECT_EQ(written("180"), "180");
  EXPECT_EQ(written("-180"), "-180");
  EXPECT_EQ(written("-75.5"), "-75.5");
}

TEST(Answers, GeoJsonOfMetresIsRefused) {
  const Finished finished = run({"detect", "--geojson"}, kMetres);
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_NE(finished.err.find("--geojson needs longitude and latitude"), std::string::npos);
}

TEST(Answers, OutputGoesToTheFileAndReplacesIt) {
  const TemporaryFolder folder;
  const std::string in = folder.file("bees.csv", kMetres);
  const std::string out = folder.file("risk.txt", "old");
  const Finished finished = run({"detect", in, "--output", out});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(folder.read("risk.txt"), "0\n1\n3\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bees.csv", "risk.txt"}));
}

TEST(Answers, TheSummaryNamesPointsFrameRiskClosestAndTimes) {
  const Finished finished = run({"detect"}, kNamed);
  for (const char* part :
       {"points     4", "frame      metres: ", "threshold  100 m", "at risk    3 (75.0 %)",
        "closest    maya and wil\"li, 60.000 m apart", "read ", "search ", "write ", "points/s"}) {
    EXPECT_NE(finished.err.find(part), std::string::npos) << part << " in\n" << finished.err;
  }
  EXPECT_EQ(finished.err.find('\x1b'), std::string::npos) << "colour without a terminal";
}

TEST(Answers, TwoColumnFilesSayThatTheHeightIsTakenAsZero) {
  const Finished finished = run({"detect"}, "longitude,latitude\n-75.5,6.25\n-75.5,6.25\n");
  EXPECT_EQ(finished.out, "0\n1\n");
  EXPECT_NE(finished.err.find("every height is taken as 0 m"), std::string::npos) << finished.err;
  EXPECT_NE(finished.err.find("frame      WGS84 longitude, latitude: "), std::string::npos)
      << finished.err;
  EXPECT_NE(run({"detect"}, kDegrees).err.find("frame      WGS84 longitude, latitude, height: "),
            std::string::npos);
}

TEST(Answers, QuietSaysNothing) {
  const Finished finished = run({"detect", "--quiet"}, kMetres);
  EXPECT_EQ(finished.out, "0\n1\n3\n");
  EXPECT_EQ(finished.err, "");
}

TEST(Answers, FailOnRiskExitsWithOneOnlyWhenABeeIsAtRisk) {
  EXPECT_EQ(run({"detect", "--fail-on-risk"}, kMetres).exit_code, 1);
  EXPECT_EQ(run({"detect", "--fail-on-risk", "--threshold", "60"}, kMetres).exit_code, 0);
  EXPECT_EQ(run({"detect"}, kMetres).exit_code, 0);
}

// The check that the help and the manual show: only 1 is danger, and nothing is printed.
TEST(Answers, TheExampleOfACheckInAScriptDistinguishesDangerFromAFailure) {
  const Arguments check = {"detect",         "-",        "--crs",    "metres", "--quiet",
                           "--fail-on-risk", "--output", "/dev/null"};
  const Finished danger = run(check, kMetres);
  EXPECT_EQ(danger.exit_code, 1);
  EXPECT_EQ(danger.out + danger.err, "");
  EXPECT_EQ(run(check, "x,y,z\n0,0,0\n").exit_code, 0);
  Arguments missing = check;
  missing[1] = "/missing.csv";
  EXPECT_EQ(run(missing).exit_code, 4);
  const std::string help = run({"detect", "--help"}).out;
  EXPECT_NE(help.find("--fail-on-risk --output /dev/null\n  [ $? -eq 1 ] && echo danger\n"),
            std::string::npos);
}

TEST(Answers, SkipBadKeepsTheRowsOfTheFileAndListsWhatItLeftOut) {
  const Finished finished =
      run({"detect", "--skip-bad"}, "x,y,z\n0,0,0\noops,0,0\n60,0,0\n5,nan,5\n");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "0\n2\n");
  EXPECT_NE(finished.err.find("skipped    2 bad records"), std::string::npos) << finished.err;
  EXPECT_NE(finished.err.find("<stdin>:3:1: 'oops'"), std::string::npos) << finished.err;
  const Finished one = run({"detect", "--skip-bad"}, "x,y,z\n0,0,0\noops,0,0\n");
  EXPECT_NE(one.err.find("skipped    1 bad record\n"), std::string::npos) << one.err;
}

TEST(Answers, JsonListsWhatWasSkippedWithPlaceAndMessage) {
  const std::string json =
      run({"detect", "--skip-bad", "--json"}, "x,y,z\n0,0,0\noops,0,0\n60,0,0\n5,nan,5\n").out;
  EXPECT_TRUE(is_json(json)) << json;
  EXPECT_NE(json.find(R"("skipped": 2)"), std::string::npos) << json;
  const std::size_t list = json.find(R"("first_skipped": [)");
  ASSERT_NE(list, std::string::npos) << json;
  const std::size_t first = json.find(R"({"code": "not_a_number", "message": "'oops')", list);
  ASSERT_NE(first, std::string::npos) << json;
  EXPECT_NE(json.find(R"("line": 3, "column": 1)", first), std::string::npos) << json;
  const std::size_t second = json.find(R"({"code": "not_finite", "message": "'nan')", first);
  ASSERT_NE(second, std::string::npos) << json;
  EXPECT_NE(json.find(R"("line": 5, "column": 2)", second), std::string::npos) << json;
  EXPECT_EQ(run({"detect", "--json"}, kMetres).out.find("first_skipped"), std::string::npos);
}

TEST(Answers, SkipBadWorksWithEveryForm) {
  constexpr std::string_view kInput = "x,y,z\noops,0,0\n0,0,0\n60,0,0\n";
  EXPECT_EQ(below_header(
                run({"detect", "--skip-bad", "--report", "nearest", "--at-risk-only"}, kInput).out),
            "1\t2\t60\n2\t1\t60\n");
  EXPECT_EQ(run({"detect", "--skip-bad", "--csv"}, kInput).out, "x,y,z\n0,0,0\n60,0,0\n");
  const std::string json = run({"detect", "--skip-bad", "--json"}, kInput).out;
  EXPECT_TRUE(is_json(json)) << json;
  EXPECT_NE(json.find(R"("at_risk": [1, 2])"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("skipped": 1)"), std::string::npos) << json;
}

TEST(Answers, ColumnsAreChosenByNameOrNumber) {
  constexpr std::string_view kShuffled = "h,who,b,l\n1500,7,6.25,-75.5\n1530,8,6.25,-75.5\n";
  EXPECT_EQ(run({"detect", "--columns", "lon=l,lat=b,height=h,id=who"}, kShuffled).out, "7\n8\n");
  EXPECT_EQ(run({"detect", "--columns", "lon=4,lat=3,height=1"}, kShuffled).out, "0\n1\n");
}

TEST(Answers, GzipIsReadFromStandardInput) {
  const std::string compressed =
      run({"generate", "--points", "2000", "--size", "2000", "--format", "csv.gz"}).out;
  const std::string plain = run({"generate", "--points", "2000", "--size", "2000"}).out;
  ASSERT_EQ(compressed.substr(0, 2), "\x1f\x8b");
  const Finished finished = run({"detect"}, compressed);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, run({"detect"}, plain).out);
  EXPECT_FALSE(finished.out.empty());
}

}  // namespace
}  // namespace beespace::cli_test
