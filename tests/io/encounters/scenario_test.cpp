// BlueSky scenarios: where aircraft begin, how fast they are, and what is not followed.
#include "io/encounters/air_data.hpp"
#include "io/encounters/scenario_words.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <cmath>
#include <string>

namespace beespace::io {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

// By the densities of the standard atmosphere, which the code does not use.
TEST(AirData, IsThatOfTheStandardAtmosphere) {
  EXPECT_NEAR(true_of_calibrated(280 * kKnot, 25000 * 0.3048), 208.09110, 1e-3);
  EXPECT_NEAR(true_of_calibrated(250 * kKnot, 10000 * 0.3048), 148.52130, 1e-3);
  EXPECT_NEAR(true_of_calibrated(400 * kKnot, 20000 * 0.3048), 269.75766, 1e-3);
  EXPECT_NEAR(true_of_calibrated(250 * kKnot, 39000 * 0.3048), 237.83467, 1e-3);
  EXPECT_NEAR(true_of_calibrated(300 * kKnot, 0), 300 * kKnot, 1e-6);
  EXPECT_NEAR(true_of_mach(0.78, 35000 * 0.3048), 231.29762, 1e-4);
  EXPECT_NEAR(true_of_mach(0.8, 41000 * 0.3048), 236.05559, 1e-4);
  EXPECT_EQ(true_of_calibrated(0, 5000), 0.0);
}

TEST(ScenarioWords, AreReadAsBlueSkyReadsThem) {
  EXPECT_EQ(timed_commands(" 0:01:10.50>CRE a")->time_s, 70.5);
  EXPECT_EQ(timed_commands("00:00:00.00> CRE a ")->commands, "CRE a");
  for (const char* line :
       {"CRE a", "00:00>CRE", "a:00:00>CRE", "-1:00:00>CRE", "1:2:3:4>x", ">x"}) {
    EXPECT_FALSE(timed_commands(line)) << line;
  }
  EXPECT_EQ(commands_in("cre a, b  1,,2;pan 0"),
            (std::vector<std::vector<std::string>>{{"CRE", "A", "B", "1", "", "2"}, {"PAN", "0"}}));
  EXPECT_EQ(degrees_in("-4.5"), -4.5);
  EXPECT_EQ(degrees_in("S4.5"), -4.5);
  EXPECT_NEAR(*degrees_in("N52'18'36"), 52.31, 1e-12);
  EXPECT_NEAR(*degrees_in("W4'30"), -4.5, 1e-12);
  EXPECT_NEAR(*degrees_in("52'18'36.0\"N"), 52.31, 1e-12);
  EXPECT_EQ(degrees_in("4.5W"), -4.5);
  for (const char* word : {"EHAM", "", "N", "NORTH", "1'2'3'4", "nan", "*"}) {
    EXPECT_FALSE(degrees_in(word)) << word;
  }
  EXPECT_EQ(heading_in("90T"), 90.0);
  EXPECT_FALSE(heading_in("90M"));
  EXPECT_EQ(feet_in("FL250"), 25000.0);
  EXPECT_EQ(feet_in("6000"), 6000.0);
  EXPECT_FALSE(feet_in("FL"));
  EXPECT_EQ(air_speed_in("280")->value, 280.0);
  EXPECT_FALSE(air_speed_in("280")->mach);
  for (const char* word : {"M0.78", "M78", "0.78", ".78", "M.78"}) {
    EXPECT_TRUE(air_speed_in(word)->mach) << word;
    EXPECT_NEAR(air_speed_in(word)->value, 0.78, 1e-12) << word;
  }
}

TEST(Scenario, AircraftAreWhereTheyAreCreated) {
  const Recording recording = recording_of(record(
      "# two of them\n\n00:00:00.00>PAN 52 4\n"
      " 0:00:00.00>CRE KL204,B744,52.3,4.7,90,FL250,280;CRE hv12 A320 52.3 5.7 270 25000 .78\n"));
  ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"KL204", "HV12"}));
  EXPECT_EQ(recording.format_description, "BlueSky scenario");
  EXPECT_FALSE(recording.since_1970);
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  EXPECT_EQ(recording.bees[0].fixes, (std::vector<Fix>{{0.0, {4.7, 52.3, 7620.0}}}));
  EXPECT_EQ(recording.bees[0].stated_heights, std::vector<double>{25000.0});
  EXPECT_NEAR(recording.bees[0].velocities.at(0).x, 208.09110, 1e-3);
  EXPECT_NEAR(recording.bees[0].velocities[0].y, 0.0, 1e-9);
  EXPECT_EQ(recording.bees[0].velocities[0].z, 0.0);
  EXPECT_NEAR(recording.bees[1].velocities.at(0).x, -0.78 * std::sqrt(1.4 * 287.05287 * 238.62),
              1e-3);
  EXPECT_TRUE(has_note(recording, "in the standard atmosphere without wind"));
  EXPECT_FALSE(has_note(recording, "that is not followed"));
}

