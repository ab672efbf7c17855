// Answers as people read them: dates instead of seconds since 1970, how far apart horizontally and
// vertically, in nautical miles and feet where the thresholds are.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Along x they meet after 50 s; b is then 3 m beside a, and 4 m below it.
constexpr std::string_view kMetres =
    "id,time_s,x,y,z,vx,vy,vz\n"
    "a,0,0,0,10,1,0,0\na,100,100,0,10,1,0,0\n"
    "b,0,100,3,6,-1,0,0\nb,100,0,3,6,-1,0,0\n";

// Two towards each other on the equator, 600 ft apart in height: 20,000 m are 0.179663 degrees.
std::string aircraft(const std::string& first_time, const std::string& second_time,
                     const std::string& time = "timestamp") {
  const std::string header = "icao24," + time + ",lat,lon,alt_ft,gs_kt,track,vertical_rate_fpm\n";
  return header + "a," + first_time + ",0,0,10000,200,90,0\nb," + first_time +
         ",0,0.1796631,10600,200,270,0\na," + second_time + ",0,0.0898315,10000,200,90,0\nb," +
         second_time + ",0,0.0898316,10600,200,270,0\n";
}

TEST(AnswersForPeople, HorizontalAndVerticalStandBehindTheOthers) {
  const Finished finished = run(
      {"replay", "--threshold", "5", "--vertical", "6", "--csv", "--max-gap", "never"}, kMetres);
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.err;
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"first", "second", "begins_s", "closest_s", "closest_m",
                                      "ends_s", "horizontal_m", "vertical_m", "lasts_s", "worst_s",
                                      "worst_share", "worst_horizontal_m", "worst_vertical_m"}));
  expect_rows({{rows[1][3], rows[1][4], rows[1][6], rows[1][7]}}, {{"50", "5", "3", "4"}});
  expect_parts(
      finished.err,
      {"closest    a and b, 3.000 m horizontally and 4.000 m vertically apart at 50.00 s\n",
       "worst      a and b, 3.000 m horizontally and 4.000 m vertically apart at 50.00 s;"});
  const std::string json =
      run({"replay", "--threshold", "5", "--vertical", "6", "--json", "--max-gap", "never"},
          kMetres)
          .out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("distance_m": 5, "horizontal_m": 3, "vertical_m": 4})",
                      R"("horizontal_m": 3, "vertical_m": 4, "lasts_s": )",
                      R"("worst": {"first": "a", "second": "b", "time_s": 50, "share": 0.666)",
                      R"("worst_s": 50, "worst_share": 0.666)"});
}

TEST(AnswersForPeople, WithoutAVerticalThresholdAllIsAsItWas) {
  const Finished finished = run({"replay", "--threshold", "6", "--max-gap", "never"}, kMetres);
  EXPECT_EQ(lines_of(finished.out).front(),
            "first\tsecond\tbegins_s\tclosest_s\tclosest_m\tends_s\tlasts_s");
  expect_parts(finished.err, {"closest    a and b, 5.000 m apart at 50.00 s\n"});
}

TEST(AnswersForPeople, AVerticalThresholdHasItsColumnsWithoutAnyConflict) {
  const Finished finished = run(
      {"replay", "--threshold", "1", "--vertical", "6", "--csv", "--max-gap", "never"}, kMetres);
  EXPECT_EQ(finished.out,
            "first,second,begins_s,closest_s,closest_m,ends_s,horizontal_m,vertical_m,lasts_s,"
            "worst_s,worst_share,worst_horizontal_m,worst_vertical_m\n");
}

TEST(AnswersForPeople, PredictTellsThemWhereTheyWillBe) {
  const Finished finished =
      run({"predict", "--threshold", "5", "--vertical", "6", "--csv", "--horizon", "60"},
          "id,x,y,z,vx,vy,vz\na,0,0,10,1,0,0.1\nb,100,3,6,-1,0,0.08\n");
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.err;
  // After 50 s or so: in height 4 m and a metre more; a straight line is shortest a little before.
  EXPECT_EQ(rows[0].at(6) + " " + rows[0].at(7), "horizontal_m vertical_m");
  const double closest_s = std::stod(rows[1].at(3));
  EXPECT_NEAR(std::stod(rows[1].at(6)), std::hypot(100 - 2 * closest_s, 3), 1e-9);
  EXPECT_NEAR(std::stod(rows[1].at(7)), 4 + 0.02 * closest_s, 1e-9);
}

