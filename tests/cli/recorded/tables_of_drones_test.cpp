// Tables that drones have logged: what their columns say of the ground, and what is too close.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two on pads 1 m beside each other climb straight up from 5 s on, and meet at a height of 20 m
// from 30 s to 40 s, 0.5 m from each other; before and after that, above the pads, they are 4 m
// apart. `more` is what a record says of its height above the pads.
template <class More>
std::string table(const std::string& header, int from_s, const More& more,
                  const std::string& id = "drone_id") {
  constexpr double kMetre_deg = 1.0 / 111'320.0;
  std::string text = "timestamp," + id + ",lat,lon,alt_amsl" + header + "\n";
  for (int second = from_s; second <= 59; ++second) {
    const double up_m = second < 5    ? 0.0
                        : second > 55 ? 0.0
                                      : std::min({20.0, second - 5.0, 55.0 - second});
    for (int bee = 1; bee <= 2; ++bee) {
      const double apart_m = second >= 30 && second <= 40 ? 0.5 : up_m > 2.0 ? 4.0 : 1.0;
      std::array<char, 120> line = {};
      std::snprintf(line.data(), line.size(), "2025-11-27T19:00:%02dZ,%d,0,%.9f,%.2f", second, bee,
                    (bee - 1) * apart_m * kMetre_deg, 102.5 + up_m);
      text += line.data() + more(up_m) + "\n";
    }
  }
  return text;
}

std::string nothing(double) {
  return {};
}
std::string above(double up_m) {
  return "," + std::to_string(up_m);
}
std::string armed(double up_m) {
  return up_m > 0.0 ? ",1" : ",0";
}
std::string landed_state(double up_m) {
  return up_m > 0.0 ? ",2" : ",1";
}
std::string stuck(double) {
  return ",0";
}

TEST(TablesOfDrones, SayWhoIsLowAboveWhereItTookOff) {
  const std::vector<std::string> leave_out = {"replay", "--threshold", "2", "--ignore-below", "3"};
  const std::vector<std::string> tables = {table(",alt_rel", 0, above), table(",armed", 0, armed),
                                           table(",landed_state", 0, landed_state)};
  for (const std::string& text : tables) {
    const Finished finished = run(leave_out, text);
    expect_parts(finished.err,
                 {"from which height each took off is read from column 6",
                  "left out   2 conflicts of two lower than 3 m above where they took "
                  "off"});
    EXPECT_EQ(finished.err.find("it is not known where"), std::string::npos) << finished.err;
    // The one in the air stays.
    expect_parts(finished.out, {"1\t2\t2025-11-27T19:00:29.571Z\t"});
  }
}

// Neighbours that stand on their pads are no surprise: what leaves them out is told without asking.
TEST(TablesOfDrones, OfferToLeaveOutThoseOnTheirPads) {
  TemporaryFolder folder;
  const std::string offer = "--ignore-below 3 leaves out 2 conflicts of two that are both lower";
  const std::string file = folder.file("log.csv", table(",alt_rel", 0, above));
  expect_parts(run({"replay", file, "--threshold", "3"}).err, {offer});
  expect_parts(run({"plot", file, "--threshold", "3", "-o", folder.path("log.svg")}).err, {offer});
  // Where it is not known where they took off it would not help.
  EXPECT_EQ(run({"replay", "--threshold", "3"}, table("", 0, nothing)).err.find("--ignore-below"),
            std::string::npos);
}

// One computer of two has its clock in another time zone.
TEST(TablesOfDrones, AnHourApartAreNoAllClear) {
  TemporaryFolder folder;
  const auto dated = [](const char* hour, double lat) {
    std::string text = "Timestamp,altitudeRelative,altitudeAMSL,gps.lat,gps.lon\n";
    for (int second = 0; second <= 59; ++second) {
      std::array<char, 120> line = {};
      const double up_m = std::min({20.0, 2.0 * second, 2.0 * (59 - second)});
      std::snprintf(line.data(), line.size(), "2026-11-27 %s:00:%02d.000,%.2f,%.2f,%.7f,19.04\n",
                    hour, second, up_m, 100.0 + up_m, lat);
      text += line.data();
    }
    return text;
  };
  const Arguments files = {folder.file("v1.csv", dated("20", 47.0)),
                           folder.file("v2.csv", dated("20", 47.001)),
                           folder.file("v3.csv", dated("19", 47.001))};
  const std::string why =
      "v3 is recorded while no other is: compared with none; its times begin about 1 h before "
      "those "
      "of the others: was the clock in another time zone?";
  for (const Arguments& asked :
       {Arguments{"replay", "--threshold", "2", "--units", "metric", "--fail-on-risk"},
        Arguments{"verify", "--threshold", "2", "--units", "metric"},
        Arguments{"plot", "--threshold", "2", "--units", "metric", "--fail-on-risk", "-o",
                  folder.path("log.svg")},
        Arguments{"report", "--threshold", "2", "--units", "metric", "--fail-on-risk", "-o",
                  folder.path("log.html")}}) {
    const Finished finished = run(asked + files);
    EXPECT_EQ(finished.exit_code, 1) << asked.front() << finished.err;
    expect_parts(finished.err, {why, "v3 flies while no other is known"});
  }
  expect_parts(folder.read("log.svg"), {"v3 flies while no other is known"});
  expect_parts(folder.read("log.html"), {"compared with none"});
}

