// What is not known, contradicts itself or was not compared is never an all-clear.
#include <gtest/gtest.h>

#include <algorithm>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

const std::string kHeader = "id,time_s,x,y,z\n";

// Up to 10 m, 1 m/s along x, and down again: from 0 s to `lasts_s`.
std::string flight(const std::string& id, int y, int lasts_s) {
  std::string text;
  for (int t = 0; t <= lasts_s; ++t) {
    const int z = std::min({10, 2 * t, 2 * (lasts_s - t)});
    const int x = std::min({std::max(0, t - 5), lasts_s - 10});
    text += id + "," + std::to_string(t) + "," + std::to_string(x) + "," + std::to_string(y) + "," +
            std::to_string(100 + z) + "\n";
  }
  return text;
}

// The same, but its log ends in the air.
std::string cut_off(const std::string& id, int y, int lasts_s, int at_s) {
  std::string text = flight(id, y, lasts_s);
  const std::string last = "\n" + id + "," + std::to_string(at_s) + ",";
  return text.substr(0, text.find('\n', text.find(last) + 1) + 1);
}

TEST(NoFalseAllClear, ADroneThatIsCutOffInTheAirIsNotCertified) {
  const std::string input = kHeader + flight("a", 0, 30) + cut_off("b", 20, 30, 15);
  const Finished verify = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(
      verify.err,
      {"verdict    not seen as a whole: holds in the known time; 1 bee known for a part of "
       "the recording only (1 of which begins or ends in the air while others fly: b)\n",
       "1 bee before the first or after the last fix, for 15 s in all; 1 of them in the "
       "air then\n"});
  const Finished replay = run({"replay", "--threshold", "2", "--fail-on-risk"}, input);
  EXPECT_EQ(replay.exit_code, 1);
  expect_parts(replay.err, {"no conflict in the known time; 1 bee known for a part of the"});
  const Finished large =
      run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB"}, input);
  EXPECT_EQ(large.exit_code, 1) << large.err;
  expect_parts(large.err, {"1 of them in the air then\n"});
  const Finished json = run({"verify", "--threshold", "2", "--json", "--quiet"}, input);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("holds": false)", R"("bees_partly_known": 1)",
                          R"("bees_cut_off_in_the_air": 1)"});
}

TEST(NoFalseAllClear, DronesThatLandAtDifferentTimesAreFine) {
  const std::string input = kHeader + flight("a", 0, 30) + flight("b", 20, 20);
  const Finished verify = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(verify.exit_code, 0) << verify.err;
  expect_parts(verify.err, {"verdict    holds in the known time; 1 bee known for a part of the "
                            "recording only\n"});
  EXPECT_EQ(run({"replay", "--threshold", "2", "--fail-on-risk"}, input).exit_code, 0);
  EXPECT_EQ(
      run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB"}, input).exit_code,
      0);
}

// The same in degrees: a log may break off in a collision. Who is heard of a little later than
// others is not cut off.
TEST(NoFalseAllClear, WhoIsCutOffInTheAirInDegreesIsNotCertified) {
  const auto fix = [](const char* id, double time_s, double lat, int height_m) {
    return std::string(id) + "," + std::to_string(time_s) + ",8.0," + std::to_string(lat) + "," +
           std::to_string(height_m) + "\n";
  };
  std::string all = "id,time_s,lon,lat,height_m\n";
  std::string broken = all;
  for (int t = 0; t <= 60; ++t) {
    const int height_m = 500 + std::min({20, 2 * std::max(0, t - 5), 2 * std::max(0, 55 - t)});
    all += fix("a", t, 47.0, height_m) + fix("b", t + 0.5, 47.001, height_m);
    broken += fix("a", t, 47.0, height_m);
    if (t < 40) broken += fix("b", t + 0.5, 47.001, height_m);
  }
  for (const Arguments& more : {Arguments{}, Arguments{"--memory", "64MiB"}}) {
    const Arguments ask = Arguments{"replay", "--threshold", "5", "--fail-on-risk"} + more;
    const Finished fine = run(ask, all);
    EXPECT_EQ(fine.exit_code, 0) << fine.err;
    const Finished cut = run(ask, broken);
    EXPECT_EQ(cut.exit_code, 1) << cut.err;
    expect_parts(cut.err, {"(1 of which begins or ends in the air while others fly: b)\n"});
  }
}