TEST(Scenario, MoveIsTheLastPlaceAndKeepsTheRest) {
  const Recording recording = recording_of(
      record("00:00:00>CRE A,B744,52,4,90,FL100,250\n00:00:20>MOVE A 53 5\n"
             "00:00:30>CRE B,B744,52,4,90,FL100,250\n00:00:40>MOVE B,53,5,12000,0,0.5,600\n"));
  EXPECT_EQ(recording.bees.at(0).fixes, (std::vector<Fix>{{20.0, {5, 53, 3048.0}}}));
  EXPECT_NEAR(recording.bees[0].velocities.at(0).x, 148.52130, 1e-3);
  EXPECT_EQ(recording.bees.at(1).fixes.at(0).time_s, 40.0);
  EXPECT_EQ(recording.bees[1].stated_heights.at(0), 12000.0);
  EXPECT_NEAR(recording.bees[1].velocities.at(0).x, 0.0, 1e-9);
  EXPECT_NEAR(recording.bees[1].velocities[0].z, 3.048, 1e-12);
}

TEST(Scenario, WhatIsNotFollowedIsSaid) {
  const Recording routed = recording_of(
      record("00:00:00>CRE A,B744,52,4,90,FL100,250\n00:00:00>CRE B,B744,52,5,90,FL100,250\n"
             "00:00:05>ADDWPT A,52.5,4.5\n00:00:06>B HDG 120\n00:00:07>ALT B,FL200\n"));
  EXPECT_TRUE(has_note(routed,
                       "2 aircraft are told how to fly from there, the first by ADDWPT in "
                       "line 3; that is not followed, so no velocity is known"));
  EXPECT_TRUE(std::isnan(routed.bees.at(0).velocities.at(0).x));
  EXPECT_TRUE(std::isnan(routed.bees.at(1).velocities.at(0).x));
  EXPECT_TRUE(has_note(routed, "replay its log as a table"));
  const Recording windy =
      recording_of(record("00:00:00>WIND 0,0,,180,25\n00:00:00>CRE A,B744,52,4,90,FL100,250\n"));
  EXPECT_TRUE(std::isnan(windy.bees.at(0).velocities.at(0).x));
  EXPECT_TRUE(has_note(windy,
                       "how fast 1 aircraft is over ground is not known: there is a command "
                       "WIND"));
  const Recording deleted =
      recording_of(record("00:00:00>CRE A,B744,52,4,90,FL100,250\n00:01:00>DEL A\n00:02:00>CRE "
                          "A,B744,1,2,90,FL100,250\n"
                          "00:03:00>DEL ALL\n"));
  EXPECT_EQ(ids_of(deleted), std::vector<std::string>{"A"});
  EXPECT_TRUE(has_note(deleted, "deleted later, and taken as if not"));
}

constexpr std::string_view kOne = "00:00:00>CRE A,B744,52,4,90,FL100,250\n";

// The wind that blew when it was created is not taken back by its end.
TEST(Scenario, WindThatEndsHasBlown) {
  const Recording recording = recording_of(
      record("00:00:00>WIND 0,0,,180,25\n" + std::string(kOne) + "00:00:10>DEL WIND\n"));
  EXPECT_TRUE(std::isnan(recording.bees.at(0).velocities.at(0).x));
  EXPECT_TRUE(has_note(recording, "there is a command WIND"));
}

TEST(Scenario, CommandsHaveSeveralNames) {
  const Recording recording =
      recording_of(record("00:00:00>CREATE A,B744,52,4,90,FL100,250\n00:00:10>DELETE A\n"
                          "00:00:20>create A,B744,1,2,90,FL100,250\n"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"A"});
  EXPECT_EQ(recording.bees[0].fixes.at(0).position, (Point{2, 1, 3048.0}));
  EXPECT_EQ(recording.missing.count, 0u);
}

TEST(Scenario, AircraftMayStandBeforeTheCommand) {
  const Recording moved = recording_of(record(std::string(kOne) + "00:00:20>A MOVE 53 5\n"));
  EXPECT_EQ(moved.bees.at(0).fixes, (std::vector<Fix>{{20.0, {5, 53, 3048.0}}}));
  EXPECT_FALSE(std::isnan(moved.bees[0].velocities.at(0).x));
  const Recording deleted = recording_of(record(std::string(kOne) + "00:00:20>A DEL\n"));
  EXPECT_TRUE(has_note(deleted, "1 aircraft is deleted later"));
  const Recording asked = recording_of(record(std::string(kOne) + "00:00:20>A;A POS\n"));
  EXPECT_FALSE(has_note(asked, "that is not followed"));
  EXPECT_FALSE(std::isnan(asked.bees.at(0).velocities.at(0).x));
}