// In metres they would climb at 200 m/s.
TEST(TablesOfDrones, InCentimetresWithoutAWordAreAskedAbout) {
  std::string text = "Drone,time_s,X,Y,Z\n";
  for (int second = 0; second <= 59; ++second) {
    for (int bee = 1; bee <= 2; ++bee) {
      text += std::to_string(bee) + "," + std::to_string(second) + "," +
              std::to_string(150 * bee + 60 * second) + ".5,0.0," +
              std::to_string(std::min({2000, 200 * second, 200 * (59 - second)})) + ".0\n";
    }
  }
  const Finished asked = run({"replay", "--threshold", "2"}, text);
  EXPECT_NE(asked.exit_code, 0);
  expect_parts(asked.err, {"are x, y, z in metres?", "--units position=cm"});
  const Finished said = run({"replay", "--threshold", "2", "--units", "position=cm"}, text);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  expect_parts(said.err, {"1.500 m apart"});
}

TEST(TablesOfDrones, OfWhichANumberIsMissingSaySo) {
  std::string text = "drone_id,time_s,x_m,y_m,z_m\n";
  for (const int bee : {1, 2, 4, 5}) {
    for (int second = 0; second <= 9; ++second) {
      text += std::to_string(bee) + "," + std::to_string(second) + "," + std::to_string(10 * bee) +
              ",0," + std::to_string(second) + "\n";
    }
  }
  expect_parts(
      run({"replay", "--threshold", "2"}, text).err,
      {"drones are numbered from 1 to 5 without 3: if one was left out, nothing is known"});
}

TEST(TablesOfDrones, ThatDoNotSaySoNameTheColumnThatWould) {
  const std::vector<std::string> leave_out = {"replay", "--threshold", "2", "--ignore-below", "3"};
  const Finished none = run(leave_out, table("", 0, nothing));
  expect_parts(none.err, {"left out   0 conflicts", "of 2 bees it is not known where they took off",
                          "a table tells it in a column of heights above the place of take-off, as "
                          "'alt_rel', or of whether each is 'armed'"});
  // Columns that are stuck say nothing: who flies is not on the ground.
  for (const char* column : {",alt_rel", ",armed"}) {
    expect_parts(run(leave_out, table(column, 0, stuck)).err, {"left out   0 conflicts"});
  }
}

TEST(TablesOfDrones, HaveOneDefaultInAllCommands) {
  TemporaryFolder folder;
  const std::string words = "threshold  5 m (closer than), the default of logs of drones";
  for (const auto& [header, id] : {std::pair{std::string(), std::string("drone_id")},
                                   std::pair{std::string(",alt_rel"), std::string("id")}}) {
    const std::string file =
        folder.file("log.csv", table(header, 0, header.empty() ? nothing : above, id));
    expect_parts(run({"replay", file}).err, {words});
    expect_parts(run({"verify", file}).err, {words});
    expect_parts(run({"plot", file, "-o", folder.path("log.svg")}).err, {words});
  }
}

TEST(TablesOfDrones, BegunInTheAirSaySo) {
  const std::string note =
      "2 drones are in the air when the recording begins: what was before is not known\n";
  for (const char* command : {"replay", "verify"}) {
    expect_parts(run({command, "--threshold", "0.2"}, table(",alt_rel", 20, above)).err, {note});
    EXPECT_EQ(run({command, "--threshold", "0.2"}, table(",alt_rel", 0, above)).err.find(note),
              std::string::npos);
  }
  const Finished json =
      run({"verify", "--threshold", "0.2", "--json", "--quiet"}, table(",alt_rel", 20, above));
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("begin_in_the_air": 2)"});
}

TEST(TablesOfDrones, ALimitOfHeightSaysFromWhereHeightsCountAndHowElse) {
  const std::string file_text = table(",alt_rel", 0, above);
  const Finished finished = run({"verify", "--threshold", "0.2", "--max-height", "120"}, file_text);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"these heights count above mean sea level, and limits of law are mostly above the "
                "ground; the worst is 20.0 m above where 1 took off",
                "add --columns lon=4,lat=3,height=6 --crs wgs84\n"});
  const Finished relative = run({"verify", "--threshold", "0.2", "--max-height", "120", "--columns",
                                 "lon=4,lat=3,height=6", "--crs", "wgs84"},
                                file_text);
  expect_parts(relative.err, {"breaches   none\n"});
}

}  // namespace
}  // namespace beespace::cli_test
