// `beespace replay`: conflicts, on recordings whose encounters are computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two fixes each, far apart; in between a and b pass 3 m apart at 5 s. Along x they are
// 100 - 20 t apart: within 4 m, and so within 5 m in all, from 4.8 s to 5.2 s.
constexpr std::string_view kPassing =
    "id,time_s,x,y,z\n"
    "a,0,0,0,0\na,10,100,0,0\n"
    "b,0,100,3,0\nb,10,0,3,0\n"
    "c,0,0,500,0\nc,10,0,500,0\n";

// How far apart a and b are after t seconds.
std::string apart(double t) {
  return std::to_string(std::hypot(100.0 - 20.0 * t, 3.0));
}

TextRows replayed(const Arguments& more, std::string_view input = kPassing) {
  const Finished finished = run(Arguments{"replay", "--threshold", "5"} + more, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  TextRows rows = rows_of(finished.out);
  const bool conflicts = std::find(more.begin(), more.end(), "--report") == more.end();
  return conflicts ? without_lasts(std::move(rows)) : rows;
}

TEST(Replay, APassBetweenTwoFixesIsFound) {
  expect_rows(replayed({}), {{"a", "b", "4.8", "5", "3", "5.2"}});
}

TEST(Replay, ExactlyTheThresholdCountsOnlyWhenInclusive) {
  const Arguments grazing = {"replay", "--threshold", "3"};
  EXPECT_EQ(below_header(run(grazing, kPassing).out), "");
  expect_rows(without_lasts(rows_of(run(grazing + Arguments{"--inclusive"}, kPassing).out)),
              {{"a", "b", "5", "5", "3", "5"}});
}

TEST(Replay, APairMayBeInConflictSeveralTimes) {
  // b stays; a comes by at 5 s, turns at 10 s, and comes by again at 15 s.
  constexpr std::string_view input =
      "id,time_s,x,y,z\n"
      "a,0,-50,0,0\na,10,50,0,0\na,20,-50,0,0\n"
      "b,0,0,3,0\nb,20,0,3,0\n";
  expect_rows(replayed({}, input),
              {{"a", "b", "4.6", "5", "3", "5.4"}, {"a", "b", "14.6", "15", "3", "15.4"}});
  expect_rows(replayed({"--report", "bees"}, input),
              {{"a", "2", "1.6", "3", "5", "b", "0"}, {"b", "2", "1.6", "3", "5", "a", "0"}});
  expect_rows(replayed({"--report", "pairs"}, input), {{"a", "b", "2", "1.6", "5", "3", "0"}});
  const Finished finished = run({"replay", "--threshold", "5"}, input);
  expect_parts(finished.err, {"does not keep its distance: 2 conflicts of 1 pair",
                              "in conflict for 1.60 s in 2 conflicts"});
}

TEST(Replay, ReportsOfPairsSayHowOftenAndForHowLong) {
  // c is close to both all the time, to a the closest.
  constexpr std::string_view input =
      "id,time_s,x,y,z\n"
      "a,0,0,0,0\na,10,0,0,0\nb,0,6,0,0\nb,10,6,0,0\nc,0,2,0,0\nc,10,2,0,0\n";
  expect_rows(replayed({"--report", "pairs"}, input),
              {{"a", "c", "1", "10", "0", "2", "0"}, {"b", "c", "1", "10", "0", "4", "0"}});
  expect_rows(replayed({"--report", "pairs", "--vertical", "1"}, input),
              {{"a", "c", "1", "10", "0", "2", "0", "2", "0", "0", "0.4", "2", "0"},
               {"b", "c", "1", "10", "0", "4", "0", "4", "0", "0", "0.8", "4", "0"}});
  const std::string json =
      run({"replay", "--threshold", "5", "--report", "pairs", "--json"}, input).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("pairs": [)", R"({"first": "a", "second": "c", "conflicts": 1, )"
                                       R"("in_conflict_s": 10, "closest_s": 0, "closest_m": 2, )"
                                       R"("unknown_s": 0})"});
  const std::string csv =
      run({"replay", "--threshold", "1", "--report", "pairs", "--csv"}, input).out;
  EXPECT_EQ(csv, "first,second,conflicts,in_conflict_s,closest_s,closest_m,unknown_s\n")
      << "no conflict";
}

TEST(Replay, ReportsOfBeesSayTheirConflictsAndTheirClosest) {
  const TextRows bees = {{"a", "1", "0.4", "3", "5", "b", "0"},
                         {"b", "1", "0.4", "3", "5", "a", "0"},
                         {"c", "0", "0", "", "", "", "0"}};
  expect_rows(replayed({"--report", "bees"}), bees);
  TextRows csv = bees;
  csv.insert(csv.begin(), {"id", "conflicts", "in_conflict_s", "closest_m", "closest_s",
                           "closest_id", "unknown_s"});
  expect_rows(
      rows_of(run({"replay", "--threshold", "5", "--report", "bees", "--csv"}, kPassing).out, ','),
      csv);
  const std::string json =
      run({"replay", "--threshold", "5", "--report", "bees", "--json"}, kPassing).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("bees": [)", R"({"id": "c", "conflicts": 0, "in_conflict_s": 0, )"
                                      R"("closest_m": null, "closest_s": null, )"
                                      R"("closest_id": null, "unknown_s": 0})"});
}

TEST(Replay, TheSeparationIsThatOfTheClosestTwoEverySoOften) {
  expect_rows(replayed({"--report", "separation", "--every", "2.5"}),
              {{"0", apart(0.0), "a", "b", "0"},
               {"2.5", apart(2.5), "a", "b", "0"},
               {"5", "3", "a", "b", "0"},
               {"7.5", apart(7.5), "a", "b", "0"},
               {"10", apart(10.0), "a", "b", "0"}});
  EXPECT_EQ(replayed({"--report", "separation"}).size(), 11u);
  EXPECT_EQ(run({"replay", "--report", "separation", "--every", "20", "--csv"},
                "id,time_s,x,y,z\na,0,0,0,0\nb,0,3,4,0\n")
                .out,
            "time_s,distance_m,first,second,unknown\n0,5,a,b,0\n");
}

TEST(Replay, WithoutCommonTimesTheSeparationIsEmpty) {
  constexpr std::string_view input =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,2,9,0,0\nb,3,9,0,0\n";
  EXPECT_EQ(below_header(run({"replay", "--report", "separation", "--quiet"}, input).out),
            "0\t\t\t\t1\n1\t\t\t\t1\n2\t\t\t\t1\n3\t\t\t\t1\n");
  const Finished json = run({"replay", "--report", "separation", "--json"}, input);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("closest": null)", R"({"time_s": 0, "distance_m": null, )"});
  expect_parts(json.err,
               {"verdict    nothing to compare: no two bees are there at the same time\n"});
}

TEST(Replay, BeesWithOneFixExistForAnInstant) {
  const Finished finished =
      run({"replay"}, "id,time_s,x,y,z\na,0,0,0,0\nb,1,0,0,0\nc,0,9,0,0\nc,2,9,0,0\n");
  expect_parts(finished.err, {"2 bees have one fix only, known for an instant; "});
}

TEST(Replay, MomentsOfTheSeparationAreBounded) {
  const Finished finished = run({"replay", "--report", "separation", "--every", "1e-9"},
                                "id,time_s,x,y,z\na,0,0,0,0\na,10,0,0,0\nb,0,9,0,0\nb,1,9,0,0\n");
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"--every 1e-09 is more than 10,000,000 rows"});
}

