// Input of `beespace watch` that is left out: "no conflict" is then about the rest only, which the
// verdict says, and with --fail-on-risk the exit status.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"

namespace beespace::cli_test {
namespace {

Finished watched(const std::string& lines, const Arguments& more = {}) {
  return run(Arguments{"watch", "--threshold", "5", "--fail-on-risk"} + more,
             "id,time_s,x,y,z\n" + lines);
}

// a and b stand 100 m from each other for two seconds, with other lines after the first.
std::string apart_with(const std::string& more) {
  return "a,0,0,0,0\nb,0,100,0,0\na,1,0,0,0\nb,1,100,0,0\n" + more + "a,2,0,0,0\nb,2,100,0,0\n";
}

// Looks that are rarer tell more at a time.
std::string sorted(const std::string& lines) {
  auto all = lines_of(lines);
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

TEST(WatchTaken, OptionsThatNothingCanBeComputedWithAreRefusedAtOnce) {
  for (const auto& [option, value] : {std::pair<const char*, const char*>{"--max-age", "1e31"},
                                      {"--max-age", "1e-31"},
                                      {"--horizon", "1e31"},
                                      {"--leave-factor", "1e300"},
                                      {"--vertical", "1e31"},
                                      {"--vertical", "1e-31"}}) {
    expect_usage_error({"watch", option, value},
                       std::string(option) + " '" + value + "' cannot be computed with");
  }
  // Each for itself is fine.
  expect_usage_error({"watch", "--threshold", "1e20", "--leave-factor", "1e20"},
                     "--leave-factor '1e20' times the threshold");
  expect_usage_error({"watch", "--vertical", "1e20ft", "--leave-factor", "1e20"},
                     "--leave-factor '1e20' times the threshold");
  expect_usage_error({"watch", "--advise", "--look-every", "1e31"}, "--look-every");
  for (const char* option : {"--horizon", "--leave-factor"}) {
    expect_usage_error({"replay", "--report", "events", "-", option, "1e31"}, option);
  }
}

TEST(WatchTaken, APlaceThatIsRepeatedThoughTheBeeMovesIsNone) {
  const auto flight = [](const std::string& speed, int until_s) {
    std::string text = "id,time_s,x_m,y_m,z_m,vx,vy,vz\n";
    for (int t = 0; t <= 16; ++t) {
      const std::string time = std::to_string(t);
      text += "a," + time + "," + std::to_string(20 * std::min(t, until_s)) + ",0,0," + speed +
              ",0,0\n";
      text += "b," + time + ",9000,0,0,0,0,0\n";
    }
    return text;
  };
  const Arguments watch = {"watch", "--threshold", "5", "--fail-on-risk"};
  const Finished stale = run(watch, flight("20", 4));
  EXPECT_EQ(stale.exit_code, kRisk);
  expect_parts(stale.err,
               {"<stdin>:18: this report says the same place as for more than 3 s before",
                "bad lines  9 left out"});
  EXPECT_NE(stale.out.find("\"event\": \"stale\""), std::string::npos) << stale.out;
  // Who says no speed, or hardly any, stands there.
  EXPECT_EQ(run(watch, flight("", 0)).exit_code, 0);
  EXPECT_EQ(run(watch, flight("0", 0)).exit_code, 0);
}

TEST(WatchTaken, AnAircraftWithoutPositionsIsKnownNowhere) {
  const auto readsb = [](const char* hex, int now, const char* rest) {
    return R"({"now": )" + std::to_string(now) + R"(, "hex": ")" + hex +
           R"(", "seen_pos": 0, "lat": 33, "lon": )" + rest + "}\n";
  };
  std::string lines;
  for (int now = 1000; now < 1003; ++now) {
    lines += readsb("aaaaaa", now, R"(-117.0, "alt_geom": 3000)");
    lines +=
        readsb("bbbbbb", now, R"(-117.0, "alt_baro": 3000)");  // no height of the kind asked for
    lines += readsb("cccccc", now, R"(-116.0, "alt_geom": 3000)");
  }
  const Arguments watch{"watch", "--threshold", "5NM", "--vertical", "1000ft", "--fail-on-risk"};
  Finished finished = run(watch + Arguments{"--heights", "geometric"}, lines);
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err,
               {"verdict    no conflict among what was taken; 1 bee is known nowhere\n"});
  // It is known once it has reported.
  finished = run(watch + Arguments{"--heights", "geometric"},
                 lines + readsb("bbbbbb", 1003, R"(-115.0, "alt_geom": 3000)") +
                     readsb("bbbbbb", 1004, R"(-115.0, "alt_geom": 3000)"));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;

  const auto message = [](const std::string& kind, const std::string& hex, int second,
                          const std::string& rest) {
    return "MSG," + kind + ",1,1," + hex + ",1,2024/05/01,12:00:0" + std::to_string(second) +
           ".000,2024/05/01,12:00:00.000," + rest + "\n";
  };
  std::string messages;
  for (int second = 0; second < 3; ++second) {
    messages += message("3", "4B1814", second, ",10000,,,47.25,8.5,,,0,0,0,0");
    messages += message("1", "4B1815", second, "SWR1,,,,,,,,,,,");
  }
  finished = run(watch, messages);
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err, {"1 bee is known nowhere\n"});
}

