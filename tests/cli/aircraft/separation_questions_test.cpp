// How close is too close is asked of aircraft, whatever their heights are in; and what is now, of
// what a receiver or a server wrote.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two 6 km beside each other at one height: as OpenSky has them, in metres.
std::string in_metres(const std::string& columns = "time,icao24,lat,lon,geoaltitude_m") {
  std::string text = columns + "\n";
  for (int t = 0; t < 4; ++t) {
    const std::string time = std::to_string(1714564800 + 10 * t);
    const std::string east = std::to_string(8.5 + 0.02 * t);
    text += time + ",4b1814,47.00," + east + ",10668.0\n";
    text += time + ",3c6444,47.06," + east + ",10668.0\n";
  }
  return text;
}

TEST(SeparationOfAircraft, InMetresIsAskedForByAllCommands) {
  const TemporaryFolder folder;
  const std::string file = folder.file("states.csv", in_metres());
  for (const std::string command : {"replay", "predict", "plot", "report", "export"}) {
    Arguments arguments = {command, file};
    if (command == "plot") arguments = arguments + Arguments{"-o", folder.path("p.svg")};
    if (command == "report") arguments = arguments + Arguments{"-o", folder.path("p.html")};
    if (command == "export") arguments = arguments + Arguments{"-o", folder.path("p.kml")};
    const Finished asked = run(arguments);
    EXPECT_EQ(asked.exit_code, 2) << command << asked.err;
    expect_parts(asked.err,
                 {"these are aircraft: how close is too close? Say --separation enroute"});
    EXPECT_EQ(run(arguments + Arguments{"--separation", "enroute"}).exit_code, 0) << command;
  }
  const Finished verified = run({"verify", file});
  EXPECT_EQ(verified.exit_code, 2) << verified.err;
  expect_parts(verified.err,
               {"these are aircraft: how close is too close? Say --separation enroute"});
  EXPECT_LT(run({"verify", file, "--separation", "enroute"}).exit_code, 2);
}

// Two that fly 2 NM beside each other, as a receiver sends them.
std::string messages() {
  std::string text;
  for (int t = 0; t < 4; ++t) {
    const std::string time = "2024/06/05,10:00:0" + std::to_string(t) + ".000";
    for (const auto* const at : {"3944EF|47.00000", "4008F6|47.03333"}) {
      const std::string of(at);
      text += "MSG,3,1,1," + of.substr(0, 6) + ",1," + time + "," + time + ",,35000,,," +
              of.substr(7) + ",8.50000,,,0,0,0,0\n";
    }
  }
  return text;
}

TEST(SeparationOfAircraft, IsAskedForByWatch) {
  const std::string question = ": how close is too close? Say --separation enroute";
  const std::string keys =
      R"({"icao24":"4b1814","callsign":"A","time":1714564800,"lat":47,"lon":8.5,"altitude_m":9000})";
  for (const std::string& input : {messages(), in_metres(), keys + "\n"}) {
    const Finished asked = run({"watch"}, input);
    EXPECT_EQ(asked.exit_code, 2) << asked.err;
    EXPECT_EQ(asked.out, "");
    expect_parts(asked.err, {"these are aircraft", question});
    const Finished bare = run({"watch", "--threshold", "5"}, input);
    EXPECT_EQ(bare.exit_code, 2) << bare.err;
    expect_parts(bare.err, {"say --threshold 5NM if it is in nautical miles"});
  }
  const Finished found = run({"watch", "--separation", "enroute", "--fail-on-risk"}, messages());
  EXPECT_EQ(found.exit_code, 1) << found.err;
  expect_parts(found.err, {"entered    1\n"});
}

TEST(SeparationOfAircraft, IsAskedForByDetect) {
  const TemporaryFolder folder;
  const std::string feet =
      "icao24,callsign,latitude,longitude,geoaltitude_ft,groundspeed\n"
      "3944ef,AFR123,48.0,1.968886,35300.0,450.0\n"
      "4008f6,BAW456,48.030072,2.0,35500.0,430.0\n";
  const std::string metres =
      "icao24,callsign,lat,lon,geoaltitude_m\n3944ef,A,48.0,1.968886,10668\n"
      "4008f6,B,48.030072,2.0,10729\n";
  for (const std::string& input : {feet, metres}) {
    const std::string file = folder.file("one.csv", input);
    for (const Arguments& more : {Arguments{}, Arguments{"--memory", "1GB"}}) {
      const Finished asked = run(Arguments{"detect", file} + more);
      EXPECT_EQ(asked.exit_code, 2) << asked.err;
      expect_parts(asked.err, {"these are aircraft", "how close is too close? Say --separation"});
      const Finished found =
          run(Arguments{"detect", file, "--separation", "enroute", "--fail-on-risk"} + more);
      EXPECT_EQ(found.exit_code, 1) << found.err;
    }
  }
}

TEST(SeparationOfAircraft, IsAskedForWhereNothingElseFliesSo) {
  const Finished asked = run({"replay"}, in_metres("time_s,id,lat,lon,height_m"));
  EXPECT_EQ(asked.exit_code, 2) << asked.err;
  expect_parts(asked.err, {"these are aircraft, higher and faster than drones fly: how close"});
}

