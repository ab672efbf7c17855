// Units of files and of options: 1,000 ft are 1,000 ft, and nothing is read as metres in silence.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kAsked =
    "icao24,lat,lon,altitude,groundspeed,vertical_rate\na,48,2,35000,450,0\nb,48,2,36000,450,0\n";

// Two of each flight level, exactly 1,000 ft apart, each pair by itself.
std::vector<std::string> flight_levels() {
  std::vector<std::string> rows;
  for (int level = 10; level <= 490; level += 10) {
    for (const int height : {100 * level, 100 * level + 1000}) {
      rows.push_back(std::to_string(rows.size()) + ",48," + std::to_string(level / 10) + "," +
                     std::to_string(height));
    }
  }
  return rows;
}

std::string table(std::string_view header, std::string_view behind = "") {
  std::string text(header);
  for (const std::string& row : flight_levels()) text.append("\n").append(row).append(behind);
  return text + "\n";
}

std::string aircraft_json() {
  std::string text = R"({"now": 100, "aircraft": [)";
  for (const std::string& row : flight_levels()) {
    const std::size_t lat = row.find(',');
    const std::size_t lon = row.find(',', lat + 1);
    const std::size_t height = row.rfind(',');
    if (text.back() == '}') text += ",";
    text += R"({"hex": "h)" + row.substr(0, lat) + R"(", "lat": 48, "lon": )" +
            row.substr(lon + 1, height - lon - 1) + R"(, "seen_pos": 0, "gs": 0, "track": 0,)" +
            R"("geom_rate": 0, "alt_geom": )" + row.substr(height + 1) + "}";
  }
  return text + "]}";
}

std::size_t lines_of(const std::string& text) {
  std::size_t lines = 0;
  for (const char c : text) lines += c == '\n' ? 1 : 0;
  return lines;
}

// Of a table that begins with its header.
std::size_t rows_of(const std::string& table) {
  EXPECT_EQ(table.rfind("first\tsecond\t", 0), 0U) << table.substr(0, 40);
  return lines_of(table) - 1;
}

constexpr std::size_t kLevels = 49;

TEST(Units, EveryDoorAsksForTheUnitOfHeightsOfAircraft) {
  for (const char* command : {"detect", "predict", "replay", "watch", "plot", "report", "export"}) {
    std::string text = std::string(kAsked);
    const bool timed =
        std::string_view(command) == "replay" || std::string_view(command) == "watch";
    if (timed) text = "time_s,icao24,lat,lon,altitude\n0,a,48,2,35000\n0,b,48,2,36000\n";
    if (std::string_view(command) == "predict") {
      text = "icao24,lat,lon,altitude,ve,vn,vu\na,48,2,35000,1,1,1\n";
    }
    Arguments arguments = {command};
    if (std::string_view(command) == "export") arguments = {command, "--format", "csv"};
    const Finished finished = run(arguments, text);
    EXPECT_EQ(finished.exit_code, 2) << command << finished.err;
    expect_parts(finished.err, {"but in which unit?", "--units height=ft"});
    EXPECT_EQ(finished.out, "") << command;
  }
}

TEST(Units, TheSummaryAndTheDocumentSayWhichUnitWasTakenAndWhy) {
  const Finished finished =
      run({"detect", "--threshold", "100m", "--units", "height=ft", "--json"}, kAsked);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(
      finished.out,
      {R"("units": [{"of": "heights", "unit": "ft", "reason": "asked for with --units"}])"});
  expect_parts(finished.err, {"units      heights in ft: asked for with --units\n"});
  expect_parts(run({"detect", "--threshold", "100m"}, "lat,lon,alt_ft\n48,2,1\n").err,
               {"heights in ft: the header names it: 'alt_ft'"});
  expect_parts(run({"detect"}, "x,y,z\n48,200,1\n4800,2,1\n").err,
               {"x, y and z in m: no unit is named, and nothing speaks of aviation"});
  const Finished replayed =
      run({"replay", "--threshold", "100", "--json"}, "id,time_s,lat,lon,alt_ft\na,0,48,2,1\n");
  EXPECT_TRUE(is_json(replayed.out)) << replayed.out;
  expect_parts(replayed.out, {R"("units": [{"of": "heights", "unit": "ft", )"});
  const Finished watched =
      run({"watch", "--threshold", "100m"}, "id,time_s,lat,lon,alt_ft\na,0,48,2,1\n");
  expect_parts(watched.err, {"heights in ft: the header names it: 'alt_ft'"});
}

