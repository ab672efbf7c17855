// Records that were left out: there is no all-clear for what was not read.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// One of a list, behind others.
std::string aircraft(const std::string& hex, const std::string& place, const std::string& height,
                     const std::string& knots = "250") {
  return R"(,{"hex":")" + hex + R"(",)" + place + height + R"("gs":)" + knots +
         R"(,"track":90,"seen_pos":0.0})";
}

const std::string kHere = R"("lat":48.0,"lon":11.0,)";
const std::string kFar = R"("lat":50.0,"lon":11.0,)";
const std::string kGeometric = R"("alt_geom":35000,"geom_rate":0,)";
const std::string kPressure = R"("alt_baro":35000,"baro_rate":0,)";

std::string look(int now_s, const std::string& more) {
  return R"({"now":)" + std::to_string(now_s) + R"(,"messages":1,"aircraft":[)" +
         aircraft("aaaaaa", kHere, kGeometric).substr(1) + aircraft("cccccc", kFar, kGeometric) +
         more + "]}";
}

// bbbbbb is where aaaaaa is, but tells its height by pressure only.
const std::string kOther = aircraft("bbbbbb", kHere, kPressure);

class LeftOutRecords : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string first_ = folder_.file("0.json", look(1700000000, kOther));
  std::string second_ = folder_.file("1.json", look(1700000001, kOther));

  Arguments ask(const std::string& command, const Arguments& more = {}) const {
    return Arguments{command, first_, second_, "--threshold", "5NM"} + more;
  }
};

TEST_F(LeftOutRecords, ReplaySaysWhichBeesAreKnownNowhere) {
  const Finished finished =
      run(ask("replay", {"--vertical", "1000ft", "--heights", "geometric", "--fail-on-risk"}));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"verdict    no conflict in the known time; 1 bee is known nowhere, 2 records were "
                "left out",
                "left out   2 records of 1 bee: place, height or time is missing or bad",
                "known nowhere: bbbbbb"});
  EXPECT_EQ(finished.err.find("keeps its distance"), std::string::npos) << finished.err;
  EXPECT_EQ(run(ask("replay")).exit_code, 0);
}

TEST_F(LeftOutRecords, JsonHasThemAndIsNotComplete) {
  for (const char* command : {"replay", "verify"}) {
    const Finished finished = run(ask(command, {"--json", "--quiet"}));
    EXPECT_TRUE(is_json(finished.out)) << finished.out;
    expect_parts(finished.out,
                 {"\"known\": {\"complete\": false",
                  "\"left_out_records\": 2, \"left_out_without_id\": 0, \"left_out_bees\": 1, "
                  "\"bees_known_nowhere\": 1, \"known_nowhere\": [\"bbbbbb\"]"});
  }
}

TEST_F(LeftOutRecords, VerifyDoesNotHold) {
  const Finished finished = run(ask("verify"));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"not seen as a whole: holds in the known time; 1 bee is known nowhere, "
                "2 records were left out"});
}

TEST_F(LeftOutRecords, PredictSaysNoneOfTheKnownBees) {
  const Arguments question = {"predict", first_, "--threshold", "5NM", "--fail-on-risk"};
  const Finished finished = run(question);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"conflicts  none of those that are known; 1 bee is known nowhere, 1 "
                              "record was left out"});
  const Finished json = run(question + Arguments{"--json", "--quiet"});
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {"\"known\": {\"complete\": false, \"left_out_records\": 1",
                          "\"known_nowhere\": [\"bbbbbb\"]"});
}

TEST_F(LeftOutRecords, PicturesAndMapsSayIt) {
  for (const Arguments& arguments :
       {Arguments{"plot", first_, second_}, Arguments{"export", first_, second_},
        Arguments{"plot", first_}}) {
    const std::string name = arguments[0] == "plot" ? "out.svg" : "out.kml";
    const Finished finished = run(
        arguments + Arguments{"--threshold", "5NM", "--fail-on-risk", "-o", folder_.path(name)});
    EXPECT_EQ(finished.exit_code, 1) << arguments[0] << finished.err;
    expect_parts(finished.err, {"1 aircraft is known nowhere", "  aircraft   "});
    EXPECT_EQ(finished.err.find("at risk    none\n"), std::string::npos) << finished.err;
    EXPECT_NE(folder_.read(name).find("1 aircraft is known nowhere"), std::string::npos);
  }
}

TEST_F(LeftOutRecords, WhatIsHarmlessDoesNotCount) {
  // On the ground, with and without a place; and the same look twice.
  const std::string on_ground = R"("alt_baro":"ground",)";
  const std::string grounded =
      aircraft("dddddd", kHere, on_ground, "15") + aircraft("eeeeee", "", on_ground, "0");
  const std::string first = folder_.file("a.json", look(1700000000, grounded));
  const std::string again = folder_.file("b.json", look(1700000000, grounded));
  const std::string later = folder_.file("c.json", look(1700000001, grounded));
  const Finished finished =
      run({"replay", first, again, later, "--threshold", "5NM", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"verdict    keeps its distance\n", "on the ground"});
  // No aircraft rolls at 250 kt.
  const std::string flies =
      folder_.file("d.json", look(1700000000, aircraft("dddddd", kHere, on_ground)));
  const Finished fast = run({"replay", flies, later, "--threshold", "5NM", "--fail-on-risk"});
  EXPECT_EQ(fast.exit_code, 1);
  expect_parts(fast.err, {"dddddd", "as high or as fast as none there"});
}

