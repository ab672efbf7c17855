// `beespace predict`: future conflicts, on swarms whose future is computed by hand.
#include <gtest/gtest.h>

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

// After t seconds a and b are 100 - 2 t apart along x, and 3 along y: 5 m after 48 s, 3 m after 50
// s, 5 m after 52 s. None comes near c.
constexpr std::string_view kHeadOn =
    "id,x,y,z,vx,vy,vz\n"
    "a,0,0,0,1,0,0\n"
    "b,100,3,0,-1,0,0\n"
    "c,0,500,0,0,0,0\n";

// The same, but b is 20 m above a and sinks to its height within 50 s.
constexpr std::string_view kSinking =
    "id,x,y,z,vx,vy,vz\n"
    "a,0,0,0,1,0,0\n"
    "b,100,3,20,-1,0,-0.4\n";

// Without the header.
TextRows csv_rows(const std::string& text) {
  TextRows rows = rows_of(text, ',');
  if (!rows.empty()) rows.erase(rows.begin());
  return without_lasts(std::move(rows));
}

TextRows predicted(const Arguments& more, std::string_view input = kHeadOn) {
  const Finished finished = run(Arguments{"predict", "--threshold", "5"} + more, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return without_lasts(rows_of(finished.out));
}

TEST(Predict, GivesBeginClosestAndEndOfAConflict) {
  expect_rows(predicted({}), {{"a", "b", "48", "50", "3", "52"}});
}

TEST(Predict, LooksAsFarAsTheHorizon) {
  expect_rows(predicted({"--horizon", "48"}), {});
  expect_rows(predicted({"--horizon", "49"}), {{"a", "b", "48", "49", "3.605551275", "49"}});
  expect_rows(predicted({"--horizon", "50"}), {{"a", "b", "48", "50", "3", "50"}});
  expect_rows(predicted({"--horizon", "0"}), {});
  expect_rows(predicted({"--horizon", "0"}, "x,y,z,vx,vy,vz\n0,0,0,9,0,0\n3,0,0,9,0,0\n"),
              {{"0", "1", "0", "0", "3", "0"}});
}

// What is closest at the end of the horizon is not as close as they come.
TEST(Predict, SaysWhereTwoAreStillClosingAtTheHorizon) {
  const Arguments predict = {"predict", "--threshold", "5", "--horizon"};
  expect_parts(run(predict + Arguments{"49"}, kHeadOn).err,
               {"; still closing at the horizon of 49 s (--horizon)"});
  const Finished later = run(predict + Arguments{"60"}, kHeadOn);
  EXPECT_EQ(later.err.find("still closing"), std::string::npos) << later.err;
}

TEST(Predict, ExactlyTheThresholdCountsOnlyWhenInclusive) {
  expect_rows(predicted({"--horizon", "48", "--inclusive"}), {{"a", "b", "48", "48", "5", "48"}});
  const Arguments grazing = {"predict", "--threshold", "3"};
  EXPECT_EQ(below_header(run(grazing, kHeadOn).out), "");
  expect_rows(without_lasts(rows_of(run(grazing + Arguments{"--inclusive"}, kHeadOn).out)),
              {{"a", "b", "50", "50", "3", "50"}});
}

TEST(Predict, AVerticalThresholdHoldsAtTheSameTimeAsTheHorizontalOne) {
  // Within 2 m in height from 45 s to 55 s; within 0.4 m from 49 s to 51 s.
  expect_rows(predicted({"--vertical", "2"}, kSinking),
              {{"a", "b", "48", "50", "3", "52", "3", "0"}});
  expect_rows(predicted({"--vertical", "0.4"}, kSinking),
              {{"a", "b", "49", "50", "3", "51", "3", "0"}});
  // In space |(2 u, 3, 0.4 u)| < 5 for |u| < 4 / sqrt(4.16), u seconds before or after.
  const double u = 4.0 / std::sqrt(4.16);
  expect_rows(predicted({}, kSinking),
              {{"a", "b", std::to_string(50.0 - u), "50", "3", std::to_string(50.0 + u)}});
}

TEST(Predict, OlderReportsAreExtrapolatedToTheLastOne) {
  // 10 s later a is at 10, b 90 m away: 5 m after 43 more seconds.
  constexpr std::string_view input =
      "id,time_s,x,y,z,vx,vy,vz\n"
      "a,0,0,0,0,1,0,0\n"
      "b,10,100,3,0,-1,0,0\n";
  expect_rows(predicted({}, input), {{"a", "b", "53", "55", "3", "57"}});
  const Finished finished = run({"predict", "--threshold", "5"}, input);
  expect_parts(
      finished.err,
      {"now        10.00 s\n", "1 last heard of before now was brought forward, by up to 10.00 s",
       "soonest    a and b, in 43.00 s\n", "closest    a and b, 3.000 m apart at 55.00 s"});
}

TEST(Predict, BeesNotHeardForLongAreLeftOutAndNamed) {
  constexpr std::string_view input =
      "id,time_s,x,y,z,vx,vy,vz\n"
      "a,0,0,0,0,1,0,0\n"
      "b,10,100,3,0,-1,0,0\n";
  expect_rows(predicted({"--max-age", "10"}, input), {{"a", "b", "53", "55", "3", "57"}});
  expect_rows(predicted({"--max-age", "9.5"}, input), {});
  expect_parts(
      run({"predict", "--max-age", "9.5"}, input).err,
      {"bees       1 of 2\n", "stale      1 left out, not heard of for 9.5 s (--max-age)"});
  const std::string json = run({"predict", "--max-age", "9.5", "--json"}, input).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("now_s": 10)", R"("movers": 1)", R"("stale": 1)"});
}

TEST(Predict, WithoutVelocitiesItIsThatOfTheLastTwoReports) {
  // The first report of a would make it fly the other way.
  const Finished finished = run({"predict", "--threshold", "5"},
                                "id,t_ms,x,y,z\n"
                                "a,0,900,0,0\na,1000,1,0,0\na,2000,2,0,0\n"
                                "b,0,100,3,0\nb,2000,98,3,0\n");
  expect_rows(without_lasts(rows_of(finished.out)), {{"a", "b", "48", "50", "3", "52"}});
  expect_parts(finished.err, {"2 without a velocity: it is that of the last two fixes"});
}

TEST(Predict, ABeeWithNeitherVelocityNorTwoReportsIsCheckedForNowAndCounted) {
  const Finished finished =
      run({"predict", "--threshold", "5"},
          "id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\nb,1,2,2,2\nc,0,9,0,0\nc,1,9,0,0\n");
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err,
               {"bees       2 of 3\n",
                "unknown    1 checked for now only, where last heard "
                "of: neither a velocity (speed, direction and climb) nor two fixes, at "});
  expect_rows(without_lasts(rows_of(finished.out)),
              {{"a", "b", "1", "1", "3", "1"}, {"a", "c", "4", "9", "0", "14"}});
}

