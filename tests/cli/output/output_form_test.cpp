// The ending of the output's name decides the form of the answer, in every subcommand alike.
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kDegrees = "id,lon,lat,height\na,8,47,100\nb,8,47,110\nc,9,47,100\n";
constexpr std::string_view kFlown =
    "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,30,0,0\nb,9,30,0,0\n";
constexpr std::string_view kMission =
    "id,x,y,z,vx,vy,vz,goal_x,goal_y,goal_z\na,0,0,0,0,0,0,9,0,0\nb,30,0,0,0,0,0,30,9,0\n";

std::string unpacked(const std::string& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) return "cannot open";
  EXPECT_EQ(gzdirect(file), 0) << path << " is not compressed";
  std::string text;
  std::array<char, 4096> room{};
  for (int count = 0; (count = gzread(file, room.data(), room.size())) > 0;) {
    text.append(room.data(), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(gzclose(file), Z_OK);
  return text;
}

class OutputForm : public testing::Test {
 protected:
  // The content of a file of this name afterwards.
  std::string written(const Arguments& arguments, const std::string& name) {
    const Finished finished = run(arguments + Arguments{"--quiet", "-o", folder_.path(name)});
    EXPECT_EQ(finished.exit_code, 0) << name << ": " << finished.err;
    EXPECT_EQ(finished.out, "");
    if (!std::string_view(name).ends_with(".gz")) return folder_.read(name);
    return unpacked(folder_.path(name));
  }

  // The file of this name holds what the options (or none) write to standard output.
  void expect_same(const Arguments& arguments, const std::string& name, const Arguments& options) {
    SCOPED_TRACE(arguments.front() + " -o " + name);
    const std::string in_file = written(arguments, name);
    const std::string printed = run(arguments + options + Arguments{"--quiet"}).out;
    EXPECT_NE(printed, "");
    // In JSON only the measured times differ.
    EXPECT_EQ(in_file.substr(0, in_file.find("\"timings\"")),
              printed.substr(0, printed.find("\"timings\"")));
  }

  // With --json the error is written to standard output too.
  static void expect_json_refused(const Arguments& arguments, const std::string& message) {
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    expect_parts(finished.err, {message});
    EXPECT_TRUE(is_json(finished.out)) << finished.out;
  }

  TemporaryFolder folder_;
  std::string degrees_ = folder_.file("degrees.csv", kDegrees);
  std::string flown_ = folder_.file("flown.csv", kFlown);
  std::string mission_ = folder_.file("mission.csv", kMission);
};

TEST_F(OutputForm, OfDetectIsThatOfTheEnding) {
  const Arguments pairs = {"detect", degrees_, "--report", "pairs"};
  for (const Arguments& ask : {pairs, Arguments{"detect", degrees_}}) {
    for (const char* name : {"x.json", "x.JSON", "x.json.gz"}) expect_same(ask, name, {"--json"});
    for (const char* name : {"x.csv", "x.csv.gz", "X.CSV.GZ"}) {
      if (std::string_view(name) != "X.CSV.GZ") expect_same(ask, name, {"--csv"});
    }
    for (const char* name : {"x.geojson", "x.geojson.gz"}) expect_same(ask, name, {"--geojson"});
    for (const char* name : {"x", "x.txt", "x.tsv", "x.gz", "x.txt.gz"}) expect_same(ask, name, {});
  }
}

TEST_F(OutputForm, OfRecordingsIsThatOfTheEnding) {
  const Arguments replay = {"replay", flown_};
  for (const Arguments& ask :
       {replay, Arguments{"predict", flown_}, Arguments{"verify", flown_},
        replay + Arguments{"--report", "bees"}, replay + Arguments{"--report", "separation"}}) {
    for (const char* name : {"x.json", "x.json.gz"}) expect_same(ask, name, {"--json"});
    for (const char* name : {"x.csv", "x.csv.gz"}) expect_same(ask, name, {"--csv"});
    for (const char* name : {"x", "x.txt", "x.tsv", "x.tsv.gz"}) expect_same(ask, name, {});
  }
  const Arguments events = replay + Arguments{"--report", "events"};
  for (const char* name : {"x.jsonl", "x.ndjson.gz", "x.txt"}) expect_same(events, name, {});
  expect_same(events, "x.csv", {"--csv"});
}

TEST_F(OutputForm, OfAdviceIsThatOfTheEnding) {
  const Arguments advise = {"advise", mission_};
  for (const char* name : {"x", "x.txt", "x.csv", "x.csv.gz"}) expect_same(advise, name, {});
  for (const char* name : {"x.json", "x.json.gz"}) expect_same(advise, name, {"--json"});
}

TEST_F(OutputForm, OfMapsMayBeCompressed) {
  const Arguments ask = {"export", degrees_};
  expect_same(ask, "x.kml.gz", {"--format", "kml"});
  expect_same(ask, "x.csv.gz", {"--format", "csv"});
}

TEST_F(OutputForm, AnEndingThatIsNotWrittenIsAnError) {
  const std::vector<std::string> before = folder_.names();
  const auto refused = [&](const Arguments& arguments, const std::string& name,
                           const std::string& message) {
    SCOPED_TRACE(arguments.front() + " -o " + name);
    // Before the input is read: it is not there.
    expect_failure(arguments + Arguments{"-o", folder_.path(name)}, {}, 2, message);
    EXPECT_EQ(folder_.names(), before);
  };
  const std::string missing = folder_.path("missing.csv");
  refused({"detect", missing}, "x.parquet",
          "'beespace detect' writes no .parquet, as the name of '" + folder_.path("x.parquet") +
              "' says; let it end in .txt, .tsv, .csv, .json or .geojson, perhaps with .gz");
  refused({"detect", missing}, "x.kml", "'beespace export' writes .kml");
  refused({"detect", missing}, "x.npy.gz", "writes no .npy");
  refused({"replay", missing}, "x.geojson", "'beespace export' writes .geojson");
  refused({"replay", missing}, "x.svg", "'beespace plot' writes .svg");
  refused({"replay", missing}, "x.jsonl", "writes no .jsonl");
  refused({"replay", missing, "--report", "events"}, "x.tsv", "let it end in .txt, .jsonl");
  refused({"predict", missing}, "x.html", "'beespace report' writes .html");
  refused({"verify", missing}, "x.xlsx", "writes no .xlsx");
  refused({"advise", missing}, "x.tsv", "let it end in .txt, .csv or .json");
  refused({"simulate", missing}, "x.json", "tells no format of a recording");
  refused({"generate", "--points", "3"}, "x.json", "does not tell the format");
  refused({"plot", missing}, "x.svg.gz", "a picture's name ends in .svg or .png");
  refused({"report", missing}, "x.html.gz", "a page is HTML");
  refused({"report", missing}, "x.v2", "a page is HTML");
  refused({"export", missing}, "x.svg", "'beespace plot' writes .svg");
}

TEST_F(OutputForm, AnOptionMustNotContradictTheEnding) {
  const std::string missing = folder_.path("missing.csv");
  for (const char* command : {"detect", "replay", "predict", "verify"}) {
    expect_json_refused(
        {command, missing, "--json", "-o", "x.csv"},
        "--json contradicts the ending of 'x.csv'; leave the option out, or let the "
        "name end in .json");
    expect_usage_error({command, missing, "--csv", "-o", "x.json.gz"}, "--csv contradicts");
    expect_usage_error({command, missing, "--csv", "-o", "x.tsv"}, "--csv contradicts");
  }
  expect_usage_error({"detect", missing, "--geojson", "-o", "x.json"}, "--geojson contradicts");
  expect_json_refused({"advise", missing, "--json", "-o", "x.csv"}, "--json contradicts");
  expect_usage_error({"export", missing, "--format", "kml", "-o", "x.csv"},
                     "--format kml contradicts the ending of 'x.csv'");
}

// Any text may be called .txt, and what has no ending any form.
TEST_F(OutputForm, AnOptionDecidesWhereTheEndingDoesNot) {
  for (const char* name : {"x", "x.txt"}) {
    for (const char* option : {"--csv", "--json"}) {
      EXPECT_EQ(written({"replay", flown_, option}, name),
                run({"replay", flown_, option, "--quiet"}).out);
    }
  }
  EXPECT_EQ(run({"detect", degrees_, "--quiet", "-o", "/dev/stdout"}).out, "a\nb\n");
}

TEST_F(OutputForm, TablesHaveAHeaderAndListsOfIdsHaveNone) {
  const auto first_line = [&](const Arguments& arguments) {
    const std::string text = run(arguments + Arguments{"--quiet"}).out;
    return text.substr(0, text.find('\n'));
  };
  const auto detect = [&](const char* report) {
    return first_line({"detect", degrees_, "--report", report});
  };
  EXPECT_EQ(detect("at-risk"), "a");
  EXPECT_EQ(detect("pairs"), "first\tsecond\tdistance_m");
  EXPECT_EQ(detect("closest-pair"), "first\tsecond\tdistance_m");
  EXPECT_EQ(detect("neighbors"), "id\tneighbor_count\tneighbors");
  EXPECT_EQ(detect("counts"), "id\tneighbor_count");
  EXPECT_EQ(detect("nearest"), "id\tnearest\tdistance_m");
  EXPECT_EQ(detect("groups"), "group\tsize\tmembers");
  const std::string conflicts = "first\tsecond\tbegins_s\tclosest_s\tclosest_m\tends_s\tlasts_s";
  EXPECT_EQ(first_line({"replay", flown_}), conflicts);
  EXPECT_EQ(first_line({"predict", flown_}), conflicts);
  EXPECT_EQ(first_line({"replay", flown_, "--threshold", "1"}), conflicts);  // with no rows, too
  EXPECT_EQ(first_line({"replay", flown_, "--report", "bees"}),
            "id\tconflicts\tin_conflict_s\tclosest_m\tclosest_s\tclosest_id\tunknown_s");
  EXPECT_EQ(first_line({"replay", flown_, "--report", "separation"}),
            "time_s\tdistance_m\tfirst\tsecond\tunknown");
  EXPECT_EQ(first_line({"verify", flown_}), "finding\tfirst\tsecond\tbegins_s\tends_s\tvalue");
  EXPECT_EQ(first_line({"advise", mission_}), "id,vx,vy,vz,advice,certified");
}

}  // namespace
}  // namespace beespace::cli_test