TEST(AnswersForPeople, ATableForSpreadsheetsTellsBothDistancesAndHowLong) {
  const Finished finished =
      run({"export", "--separation", "enroute", "--format", "csv", "--max-gap", "never"},
          aircraft("0", "100", "time_s"));
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.err;
  ASSERT_EQ(rows[0].size(), 18u);
  const std::vector<std::string> last(rows[0].end() - 5, rows[0].end());
  EXPECT_EQ(last, (std::vector<std::string>{"lasts_s", "horizontal_m", "vertical_m",
                                            "horizontal_NM", "vertical_ft"}));
  EXPECT_NEAR(std::stod(rows[1].at(13)), std::stod(rows[1].at(4)) - std::stod(rows[1].at(2)), 1e-9);
  EXPECT_NEAR(std::stod(rows[1].at(16)), std::stod(rows[1].at(14)) / 1852, 1e-12);
  EXPECT_NEAR(std::stod(rows[1].at(17)), 600, 1e-9);
}

TEST(AnswersForPeople, AviationHasNauticalMilesAndFeetToo) {
  const std::string input = aircraft("0", "100", "time_s");
  for (const char* const command : {"replay", "predict"}) {
    Arguments arguments = {command, "--separation", "enroute", "--csv"};
    if (std::string(command) == "replay") arguments = arguments + Arguments{"--max-gap", "never"};
    const Finished finished = run(arguments, input);
    const TextRows rows = rows_of(finished.out, ',');
    ASSERT_EQ(rows.size(), 2u) << finished.err;
    EXPECT_EQ(rows[0].at(8) + " " + rows[0].at(9), "horizontal_NM vertical_ft");
    const double horizontal_m = std::stod(rows[1].at(6));
    EXPECT_NEAR(std::stod(rows[1].at(8)), horizontal_m / 1852, 1e-12);
    EXPECT_EQ(rows[1].at(9), "600");
    EXPECT_NEAR(std::stod(rows[1].at(7)), 182.88, 1e-9);
  }
  const Finished said =
      run({"replay", "--threshold", "3NM", "--vertical", "1000ft", "--max-gap", "never"}, input);
  expect_parts(said.err, {" NM (", " m) horizontally and 600 ft (182.880 m) vertically apart at "});
}

// Spreadsheets have both, the dates behind all others.
TEST(AnswersForPeople, TablesHaveDatesBehindAllOthers) {
  const Arguments question = {"replay", "--threshold", "5", "--max-gap", "never", "--csv"};
  const auto last_three = [&](const std::string& input, const Arguments& more) {
    const Finished finished = run(question + more, input);
    TextRows rows = rows_of(finished.out, ',');
    EXPECT_EQ(rows.size(), 2u) << finished.err;
    for (auto& row : rows) row.erase(row.begin(), row.end() - 3);
    return rows;
  };
  const auto table = [](const std::string& behind) {
    return "id,time,x_m,y_m\na,2024-07-01 12:00:00" + behind + ",0,0\na,2024-07-01 12:00:20" +
           behind + ",20,0\nb,2024-07-01 12:00:00" + behind + ",10,3\nb,2024-07-01 12:00:20" +
           behind + ",10,3\n";
  };
  const std::vector<std::string> head = {"begins", "closest", "ends"};
  // As it stands in the file, which names no zone: not in UTC.
  EXPECT_EQ(last_three(table(""), {}),
            (TextRows{head,
                      {"2024-07-01 12:00:06.000", "2024-07-01 12:00:10.000",
                       "2024-07-01 12:00:14.000"}}));
  EXPECT_EQ(last_three(table("Z"), {})[1].at(1), "2024-07-01T12:00:10.000Z");
  EXPECT_EQ(last_three(table("Z"), {"--time-zone", "Europe/Berlin"})[1].at(1),
            "2024-07-01T14:00:10.000+02:00");
  EXPECT_EQ(last_three(table(""), {"--time-zone", "Europe/Berlin"})[1].at(1),
            "2024-07-01T12:00:10.000+02:00");
  const std::vector<std::string> seconds = lines_of(run(question, kMetres).out);
  EXPECT_TRUE(seconds.at(0).ends_with(",lasts_s")) << seconds.at(0);
  // Of reports, too.
  expect_parts(run(question + Arguments{"--report", "pairs"}, table("")).out,
               {",closest\n", ",2024-07-01 12:00:10.000\n"});
  expect_parts(run(question + Arguments{"--report", "separation"}, table("")).out,
               {",time\n", ",2024-07-01 12:00:10.000\n"});
  expect_parts(run(question + Arguments{"--report", "events"}, table("")).out,
               {",time,closest,said_at\n", ",2024-07-01 12:00:06.000,"});
}