TEST(Predict, WithoutAnyVelocityThereIsAnError) {
  expect_failure({"predict"}, "id,time_s,x,y,z\na,1,1,0,0\nb,1,2,2,2\n", 3,
                 "bee 'b': there is no velocity, and only one fix to tell it from");
  expect_failure({"predict"}, "id,x,y,z\na,0,0,0\nb,1,1,1\n", 3,
                 "there is neither a time nor a velocity");
}

TEST(Predict, WithoutIdsBeesAreCalledByTheirRow) {
  expect_rows(predicted({}, "x,y,z,vx,vy,vz\n0,0,0,1,0,0\n100,3,0,-1,0,0\n"),
              {{"0", "1", "48", "50", "3", "52"}});
}

TEST(Predict, TheSummarySaysWhatWasAskedAndFound) {
  const Finished finished = run({"predict", "--threshold", "5", "--vertical", "2"}, kSinking);
  expect_parts(
      finished.err,
      {"input      standard input (", "frame      metres: the header names x, y and z",
       "note       velocities along x, y, z are read", "bees       2\n", "now        0.00 s\n",
       "threshold  horizontally 5 m (closer than), and in height 2 m (closer than)\n",
       "horizon    60 s\n", "conflicts  1, of 2 bees\n", "soonest    a and b, in 48.00 s\n",
       "closest    a and b, 3.000 m horizontally and 0 m vertically apart at 50.00 s\n",
       "time       search "});
  expect_parts(run({"predict", "--threshold", "3"}, kHeadOn).err, {"conflicts  none\n"});
  expect_parts(run({"predict", "--threshold", "3", "--inclusive"}, kHeadOn).err,
               {"threshold  3 m or closer\n"});
}