// Who is seen in a plane comes and goes.
TEST(NoFalseAllClear, WhoComesAndGoesIsKnownForAPartOnly) {
  std::string input = "id,time_s,x,y\n";
  for (int t = 0; t <= 20; ++t)
    input += "a," + std::to_string(t) + "," + std::to_string(t) + ",0\n";
  for (int t = 5; t <= 9; ++t) input += "b," + std::to_string(t) + "," + std::to_string(t) + ",9\n";
  const Finished finished = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"holds in the known time; 1 bee known for a part"});
  EXPECT_EQ(run({"replay", "--threshold", "2", "--fail-on-risk"}, input).exit_code, 0);
}

// Its own records say that an animal is there, but not where.
TEST(NoFalseAllClear, WhoIsThereWithoutAPlaceIsUnknown) {
  std::string known;
  std::string end;
  std::string begin;
  for (int frame = 0; frame < 20; ++frame) {
    const std::string at = "," + std::to_string(frame) + ".0,";
    known += "a" + at + std::to_string(frame) + ",0\n";
    const std::string place = std::to_string(frame) + ",9\n";
    end += "b" + at + (frame < 15 ? place : "NA,NA\n");
    begin += "b" + at + (frame > 4 ? place : "NA,NA\n");
  }
  for (const std::string& other : {end, begin}) {
    const std::string input = "id,time_s,x,y\n" + known + other;
    const Finished replay = run({"replay", "--threshold", "5", "--fail-on-risk"}, input);
    EXPECT_EQ(replay.exit_code, 1) << replay.err;
    expect_parts(replay.err, {"1 of them there without a place before or after"});
    const Finished verify = run({"verify", "--threshold", "5", "--json"}, input);
    EXPECT_EQ(verify.exit_code, 1) << verify.err;
    expect_parts(verify.out, {R"("holds": false)", R"("bees_there_without_a_place": 1)"});
  }
  // All of them.
  std::string all = "id,time_s,x,y\n" + end;
  for (int frame = 0; frame < 20; ++frame) {
    const std::string at = "c," + std::to_string(frame) + ".0,";
    all += at + (frame < 15 ? std::to_string(frame) + ",0\n" : "NA,NA\n");
  }
  EXPECT_EQ(run({"replay", "--threshold", "5", "--fail-on-risk"}, all).exit_code, 1);
  EXPECT_EQ(run({"verify", "--threshold", "5"}, all).exit_code, 1);
  // Who has no records there has gone, or has not come yet.
  const std::string gone = end.substr(0, end.find("NA") - std::string("b,15.0,").size());
  EXPECT_EQ(run({"replay", "--threshold", "5", "--fail-on-risk"}, "id,time_s,x,y\n" + known + gone)
                .exit_code,
            0);
}

TEST(NoFalseAllClear, NothingComparedIsARisk) {
  constexpr std::string_view apart =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,2,9,0,0\nb,3,9,0,0\n";
  for (const Arguments& more : {Arguments{}, Arguments{"--memory", "64MiB"}}) {
    const Finished finished = run(Arguments{"replay", "--fail-on-risk"} + more, apart);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err, {"nothing to compare"});
    EXPECT_EQ(run(Arguments{"replay"} + more, apart).exit_code, 0);
  }
  const Finished verify = run({"verify"}, apart);
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(verify.err, {"nothing to compare: no two bees are there at the same time"});
  // One bee alone is checked for what it may do alone.
  constexpr std::string_view alone = "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\n";
  EXPECT_EQ(run({"verify", "--max-speed", "1"}, alone).exit_code, 0);
  EXPECT_EQ(run({"verify"}, alone).exit_code, 1);
}