TEST(AnswersForPeople, TimesSince1970AreDatesInTextAndNumbersForPrograms) {
  const std::string input = aircraft("1533099600", "1533099700");
  const Arguments question = {"replay", "--threshold", "5NM",  "--vertical",
                              "1000ft", "--max-gap",   "never"};
  const Finished text = run(question, input);
  const auto lines = lines_of(text.out);
  ASSERT_EQ(lines.size(), 2u) << text.err;
  EXPECT_EQ(fields_of(lines[0], '\t')[2] + " " + fields_of(lines[0], '\t')[3] + " " +
                fields_of(lines[0], '\t')[5],
            "begins closest ends");
  EXPECT_EQ(fields_of(lines[1], '\t')[3].substr(0, 20), "2018-08-01T05:01:40.");
  EXPECT_EQ(fields_of(lines[1], '\t')[3].back(), 'Z');
  const Finished csv = run(question + Arguments{"--csv"}, input);
  EXPECT_EQ(rows_of(csv.out, ',')[0][2], "begins_s");
  EXPECT_NEAR(std::stod(rows_of(csv.out, ',')[1][3]), 1533099699.9, 0.2);
  for (const char* const report : {"bees", "separation"}) {
    const Finished other = run(question + Arguments{"--report", report}, input);
    expect_parts(other.out,
                 {"2018-08-01T05:0", report == std::string("bees") ? "closest\t" : "time\t"});
    expect_parts(run(question + Arguments{"--report", report, "--csv"}, input).out, {"1533099700"});
  }
}

// In conflict, and so shown below the limits, whatever the digits cost.
TEST(AnswersForPeople, RoundingNeverReachesALimit) {
  const std::string levels =
      "icao24,time_s,lat,lon,alt_ft\na,0,0,0,10000\na,10,0,0,10000\nb,0,0,0.01,10999.9996\n"
      "b,10,0,0.01,10999.9996\n";
  const Finished finished = run({"replay", "--separation", "enroute"}, levels);
  expect_parts(finished.err, {"horizontally and 999.9996 ft ("});
  EXPECT_EQ(finished.err.find("1,000 ft ("), std::string::npos) << finished.err;
  const std::string metres =
      "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,99.9999,0,0\n"
      "b,9,99.9999,0,0\n";
  expect_parts(run({"replay", "--threshold", "100"}, metres).err,
               {"closest    a and b, 99.9999 m apart"});
  expect_parts(run({"replay", "--threshold", "0.05NM"},
                   "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,92.59,0,0\nb,9,92.59,0,0\n")
                   .err,
               {"0.04999 NM (92.590 m) apart"});
  expect_parts(
      run({"detect", "--threshold", "100", "--crs", "metres"}, "x,y,z\n0,0,0\n99.9999,0,0\n").err,
      {"closest    0 and 1, 99.9999 m apart"});
}