// What has happened is not asked about, and no word of the answer is of it.
TEST(Predict, OfARecordingTheAnswerIsOfWhatLiesAfterItsEnd) {
  const std::string met = "id,time_s,x,y,z\na,0,0,0,0\na,10,100,0,0\nb,0,1,0,0\nb,10,900,0,0\n";
  expect_parts(run({"predict", "--threshold", "5"}, met).err,
               {"conflicts  none after the end of the recording\n"});
  expect_parts(run({"predict", "--threshold", "5", "--json"}, met).out,
               {R"("not_looked_at": {"begins_s": 0, "ends_s": 10})"});
  expect_parts(run({"predict", "--threshold", "1000"}, met).err,
               {"conflicts  1, of 2 bees, after the end of the recording\n"});
  expect_parts(run({"predict", "--threshold", "3", "--json"}, kHeadOn).out,
               {R"("not_looked_at": null)"});
}

TEST(Predict, JsonHasTheQueryAndTheAnswer) {
  const std::string json =
      run({"predict", "--threshold", "5", "--vertical", "2", "--horizon", "70", "--json"}, kSinking)
          .out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("command": "predict")", R"("threshold_m": 5)", R"("vertical_m": 2)",
                      R"("horizon_s": 70)", R"("now_s": 0)", R"("movers": 2)", R"("stale": 0)",
                      R"("times": "seconds")", R"("conflict_count": 1)",
                      R"("closest_s": 50, "closest_m": 3, )"});
}

// Two on the equator at the same speed towards each other, 0.1 degrees and 200 m of height apart.
class PredictAircraft : public testing::Test {
 protected:
  static constexpr double kRadius_m = 6'378'137.0;
  static constexpr double kHalf = 0.05 * std::numbers::pi / 180.0;
  // Each flies on in a straight line on its own horizon; what they do along the line between them.
  const double apart_m_ = 2.0 * kRadius_m * std::sin(kHalf);
  const double closing_mps_ = 200.0 * std::cos(kHalf);

