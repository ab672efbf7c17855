// What is said of input of the wrong kind: what was found, what is needed, and which command or
// option does it.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

using namespace std::string_view_literals;

const std::vector<std::string> kAllThatRead = {"detect", "predict", "replay", "verify",
                                               "advise", "export",  "report", "watch"};

Arguments ask(const std::string& command, const std::string& file) {
  if (command == "export") return {command, file, "--format", "csv"};
  if (command == "report") return {command, file, "-o", "/dev/null"};
  return {command, file};
}

class Messages : public testing::Test {
 protected:
  void expect_said(const std::vector<std::string>& commands, const std::string& name,
                   std::string_view content, const std::string& message) {
    const std::string file = folder_.file(name, content);
    for (const std::string& command : commands) {
      SCOPED_TRACE(command + " " + name);
      expect_failure(ask(command, file), {}, kBadInput, message);
    }
  }

  TemporaryFolder folder_;
};

std::string utf16(std::string_view text, bool big) {
  std::string wide;
  for (const char c : text) {
    if (big) wide += '\0';
    wide += c;
    if (!big) wide += '\0';
  }
  return wide;
}

TEST_F(Messages, Utf16WithoutAMarkIsKnown) {
  constexpr std::string_view kTable = "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\n";
  expect_said(kAllThatRead, "little.csv", utf16(kTable, false),
              "this is UTF-16 text without a mark that says so; save it as UTF-8 (iconv -f "
              "UTF-16LE -t UTF-8 " +
                  folder_.path("little.csv") + ")");
  expect_said(kAllThatRead, "big.csv", utf16(kTable, true),
              "iconv -f UTF-16BE -t UTF-8 " + folder_.path("big.csv"));
  // A single NUL proves nothing.
  expect_said({"detect"}, "one.csv", "x,y,z\n0,0,\0000\n"sv, "byte 10 is NUL");
}

TEST_F(Messages, OneColumnIsNotAnsweredWithAnEmptyExample) {
  const std::string needed =
      "needed are at least two columns of numbers, longitude and latitude or x and y, with commas, "
      "semicolons, tabs or blanks between them (the columns are 1 'name')";
  expect_said({"detect", "export"}, "one.csv", "name\nmaya\nwilli\n", needed);
}

TEST_F(Messages, NoColumnIsOfferedAsAHeightThatDoesNotSoundLikeOne) {
  constexpr std::string_view kTable = "id,visible,lat,lon\na,1,47,8\nb,0,47.1,8\n";
  expect_said({"detect"}, "visible.csv", kTable,
              "no column names the height, and 'visible' may or may not be it; say --columns "
              "lon=4,lat=3 if there is none, and add height=N for column N that holds it");
  const std::string file = folder_.path("visible.csv");
  EXPECT_EQ(run({"detect", file, "--columns", "lon=4,lat=3", "--quiet"}).exit_code, 0);
  // One that does is.
  expect_said({"detect"}, "rel.csv", "lat,lon,Rel Alt\n47,8,100\n47.1,8,90\n",
              "--columns lon=2,lat=1,height=3");
}

TEST_F(Messages, TheErrorOfATableWithoutTimesNamesWhatMayBeMissing) {
  constexpr std::string_view kTable = "id,x_m,y_m,z_m,vertical_rate\na,0,0,0,1\nb,1,0,0,1\n";
  for (const char* command : {"predict", "replay"}) {
    const Finished finished = run({command}, kTable);
    EXPECT_EQ(finished.exit_code, kBadInput);
    expect_parts(finished.err, {"neither a time nor a velocity", "--columns time=N", "vx=N,vy=N",
                                "ask 'beespace detect'"});
    EXPECT_EQ(finished.err.find("time=5"), std::string::npos) << finished.err;
  }
  // A column whose name sounds like it is offered.
  EXPECT_NE(run({"predict"}, "id,x,y,z,zeitpunkt\na,0,0,0,1\n").err.find("time=5"),
            std::string::npos);
}