// Who speaks of millimetres is told in millimetres.
TEST(AnswersForPeople, SmallThingsAreToldInTheirUnits) {
  const std::string cage = "id,time_s,x [mm],y [mm]\na,0,0,0\na,9,0,0\nb,0,15.72,0\nb,9,15.72,0\n";
  expect_parts(run({"replay", "--threshold", "30mm"}, cage).err, {"15.7 mm apart"});
  expect_parts(run({"replay"}, cage).err, {"15.7 mm apart"});
  expect_parts(run({"replay", "--threshold", "2cm"}, cage).err, {"1.57 cm apart"});
  expect_parts(run({"replay", "--threshold", "0.03"}, cage).err, {"0.016 m apart"});
  const std::string near = "id,time_s,x_mm,y_mm\na,0,0,0\na,9,0,0\nb,0,15.76,0\nb,9,15.76,0\n";
  expect_parts(run({"replay", "--threshold", "15.8mm"}, near).err, {"15.76 mm apart"});
  expect_parts(run({"replay", "--threshold", "20mm"}, near).err, {"15.8 mm apart"});
}

// Drones a foot apart are not told in nautical miles.
TEST(AnswersForPeople, WhoSpeaksOfFeetIsToldInFeet) {
  const std::string show =
      "id,time_s,x,y,z\na,0,0,0,5\na,9,0,0,5\nb,0,0.35052,0,5\nb,9,0.35052,0,5\n";
  expect_parts(run({"replay", "--threshold", "5ft"}, show).err, {"1.15 ft (0.351 m) apart"});
  expect_parts(run({"replay", "--threshold", "500ft"}, show).err, {"1 ft (0.351 m) apart"});
  expect_parts(run({"replay", "--threshold", "0.05NM"}, show).err, {" NM (0.351 m) apart"});
  const std::string feet = "id,time_s,x_ft,y_ft,z_ft\na,0,0,0,5\na,9,0,0,5\nb,0,2,0,5\nb,9,2,0,5\n";
  expect_parts(run({"replay", "--threshold", "2"}, feet).err, {"2.00 ft (0.610 m) apart"});
}

TEST(AnswersForPeople, AThresholdThatIsWiderThanTheSceneIsPointedOut) {
  const std::string small = "id,time_s,x_um,y_um\na,0,0,0\na,9,0,0\nb,0,30,40\nb,9,30,40\n";
  expect_parts(run({"replay", "--threshold", "10"}, small).err,
               {"note       all of it is 50.0 µm wide, and the threshold is 10 m: if µm are meant, "
                "say --threshold 10µm\n"});
  for (const char* const threshold : {"10um", "0.00001"}) {
    const Finished finished = run({"replay", "--threshold", threshold}, small);
    EXPECT_EQ(finished.err.find("wide"), std::string::npos) << finished.err;
  }
  const std::string pixels = "id,frame,x,y\na,0,0,0\na,9,0,0\nb,0,300,400\nb,9,300,400\n";
  expect_parts(
      run({"replay", "--fps", "25", "--scale", "0.5mm", "--threshold", "20"}, pixels).err,
      {"note       all of it is 250.0 mm (500 px) wide, and the threshold is 20 m: if px are "
       "meant, say --threshold 10mm\n"});
}

TEST(AnswersForPeople, UnitsOfAviationMayBeAskedForOrNot) {
  const Arguments question = {"replay", "--threshold", "9260", "--vertical",
                              "300",    "--max-gap",   "never"};
  const std::string metres =
      "id,time_s,lat,lon,height_m\na,0,0,0,1000\na,10,0,0,1000\nb,0,0,0.01,1100\nb,10,0,0.01,"
      "1100\n";
  expect_parts(run(question, metres).err,
               {"1,113.195 m horizontally and 100.000 m vertically apart"});
  expect_parts(run(question + Arguments{"--units", "aviation"}, metres).err,
               {"0.601 NM (1,113.195 m) horizontally and 328 ft (100.000 m) vertically apart"});
  const std::string feet =
      "id,time_s,lat,lon,alt_ft\na,0,0,0,1000\na,10,0,0,1000\nb,0,0,0.01,1100\nb,10,0,0.01,1100\n";
  expect_parts(run(question, feet).err, {"0.601 NM (1,113.195 m) horizontally and 100 ft ("});
  expect_parts(run(question + Arguments{"--units", "metric"}, feet).err,
               {"1,113.195 m horizontally and 30.480 m vertically apart"});
}