  static std::string traffic(const std::string& climb_mps) {
    return "id,time,lon,lat,height,ve,vn,vu\n"
           "KLM1,2024-05-01T12:00:00Z,0,0,10000,100,0," +
           climb_mps + "\nBAW2,2024-05-01T12:00:00Z,0.1,0,10200,-100,0,0\n";
  }
  static std::string at(double in_s) { return std::to_string(1'714'564'800.0 + in_s); }
};

TEST_F(PredictAircraft, GroundDistanceAndHeightAreComparedApart) {
  const Arguments question = {"predict", "--threshold", "1000", "--horizon", "100", "--csv"};
  const TextRows meeting = {{"KLM1", "BAW2", at((apart_m_ - 1'000.0) / closing_mps_),
                             at(apart_m_ / closing_mps_), "200",
                             at((apart_m_ + 1'000.0) / closing_mps_), "0", "200"}};
  expect_rows(csv_rows(run(question + Arguments{"--vertical", "201"}, traffic("0")).out), meeting);
  EXPECT_EQ(below_header(run(question + Arguments{"--vertical", "200"}, traffic("0")).out), "");
}

TEST_F(PredictAircraft, TheClimbCountsForTheHeight) {
  // Less than 50 m apart in height while |200 - 4 t| < 50.
  const auto rows = csv_rows(
      run({"predict", "--threshold", "5000", "--vertical", "50", "--horizon", "100", "--csv"},
          traffic("4"))
          .out);
  ASSERT_EQ(rows.size(), 1u);
  expect_rows({{rows[0].at(2), rows[0].at(5)}}, {{at(37.5), at(62.5)}});
}

TEST_F(PredictAircraft, TimesAreShownAsDates) {
  const Finished finished =
      run({"predict", "--threshold", "1000", "--vertical", "300"}, traffic("0"));
  expect_parts(finished.err, {"frame      WGS84 longitude, latitude, height",
                              "now        2024-05-01T12:00:00.000Z",
                              "closest    KLM1 and BAW2, under 1 mm horizontally and 200.000 m "
                              "vertically apart at 2024-05-01T12:00:55.660Z"});
  const Finished json =
      run({"predict", "--threshold", "1000", "--vertical", "300", "--json"}, traffic("0"));
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("frame": "wgs84")", R"("times": "seconds since 1970-01-01T00:00:00Z")",
                          R"("now_s": 1714564800)", R"("vertical_m": 300)"});
}

TEST_F(PredictAircraft, TheDistanceShownIsThatOnTheGroundAndTheHeightPutTogether) {
  // At rest, 20 km apart in a straight line at most.
  const std::string still =
      "id,time_s,lon,lat,height,ve,vn,vu\na,0,0,0,10000,0,0,0\nb,0,0.1,0,10200,0,0,0\n";
  const Arguments question = {"--threshold", "20000", "--vertical", "300"};
  const TextRows rows = rows_of(run(Arguments{"predict"} + question, still).out);
  ASSERT_EQ(rows.size(), 1u);
  expect_rows({{rows[0].at(4)}}, {{std::to_string(std::hypot(apart_m_, 200.0))}});
  // And the straight line, by the law of cosines.
  const double a = kRadius_m + 10'000.0;
  const double b = kRadius_m + 10'200.0;
  const double straight = std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(2.0 * kHalf));
  expect_rows(rows_of(run(Arguments{"detect", "--report", "closest-pair"} +
                              Arguments{"--threshold", "20000"},
                          still)
                          .out),
              {{"a", "b", std::to_string(straight)}});
  const TextRows pairs =
      rows_of(run(Arguments{"detect", "--report", "pairs"} + question, still).out);
  ASSERT_EQ(pairs.size(), 1u);
  expect_rows({{pairs[0].at(2), pairs[0].at(3), pairs[0].at(4)}},
              {{std::to_string(straight), std::to_string(apart_m_), "200"}});
}

TEST(Predict, TheHelpSaysWhatTimesAndDistancesMean) {
  expect_parts(run({"predict", "--help"}).out,
               {"These times lie between now and the horizon", "hypot(ground, height)"});
  expect_parts(run({"replay", "--help"}).out, {"hypot(ground, height)"});
  expect_parts(run({"watch", "--help"}).out, {"hypot(ground, height)"});
  expect_parts(run({"detect", "--help"}).out, {"in a straight line"});
}

TEST(Predict, LinesToTypeHaveNamesOfFilesAsOneWord) {
  TemporaryFolder folder;
  const std::string moving = "id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\nb,0,9,9,9\nb,1,8,9,9\n";
  const std::string spaced = folder.file("White Stork.csv", moving);
  const std::string plain = folder.file("stork.csv", moving);
  expect_parts(run({"predict", spaced, "--threshold", "5"}).err,
               {"ask 'beespace replay \"" + spaced + "\" --threshold 5'"});
  expect_parts(run({"predict", plain, "--threshold", "5"}).err,
               {"ask 'beespace replay " + plain + " --threshold 5'"});
}

TEST(Predict, BeesOnTheGroundCountWhenAskedFor) {
  const std::string landed =
      R"({"now": 1000000.5, "messages": 7, "aircraft": [
        {"hex":"a","alt_baro":"ground","alt_geom":0,"gs":9,"track":0,"geom_rate":0,"lat":1,"lon":2,"seen_pos":0},
        {"hex":"b","alt_geom":10,"gs":9,"track":0,"geom_rate":0,"lat":1,"lon":2,"seen_pos":0}]})";
  EXPECT_EQ(below_header(run({"predict", "--threshold", "100"}, landed).out), "");
  EXPECT_EQ(rows_of(run({"predict", "--threshold", "100", "--grounded"}, landed).out).size(), 1u);
}

TEST(Predict, InvalidNumbersAreRefused) {
  for (const std::string option : {"--horizon", "--max-age"}) {
    for (const std::string bad : {"-1", "nan", "inf", "soon", "5s"}) {
      expect_usage_error({"predict", option + "=" + bad},
                         option + " '" + bad + "' is not a number of seconds from 0 on");
    }
  }
  expect_usage_error({"predict", "-", "-"}, "standard input can be read once");
  expect_usage_error({"predict", "--report", "bees"}, "'--report' is no option");
  expect_usage_error({"predict", "--speed", "2"}, "'--speed' is no option");
}

TEST(Predict, AShowIsForReplay) {
  const TemporaryFolder folder;
  const std::string show = folder.file(
      "show.json", R"({"version": 1, "settings": {}, "swarm": {"drones": [{"type": "generic",
        "settings": {"name": "a", "trajectory": {"version": 1,
        "points": [[0, [0, 0, 0], []], [9, [0, 0, 9], []]]}}}]}})");
  expect_failure({"predict", show}, {}, 3, "ask 'beespace replay' about it");
}

}  // namespace
}  // namespace beespace::cli_test