TEST(WatchTaken, InputOfWhichNoReportIsTakenIsBadInput) {
  for (const std::string line : {"a,0,1e40,0,0\n", "a,0,0,nan,0\n", "a,soon,0,0,0\n"}) {
    expect_failure({"watch", "--quiet"}, "id,time_s,x,y,z\n" + line, kBadInput, "");
  }
  // What is only over the ends of the domain as metres.
  expect_failure({"watch", "--quiet"}, "id,time_s,x_km,y_km,z_km\na,0,1.2e30,0,0\n", kBadInput, "");
}

TEST(WatchTaken, ThatAllIsTakenIsFine) {
  for (const std::string harmless : {"", "\n\n", "a,1,0,0,0\nb,1,100,0,0\na,1,0,0,0\n"}) {
    const Finished finished = watched(apart_with(harmless));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.err, {"verdict    no conflict\n"});
  }
}

TEST(WatchTaken, WhatCouldNotBeReadIsUnknown) {
  const Finished finished = watched(apart_with("rubbish\nc,1,oops,0,0\nc,1,oops,0,0\n"));
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err, {"verdict    no conflict among what was taken; 3 lines were left out, "
                              "1 bee is known nowhere\n"});
}

TEST(WatchTaken, WhatCameTooLateIsUnknown) {
  // b was at a.
  const Finished finished = watched(apart_with("b,0.5,0,0,0\n"));
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err, {"late       1 left out\n", "no conflict among what was taken; ",
                              "1 report came too late\n"});
}

TEST(WatchTaken, ABeeAtTwoPlacesAtOneTimeIsReported) {
  for (const std::string contrary : {"b,1,0,0,0\n", "b,0,0,0,0\n"}) {
    const Finished finished = watched(apart_with(contrary));
    EXPECT_EQ(finished.exit_code, kRisk);
    EXPECT_EQ(finished.out, "");
    expect_parts(
        finished.err,
        {"beespace: left out: b is said to be at two places at ", "contrary   1 left out\n",
         "no conflict among what was taken; 1 report contradicts another one\n"});
  }
  // In height alone, where that is compared apart.
  const Finished high =
      run({"watch", "--threshold", "5", "--vertical", "2", "--fail-on-risk", "--crs", "wgs84"},
          "id,time_s,lon,lat,height\na,0,8,47,0\na,0,8,47,10\na,1,8,47,0\n");
  EXPECT_EQ(high.exit_code, kRisk);
  expect_parts(high.err, {"contrary   1 left out\n"});
}

