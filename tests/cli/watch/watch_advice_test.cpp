// `beespace watch --advise`: which bees are told to change course, when, and how.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

// a and b fly at each other at 8 m/s, 60 m apart at first and all but in line; c is fast and far
// off. They need some 7 m each to a stop, so 5 m between them are in danger after some 2.5 s.
std::string head_on() {
  std::ostringstream text;
  text << "id,time_s,x,y,z,vx,vy,vz\n";
  for (int tenths = 0; tenths <= 27; ++tenths) {
    const double t = tenths / 10.0;
    text << "a," << t << "," << 8 * t << ",0,0,8,0,0\n";
    text << "b," << t << "," << 60 - 8 * t << ",0.5,0,-8,0,0\n";
    text << "c," << t << "," << 40 * t << ",900,0,40,0,0\n";
  }
  return text.str();
}

Finished watched(const Arguments& more, const std::string& input) {
  return run(Arguments{"watch", "--threshold", "5", "--horizon", "0"} + more, input);
}

// The value of a member that is a number.
double number_in(const std::string& line, const std::string& name) {
  const std::size_t at = line.find("\"" + name + "\": ");
  EXPECT_NE(at, std::string::npos) << name << " in " << line;
  return at == std::string::npos ? 0.0 : std::stod(line.substr(at + name.size() + 4));
}

// The lines of bees, and the lines that end a round of advice.
struct Told {
  std::vector<std::string> bees;
  std::vector<std::string> ends;
};
Told told(const Finished& finished) {
  Told told;
  for (const std::string& line : lines_of(finished.out)) {
    EXPECT_TRUE(is_json(line)) << line;
    if (line.find(R"({"event": "advice", "time_s": )") == 0) told.bees.push_back(line);
    if (line.find(R"({"event": "advised", "time_s": )") == 0) told.ends.push_back(line);
  }
  return told;
}

TEST(WatchAdvice, IsGivenToBeesThatShouldNotFlyOn) {
  const Finished finished = watched({"--advise"}, head_on());
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const Told all = told(finished);
  // The round of time 0 is late: only later have all reported.
  ASSERT_EQ(all.ends.size(), 27u);
  for (std::size_t i = 0; i < all.ends.size(); ++i) {
    EXPECT_DOUBLE_EQ(number_in(all.ends[i], "time_s"), static_cast<double>(i + 1) / 10);
    EXPECT_DOUBLE_EQ(number_in(all.ends[i], "effective_s"), static_cast<double>(i + 2) / 10);
    EXPECT_EQ(number_in(all.ends[i], "bees"), 3.0);
  }
  // Each is named once. c is faster than 30 m/s, and may be.
  ASSERT_GT(all.bees.size(), 5u);
  EXPECT_DOUBLE_EQ(number_in(all.bees[2], "time_s"), 0.1);
  expect_parts(all.bees[2], {R"("id": "c", "velocity": {"vx": 40, "vy": 0, "vz": 0})",
                             R"("advice": "as-preferred", "certified": true})"});
  for (std::size_t i = 3; i < all.bees.size(); ++i) {
    EXPECT_EQ(all.bees[i].find(R"("id": "c")"), std::string::npos) << all.bees[i];
    EXPECT_GT(number_in(all.bees[i], "time_s"), 2.0);
  }
  EXPECT_LT(number_in(all.bees[3], "vx"), 8.0);
  expect_parts(all.bees[3], {R"("id": "a")", R"("certified": true})"});
  expect_parts(finished.err, {"advice     " + std::to_string(all.bees.size())});
}