// Longitude and latitude under each other's name in one of two files.
TEST(NoFalseAllClear, SwappedDegreesAreSaid) {
  TemporaryFolder folder;
  const std::string one =
      folder.file("a.csv", "id,time_s,lon,lat\na,1,9,47\na,2,9.00001,47\na,3,9.00002,47\n");
  const std::string other =
      folder.file("b.csv", "id,time_s,lat,lon\nb,1,9.0001,47\nb,2,9.0001,47\nb,3,9.0001,47\n");
  const Finished finished = run({"replay", one, other, "--threshold", "50"});
  expect_parts(finished.err, {"bee 'a' is 5,",
                              " km from the nearest other one, but would be 0.0 km "
                              "from 'b' with longitude and latitude the other way round"});
  EXPECT_EQ(run({"replay", one, other, "--fail-on-risk"}).exit_code, 1);
  expect_parts(finished.err, {"longitude and latitude of 1 bee seem to be the other way round"});
  const Finished json = run({"replay", one, other, "--json", "--quiet"});
  expect_parts(json.out, {R"("swapped_degrees": 1)"});
  // Who says which is which means it.
  const Finished meant = run(
      {"replay", one, other, "--fail-on-risk", "--columns", "id=id,time=time_s,lon=lon,lat=lat"});
  EXPECT_EQ(meant.exit_code, 0) << meant.err;
  const std::string far =
      folder.file("c.csv", "id,time_s,lon,lat\nb,1,30,-47\nb,2,30,-47\nb,3,30,-47\n");
  EXPECT_EQ(run({"replay", one, far}).err.find("the other way round"), std::string::npos);
}

// Two of a file are beside each other, and so not far from all others.
TEST(NoFalseAllClear, SwappedDegreesOfSeveralAreSaidToo) {
  TemporaryFolder folder;
  std::string right = "id,time_s,lon,lat\n";
  std::string wrong = "id,time_s,lat,lon\n";
  for (int t = 1; t < 4; ++t) {
    const std::string time = std::to_string(t);
    right += "a," + time + ",9,47\nb," + time + ",9.01,47\nc," + time + ",9.02,47\n";
    wrong += "d," + time + ",9.1,47\ne," + time + ",9.11,47\n";
  }
  const Finished finished = run({"replay", folder.file("right.csv", right),
                                 folder.file("wrong.csv", wrong), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"bee 'd', as 1 beside it, is 5,",
                              "longitude and latitude of 2 bees seem to be the other way round"});
}

// Two of one address in a snapshot; or the time of a position that stands still while it moves.
TEST(NoFalseAllClear, PlacesFartherApartThanRoundingExplainsAreLeftOut) {
  const auto aircraft = [](const std::string& second) {
    return R"({"now": 1700000000.0, "aircraft": [
{"hex":"a00001","lat":50.0,"lon":8.0,"alt_baro":30000,"gs":400,"track":90,"baro_rate":0,"seen_pos":0},
{"hex":"a00001","lat":50.0,"lon":)" +
           second + R"(,"alt_baro":30000,"gs":400,"track":90,"baro_rate":0,"seen_pos":0},
{"hex":"b00002","lat":52.0,"lon":8.0,"alt_baro":30000,"gs":400,"track":90,"baro_rate":0,"seen_pos":0}]})";
  };
  const std::vector<std::string> predict = {"predict", "--separation", "enroute", "--fail-on-risk"};
  const Finished far = run(predict, aircraft("8.2"));
  EXPECT_EQ(far.exit_code, 1) << far.err;
  expect_parts(far.err, {"1 record with another place", "1 record was left out"});
  EXPECT_EQ(run(predict, aircraft("8.002")).exit_code, 0);

  std::string stands =
      "time,icao24,lat,lon,velocity,heading,vertrate,baroaltitude,geoaltitude,"
      "lastposupdate\n";
  for (int t = 0; t < 60; t += 10) {
    const std::string time = std::to_string(1'700'000'000 + t);
    stands += time + ",a00001,50.0," + std::to_string(8.0 + 0.003 * t) +
              ",215,90,0,10000,10000,1700000000\n" + time + ",b00002,52.0," +
              std::to_string(8.0 + 0.003 * t) + ",215,90,0,10000,10000," + time + "\n";
  }
  // A drone gets less far.
  std::string slow = stands.substr(0, stands.find('\n') + 1);
  for (int t = 0; t < 30; t += 5) {
    const std::string time = std::to_string(1'700'000'000 + t);
    slow += time + ",a00001,50.0," + std::to_string(8.0 + 0.0002 * t) +
            ",15,90,0,100,100,1700000000\n" + time + ",b00002,52.0," +
            std::to_string(8.0 + 0.0002 * t) + ",15,90,0,100,100," + time + "\n";
  }
  const Finished drone = run({"replay", "--threshold", "50", "--fail-on-risk"}, slow);
  EXPECT_EQ(drone.exit_code, 1) << drone.err;
  expect_parts(drone.err, {"5 records with another place"});
  const Finished replay = run({"replay", "--separation", "enroute", "--fail-on-risk"}, stands);
  EXPECT_EQ(replay.exit_code, 1) << replay.err;
  expect_parts(replay.err, {"5 records with another place", "--columns time="});
}

// Of three aircraft two were heard at one moment, and the third a little later.
TEST(NoFalseAllClear, OneFixIsNoTrack) {
  const std::string snapshot = R"({"now": 1700000000.0, "aircraft": [
{"hex":"a00001","lat":50.0,"lon":8.0,"alt_baro":30000,"gs":400,"track":90,"seen_pos":0.5},
{"hex":"a00002","lat":50.07,"lon":8.0,"alt_baro":30400,"gs":400,"track":90,"seen_pos":0.9},
{"hex":"b00003","lat":52.0,"lon":8.0,"alt_baro":30000,"gs":400,"track":90,"seen_pos":0.5}]})";
  const Finished finished = run({"replay", "--separation", "enroute", "--fail-on-risk"}, snapshot);
  EXPECT_EQ(finished.exit_code, 3) << finished.err;
  expect_parts(finished.err, {"each of the 3 aircraft has one fix only"});
}