TEST(WatchTaken, ABeeHeardOnceIsUnknown) {
  const Finished finished = watched("a,0,0,0,0\nb,0.5,1,0,0\n");
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err, {"verdict    no conflict; 2 bees were heard of once only\n"});
  EXPECT_EQ(watched("a,0,0,0,0\nb,0.5,1,0,0\n", {"--max-speed", "1"}).exit_code, kRisk);
  EXPECT_EQ(watched(apart_with("c,0,0,900,0\n")).exit_code, kRisk);
  EXPECT_EQ(watched(apart_with("c,1,0,900,0\n{\"event\": \"leave\", \"id\": \"c\"}\n")).exit_code,
            0);
}

TEST(WatchTaken, AConflictThatLiesAheadAtTheEndIsARisk) {
  const std::string table = "a,0,0,0,0\nb,0,100,0,0\na,1,0,0,0\nb,1,80,0,0\n";
  const Finished finished = watched(table);
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.out, {"\"predicted\""});
  expect_parts(finished.err,
               {"verdict    no conflict; 1 predicted conflict lay ahead at the end\n"});
  // It turns away.
  EXPECT_EQ(watched(table + "a,2,0,0,0\nb,2,90,0,0\n").exit_code, 0);
}

// a comes along x, b along y, and both are at 0 at 10 s; b's clock is ahead as it says.
std::string meeting(double ahead_s, double lasts_s) {
  std::ostringstream text;
  for (int t = 0; t <= lasts_s; ++t) {
    text << "a," << 1'000 + t << "," << -200 + 20 * t << ",0,0\n";
    text << "b," << 1'000 + t + ahead_s << ",0," << -200 + 20 * t << ",0\n";
  }
  return text.str();
}

TEST(WatchTaken, AClockThatIsBehindHidesNoConflict) {
  for (const double ahead_s : {-2.1, -3.0, -4.0, -4.9, -6.0, -100.0, 3.0, 100.0}) {
    const Finished finished = watched(meeting(ahead_s, 20.0));
    EXPECT_EQ(finished.exit_code, kRisk) << ahead_s;
    expect_parts(finished.out, {"\"clock\"", "\"entered\""});
    expect_parts(finished.err, {"verdict    1 conflict", "1 bee's clock was off"});
  }
  // Before it is clear whether b is late only.
  const Finished soon = watched(meeting(-3.0, 4.0), {"--horizon", "0"});
  EXPECT_EQ(soon.exit_code, kRisk);
  expect_parts(soon.err, {"no conflict", "1 bee's clock was off"});
}

TEST(WatchTaken, WhereAClockStepsItsBeeIsUnknown) {
  // b comes towards a; then its clock steps, and its reports are left out for a while.
  // Reports that are a little late are believed until it is clear that the clock is off.
  for (const auto& [step_s, since] :
       {std::pair{100.0, "1004"}, {-100.0, "1004"}, {-3.5, "1005.5"}}) {
    std::ostringstream text;
    for (int t = 0; t <= 20; ++t) {
      const double ahead_s = t < 5 ? 0.0 : step_s;
      text << "a," << 1'000 + t << ",0,0,0\n";
      text << "c," << 1'000 + t << ",0,5000,0\n";
      text << "b," << 1'000 + t + ahead_s << "," << 1'000 - 10 * t << ",0,0\n";
    }
    const Finished finished = watched(text.str(), {"--horizon", "0"});
    EXPECT_EQ(finished.exit_code, kRisk) << step_s;
    expect_parts(finished.out,
                 {R"({"event": "stale", "time_s": )" + std::string(since) + R"(, "id": "b"})",
                  R"("since_s": )" + std::string(since) + R"(, "id": "b")"});
    expect_parts(finished.err, {"unknown    1 bee for "});
    EXPECT_EQ(finished.out.find(R"("id": "a")"), std::string::npos) << finished.out;
  }
}