TEST(Replay, InAGapABeeIsUnknownAndThatIsReported) {
  constexpr std::string_view input =
      "id,time_s,x,y,z\n"
      "a,0,0,0,0\na,1,10,0,0\na,9,90,0,0\na,10,100,0,0\n"
      "b,0,100,3,0\nb,1,90,3,0\nb,2,80,3,0\nb,9,10,3,0\nb,10,0,3,0\n";
  expect_rows(replayed({"--max-gap", "8"}, input), {{"a", "b", "4.8", "5", "3", "5.2"}});
  expect_rows(replayed({"--max-gap", "7.5"}, input), {});
  expect_parts(run({"replay", "--max-gap", "7.5"}, input).err,
               {"max gap    7.5 s (--max-gap)\n",
                "unknown    1 bee in 1 gap between two fixes, for 8 s in all"});
  expect_parts(run({"replay", "--max-gap", "5", "--json"}, input).out, {R"("gap_count": 2)"});
}

TEST(Replay, AVerticalThresholdHoldsAtTheSameTimeAsTheHorizontalOne) {
  // b sinks from 20 m to the height of a at 5 s, and on: within 0.4 m from 4.9 s to 5.1 s.
  constexpr std::string_view input =
      "id,time_s,x,y,z\na,0,0,0,0\na,10,100,0,0\nb,0,100,3,20\nb,10,0,3,-20\n";
  expect_rows(replayed({"--vertical", "2"}, input), {{"a", "b", "4.8", "5", "3", "5.2", "3", "0"}});
  expect_rows(replayed({"--vertical", "0.4"}, input),
              {{"a", "b", "4.9", "5", "3", "5.1", "3", "0"}});
  expect_rows(replayed({"--vertical", "0.4"}), {{"a", "b", "4.8", "5", "3", "5.2", "3", "0"}});
}