// The suggestion is the same threshold in the unit of the heights.
TEST(Units, TheSuggestedThresholdIsTheOneThatWasGiven) {
  const std::string levels = "id,lat,lon,altitude [FL]\na,48,2,310\nb,48,2,320\n";
  expect_parts(run({"detect", "--threshold", "5NM", "--vertical", "304.8"}, levels).err,
               {"(--vertical 10FL)"});
  expect_parts(
      run({"detect", "--threshold", "100m", "--vertical", "304.8"}, "id,lat,lon,alt_ft\na,48,2,1\n")
          .err,
      {"(--vertical 1000ft)"});
}

// 16 of 39 flight levels were in conflict at 304.8 m.
TEST(Units, AThousandFeetAreExactInSnapshots) {
  const Arguments question = {"detect", "--threshold", "0.3km", "--vertical",
                              "1000ft", "--report",    "pairs", "--quiet"};
  for (const std::string& text : {table("id,lat,lon,alt_ft"), table("id,y,x,z_ft")}) {
    const Arguments frame =
        text.find("z_ft") == std::string::npos ? Arguments{} : Arguments{"--units", "position=km"};
    const std::string read = text;
    EXPECT_EQ(rows_of(run(question + frame, read).out), 0U) << read.substr(0, 20);
    EXPECT_EQ(rows_of(run(question + frame + Arguments{"--inclusive"}, read).out), kLevels);
  }
  Arguments closer = question;
  closer[4] = "1000.5ft";
  EXPECT_EQ(rows_of(run(closer, table("id,lat,lon,alt_ft")).out), kLevels);
  expect_parts(
      run({"detect", "--threshold", "100m", "--vertical", "1000ft"}, table("id,lat,lon,alt_ft"))
          .err,
      {"vertical   1000 ft, compared with heights in ft as they stand\n"});
  expect_parts(
      run({"detect", "--threshold", "100m", "--vertical", "304.8"}, table("id,lat,lon,alt_ft")).err,
      {"compared in metres, to which heights in ft are rounded"});
}

// A hundred feet are a flight level: the one is as exact as the other.
TEST(Units, AThousandFeetAreExactBetweenFlightLevels) {
  std::string levels = "id,lat,lon,altitude [FL],time_s";
  for (const int time_s : {0, 4}) {
    for (int level = 10; level <= 490; level += 10) {
      for (const int height : {level, level + 10}) {
        levels += "\n" + std::to_string(level) + "-" + std::to_string(height) + ",48," +
                  std::to_string(level / 10) + "," + std::to_string(height) + "," +
                  std::to_string(time_s);
      }
    }
  }
  const auto conflicts = [&](const std::string& command, const std::string& vertical) {
    return rows_of(
        run({command, "--threshold", "5NM", "--vertical", vertical, "--quiet"}, levels + "\n").out);
  };
  EXPECT_EQ(conflicts("replay", "1000ft"), 0U);
  EXPECT_EQ(conflicts("replay", "10FL"), 0U);
  EXPECT_EQ(conflicts("replay", "1000.5ft"), kLevels);
  EXPECT_EQ(
      run({"watch", "--threshold", "5NM", "--vertical", "1000ft", "--max-age", "60"}, levels).out,
      "");
  const std::string now = "id,lat,lon,altitude [FL]\na,48,2,310\nb,48,2,320\n";
  EXPECT_EQ(run({"detect", "--threshold", "5NM", "--vertical", "1000ft"}, now).out, "");
  expect_parts(run({"detect", "--threshold", "5NM", "--vertical", "1000ft"}, now).err,
               {"vertical   1000 ft, compared with heights in FL as they stand\n"});
  const std::string feet = "id,lat,lon,alt_ft\na,48,2,31000\nb,48,2,32000\n";
  EXPECT_EQ(run({"detect", "--threshold", "5NM", "--vertical", "10FL"}, feet).out, "");
}

TEST(Units, AThousandFeetAreExactWhenPredictedReplayedAndWatched) {
  const TemporaryFolder folder;
  const std::string json = folder.file("aircraft.json", aircraft_json());
  std::string recorded = table("id,lat,lon,alt_ft,time_s", ",0");
  const std::string later = table("", ",4");
  recorded += later.substr(1);
  const std::string moving = table("id,lat,lon,alt_ft,ve,vn,vu", ",1,1,0");
  const Arguments apart = {"--threshold", "5NM", "--vertical", "1000ft", "--quiet"};
  const Arguments inclusive = {"--inclusive"};
  // Those of aircraft are by satellites.
  for (const Arguments& predict :
       {Arguments{"predict", json, "--heights", "geometric"}, Arguments{"predict", "-"}}) {
    EXPECT_EQ(rows_of(run(predict + apart, moving).out), 0U);
    EXPECT_EQ(rows_of(run(predict + apart + inclusive, moving).out), kLevels);
  }
  const Arguments replay = {"replay", "-"};
  EXPECT_EQ(rows_of(run(replay + apart, recorded).out), 0U);
  EXPECT_EQ(rows_of(run(replay + apart + inclusive, recorded).out), kLevels);
  EXPECT_EQ(run(Arguments{"replay", "-", "--report", "events"} + apart, recorded).out, "");
  const Arguments watch = {"watch", "--max-age", "60"};
  EXPECT_EQ(run(watch + apart, recorded).out, "");
  Arguments closer = apart;
  closer[3] = "1000.5ft";
  const std::string events = run(watch + closer, recorded).out;
  EXPECT_GE(lines_of(events), kLevels);
  // 304.8 m apart: reported in metres.
  expect_parts(events, {R"("distance_m": 304.8)"});
  expect_parts(run(Arguments{"replay", "-", "--csv"} + closer, recorded).out, {",304.8"});
}