TEST(WatchTaken, ASilentBeeStaysUnknownWhenAllClocksBeginAnew) {
  std::ostringstream text;
  for (int t = 0; t < 60; ++t) {
    const int time_s = t < 30 ? 100 + t : t - 30;
    text << "a," << time_s << ",0,0,0\nb," << time_s << ",1000,0,0\n";
    if (t < 3) text << "w," << time_s << ",0,2000,0\n";
    // Heard of until just before.
    if (t < 29) text << "v," << time_s << ",0,3000,0\n";
  }
  const Finished finished = watched(text.str());
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.out, {R"("event": "clocks_anew")",
                              R"({"event": "stale", "time_s": 102, "id": "w"})", R"("id": "v"})"});
  expect_parts(finished.err, {"bees       2 heard of, 2 stale\n", "unknown    2 bees for ", "w 5",
                              "2 bees were unknown for a time", "all clocks began anew"});
  // With a greatest speed, possible conflicts and the next report are events.
  const Finished fast = watched(text.str() + "w,31,0,2000,0\n", {"--max-speed", "100"});
  expect_parts(fast.out, {"\"possible\"", R"("event": "heard", "time_s": 31)"});
}

TEST(WatchTaken, AnotherHeaderIsNoRecord) {
  const std::string header = "id,time_s,x,y,z\n";
  EXPECT_EQ(watched(apart_with(header)).exit_code, 0);
  EXPECT_EQ(watched(header + apart_with("")).exit_code, 0);
  for (const std::string other : {"id,time_s,x_ft,y_ft,z_ft\n", "id,time_s,y,x,z\n",
                                  "id,time_s,lon,lat,height\n", "time_s,id,x,y,z,vx,vy,vz\n"}) {
    for (const std::string& table : {apart_with(other), other + apart_with("")}) {
      const Finished finished = watched(table);
      EXPECT_EQ(finished.exit_code, kBadInput) << other << finished.err;
      expect_parts(finished.err, {"another header, "});
    }
  }
  // With given columns.
  expect_failure({"watch", "--columns", "id=1,time=2,x=3,y=4,z=5", "--time-unit", "s"},
                 "a,0,0,0,0\nb,0,1,0,0\nid,time_s,x_ft,y_ft,z_ft\nb,1,30,0,0\n", kBadInput,
                 "<stdin>:3: another header, ");
}

TEST(WatchTaken, ADuplicateKeyIsReported) {
  const Finished finished = run({"watch", "--fail-on-risk", "--threshold", "5"},
                                "{\"id\": \"a\", \"time_s\": 0, \"x\": 0, \"y\": 0}\n"
                                "{\"id\": \"a\", \"time_s\": 1, \"x\": 0, \"y\": 0, \"x\": 9}\n"
                                "{\"id\": \"a\", \"time_s\": 2, \"x\": 0, \"y\": 0}\n");
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err,
               {"left out: <stdin>:2: 'x' is there twice", "bad lines  1 left out\n"});
  expect_failure({"watch"}, "{\"id\": \"a\", \"id\": \"b\", \"time_s\": 0, \"x\": 0, \"y\": 0}\n",
                 kBadInput, "'id' is there twice");
}

// Possible events between two looks are the same, however often looks are taken.
TEST(WatchTaken, APossibleConflictBetweenTwoLooksIsReported) {
  const std::string table =
      "a,0.01,0,0,0\nb,0.01,1000,0,0\na,5.05,0,0,0\nb,5.05,1000,0,0\na,5.5,0,0,0\nb,5.5,1000,0,0\n";
  const std::string others =
      "a,0,0,0,0\nb,0,1000,0,0\na,1.4,0,0,0\na,2.8,0,0,0\na,4.2,0,0,0\na,5.6,0,0,0\n"
      "b,5.9,1000,0,0\na,7,0,0,0\nb,7,1000,0,0\n";
  for (const std::string& lines : {table, others}) {
    std::string first;
    for (const char* every : {"0.01", "0.1", "1", "10"}) {
      const Finished finished =
          watched(lines, {"--max-speed", "200", "--look-every", every, "--horizon", "0"});
      EXPECT_EQ(finished.exit_code, kRisk) << every << finished.out;
      expect_parts(finished.out, {"\"possible\""});
      if (first.empty()) first = sorted(finished.out);
      EXPECT_EQ(sorted(finished.out), first) << every;
    }
  }
}

