// `beespace watch --advise`: who is told to fly otherwise, when, and how.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/command_run.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/json_check.hpp"

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

TEST(WatchAdvice, IsToldToThoseWhoShouldNotFlyOn) {
  const Finished finished = watched({"--advise"}, head_on());
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const auto lines = lines_of(finished.out);
  ASSERT_FALSE(lines.empty());
  double before_s = 0.0;
  for (const std::string& line : lines) {
    EXPECT_TRUE(is_json(line)) << line;
    EXPECT_EQ(line.find(R"({"event": "advice", "time_s": )"), 0u) << line;
    EXPECT_EQ(line.find(R"("id": "c")"), std::string::npos) << "it is faster than 30 m/s, and may";
    expect_parts(line, {R"(, "velocity": {"vx": )", R"(, "advice": ")", R"(, "certified": )"});
    EXPECT_GT(number_in(line, "time_s"), 2.0);
    EXPECT_GE(number_in(line, "time_s"), before_s);
    before_s = number_in(line, "time_s");
  }
  EXPECT_LT(number_in(lines[0], "vx"), 8.0);
  expect_parts(lines[0], {R"("id": "a")", R"("certified": true})"});
  expect_parts(finished.err, {"advice     " + std::to_string(lines.size())});
}

TEST(WatchAdvice, IsNotToldUnlessItIsWished) {
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
    if (line.find(R"("event": "advice")") == std::string::npos) events += line + "\n";
  }
  EXPECT_GT(advised.out.size(), events.size());
  EXPECT_EQ(events, plain.out);
}

TEST(WatchAdvice, IsAboutTheLimitsThatAreGiven) {
  // All at the same time: one look; too close to stop in time.
  const std::string together = "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,8,0,0\nb,0,12,0.5,0,-8,0,0\n";
  const auto change = [&](const Arguments& more) {
    const auto lines = lines_of(watched(Arguments{"--advise"} + more, together).out);
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
  // Whoever can stop at once need not yet.
  EXPECT_EQ(watched({"--advise", "--max-acceleration", "none"}, together).out, "");
}

// The lines of advice among those of events.
std::vector<std::string> advice_in(const std::string& out) {
  std::vector<std::string> advice;
  for (const std::string& line : lines_of(out)) {
    if (line.find(R"("event": "advice")") != std::string::npos) advice.push_back(line);
  }
  return advice;
}

TEST(WatchAdvice, SaysWhoIsNotCertified) {
  const Finished finished =
      watched({"--advise"}, "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,0,0,0\nb,0,2,0,0,0,0,0\n");
  const auto lines = advice_in(finished.out);
  ASSERT_EQ(lines.size(), 2u) << finished.out;
  expect_parts(lines[0], {R"("id": "a")", R"("advice": "deflected", "certified": false})"});
  EXPECT_LT(number_in(lines[0], "vx"), 0.0);
  EXPECT_GT(number_in(lines[1], "vx"), 0.0);
  expect_parts(finished.err, {"advice     2, 2 not certified\n"});
}

TEST(WatchAdvice, IsEastNorthAndUpBetweenDegrees) {
  const Finished finished = watched({"--advise"},
                                    "id,time_s,lon,lat,height,ve,vn,vu\n"
                                    "a,0,-75.6,6.25,1500,0,8,0\nb,0,-75.6,6.2501,1500.5,0,-8,0\n");
  const auto lines = lines_of(finished.out);
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
  const Finished finished =
      watched({"--advise"}, R"({"hex": "a1b2c3", "flight": "UAL123  ", "lat": 50, )"
                            R"("lon": 10, "alt_geom": 3000, "gs": 0, "track": 0, )"
                            R"("geom_rate": 0, "seen_pos": 0, "now": 100})"
                            "\n"
                            R"({"hex": "d4e5f6", "lat": 50.00001, "lon": 10, )"
                            R"("alt_geom": 3000, "gs": 0, "track": 0, )"
                            R"("geom_rate": 0, "seen_pos": 0, "now": 100})"
                            "\n");
  const auto lines = advice_in(finished.out);
  ASSERT_EQ(lines.size(), 2u) << finished.out << finished.err;
  expect_parts(lines[0], {R"("id": "a1b2c3")", R"("certified": false, "label": "UAL123"})"});
  expect_parts(lines[1], {R"("id": "d4e5f6")", R"("certified": false})"});
}

TEST(WatchAdvice, IsNotCertifiedBesideOneWhoIsStaleOrWhoseVelocityIsNotKnown) {
  // a stays; b was last heard of beside it six seconds ago; nobody knows where c is going.
  const Finished finished = watched({"--advise", "--look-every", "7"},
                                    "id,time_s,x,y,z\n"
                                    "a,0,0,0,0\nb,0,2,0,0\na,1,0,0,0\nb,1,2,0,0\n"
                                    "a,5,0,0,0\na,7,0,0,0\nc,7,3,0,0\n");
  const auto lines = advice_in(finished.out);
  ASSERT_EQ(lines.size(), 1u) << finished.out;
  expect_parts(lines[0], {R"("id": "a")", R"("certified": false)"});
}

TEST(WatchAdvice, OptionsThatMakeNoSenseAreRefused) {
  expect_usage_error({"watch", "--max-speed", "9"}, "--max-speed is of advice; add --advise");
  expect_usage_error({"watch", "--max-acceleration", "9"}, "--max-acceleration is of advice");
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

TEST(WatchAdvice, EndsQuietlyWhenNobodyReads) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  const Finished finished =
      run({"watch", "--threshold", "5", "--horizon", "0", "--advise"}, head_on(), closed);
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

}  // namespace
}  // namespace beespace::cli_test