// As OpenSky writes them: multiples of 7.62 m. By fractions of two 8 of 12 were in conflict.
TEST(Units, AThousandFeetAreExactOfHeightsInMetres) {
  const auto in_metres = [](const std::string& feet_table) {
    std::istringstream lines(feet_table);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> fields;
      std::istringstream record(line);
      for (std::string field; std::getline(record, field, ',');) fields.push_back(field);
      if (fields[3] == "alt_ft") {
        fields[3] = "alt_m";
      } else {
        const int centimetres = std::stoi(fields[3]) * 3048 / 100;
        const std::string hundredths = std::to_string(centimetres % 100);
        fields[3] =
            std::to_string(centimetres / 100) + (hundredths.size() < 2 ? ".0" : ".") + hundredths;
      }
      for (std::size_t i = 0; i < fields.size(); ++i) text += (i == 0 ? "" : ",") + fields[i];
      text += '\n';
    }
    return text;
  };
  const TemporaryFolder folder;
  const std::string snapshot = folder.file("now.csv", in_metres(table("id,lat,lon,alt_ft")));
  std::string recorded = table("id,lat,lon,alt_ft,time_s", ",0");
  recorded += table("", ",4").substr(1);
  recorded = folder.file("recorded.csv", in_metres(recorded));
  const std::string moving =
      folder.file("moving.csv", in_metres(table("id,lat,lon,alt_ft,ve,vn,vu", ",1,1,0")));
  const Arguments apart = {"--threshold", "5NM", "--vertical", "1000ft", "--quiet"};
  Arguments closer = apart;
  closer[3] = "1000.5ft";
  const Arguments memory = {"--memory", "64MB"};
  for (const Arguments& command :
       {Arguments{"detect", snapshot, "--report", "pairs"},
        Arguments{"detect", snapshot, "--report", "pairs"} + memory, Arguments{"predict", moving},
        Arguments{"replay", recorded}, Arguments{"replay", recorded} + memory}) {
    EXPECT_EQ(rows_of(run(command + apart).out), 0U) << command[0];
    EXPECT_EQ(rows_of(run(command + apart + Arguments{"--inclusive"}).out), kLevels) << command[0];
    EXPECT_EQ(rows_of(run(command + closer).out), kLevels) << command[0];
  }
  const Arguments watch = {"watch", "--max-age", "60"};
  EXPECT_EQ(run(watch + apart, folder.read("recorded.csv")).out, "");
  const std::string events = run(watch + closer, folder.read("recorded.csv")).out;
  EXPECT_GE(lines_of(events), kLevels);
  expect_parts(events, {R"("distance_m": 304.8)"});
  expect_parts(run({"detect", snapshot, "--threshold", "5NM", "--vertical", "1000ft"}).err,
               {"vertical   1000 ft, compared with heights in metres as 304.8 m\n"});
  expect_parts(
      run({"replay", recorded, "--threshold", "5NM", "--vertical", "1000ft", "--json"}).out,
      {R"("compared_in": "cm")"});
}