TEST(SeparationOfAircraft, ABareNumberOfMilesIsNoNumberOfMetres) {
  const Finished bare = run({"replay", "--threshold", "5"}, in_metres());
  EXPECT_EQ(bare.exit_code, 2) << bare.err;
  expect_parts(bare.err, {"--threshold 5 would be 5 m, less than any separation of aircraft: say "
                          "--threshold 5NM if it is in nautical miles, or --threshold 5m"});
  EXPECT_EQ(run({"replay", "--threshold", "5m", "--fail-on-risk"}, in_metres()).exit_code, 0);
  EXPECT_EQ(run({"replay", "--threshold", "5NM", "--fail-on-risk"}, in_metres()).exit_code, 1);
}

// 1000 ft are usual, and 1000 m are not; of metres 300 are.
TEST(SeparationOfAircraft, ABareNumberOfFeetIsNoNumberOfMetres) {
  const TemporaryFolder folder;
  const std::string file = folder.file("states.csv", in_metres());
  for (const std::string command : {"replay", "predict", "verify", "report"}) {
    Arguments arguments = {command, file, "--threshold", "5NM"};
    if (command == "report") arguments = arguments + Arguments{"-o", folder.path("p.html")};
    const Finished bare = run(arguments + Arguments{"--vertical", "1000"});
    EXPECT_EQ(bare.exit_code, 2) << command << bare.err;
    expect_parts(bare.err, {"these are aircraft",
                            "and --vertical 1000 would be 1000 m: say "
                            "--vertical 1000ft if it is in feet, or "
                            "--vertical 1000m\n"});
    for (const std::string said : {"1000ft", "1000m", "300"}) {
      EXPECT_LT(run(arguments + Arguments{"--vertical", said}).exit_code, 2) << command << said;
    }
  }
  const Finished both = run({"replay", "--threshold", "5", "--vertical", "1000"}, in_metres());
  EXPECT_EQ(both.exit_code, 2) << both.err;
  expect_parts(both.err, {"say --threshold 5NM --vertical 1000ft if they are in nautical miles and "
                          "feet, or --threshold 5m --vertical 1000m\n"});
  const Finished live = run({"watch", "--threshold", "5NM", "--vertical", "1000"}, messages());
  EXPECT_EQ(live.exit_code, 2) << live.err;
  expect_parts(live.err, {"say --vertical 1000ft if it is in feet"});
}

TEST(SeparationOfAircraft, WellClearIsOfTwoKinds) {
  const Finished asked = run({"replay", "--separation", "well-clear"}, in_metres());
  EXPECT_EQ(asked.exit_code, 2) << asked.err;
  expect_parts(asked.err, {"--separation well-clear-suas (2000 ft, 250 ft, ASTM F3442)",
                           "--threshold 4000ft --vertical 450ft (RTCA DO-365"});
  expect_parts(run({"replay", "--separation", "enrout"}, in_metres()).err,
               {"did you mean 'enroute'?"});
}

// Ships and drones have some of these words, too.
TEST(SeparationOfAircraft, IsNotAskedOfOthers) {
  const std::string ships =
      "MMSI,BaseDateTime,LAT,LON,CallSign\n1,2024-05-01T12:00:00Z,47,8.5,A\n"
      "2,2024-05-01T12:00:00Z,47.1,8.5,B\n";
  EXPECT_EQ(run({"replay"}, ships).err.find("aircraft"), std::string::npos);
  const std::string drones =
      "drone,flight,time_s,lat,lon,height_m\na,1,0,47,8.5,60\n"
      "a,1,1,47,8.5,61\nb,1,0,47.1,8.5,60\nb,1,1,47.1,8.5,60\n";
  EXPECT_EQ(run({"replay"}, drones).err.find("these are aircraft"), std::string::npos);
}

// ---- What is now --------------------------------------------------------------------------------

// Two that fly towards each other, heard of at 1714564800.
std::string states_at(const std::string& time) {
  return R"({"time":)" + time + R"(,"states":[)" +
         R"(["4b1814","","X",1714564800,1714564800,8.0,47.0,10000,false,200,90,0,null,10000,)" +
         R"(null,false,0,0],)" +
         R"(["3c6444","","X",1714564800,1714564800,8.4,47.0,10000,false,200,270,0,null,10000,)" +
         R"(null,false,0,0]]})";
}

// Where each has one place nothing is known of a flight; what lies ahead is.
TEST(SeparationOfAircraft, OneMomentIsNoRecording) {
  const TemporaryFolder folder;
  const std::string file = folder.file("states.json", states_at("1714564800"));
  for (const std::string command : {"replay", "verify"}) {
    const Finished moment = run({command, file, "--separation", "enroute"});
    EXPECT_EQ(moment.exit_code, 3) << moment.out << moment.err;
    EXPECT_EQ(moment.out, "");
    expect_parts(moment.err, {"each of the 2 aircraft has one fix only", "this is one moment",
                              "ask 'beespace predict " + file + " --separation enroute'"});
  }
  EXPECT_LT(run({"predict", file, "--separation", "enroute"}).exit_code, 2);
}