TEST(Scenario, AllMayBeToldToManoeuvre) {
  for (const char* const command : {"HDG ALL 90", "SPD * 250", "ALL ALT FL200"}) {
    const Recording recording =
        recording_of(record(std::string(kOne) + "00:00:01>" + command + "\n"));
    EXPECT_TRUE(std::isnan(recording.bees.at(0).velocities.at(0).x)) << command;
    EXPECT_EQ(recording.missing.count, 0u) << command;
  }
}

// What is not known may create or move one.
TEST(Scenario, UnknownCommandsAreMissing) {
  const Recording recording =
      recording_of(record(std::string(kOne) + "00:00:00>SPAWN B,B744,52,4\n00:00:00>HDG B 90\n"));
  EXPECT_EQ(recording.missing.count, 2u);
  EXPECT_TRUE(has_note(recording, "2 records of commands that are not known here, or are for"));
  EXPECT_FALSE(std::isnan(recording.bees.at(0).velocities.at(0).x));
  const Recording harmless = recording_of(record(
      std::string(kOne) +
      "00:00:00>ASAS ON;RESO MVP;ZONER 5;DT 0.1;FF 60;OP;HOLD;PAN A;ZOOM 2;SCEN x;ECHO hello\n"));
  EXPECT_EQ(harmless.missing.count, 0u);
}

// Aircraft that are not known are never passed over.
TEST(Scenario, OtherWaysToCreateAircraftAreMissing) {
  const Recording recording = recording_of(
      record("00:00:00>CRE A,B744,52,4,90,FL100,250\n00:00:00>MCRE 10\n00:00:00>CALL other\n"));
  EXPECT_EQ(recording.missing.count, 2u);
  EXPECT_TRUE(has_note(recording, "2 records of commands that create aircraft in other ways"));
  const auto none = record("00:00:00>SYN SUPER 8\n");
  ASSERT_FALSE(none.has_value());
  EXPECT_NE(
      to_string(none.error()).find("no bee is left: 1 record of commands that create aircraft"),
      std::string::npos)
      << to_string(none.error());
}

void expect_bad(const std::string& line, std::string_view part) {
  const std::string good = "00:00:00>CRE A,B744,52,4,90,FL100,250\n";
  const auto loaded = record(good + line + "\n");
  ASSERT_FALSE(loaded.has_value()) << line;
  EXPECT_NE(to_string(loaded.error()).find("bees.csv:2"), std::string::npos)
      << to_string(loaded.error());
  EXPECT_NE(to_string(loaded.error()).find(part), std::string::npos) << to_string(loaded.error());
  const Recording skipped = recording_of(record(good + line + "\n", skipping_bad()));
  EXPECT_EQ(skipped.missing.count, 1u) << line;
}

TEST(Scenario, WhatIsBrokenSaysWhere) {
  expect_bad("00:00:00>CRE B,B744,EHAM,90,FL100,250",
             "'EHAM' is no latitude in degrees; places "
             "that BlueSky's navigation data name");
  expect_bad("00:00:00>CRE B,B744,52,4,,FL100,250", "is no heading in degrees from true north");
  expect_bad("00:00:00>CRE B,B744,52,4,90M,FL100,250", "'90M' is no heading");
  expect_bad("00:00:00>CRE B,B744,52,4,90,HIGH,250", "'HIGH' is no altitude");
  expect_bad("00:00:00>CRE B,B744,52,4,90,FL100", "is no calibrated speed or Mach number");
  expect_bad("00:00:00>CRE B,B744,152,4,90,FL100,250", "latitude 152 is beyond 90 degrees");
  expect_bad("00:00:00>CRE B", "CRE needs an id");
  expect_bad("00:00:00>CRE A,B744,52,4,90,FL100,250", "there is an aircraft of that id already");
  expect_bad("00:00:00>MOVE B,52,4", "MOVE of an aircraft that CRE has not created");
  expect_bad("00:00:00>MOVE A,52,4,1000,0,250,up", "'UP' is no climb rate");
  expect_bad("CRE B,B744,52,4,90,FL100,250", "has no time before it");
  RecordingOptions options;
  options.frame = Frame::kMetres;
  EXPECT_FALSE(record("00:00:00>CRE A,B744,52,4,90,FL100,250\n", options).has_value());
}

}  // namespace
}  // namespace beespace::io