TEST(LeftOutMessages, OfBaseStation) {
  const auto message = [](const std::string& kind, const std::string& address,
                          const std::string& second, const std::string& altitude,
                          const std::string& place) {
    return "MSG," + kind + ",1,1," + address + ",1,2024/05/01,12:00:0" + second +
           ".000,2024/05/01,12:00:0" + second + ".000,," + altitude + ",,," + place + ",,,,,,0\n";
  };
  const std::string here = "48.0,11.0";
  const std::string flown = message("3", "AAAAAA", "0", "35000", here) +
                            message("3", "AAAAAA", "1", "35000", here) +
                            message("3", "CCCCCC", "0", "35000", "50.0,11.0") +
                            message("3", "CCCCCC", "1", "35000", "50.0,11.0");
  const Arguments question = {"replay", "--threshold", "5NM", "--fail-on-risk"};
  EXPECT_EQ(run(question, flown).exit_code, 0);
  // Without a height; and one that never tells a position.
  for (const std::string& more :
       {message("3", "BBBBBB", "1", "", here), message("5", "BBBBBB", "1", "35000", ",")}) {
    const Finished finished = run(question, flown + more);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err,
                 {"1 bee is known nowhere, 1 record was left out", "known nowhere: bbbbbb"});
  }
}

TEST(LeftOutRows, SkippedOnesAreNoAllClear) {
  constexpr std::string_view kFlown =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,0,90,0,0\nb,1,90,0,0\nc,0,oops,0,0\n"
      "b,0.5,5,,\n,0,0,0,0\n";
  const Arguments options = {"--threshold", "10", "--skip-bad"};
  const Finished finished = run(Arguments{"replay", "--fail-on-risk"} + options, kFlown);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"1 bee is known nowhere, 3 records were left out",
                              "3 records of 2 bees and 1 of unknown ones", "known nowhere: c"});
  EXPECT_EQ(run(Arguments{"verify"} + options, kFlown).exit_code, 1);
  EXPECT_EQ(run(Arguments{"predict", "--fail-on-risk"} + options, kFlown).exit_code, 1);
  const TemporaryFolder folder;
  const Finished plotted =
      run(Arguments{"plot", "-o", folder.path("out.svg"), "--fail-on-risk"} + options, kFlown);
  EXPECT_EQ(plotted.exit_code, 1) << plotted.err;
}

TEST(LeftOutRows, OfSnapshotsToo) {
  const Arguments question = {"detect", "--skip-bad", "--fail-on-risk"};
  const Finished finished = run(question, "id,x,y,z\na,0,0,0\nb,5000,oops,0\n");
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"at risk    none of those that are known; 1 record was left out"});
  EXPECT_EQ(run(question, "id,x,y,z\na,0,0,0\nb,5000,0,0\n").exit_code, 0);
}

// One without a velocity is where it is, even if it is not known where it goes.
TEST(Predict, WhatHasNoVelocityIsCheckedForNow) {
  constexpr std::string_view kHeader = "id,x,y,z,vx,vy,vz\n";
  const Arguments question = {"predict", "--threshold", "10", "--fail-on-risk"};
  const Finished close = run(question, std::string(kHeader) + "b,1,0,0,,,\na,0,0,0,1,0,0\n");
  EXPECT_EQ(close.exit_code, 1);
  expect_rows(without_lasts(rows_of(close.out)), {{"b", "a", "0", "0", "1", "0"}});
  expect_parts(close.err, {"1, of 2 bees; 1 bee is checked for now only"});
  const Finished far = run(question, std::string(kHeader) + "a,0,0,0,1,0,0\nb,100,0,0,,,\n");
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_EQ(below_header(far.out), "");
  expect_parts(far.err, {"none of those that are known; 1 bee is checked for now only"});
  // And between two of these; in a cylinder, above degrees, too.
  const Finished both =
      run(question, std::string(kHeader) + "b,50,0,0,,,\nc,51,0,0,,,\na,0,0,0,1,0,0\n");
  expect_rows(without_lasts(rows_of(both.out)), {{"b", "c", "0", "0", "1", "0"}});
  const Finished cylinder = run(question + Arguments{"--vertical", "5", "--quiet"},
                                "id,lon,lat,height,ve,vn,vu\na,11,48,100,1,0,0\nb,11,48,104,,,\n"
                                "c,11,48,106,,,\n");
  EXPECT_EQ(rows_of(cylinder.out).size(), 2u) << cylinder.out;
}

TEST(Predict, WhatIsStaleIsNoAllClear) {
  const Finished finished = run({"predict", "--threshold", "10", "--fail-on-risk", "--quiet"},
                                "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,0,0,0\nb,100,1,0,0,0,0,0\n");
  EXPECT_EQ(finished.exit_code, 1);
}

}  // namespace
}  // namespace beespace::cli_test