TEST(WatchAdvice, ReportsABeeThatDidNotFlyAsAdvised) {
  const Told all = told(watched({"--advise"}, head_on()));
  // They are told when to brake, and fly on.
  ASSERT_FALSE(all.bees.empty());
  expect_parts(all.bees.back(), {R"("id": "b")", R"("certified": false, "because": ")"});
  EXPECT_NE(all.ends.back().find(R"("not_as_advised": )"), std::string::npos) << all.ends.back();
}

TEST(WatchAdvice, CertifiesNoBeeWithoutVelocitiesOrAfterLongSilence) {
  std::string table = "id,time_s,x,y,z\n";
  for (const char* time : {"0", "0.1", "0.2", "0.3"}) {
    table += std::string("a,") + time + ",0,0,0\nb," + time + ",50,0,0\n";
  }
  for (const std::string& line : told(watched({"--advise"}, table)).bees) {
    expect_parts(line, {R"("certified": false, "because": "no_velocity"})"});
  }
  std::string silent = "id,time_s,x,y,z,vx,vy,vz\n";
  for (int tenths = 0; tenths <= 9; ++tenths) {
    const std::string time = "0." + std::to_string(tenths);
    silent += "a," + time + ",0,0,0,0,0,0\n";
    if (tenths <= 3) silent += "b," + time + ",50,0,0,0,0,0\n";
  }
  const Told all = told(watched({"--advise"}, silent));
  ASSERT_FALSE(all.bees.empty());
  expect_parts(all.bees.back(), {R"("id": "b")", R"("because": "old_report"})"});
  EXPECT_GT(number_in(all.bees.back(), "time_s"), 0.55);
}

TEST(WatchAdvice, NeverForgetsABeeThatIsSilent) {
  std::string table = "id,time_s,x,y,z,vx,vy,vz\n";
  for (int tenths = 0; tenths <= 90; ++tenths) {
    const std::string time = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    table += "a," + time + ",0,0,0,0,0,0\n";
    if (tenths <= 3) table += "b," + time + ",60,0,0,0,0,0\n";
  }
  const Told all = told(watched({"--advise", "--max-age", "2", "--max-speed", "10"}, table));
  // The silent b gets no advice; a makes way for it as soon as it may come close, and not before.
  bool gives_way = false;
  for (const std::string& line : all.bees) {
    const bool is_a = line.find(R"("id": "a")") != std::string::npos;
    if (is_a && number_in(line, "vx") < 0.0) gives_way = true;
    if (!is_a && number_in(line, "time_s") > 2.35) {
      expect_parts(line, {R"("id": "b", "advice": "none", "certified": false, )"
                          R"("because": "stale"})"});
    }
    // 60 m, less X and what it is widened by, less where a stops and b comes within 2.1 s.
    if (number_in(line, "time_s") < 2.35) {
      EXPECT_FALSE(gives_way) << line;
    }
  }
  EXPECT_TRUE(gives_way);
  expect_parts(all.ends.back(), {R"("bees": 2, )", R"("stale": 1)"});
}

TEST(WatchAdvice, IsAboutTheTimeAtWhichItIsFlown) {
  // They come in at 8 m/s: what is certified leaves them 5.2 m apart where they stop.
  const Finished finished = watched({"--advise"}, head_on());
  double first_s = 0.0;
  for (const std::string& line : told(finished).bees) {
    if (number_in(line, "vx") == 8.0 || number_in(line, "vx") == -8.0) continue;
    if (line.find(R"("id": "a")") == std::string::npos) continue;
    first_s = number_in(line, "effective_s");
    break;
  }
  // 60 - 16 t = 5.2 + 2 * (6.4 + 0.4 + ...): at the latest.
  EXPECT_GT(first_s, 2.0);
  EXPECT_LT(first_s, (60.0 - 5.2 - 2 * 6.8) / 16.0);
}

TEST(WatchAdvice, IsNotGivenUnlessAskedFor) {
  const Finished finished = watched({}, head_on());
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err.find("advice"), std::string::npos) << finished.err;
}