TEST(NoFalseAllClear, OneBeeAloneIsNothingToPredict) {
  const Finished one =
      run({"predict", "--fail-on-risk"}, "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\n");
  EXPECT_EQ(one.exit_code, 1);
  expect_parts(one.err, {"conflicts  nothing to compare: fewer than two bees are known now\n"});
  const Finished two = run({"predict", "--fail-on-risk"},
                           "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\nb,0,0,900,0,1,0,0\n");
  EXPECT_EQ(two.exit_code, 0) << two.err;
  // The other one was not heard of for too long.
  const Finished stale = run({"predict", "--fail-on-risk"},
                             "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\nb,900,0,9,0,1,0,0\n");
  EXPECT_EQ(stale.exit_code, 1);
  expect_parts(stale.err, {"nothing to compare: fewer than two bees are known now; 1 bee is left"});
}

// Clocks are set back from 3 to 2 at night: sorting would mix two hours.
TEST(NoFalseAllClear, TimesThatAreSetBackAreAskedAbout) {
  std::string night = "id,timestamp,x,y,z\n";
  const auto add = [&night](const std::string& hour, int minute, int x) {
    night += "a,2015-10-25 " + hour + (minute < 10 ? ":0" : ":") + std::to_string(minute) + ":00," +
             std::to_string(x) + ",0,0\n";
  };
  for (int minute = 0; minute < 60; minute += 10) add("02", minute, minute);
  std::string in_order = night;
  for (int minute = 0; minute < 60; minute += 10) add("02", minute, 60 + minute);
  const Finished finished = run({"replay"}, night);
  EXPECT_EQ(finished.exit_code, 3);
  expect_parts(finished.err, {"<stdin>:8:2: the times of bee 'a' go back by 50 min here, as where "
                              "clocks are set back at night, and name no zone"});
  EXPECT_EQ(run({"replay"}, in_order).exit_code, 0);
  // Whatever the pace.
  const Finished slow =
      run({"replay"},
          "id,timestamp,x,y,z\na,2015-10-25 01:15:00,0,0,0\na,2015-10-25 02:00:00,1,0,0\n"
          "a,2015-10-25 02:45:10,2,0,0\na,2015-10-25 02:30:00,3,0,0\n");
  EXPECT_EQ(slow.exit_code, 3);
  expect_parts(slow.err, {"<stdin>:5:2: the times of bee 'a' go back by 15 min 10 s here"});
  // Of a place whose clocks are set back the order of the records says which is meant.
  const Finished zoned = run({"replay", "--time-zone", "Europe/Madrid"}, night);
  EXPECT_EQ(zoned.exit_code, 0) << zoned.err;
  expect_parts(zoned.err, {"(6,600.00 s)"});
  EXPECT_EQ(run({"replay", "--time-zone", "Europe/Madrid"}, in_order).exit_code, 3);
  // By day, or by days, records only are in no order.
  std::string day = night;
  for (std::size_t at = 0; (at = day.find(" 02:", at)) != std::string::npos;) {
    day.replace(at, 4, " 12:");
  }
  expect_parts(run({"replay"}, day).err, {"is at another place at the same time"});
}