std::string heard_at(const std::string& now, const std::string& seen) {
  return R"({"now":)" + now + R"(,"aircraft":[)" +
         R"({"hex":"4b1814","lat":47.0,"lon":8.0,"alt_geom":33000,"gs":400,"track":90,)" +
         R"("geom_rate":0,"seen_pos":)" + seen + R"(},{"hex":"3c6444","lat":47.0,"lon":8.4,)" +
         R"("alt_geom":33000,"gs":400,"track":270,"geom_rate":0,"seen_pos":)" + seen + "}]}";
}

TEST(PresentOfAircraft, IsThatOfTheFile) {
  const Arguments ask = {"predict",   "--separation", "enroute",
                         "--heights", "geometric",    "--fail-on-risk"};
  // 30 km apart, at 400 m/s: closer than 5 NM after 53 s.
  EXPECT_EQ(rows_of(run(ask, states_at("1714564800")).out).size(), 1u);
  const Finished later = run(ask, states_at("1714564820"));
  EXPECT_EQ(rows_of(later.out).size(), 1u) << later.err;
  expect_parts(later.err,
               {"now        2024-05-01T12:00:20.000Z\n", "brought forward, by up to 20"});
  const Finished soon = run(ask + Arguments{"--horizon", "40"}, states_at("1714564820"));
  EXPECT_EQ(rows_of(soon.out).size(), 1u) << soon.err;
  const Finished heard = run(ask, heard_at("1714564825", "25"));
  EXPECT_EQ(rows_of(heard.out).size(), 1u) << heard.err;
  expect_parts(heard.err, {"now        2024-05-01T12:00:25.000Z\n"});
}

TEST(PresentOfAircraft, WhereAllPositionsAreOldIsNoAllClear) {
  for (const std::string& text : {states_at("1714564900"), heard_at("1714564900", "100")}) {
    const Finished finished = run(
        {"predict", "--separation", "enroute", "--heights", "geometric", "--fail-on-risk"}, text);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err, {"stale      2 left out, not heard of for 30 s (--max-age)",
                                "nothing to compare"});
  }
}

// An aircraft that was created before another one flies on.
TEST(PresentOfAircraft, OfAScenarioAllAreKept) {
  const std::string text =
      "00:00:00.00>CRE A B744 47 8 90 FL300 400\n"
      "00:04:10.00>CRE B B744 47 9 270 FL300 400\n";
  const Finished finished = run({"predict", "--separation", "enroute", "--fail-on-risk"}, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err,
               {"let fly on as created, for up to 250.00 s", "conflicts  1, of 2 bees"});
}

// ---- Spikes -------------------------------------------------------------------------------------

// One that flies level eastwards, and one above; of these two records in a row are elsewhere.
std::string with_spike(const std::string& height_m, const std::string& latitude) {
  std::string text =
      "time,icao24,lat,lon,geoaltitude [m],groundspeed [m/s],track,vertical_rate [m/s]\n";
  for (int t = 0; t < 12; ++t) {
    const bool false_one = t == 5 || t == 6;
    const std::string time = std::to_string(1714564800 + 5 * t);
    const std::string east = std::to_string(8.0 + 0.0040 * t) + ",";
    text += time + ",4b1814,47," + east + "10000,60.9,90,0\n";
    text += time + ",3c6444," + (false_one ? latitude : "47.2") + "," + east +
            (false_one ? height_m : "10000") + ",60.9,90,0\n";
  }
  return text;
}

TEST(SpikesOfAircraft, AgainstTheirOwnRatesAreNotKnown) {
  const Arguments ask = {"replay",    "--separation", "enroute",
                         "--heights", "geometric",    "--fail-on-risk"};
  for (const auto& [height_m, latitude] :
       {std::pair("10305", "47.2"), {"13048", "47.2"}, {"0", "47.2"}, {"10000", "47.22"}}) {
    const std::string text = with_spike(height_m, latitude);
    const Finished finished = run(ask, text);
    EXPECT_EQ(finished.exit_code, 1) << height_m << finished.err;
    expect_parts(finished.err, {"1 bee jumps"});
    // From the fix before to the one behind, and not while it jumps alone.
    const std::string bees = run(ask + Arguments{"--report", "bees", "--json"}, text).out;
    expect_parts(bees, {R"("unknown_s": 15)"});
  }
}

TEST(SpikesOfAircraft, StepsAndSlowRatesAreNone) {
  const Arguments ask = {"replay",    "--separation", "enroute",
                         "--heights", "geometric",    "--fail-on-risk"};
  for (const std::string height_m : {"10030.48", "10060.96", "9950", "10100"}) {
    const Finished finished = run(ask, with_spike(height_m, "47.2"));
    EXPECT_EQ(finished.exit_code, 0) << height_m << finished.err;
  }
}

}  // namespace
}  // namespace beespace::cli_test