TEST_F(Messages, TheErrorForJsonNamesTheCommandThatReadsIt) {
  const std::vector<std::string> readers = {"detect", "predict", "replay", "advise"};
  expect_said(readers, "city.json",
              R"({"obstacles": [{"kind": "sphere", "center": [0, 0, 50], "radius_m": 10}]})",
              "JSON with obstacles; give it with --obstacles to 'beespace simulate', 'advise' or "
              "'verify'");
  expect_said(readers, "map.geojson", R"({"type": "FeatureCollection", "features": []})",
              "GeoJSON, which beespace writes and does not read");
  const std::string aircraft =
      R"({"now": 1, "aircraft": [{"hex": "ab", "lat": 8, "lon": 47, "alt_geom": 100, "seen_pos": 0}]})";
  expect_said({"detect"}, "aircraft.json", aircraft, "ask 'beespace predict' about it");
  expect_said({"advise"}, "aircraft.json", aircraft,
              "JSON with aircraft (readsb, dump1090); 'beespace replay' and 'beespace predict' "
              "read it");
  expect_said({"detect"}, "cut.json", aircraft.substr(0, 40), "'beespace replay'");
  expect_said(readers, "list.json", "[1, 2, 3]", "JSON of a kind that beespace does not know");
}

TEST_F(Messages, AnArrayIsForDetect) {
  for (const char* command : {"predict", "replay", "verify", "advise"}) {
    expect_said({command}, "points.npy", "\x93NUMPY\x01\0",
                "this is a .npy array, which holds positions and nothing else; 'beespace detect' "
                "reads it");
  }
}

TEST_F(Messages, ATelemetryLogIsKnownHoweverShort) {
  // The time and the beginning of a frame.
  const std::string log("\0\x06\x0A\x24\x18\x1E\x40\0\xFE\x1C\x01\x01\x01\x21\x01\x02", 16);
  for (const char* command : {"detect", "replay", "predict", "advise"}) {
    expect_said({command}, "cut.tlog", log,
                "a MAVLink telemetry log (.tlog), which 'beespace replay' reads; where it finds no "
                "whole message in it, it is cut off or damaged");
  }
}

TEST_F(Messages, PackedDataThatIsCutOffIsKnownLive) {
  const Finished finished = run({"watch"}, "\x1F\x8B\x08\0\0\0\0\0\0\0\0\0\n"sv);
  EXPECT_EQ(finished.exit_code, kBadInput);
  expect_parts(finished.err, {"the gzip data ends too early"});
}

TEST_F(Messages, MissingFoldersAndFilesHaveTheSameError) {
  expect_failure({"watch", folder_.path("no.csv")}, {}, 4,
                 "there is no such file; check the name and the folder");
  expect_failure({"watch", folder_.path("")}, {}, 4, "this is a directory; name a file in it");
}

TEST_F(Messages, AnExistingFolderIsNotReportedAsMissing) {
  const Finished finished = run({"detect", "-o", "/proc/beespace"}, "id,x,y,z\na,0,0,0\nb,1,0,0\n");
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_EQ(finished.err.find("create it first"), std::string::npos) << finished.err;
  expect_parts(finished.err, {"/proc/beespace: cannot write"});
  expect_failure({"detect", "-o", folder_.path("no/out.txt")}, "id,x,y,z\na,0,0,0\n", 4,
                 "the folder does not exist; create it first");
  const std::string file = folder_.file("file", "");
  expect_failure({"detect", "-o", file + "/out.txt"}, "id,x,y,z\na,0,0,0\n", 4,
                 "a part of this path is a file, not a folder");
}

TEST_F(Messages, AThresholdBelowZeroIsNotAnsweredWithTheEndsOfTheDomain) {
  for (const char* command : {"detect", "replay", "predict", "verify", "watch"}) {
    const Finished finished = run({command, "--threshold", "-5"}, "x,y,z\n0,0,0\n");
    EXPECT_EQ(finished.exit_code, 2);
    expect_parts(finished.err, {"the threshold is -5 m; give a finite distance above zero, in "
                                "metres, for example --threshold 100"});
    EXPECT_EQ(finished.err.find("e+"), std::string::npos) << finished.err;
  }
}

}  // namespace
}  // namespace beespace::cli_test