TEST(Replay, TheSummaryNamesTheClosestPairItsTimeAndDistance) {
  const Finished finished = run({"replay", "--threshold", "5"}, kPassing);
  expect_parts(finished.err,
               {"input      standard input (", "frame      metres: the header names x, y and z",
                "bees       3\n", "from       0.00 s to 10.00 s (10.00 s)\n",
                "threshold  5 m (closer than)\n",
                "verdict    does not keep its distance: 1 conflict of 1 pair\n",
                "closest    a and b, 3.000 m apart at 5.00 s\n",
                "worst      a and b, 3.000 m apart at 5.00 s; in conflict for 0.40 s\n",
                "over time  ██", "!!", "time       read "});
  const Finished fine = run({"replay", "--threshold", "3"}, kPassing);
  expect_parts(fine.err, {"verdict    keeps its distance\n",
                          "closest    a and b, 3.000 m apart at 5.00 s\n"});
  EXPECT_EQ(fine.err.find("!!"), std::string::npos);
  EXPECT_EQ(fine.err.find("worst"), std::string::npos);
}

TEST(Replay, JsonSaysTheVerdictInNumbers) {
  const std::string json = run({"replay", "--threshold", "5", "--json"}, kPassing).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("command": "replay")", R"("bees": 3)", R"("conflict_count": 1)",
                      R"("pair_count": 1)", R"("gap_count": 0)",
                      R"("closest": {"first": "a", "second": "b", "time_s": 5, "distance_m": 3})",
                      R"("closest_s": 5, "closest_m": 3, )"});
}

TEST(Replay, ManyFilesAndFoldersAreOneRecording) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.csv", "time_s,x,y,z\n1,0,0,0\n11,100,0,0\n");
  const std::string b = folder.file("b.csv", "time_s,x,y,z\n1,100,3,0\n11,0,3,0\n");
  const TextRows meeting = {{"a", "b", "5.8", "6", "3", "6.2"}};
  expect_rows(replayed({a, b}), meeting);
  expect_rows(replayed({folder.path(".")}), meeting);
  const Finished finished = run({"replay", a, b});
  expect_parts(finished.err, {"a.csv and 1 more ("});
  expect_parts(run({"replay", a, b, "--json"}).out, {"a.csv\", \"" + b + "\"]"});
  expect_failure({"replay", a, folder.path("c.csv")}, {}, 4, "c.csv: there is no such file");
}

TEST(Replay, TheSameIdInSeveralFilesIsOneBee) {
  const TemporaryFolder folder;
  const std::string early = folder.file("1.csv", "id,time_s,x,y,z\na,0,0,0,0\nb,0,100,3,0\n");
  const std::string late = folder.file("2.csv", "id,time_s,x,y,z\na,10,100,0,0\nb,10,0,3,0\n");
  expect_rows(replayed({early, late}), {{"a", "b", "4.8", "5", "3", "5.2"}});
  expect_failure(
      {"replay", "--one-clock", early, folder.file("3.csv", "id,time_s,x,y,z\na,0,1,0,0\n")}, {}, 3,
      "bee 'a' is at another place at the same time");
}

// Two that change places on the equator within a minute, at 10,000 m and 10,200 m.
constexpr std::string_view kAircraft =
    "id,time,lon,lat,height\n"
    "KLM1,2024-05-01T12:00:00Z,0,0,10000\nKLM1,2024-05-01T12:01:00Z,0.1,0,10000\n"
    "BAW2,2024-05-01T12:00:00Z,0.1,0,10200\nBAW2,2024-05-01T12:01:00Z,0,0,10200\n";