// One climbs through the height of the other, nearer to it before: told is when they are farthest
// within both limits, and not the end of the conflict, where its heights are the limit.
TEST(AnswersForPeople, AConflictByHeightsIsToldWhenItIsWorst) {
  std::string input = "id,time_s,x,y,z\n";
  for (int t = 0; t <= 100; t += 10) {
    input += "a," + std::to_string(t) + "," + std::to_string(1000 + 10 * t) + ",0,1000\n";
    input += "b," + std::to_string(t) + ",0,0," + std::to_string(1000 - 500 + 10 * t) + "\n";
  }
  const Finished replay =
      run({"replay", "--threshold", "5NM", "--vertical", "300m", "--max-gap", "20"}, input);
  expect_parts(replay.err,
               {"closest    a and b, 0.785 NM (1,452.929 m) horizontally and 154 ft (47.071 m) "
                "vertically apart at 45.29 s\n",
                "worst      a and b, 0.785 NM"});
  EXPECT_EQ(replay.err.find("just under"), std::string::npos) << replay.err;
  // Tables have when they are closest in a straight line beside.
  const TextRows rows = rows_of(replay.out);
  expect_rows({{rows[0][3], rows[0][7]}}, {{"20", "300"}});
  for (const char* const command : {"verify", "replay"}) {
    const Finished again = run({command, "--threshold", "5NM", "--vertical", "300m"}, input);
    expect_parts(again.err, {"0.785 NM (1,452.929 m) horizontally and 154 ft"});
  }
  // That it is a limit is no distance of those that keep it.
  std::string level = "id,time_s,x,y,z\n";
  for (int t = 0; t <= 20; t += 10) {
    level += "a," + std::to_string(t) + ",0,0,1000\nb," + std::to_string(t) + ",0,100,1300\n";
  }
  const Finished apart = run({"replay", "--threshold", "5NM", "--vertical", "300m"}, level);
  EXPECT_EQ(apart.err.find("just under"), std::string::npos) << apart.err;
}

// By the straight line who climbs away would be first, though it is others who meet.
TEST(AnswersForPeople, WhoMeetsAtOneHeightIsWorseThanWhoPassesNearALimit) {
  const std::string input =
      "id,time_s,x,y,z\n"
      "a,0,0,0,1000\na,100,0,0,1000\nb,0,0,500,1290\nb,100,0,500,1290\n"
      "c,0,90000,0,1000\nc,100,90000,0,1000\nd,0,90000,2000,1000\nd,100,90000,2000,1000\n";
  const Arguments question = {"replay", "--threshold", "5NM", "--vertical", "300m"};
  expect_parts(run(question, input).err,
               {"closest    c and d, 1.080 NM (2,000.000 m) horizontally and 0 ft (0 m)",
                "worst      c and d, 1.080 NM"});
  const TextRows pairs = rows_of(run(question + Arguments{"--report", "pairs"}, input).out);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0][0] + pairs[0][1] + pairs[1][0] + pairs[1][1], "cdab");
  const std::string json = run(question + Arguments{"--json"}, input).out;
  expect_parts(json, {R"("closest": {"first": "a", "second": "b")",
                      R"("worst": {"first": "c", "second": "d")"});
  const TemporaryFolder folder;
  run(Arguments{"plot", folder.file("t.csv", input)} +
      Arguments{"--threshold", "5NM", "--vertical", "300m", "--output", folder.path("t.svg")});
  const std::string picture = folder.read("t.svg");
  expect_parts(picture, {"Worst pairs in conflict", "closest: 1.08 NM across, 0 ft in height"});
  EXPECT_LT(picture.find("1.08 NM, 0 ft at"), picture.find("0.27 NM, 951 ft at"));
}

}  // namespace
}  // namespace beespace::cli_test