TEST(WatchAdvice, ComesBesideTheEventsAndChangesNone) {
  const Arguments wide = {"--threshold", "30", "--horizon", "5"};
  const Finished plain = run(Arguments{"watch"} + wide, head_on());
  const Finished advised = run(Arguments{"watch", "--advise"} + wide, head_on());
  std::string events;
  for (const std::string& line : lines_of(advised.out)) {
    if (line.find(R"("event": "advi)") == std::string::npos) events += line + "\n";
  }
  EXPECT_GT(advised.out.size(), events.size());
  EXPECT_EQ(events, plain.out);
}

TEST(WatchAdvice, IsAboutTheLimitsThatAreGiven) {
  // All at the same time: one look; too close to stop in time.
  const std::string together = "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,8,0,0\nb,0,12,0.5,0,-8,0,0\n";
  const auto change = [&](const Arguments& more) {
    const auto lines = told(watched(Arguments{"--advise"} + more, together)).bees;
    EXPECT_EQ(lines.size(), 2u);
    if (lines.empty()) return 0.0;
    return std::hypot(number_in(lines[0], "vx") - 8.0, number_in(lines[0], "vy"),
                      number_in(lines[0], "vz"));
  };
  // As hard as they can.
  EXPECT_NEAR(change({}), 0.5, 1e-3);
  EXPECT_NEAR(change({"--max-acceleration", "2"}), 0.2, 1e-3);
  // Without --step it is as long as it is from one look to the next.
  for (const char* option : {"--step", "--look-every"}) {
    const double in_longer = change({option, "0.4"});
    EXPECT_GT(in_longer, 1.0) << option;
    EXPECT_LT(in_longer, 2.001) << option;
  }
  // A bee that can stop at once need not brake yet.
  EXPECT_EQ(change({"--max-acceleration", "none"}), 0.0);
}

TEST(WatchAdvice, NamesBeesThatAreNotCertified) {
  const Finished finished =
      watched({"--advise"}, "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,0,0,0\nb,0,2,0,0,0,0,0\n");
  const auto lines = told(finished).bees;
  ASSERT_EQ(lines.size(), 2u) << finished.out;
  expect_parts(lines[0], {R"("id": "a")", R"("advice": "deflected", "certified": false, )"});
  EXPECT_LT(number_in(lines[0], "vx"), 0.0);
  EXPECT_GT(number_in(lines[1], "vx"), 0.0);
  expect_parts(finished.err, {"advice     2, 2 not certified\n"});
}

TEST(WatchAdvice, IsEastNorthAndUpBetweenDegrees) {
  const Finished finished = watched({"--advise"},
                                    "id,time_s,lon,lat,height,ve,vn,vu\n"
                                    "a,0,-75.6,6.25,1500,0,8,0\nb,0,-75.6,6.2501,1500.5,0,-8,0\n");
  const auto lines = told(finished).bees;
  ASSERT_EQ(lines.size(), 2u) << finished.out;
  // 11 m apart: they go on about as they flew, and change that as hard as they can.
  for (const std::size_t bee : {std::size_t{0}, std::size_t{1}}) {
    const double north = bee == 0 ? 8.0 : -8.0;
    EXPECT_NEAR(std::hypot(number_in(lines[bee], "ve"), number_in(lines[bee], "vn") - north,
                           number_in(lines[bee], "vu")),
                0.5, 1e-3)
        << lines[bee];
  }
}

TEST(WatchAdvice, NamesFlightsAsEventsDo) {
  const Finished finished = run({"watch", "--threshold", "5m", "--horizon", "0", "--advise"},
                                R"({"hex": "a1b2c3", "flight": "UAL123  ", "lat": 50, )"
                                R"("lon": 10, "alt_geom": 2000, "gs": 0, "track": 0, )"
                                R"("geom_rate": 0, "seen_pos": 0, "now": 100})"
                                "\n"
                                R"({"hex": "d4e5f6", "lat": 50.00001, "lon": 10, )"
                                R"("alt_geom": 2000, "gs": 0, "track": 0, )"
                                R"("geom_rate": 0, "seen_pos": 0, "now": 100})"
                                "\n");
  const auto lines = told(finished).bees;
  ASSERT_EQ(lines.size(), 2u) << finished.out << finished.err;
  expect_parts(lines[0], {R"("id": "a1b2c3")", R"("certified": false, )", R"("label": "UAL123"})"});
  expect_parts(lines[1], {R"("id": "d4e5f6")", R"("certified": false, "because": "heard_once"})"});
}

TEST(WatchAdvice, InvalidOptionsAreRefused) {
  expect_usage_error({"watch", "--max-speed", "0"}, "--max-speed '0'");
  expect_usage_error({"watch", "--max-acceleration", "9"}, "--max-acceleration is of advice");
  expect_usage_error({"watch", "--uncertainty", "9"}, "--uncertainty is of advice");
  expect_usage_error({"watch", "--step", "9"}, "--step is of advice; add --advise");
  expect_usage_error({"watch", "--advise", "--vertical", "9"},
                     "--advise knows distances in space only");
  for (const std::string bad : {"0", "-1", "nan", "inf", "fast"}) {
    expect_usage_error({"watch", "--advise", "--max-speed=" + bad}, "--max-speed '" + bad + "'");
    expect_usage_error({"watch", "--advise", "--max-acceleration=" + bad},
                       "--max-acceleration '" + bad + "'");
    expect_usage_error({"watch", "--advise", "--step=" + bad}, "--step '" + bad + "'");
  }
}

TEST(WatchAdvice, EndsQuietlyWhenTheReaderIsGone) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  const Finished finished =
      run({"watch", "--threshold", "5", "--horizon", "0", "--advise"}, head_on(), closed);
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

// a and b stand far from each other, and c, of which lines say so much.
std::string with_c(const std::string& c_line, int from = 0, int until = 30) {
  std::ostringstream text;
  text << "id,time_s,x,y,z,vx,vy,vz\n";
  for (int i = 0; i < 30; ++i) {
    std::ostringstream t;
    t << ',' << i / 10 << '.' << i % 10 << ',';
    text << "a" << t.str() << "0,0,0,0,0,0\nb" << t.str() << "1000,0,0,0,0,0\n";
    if (i >= from && i < until) text << "c" << t.str() << c_line << "\n";
  }
  return text.str();
}

TEST(WatchAdvice, NoBeeIsCertifiedWhileOneHasBeenHeardOfAndItIsNotKnownWhere) {
  const std::string certified = "\"certified\": 2";
  const std::string unplaced = R"("not_certified": {"unplaced_bee": 2})";
  EXPECT_NE(watched({"--advise"}, with_c("1,0,0,0,0,0", 0, 0)).out.find(certified),
            std::string::npos);
  for (const auto& [more, table] :
       {std::pair{Arguments{"--advise", "--max-bees", "2"}, with_c("500,0,0,0,0,0")},
        std::pair{Arguments{"--advise"}, with_c("1e,0,0,0,0,0")},
        std::pair{Arguments{"--advise"}, with_c("1e,0,0,0,0,0", 0, 1)},
        std::pair{Arguments{"--advise"}, with_c("500,0,0", 0, 1)}}) {
    const Finished finished = watched(more, table);
    EXPECT_EQ(finished.out.find(certified), std::string::npos) << finished.out;
    expect_parts(finished.out, {unplaced, R"("because": "unplaced_bee")"});
  }
  // Once it is heard of, or has left, it is as any.
  const std::string left = with_c("1e,0,0,0,0,0", 0, 1);
  const std::size_t at = left.find("a,1.0");
  const Finished gone =
      watched({"--advise"},
              left.substr(0, at) + "{\"event\": \"leave\", \"id\": \"c\"}\n" + left.substr(at));
  expect_parts(gone.out, {unplaced, certified});
  std::string heard = with_c("500,0,0,0,0,0");
  const std::string damaged = "c,0.0,5e0e";
  heard = heard.substr(0, heard.find("c,0.0,500")) + damaged +
          heard.substr(heard.find("c,0.0,500") + 9);
  expect_parts(watched({"--advise"}, heard).out, {"\"certified\": 3"});
}

TEST(WatchAdvice, ABeeWhoseClockIsOffIsNotCertified) {
  std::ostringstream text;
  text << "id,time_s,x,y,z,vx,vy,vz\n";
  for (int i = 0; i < 60; ++i) {
    for (const auto& [id, x, ahead_s] :
         {std::tuple{"a", 0, 0}, std::tuple{"b", 1'000, 0}, std::tuple{"c", 2'000, 60}}) {
      text << id << ',' << i / 10 + ahead_s << '.' << i % 10 << ',' << x << ",0,0,0,0,0\n";
    }
  }
  const Finished finished = watched({"--advise"}, text.str());
  expect_parts(finished.out, {R"("id": "c", "ahead_s": 60)", R"("because": "clock_off")",
                              R"("certified": 2, "not_certified": {"clock_off": 1})"});
}

}  // namespace
}  // namespace beespace::cli_test