// Two that pass each other ten times a second, the first of them said to be elsewhere meanwhile.
std::string passing(const std::function<std::string(int i)>& place_of_a, int until_b = 100) {
  std::string text = "id,time_s,x_m,y_m\n";
  for (int i = 0; i < 100; ++i) {
    const std::string time = "," + std::to_string(i / 10) + "." + std::to_string(i % 10) + ",";
    const std::string place = place_of_a(i);
    if (!place.empty()) text += "a" + time + place + "\n";
    if (i < until_b) text += "b" + time + std::to_string(7.0 - 0.05 * i) + ",0.3\n";
  }
  return text;
}

std::string by_itself(int i) {
  return std::to_string(2.0 + 0.05 * i) + ",0";
}

const Arguments kWatchClosely = {"watch", "--threshold", "0.5", "--fail-on-risk"};

TEST(WatchTaken, ThePlaceThatAFrozenPoseHasLeftIsNotKnown) {
  ASSERT_EQ(run(kWatchClosely, passing(by_itself)).exit_code, kRisk);
  const Finished frozen =
      run(kWatchClosely, passing([](int i) { return by_itself(i >= 20 && i < 90 ? 20 : i); }));
  EXPECT_EQ(frozen.exit_code, kRisk);
  expect_parts(frozen.err,
               {"a jumps in line 182, 9 s, more than three times as far and as fast as before, out "
                "of a place that it had repeated exactly",
                "1 bee repeats a place that it has left"});
  // One that stands far from the other, and goes on as it came.
  const Finished stands =
      run(kWatchClosely, passing([](int i) {
            return std::to_string(-2.0 + 0.05 * std::min(i, std::max(40, i - 30))) + ",9";
          }));
  EXPECT_EQ(stands.exit_code, 0) << stands.err;
}

// Also where it says that it stands, and its velocities cannot have led it on from there.
TEST(WatchTaken, ThePlaceOutOfWhichItJumpsAgainstItsVelocitiesIsNotKnown) {
  const auto told = [](int freezes_until) {
    std::string text = "id,time_s,x_m,y_m,vx,vy\n";
    for (int i = 0; i < 150; ++i) {
      const bool stands = i > 50 && i < freezes_until;
      const std::string time = "," + std::to_string(i / 10) + "." + std::to_string(i % 10) + ",";
      text += "a" + time + std::to_string(0.1 * (stands ? 50 : i)) +
              (stands ? ",0,0,0\n" : ",0,1,0\n") + "b" + time + "0,90,0.0,0.0\n";
    }
    return text;
  };
  const Finished frozen = run(kWatchClosely, told(110));
  EXPECT_EQ(frozen.exit_code, kRisk);
  expect_parts(frozen.err, {"1 bee repeats a place that it has left"});
  EXPECT_EQ(run(kWatchClosely, told(0)).exit_code, 0);
}

// The same with its velocity, or with noise, or neither, to the end.
TEST(WatchTaken, APoseThatIsFrozenToTheEndIsNoAllClear) {
  std::string own = "id,time_s,x_m,y_m,vx,vy\n";
  std::string noisy = "id,time_s,x_m,y_m\n";
  std::string computed = noisy;
  for (int i = 0; i < 100; ++i) {
    const std::string time = "," + std::to_string(i / 10) + "." + std::to_string(i % 10) + ",";
    const int at = std::min(i, 50);
    const double noise = 0.002 * std::sin(1e4 * at * at);
    own += "a" + time + std::to_string(0.05 * at) + ",0,0.5,0\nb" + time + "0,9,0.0,0.0\n";
    noisy += "a" + time + std::to_string(0.05 * at + noise) + ",0\nb" + time + "0,9\n";
    computed += "a" + time + std::to_string(0.05 * at) + ",0\nb" + time + "0,9\n";
  }
  const Finished moves = run(kWatchClosely, own);
  EXPECT_EQ(moves.exit_code, kRisk);
  expect_parts(moves.err, {"though the bee has moved on by its own velocity"});
  const Finished wavers = run(kWatchClosely, noisy);
  EXPECT_EQ(wavers.exit_code, kRisk);
  expect_parts(wavers.err, {"no conflict; 1 bee repeats its place exactly to the end"});
  const Finished stops = run(kWatchClosely, computed);
  EXPECT_EQ(stops.exit_code, 0) << stops.err;
  expect_parts(stops.err, {"bee 'a' stops at once, from one fix to the next"});
}