// Of a picture of 500 pixels none comes closer than 2 mm, where pixels are taken for metres.
TEST(NoFalseAllClear, PixelsAreNotTakenForMetresBesideAThresholdInMillimetres) {
  std::string table = "id,t,x,y\n";
  for (int picture = 0; picture < 20; ++picture) {
    const std::string time = "2024-05-01T10:00:0" + std::to_string(picture * 0.04) + "Z";
    table += "0," + time + "," + std::to_string(100 + 2 * picture) + ",300\n";
    table += "2," + time + ",600,700\n";
    table += "1," + time + "," + std::to_string(100 + 2 * picture) + ",312\n";
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("fish.csv", table);
  const Arguments question = {file, "--threshold", "2mm"};
  for (const std::string command : {"replay", "verify"}) {
    expect_failure(Arguments{command} + question, {}, 2,
                   "are x and y in metres? Nothing names their unit");
  }
  expect_failure(Arguments{"report", "--output", folder.path("fish.html")} + question, {}, 2,
                 "--scale 0.1mm");
  expect_parts(run(Arguments{"replay", "--scale", "0.1mm"} + question).err,
               {"1 conflict of 1 pair"});
  expect_parts(run(Arguments{"replay", "--units", "position=m"} + question).err,
               {"keeps its distance"});
}

// Nothing names the unit of places, and the threshold is small: whatever their spread.
TEST(NoFalseAllClear, PlacesWithoutAUnitAreAskedAboutBesideASmallThreshold) {
  std::string table = "id,time_s,x,y\n";
  for (int t = 0; t < 20; ++t) {
    table += "a," + std::to_string(t) + ",100,100\nb," + std::to_string(t) + ",103,100\n";
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("fish.csv", table);
  for (const char* const threshold : {"2mm", "2cm", "900um"}) {
    expect_failure({"replay", file, "--threshold", threshold}, {}, 2, "--units position=mm");
    expect_failure({"watch", file, "--threshold", threshold}, {}, 2, "--units position=mm");
  }
  const Finished believed = run({"replay", file, "--threshold", "2cm", "--crs", "metres"});
  expect_parts(believed.err,
               {"places are taken as metres, as --crs metres says, beside a threshold"});
}

TEST(NoFalseAllClear, AnimalsKeptApartByHeightsAloneAreNone) {
  std::string storks =
      "event-id,visible,timestamp,location-long,location-lat,height-above-ellipsoid,"
      "sensor-type,individual-local-identifier\n";
  for (int minute = 10; minute < 20; ++minute) {
    const std::string time = ",true,2015-09-10 07:" + std::to_string(minute) + ":00.000,";
    storks += "1" + std::to_string(minute) + time + "9.1701,47.7,400,gps,Anna\n";
    storks += "2" + std::to_string(minute) + time + "9.1702,47.7,480,gps,Bert\n";
  }
  const Finished found = run({"replay", "--threshold", "50", "--fail-on-risk"}, storks);
  EXPECT_EQ(found.exit_code, 1) << found.err;
  expect_parts(found.err, {"1 pair of animals is kept apart by heights alone", "--vertical 100"});
  EXPECT_EQ(
      run({"replay", "--threshold", "50", "--vertical", "50", "--fail-on-risk"}, storks).exit_code,
      0);
}

// Heights by satellites, off by tens of metres, of two that stand beside each other.
TEST(NoFalseAllClear, WhomHeightsAloneKeepApartIsToldWithTheOptionThatCountsThem) {
  std::string cows = "id,time_s,lon,lat,height_m\n";
  for (int t = 0; t < 10; ++t) {
    const std::string time = std::to_string(600 * t);
    cows += "a," + time + ",8.0001,47,310\nb," + time + ",8.0002,47,365\n";
    cows += "c," + time + ",8.1,47,310\n";
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("cows.csv", cows);
  const Arguments question = {file, "--threshold", "50", "--fail-on-risk"};
  const std::string told =
      "1 pair comes closer than 50 m over ground, and only their heights keep them apart (a and b: "
      "7.6";
  const Finished replayed = run(Arguments{"replay"} + question);
  EXPECT_EQ(replayed.exit_code, 0);
  expect_parts(replayed.err, {"keeps its distance", told, "--vertical 100 counts it"});
  expect_parts(run(Arguments{"replay", "--vertical", "100"} + question).err,
               {"1 conflict of 1 pair"});
  expect_parts(
      run(Arguments{"plot", "--output", folder.path("c.svg"), file, "--threshold", "50"}).err,
      {told});
  expect_parts(run(Arguments{"replay", "--json"} + question).out,
               {"\"kept_by_height\": {\"pair_count\": 1, "});
  // Whom neither keeps apart, or both; and who has no heights.
  const auto says_nothing = [&](const std::string& table, const char* threshold) {
    const std::string other = folder.file("other.csv", table);
    const Finished finished = run({"replay", other, "--threshold", threshold});
    EXPECT_EQ(finished.err.find("only their heights"), std::string::npos) << finished.err;
  };
  says_nothing(cows, "60");
  says_nothing(cows, "5");
  says_nothing("id,time_s,lon,lat\na,0,8,47\nb,0,8.01,47\na,9,8,47\nb,9,8.01,47\n", "50");
}

// Millimetres: in metres these robots would cross the threshold 200 times a second.
TEST(NoFalseAllClear, PlacesThatWouldMoveTooFastInMetresAreAskedAbout) {
  std::string table = "id,time_s,x,y,z\n";
  for (int t = 0; t < 100; ++t) {
    const std::string time = std::to_string(t / 10) + "." + std::to_string(t % 10);
    table += "a," + time + "," + std::to_string(20 * t) + ",0,35\n";
    table += "b," + time + "," + std::to_string(2000 - 20 * t) + ",300,35\n";
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("robots.csv", table);
  for (const char* const command : {"replay", "verify", "watch"}) {
    expect_failure({command, file, "--threshold", "1"}, {}, 2, "in metres they move at 200 m/s");
  }
  expect_parts(run({"replay", file, "--threshold", "1", "--units", "position=mm"}).err,
               {"1 conflict of 1 pair"});
  expect_parts(run({"replay", file, "--threshold", "50"}).err, {"keeps its distance"});
}

// Slower ones, by whole numbers; and few reports, once no more come.
TEST(NoFalseAllClear, WholeNumbersThousandsWideAreAskedAboutBesideASmallThreshold) {
  const auto robots = [](int steps, double seconds, double more) {
    std::string table = "id,time_s,x,y\n";
    for (int t = 0; t < steps; ++t) {
      const std::string time = std::to_string(seconds * t);
      table += "a," + time + "," + std::to_string(20 * t + more) + ",0\n";
      table += "b," + time + "," + std::to_string(3000 - 20 * t) + ",300\n";
    }
    return table;
  };
  const TemporaryFolder folder;
  const std::string slow = folder.file("slow.csv", robots(60, 2.0, 0.0));
  for (const char* const command : {"replay", "verify", "watch"}) {
    expect_failure({command, slow, "--threshold", "1"}, {}, 2, "they are whole numbers, and go ");
    EXPECT_NE(run({command, slow, "--threshold", "1", "--crs", "metres"}).exit_code, 2) << command;
  }
  EXPECT_NE(run({"replay", slow, "--threshold", "5"}).exit_code, 2);
  const std::string decimals = folder.file("decimals.csv", robots(60, 2.0, 0.25));
  EXPECT_NE(run({"replay", decimals, "--threshold", "1"}).exit_code, 2);
  const std::string few = folder.file("few.csv", robots(8, 0.1, 0.5));
  expect_failure({"watch", few, "--threshold", "1"}, {}, 2, "in metres they move at 200 m/s");
}

}  // namespace
}  // namespace beespace::cli_test