TEST(Units, ThresholdsOfEverySubcommandTakeThem) {
  const std::string three = "id,x,y,z\na,0,0,0\nb,9259,0,0\nc,99999,0,0\n";
  EXPECT_EQ(run({"detect", "--threshold", "5NM"}, three).out, "a\nb\n");
  EXPECT_EQ(run({"detect", "--threshold", "5 nmi"}, three).out, "a\nb\n");
  EXPECT_EQ(run({"detect", "--threshold", "9.26km"}, three).out, "a\nb\n");
  EXPECT_EQ(run({"detect", "--threshold", "9259"}, three).out, "");
  for (const Arguments& bad :
       {Arguments{"detect", "--threshold", "5furlongs"}, Arguments{"detect", "--threshold", "5M"},
        Arguments{"predict", "--threshold", "kt"}, Arguments{"watch", "--threshold", "5kt"}}) {
    const Finished finished = run(bad, three);
    EXPECT_EQ(finished.exit_code, 2) << finished.err;
    expect_parts(finished.err, {"is not a length", "5NM, 0.3km or 1000ft"});
  }
  const TemporaryFolder folder;
  const std::string recording =
      folder.file("two.csv", "id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\nb,0,300,0,0\nb,1,301,0,0\n");
  EXPECT_EQ(run({"verify", recording, "--threshold", "1000ft", "--quiet"}).exit_code, 1);
  EXPECT_EQ(run({"verify", recording, "--threshold", "300", "--quiet"}).exit_code, 1);
  EXPECT_EQ(run({"verify", recording, "--threshold", "900ft", "--quiet"}).exit_code, 0);
  EXPECT_EQ(
      run({"verify", recording, "--threshold", "1m", "--max-speed", "1kt", "--quiet"}).exit_code,
      1);
  EXPECT_EQ(
      run({"verify", recording, "--threshold", "1m", "--max-speed", "2kt", "--quiet"}).exit_code,
      0);
  const Arguments generate = {"generate", "--points", "3", "--seed", "2"};
  EXPECT_EQ(run(generate + Arguments{"--size", "1km"}).out,
            run(generate + Arguments{"--size", "1000"}).out);
  const Arguments simulate = {"simulate", "head-on", "--quiet", "--steps", "5", "--threshold"};
  EXPECT_EQ(run(simulate + Arguments{"0.005km"}).out, run(simulate + Arguments{"5"}).out);
}

TEST(Ids, AreKeptWhereColumnsAreNamed) {
  const std::string text = "id,east,north,up\nk,0,0,0\nl,3,0,0\nm,99999,0,0\n";
  EXPECT_EQ(run({"detect", "--columns", "x=2,y=3,z=4"}, text).out, "k\nl\n");
  EXPECT_EQ(run({"detect", "--columns", "x=2,y=3,z=4,id=4"}, text).out, "0\n0\n");
  EXPECT_EQ(run({"detect", "--columns", "x=1,y=2,z=3"}, "1,0,0,0\n").exit_code, 0);
  // A column that looks like an id may be named as a coordinate.
  EXPECT_EQ(run({"detect", "--columns", "x=1,y=2"}, "id,y\n0,0\n1,1\n").out, "0\n1\n");
  EXPECT_EQ(run({"detect"}, "drone,x,y,z\nk,0,0,0\nl,3,0,0\nm,99999,0,0\n").out, "k\nl\n");
}

TEST(Ids, ThatComeAgainAreCountedOrRefused) {
  const std::string text = "id,x,y,z\nk,0,0,0\nl,3,0,0\nk,99999,0,0\nk,999999,0,0\n";
  const Finished finished = run({"detect", "--json"}, text);
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err,
               {"2 records have the id of another one before: the first is 'k', of data rows 0 "
                "and 2\n"});
  expect_parts(finished.out,
               {R"("repeated_ids": 2)", R"("first_repeated": {"id": "k", "records": [0, 2]})"});
  const Finished refused = run({"detect", "--unique-ids"}, text);
  EXPECT_EQ(refused.exit_code, 3);
  expect_parts(refused.err, {"2 records have the id of another one before", "--unique-ids"});
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(run({"detect", "--unique-ids"}, "id,x,y\nk,0,0\nl,999999,0\n").exit_code, 0);
  expect_parts(run({"detect", "--json"}, "x,y\n0,0\n999999,0\n").out, {R"("repeated_ids": 0)"});
}

// Pixels, perhaps, of which none would come close: as replay asks.
TEST(UnitsOfPlaces, ThatAreFarForThatThresholdAreAskedAboutByDetect) {
  TemporaryFolder folder;
  const std::string places =
      folder.file("places.csv", "id,x,y\na,100,100\nb,112,100\nc,600,480\nd,900,0\n");
  for (const Arguments& more : {Arguments{}, Arguments{"--memory", "100MB"}}) {
    const Finished asked = run(Arguments{"detect", places, "--threshold", "2mm"} + more);
    EXPECT_EQ(asked.exit_code, 2) << asked.err;
    expect_parts(asked.err, {"are x and y in metres?",
                             "if they are pixels, make lengths of them "
                             "first, otherwise say --units position=mm, or position=m"});
    EXPECT_EQ(run(Arguments{"detect", places, "--threshold", "2mm", "--units", "position=m"} + more)
                  .exit_code,
              0);
    EXPECT_EQ(run(Arguments{"detect", places, "--threshold", "2m"} + more).exit_code, 0);
  }
  const std::string moving = "id,time_s,x,y\na,0,100,100\na,1,100,100\nb,0,900,480\nb,1,900,480\n";
  EXPECT_EQ(run({"replay", "--threshold", "2mm", "--memory", "100MB"}, moving).exit_code, 2);
}

}  // namespace
}  // namespace beespace::cli_test