TEST(WatchTaken, ZeroOfMetresToWhichABeeOnlyJumpsIsNoPlace) {
  const Finished lost = run(
      kWatchClosely, passing([](int i) { return i >= 30 && i < 90 ? "0.0,-0.0" : by_itself(i); }));
  EXPECT_EQ(lost.exit_code, kRisk);
  expect_parts(lost.err, {"this report is at 0, 0, 0 exactly", "bad lines  60 left out"});
  // With which it begins: then what comes later tells.
  const Finished first =
      run(kWatchClosely, passing([](int i) { return i < 60 ? "0,0" : by_itself(i); }));
  EXPECT_EQ(first.exit_code, kRisk);
  expect_parts(first.err, {"1 bee's places were none for a time, as what came later shows"});
  // Where it goes through as it moves elsewhere.
  const Finished through =
      run(kWatchClosely, passing([](int i) { return std::to_string(0.05 * (i - 50)) + ",9"; }));
  EXPECT_EQ(through.exit_code, 0) << through.err;
}

TEST(WatchTaken, WhoFallsSilentBeforeTheEndIsNotKnownFromThenOn) {
  const auto far = [](int i) { return std::to_string(2.0 + 0.05 * i) + ",90"; };
  const Finished silent = run(kWatchClosely, passing(far, 60));
  EXPECT_EQ(silent.exit_code, kRisk);
  expect_parts(silent.err, {"no conflict; 1 bee fell silent before the end"});
  // By no more than five times as long as between its reports.
  EXPECT_EQ(run(kWatchClosely, passing(far, 96)).exit_code, 0);
  // Nor by less than the other's reports are apart.
  const Finished seldom =
      run(kWatchClosely, passing([&](int i) { return i % 20 == 0 ? far(i) : std::string(); }, 65));
  EXPECT_EQ(seldom.exit_code, 0) << seldom.err;
}

// replay says: nothing to compare.
TEST(WatchTaken, OneBeeAloneIsNoAllClear) {
  const Finished finished = run({"watch", "--threshold", "5", "--fail-on-risk"},
                                "id,time_s,x_m,y_m,z_m\na,0,0,0,5\na,1,1,0,5\na,2,2,0,5\n");
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.err, {"no conflict; one bee alone was heard of, and no pair"});
}

TEST(WatchTaken, FramesOfRosThatBeginAnywhereAreNotCompared) {
  const std::string header =
      "header.stamp.sec,header.stamp.nanosec,header.frame_id,child_frame_id,pose.pose.position.x,"
      "pose.pose.position.y,pose.pose.position.z\n";
  const std::vector<std::string> watch = {"watch", "--threshold", "0.5", "--fail-on-risk"};
  for (const std::string frames : {"odom,odom", "r1/odom,r2/odom"}) {
    const std::size_t comma = frames.find(',');
    const Finished finished =
        run(watch, header + "1750000000,0," + frames.substr(0, comma) + ",r1,0,0,0\n1750000000,1," +
                       frames.substr(comma + 1) + ",r2,5,0,0\n");
    EXPECT_EQ(finished.exit_code, kRisk);
    expect_parts(finished.err, {"left out: <stdin>:3: this position", "frame", "of ROS"});
  }
}

}  // namespace
}  // namespace beespace::cli_test