TEST(Replay, AircraftAreApartOnTheGroundAndInHeight) {
  // On the ground each flies the chord, so that they are 1000 m apart for 2000 m of twice its
  // length.
  const double chord_m = 2.0 * 6'378'137.0 * std::sin(0.05 * std::numbers::pi / 180.0);
  const double half_s = 30.0 * 1'000.0 / chord_m;
  const double met_s = 1'714'564'830.0;
  TextRows rows = rows_of(
      run({"replay", "--threshold", "1000", "--vertical", "201", "--csv"}, kAircraft).out, ',');
  ASSERT_EQ(rows.size(), 2u);
  rows.erase(rows.begin());
  rows = without_lasts(std::move(rows));
  expect_rows(rows, {{"KLM1", "BAW2", std::to_string(met_s - half_s), std::to_string(met_s), "200",
                      std::to_string(met_s + half_s), "0", "200"}});
  const Finished apart = run({"replay", "--threshold", "1000", "--vertical", "200"}, kAircraft);
  EXPECT_EQ(below_header(apart.out), "");
  expect_parts(apart.err, {"verdict    keeps its distance\n"});
}

TEST(Replay, TimesAreShownAsDates) {
  const Finished finished = run({"replay", "--threshold", "1000", "--vertical", "300"}, kAircraft);
  expect_parts(finished.err,
               {"from       2024-05-01T12:00:00.000Z to 2024-05-01T12:01:00.000Z (60.00 s)",
                "threshold  horizontally 1000 m (closer than), and in height 300 m (closer than)",
                "closest    KLM1 and BAW2, 0 m horizontally and 200.000 m vertically apart at "
                "2024-05-01T12:00:30.000Z"});
  // 59.9996 s are the next minute, not its 60th second.
  expect_parts(run({"replay"},
                   "id,time,x,y,z\na,2023-12-31T23:59:59.9996Z,0,0,0\nb,2023-12-31T23:59:59.9996Z,"
                   "500,0,0\na,2024-01-01T00:01:00Z,0,0,0\nb,2024-01-01T00:01:00Z,500,0,0\n")
                   .err,
               {"from       2024-01-01T00:00:00.000Z to 2024-01-01T00:01:00.000Z"});
}

TEST(Replay, OptionsThatTheReportWouldIgnoreAreRefused) {
  for (const std::string report : {"conflicts", "bees", "events"}) {
    expect_usage_error({"replay", "--report", report, "--every", "1"},
                       "--every does not apply to --report " + report +
                           "; leave it out, or say --report separation");
  }
  for (const std::string report : {"conflicts", "bees", "separation"}) {
    for (const std::string option : {"--horizon", "--leave-factor", "--look-every"}) {
      expect_usage_error({"replay", "--report", report, option, "2"},
                         option + " does not apply to --report " + report +
                             "; leave it out, or say --report events");
    }
  }
  // Without --report it is conflicts; and the default value, if it is given, is refused like any
  // other.
  expect_usage_error({"replay", "--every", "1"}, "--every does not apply to --report conflicts");
  expect_usage_error({"replay", "--report", "events", "--inclusive"},
                     "--inclusive does not apply to --report events");
}

TEST(Replay, InvalidNumbersAndWordsAreRefused) {
  for (const auto& [option, report] :
       {std::pair<std::string, std::string>{"--max-gap", "bees"},
        std::pair<std::string, std::string>{"--every", "separation"},
        std::pair<std::string, std::string>{"--look-every", "events"}}) {
    for (const std::string bad : {"0", "-1", "nan", "inf", "soon"}) {
      expect_usage_error({"replay", "--report", report, option + "=" + bad},
                         option + " '" + bad + "' is not a number of seconds above 0");
    }
  }
  expect_usage_error({"replay", "--tolerance=0"},
                     "--tolerance '0' is not a number of metres above");
  const Arguments events = {"replay", "--report", "events"};
  expect_usage_error(events + Arguments{"--horizon=-1"},
                     "--horizon '-1' is not a number of seconds from 0");
  expect_usage_error(events + Arguments{"--leave-factor=0.9"},
                     "--leave-factor '0.9' is not a number");
  expect_usage_error({"replay", "--report", "event"}, "did you mean 'events'?");
  expect_usage_error({"replay", "-", "-"}, "standard input can be read once");
  expect_usage_error({"replay", "--speed", "2"}, "'--speed' is no option");
}

}  // namespace
}  // namespace beespace::cli_test
