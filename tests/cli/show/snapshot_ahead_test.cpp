// Pictures and pages of one moment: they say when it is, and what lies ahead of it.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/page_command.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two at 8 km from where their ways cross, one after the other; a third far away.
std::string scenario(const std::string& heading_of_second) {
  return "00:00:00.00>CRE AFR123,A320,48.0,2.0,90,FL350,450\n"
         "00:00:00.00>CRE BAW456,A320,47.9,2.15," +
         heading_of_second + ",FL352,430\n00:00:00.00>CRE SWR22K,A320,50.0,5.0,270,FL330,440\n";
}

class SnapshotAhead : public testing::Test {
 protected:
  Finished plot(const std::string& file, const Arguments& more = {}) {
    return run(Arguments{"plot", file, "--separation", "enroute", "-o", picture()} + more);
  }
  [[nodiscard]] std::string picture() const { return folder_.path("p.svg"); }

  TemporaryFolder folder_;
};

TEST_F(SnapshotAhead, APictureTellsWhatIsFoundAhead) {
  const std::string file = folder_.file("meet.scn", scenario("0"));
  const Finished finished = plot(file, {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err,
               {"now        0.00 s\n", "at risk    none at this moment\n",
                "ahead      flying straight on, 1 conflict within 300 s: AFR123 and BAW456 in ",
                "'beespace predict " + file + " --separation enroute' tells more\n"});
  const std::string drawn = folder_.read("p.svg");
  expect_parts(
      drawn,
      {"3 aircraft at 0.00 s. No aircraft is closer than 5 NM across and closer than 1,000 ft in "
       "height to another at this moment. Ahead: flying straight on, 1 conflict within 300 s",
       "Ahead, flying straight on", ">AFR123</text>", ">BAW456</text>", "stroke-dasharray",
       "to where two are closest and too close"});
  EXPECT_EQ(drawn.find(">SWR22K</text>"), std::string::npos);
}

// The worst encounter may be ahead where others are too close already.
TEST_F(SnapshotAhead, IsListedBesideThoseWhoAreTooCloseNow) {
  const std::string file = folder_.file(
      "meet.scn", scenario("0") + "00:00:00.00>CRE KLM81R,A320,50.0,5.05,270,FL330,440\n");
  const Finished finished = plot(file);
  expect_parts(finished.err, {"ahead      flying straight on, 1 conflict within 300 s: AFR123"});
  expect_parts(folder_.read("p.svg"), {"Closest pairs (straight line)", "Ahead, flying straight on",
                                       ">AFR123</text>", "KLM81R"});
}

TEST_F(SnapshotAhead, TheWorstIsToldFirst) {
  // 20 km apart head-on at one level, later than the others are, who keep 700 ft.
  const std::string file = folder_.file("two.scn",
                                        "00:00:00.00>CRE AFR123,A320,48.0,2.0,90,FL350,450\n"
                                        "00:00:00.00>CRE BAW456,A320,48.0,2.2,270,FL357,450\n"
                                        "00:00:00.00>CRE SWR22K,A320,50.0,5.0,90,FL330,440\n"
                                        "00:00:00.00>CRE KLM81R,A320,50.0,5.5,270,FL330,440\n");
  expect_parts(plot(file).err,
               {"ahead      flying straight on, 2 conflicts within 300 s, the worst first: SWR22K "
                "and KLM81R in "});
  EXPECT_EQ(folder_.read("p.svg").find("AFR123 and BAW456 in"), std::string::npos)
      << "named in the list only";
}

TEST_F(SnapshotAhead, AsPredictFindsIt) {
  const std::string file = folder_.file("meet.scn", scenario("0"));
  const auto rows = rows_of(
      run({"predict", file, "--separation", "enroute", "--horizon", "300", "--csv"}).out, ',');
  ASSERT_EQ(rows.size(), 2u);
  const std::string in_s = rows[1][2].substr(0, rows[1][2].find('.') + 2);
  const std::string said = plot(file).err;
  const std::size_t at = said.find("AFR123 and BAW456 in ");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_NEAR(std::stod(said.substr(at + 21)), std::stod(rows[1][2]), 0.06) << in_s;
}

TEST_F(SnapshotAhead, WhereNoneMeetThatIsSaidToo) {
  const std::string file = folder_.file("part.scn", scenario("180"));
  const Finished finished = plot(file, {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"ahead      flying straight on, no conflict begins within 300 s\n"});
}

// As far as `predict` is asked to look.
TEST_F(SnapshotAhead, HowFarAheadIsAskedAsOfPredict) {
  const std::string file = folder_.file("meet.scn", scenario("0"));
  const Finished soon = plot(file, {"--horizon", "1", "--fail-on-risk"});
  EXPECT_EQ(soon.exit_code, 0) << soon.err;
  expect_parts(soon.err, {"ahead      flying straight on, no conflict begins within 1 s\n"});
  const Finished late = plot(file, {"--horizon", "1200", "--fail-on-risk"});
  EXPECT_EQ(late.exit_code, 1) << late.err;
  expect_parts(late.err, {"ahead      flying straight on, 1 conflict within 1,200 s: ",
                          " --separation enroute --horizon 1200' tells more\n"});
  const std::string recorded =
      folder_.file("flown.csv", "id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\nb,0,9,9,9\nb,1,9,9,9\n");
  const Finished refused = run({"plot", recorded, "-o", folder_.path("q.svg"), "--horizon", "60"});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  expect_parts(refused.err,
               {"is not one moment with velocities, from which --horizon looks ahead"});
}

TEST_F(SnapshotAhead, ALookOfAReceiverNamesItsTime) {
  const std::string file = folder_.file(
      "aircraft.json",
      R"({"now": 1717581840.0, "aircraft": [)"
      R"({"hex": "3944ef", "flight": "AFR123", "alt_baro": 35000, "gs": 450, "track": 90, )"
      R"("baro_rate": 0, "lat": 48.0, "lon": 1.8133, "seen_pos": 0.4}, )"
      R"({"hex": "4008f6", "flight": "BAW456", "alt_baro": 35200, "gs": 430, "track": 0, )"
      R"("baro_rate": 0, "lat": 47.9306, "lon": 2.0, "seen_pos": 0.4}]})");
  EXPECT_EQ(plot(file, {"--fail-on-risk"}).exit_code, 1);
  expect_parts(folder_.read("p.svg"), {"2 aircraft at 2024-06-05T10:04:00.000Z. "});
  if (!kHasPage) return;
  const Page page = reported({file, "--separation", "enroute"});
  expect_parts(std::string(page.parts.json),
               {R"("moment":"2024-06-05T10:04:00.000Z")", R"("ahead_count":1)",
                R"("ahead":"flying straight on, 1 conflict within 300 s: )"});
}

// One heard a second ago that tells no climb rate, and is too close to another.
TEST_F(SnapshotAhead, WhoTellsNoClimbRateIsThereWhereLastHeardOf) {
  const auto aircraft = [this](const std::string& height_ft, const std::string& rate) {
    return folder_.file(
        "aircraft.json",
        R"({"now": 1717581840.0, "aircraft": [)"
        R"({"hex": "3944ef", "flight": "AFR123", "alt_baro": 35000, "gs": 450, "track": 90, )" +
            rate + R"("lat": 48.0, "lon": 1.8, "seen_pos": 1.0}, )" +
            R"({"hex": "4008f6", "flight": "BAW456", "alt_baro": )" + height_ft +
            R"(, "gs": 430, "track": 90, "baro_rate": 0, )" +
            R"("lat": 48.01, "lon": 1.8, "seen_pos": 0.5}, )" +
            R"({"hex": "4b1814", "flight": "SWR22K", "alt_baro": 33000, "gs": 430, "track": 0, )" +
            rate + R"("lat": 50.01, "lon": 5.8, "seen_pos": 0.5}]})");
  };
  const Finished near = plot(aircraft("35000", ""), {"--fail-on-risk"});
  EXPECT_EQ(near.exit_code, 1) << near.err;
  expect_parts(near.err, {"at risk    2 of 3: 1 pair in 1 group; 2 aircraft are checked for now "
                          "only, where last heard of\n",
                          "2 shown where last heard of, up to 1.00 s before"});
  expect_parts(folder_.read("p.svg"), {"4008f6 (BAW456) \u2013 3944ef (AFR123)",
                                       "2 are at risk: 1 pair closer than 5 NM across"});
  const std::string table = folder_.path("t.csv");
  run({"export", folder_.path("aircraft.json"), "--separation", "enroute", "-o", table});
  EXPECT_EQ(rows_of(folder_.read("t.csv"), ',').size(), 2u);
  // Kept apart in height, it may climb.
  const Finished apart = plot(aircraft("37000", ""), {"--fail-on-risk"});
  EXPECT_EQ(apart.exit_code, 1) << apart.err;
  expect_parts(folder_.read("p.svg"),
               {"3 aircraft at 2024-06-05T10:04:00.000Z. Not known of all: 2 "
                "aircraft are checked for now only"});
  const Finished known = plot(aircraft("37000", R"("baro_rate": 0, )"), {"--fail-on-risk"});
  EXPECT_EQ(known.exit_code, 0) << known.err;
  expect_parts(folder_.read("p.svg"), {"No aircraft is closer than 5 NM across"});
}

// Of none is it known: they are compared all the same, at their heights.
TEST_F(SnapshotAhead, WhereNoneTellsAClimbRateHeightsCount) {
  const auto aircraft = [this](const std::string& height_ft) {
    return folder_.file("aircraft.json",
                        R"({"now": 1717581840.0, "aircraft": [)"
                        R"({"hex": "3944ef", "alt_baro": 35000, "gs": 450, "track": 90, )"
                        R"("lat": 48.0, "lon": 1.8, "seen_pos": 1.0}, )"
                        R"({"hex": "4008f6", "alt_baro": )" +
                            height_ft +
                            R"(, "gs": 430, "track": 90, "lat": 48.01, "lon": 1.8, )"
                            R"("seen_pos": 0.5}]})");
  };
  expect_parts(plot(aircraft("35100")).err, {"at risk    2 of 2: 1 pair in 1 group"});
  expect_parts(plot(aircraft("37000")).err,
               {"at risk    none of those that are known; 2 aircraft"});
  const Finished predicted =
      run({"predict", aircraft("37000"), "--separation", "enroute", "--csv"});
  EXPECT_EQ(rows_of(predicted.out, ',').size(), 1u) << predicted.out << predicted.err;
}

TEST_F(SnapshotAhead, WhatIsNotKnownIsSaidToBe) {
  const std::string file = folder_.file(
      "aircraft.json",
      R"({"now": 1717581840.0, "aircraft": [)"
      R"({"hex": "3944ef", "alt_baro": 35000, "lat": 48.0, "lon": 1.8, "seen_pos": 0}, )"
      R"({"hex": "4008f6", "alt_baro": 35000, "lat": 48.3, "lon": 1.8, "seen_pos": 0}]})");
  expect_parts(
      plot(file).err,
      {"ahead      not known, as the input tells no velocities that can be flown on with"});
}

}  // namespace
}  // namespace beespace::cli_test
