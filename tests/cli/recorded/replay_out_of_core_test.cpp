// `beespace replay --memory`: the answers of the same command without it, byte for byte, what it
// says beside them, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

class ReplayOutOfCore : public testing::Test {
 protected:
  [[nodiscard]] Finished small(const Arguments& arguments, std::string_view input = {},
                               const Surroundings& surroundings = {}) const {
    return run(
        Arguments{"replay"} + arguments +
            Arguments{"--memory", "17MB", "--threads", "1", "--temporary", scratch_.path("")},
        input, surroundings);
  }

  // An answer without what is not looked at with --memory: pairs that heights alone keep apart.
  static std::string without_heights(std::string answer) {
    // Nor is it looked for the longest gap that is bridged.
    const std::size_t bridged = answer.find("\"longest_bridged\": ");
    if (bridged != std::string::npos) {
      const std::size_t comma = answer.rfind(',', bridged);
      const std::size_t value = answer.find(": ", bridged) + 2;
      const bool none = answer.compare(value, 4, "null") == 0;
      answer.erase(comma, (none ? value + 4 : answer.find('}', value) + 1) - comma);
    }
    const std::size_t begins = answer.find("\"kept_by_height\": ");
    if (begins == std::string::npos) return answer;
    const std::size_t ends = answer.find("\"closest\": ", begins);
    return answer.erase(begins, ends - begins);
  }

  // With --memory the worst moments are not looked for, and the closest are of the straight line.
  static std::string without_worst_columns(const std::string& table) {
    if (table.starts_with('{')) {
      return std::regex_replace(table, std::regex(R"(,\s*"worst[^"]*": (\{[^}]*\}|[^,{}]*))"), "");
    }
    const char delimiter = table.find('\t') != std::string::npos ? '\t' : ',';
    std::string rest;
    std::vector<bool> kept;
    for (const std::string& line : lines_of(table)) {
      const auto fields = fields_of(line, delimiter);
      for (std::size_t i = kept.size(); i < fields.size(); ++i) {
        kept.push_back(!fields[i].starts_with("worst"));
      }
      std::string row;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (kept[i]) row += (row.empty() ? "" : std::string(1, delimiter)) + fields[i];
      }
      rest += row + '\n';
    }
    return rest;
  }
  static std::string without_worst_lines(const std::string& summary) {
    std::string rest;
    bool worst = false;
    for (const std::string& line : lines_of(summary)) {
      const bool goes_on = line.starts_with("             ");
      worst = line.starts_with("  closest") || line.starts_with("  worst") || (worst && goes_on);
      if (!worst) rest += line + '\n';
    }
    return rest;
  }

  // The summary without that, and what is said of memory and time, and of the closest over time.
  static std::string known_lines(const std::string& summary) {
    std::string known;
    bool over_time = false;
    for (const std::string& line : lines_of(summary)) {
      const bool goes_on = line.starts_with("             ");
      over_time = line.starts_with("  over time") || (over_time && goes_on);
      if (over_time || line.starts_with("  memory") || line.starts_with("  time")) continue;
      if (line.starts_with("  bridged")) continue;
      if (line.find("only their heights keep") != std::string::npos) continue;
      if (line.find("whether heights alone keep") != std::string::npos) continue;
      known += line + '\n';
    }
    return known;
  }

  // All that is written is the same, at least so much. With --memory velocities are not looked at.
  void expect_same(const Arguments& more, std::string_view input = {},
                   std::size_t least = 100) const {
    const Arguments arguments = more + Arguments{"--straight"};
    Finished expected = run(Arguments{"replay"} + arguments, input);
    Finished found = small(arguments, input);
    if (std::find(more.begin(), more.end(), "--vertical") != more.end()) {
      expected.out = without_worst_columns(expected.out);
      expected.err = without_worst_lines(expected.err);
      found.err = without_worst_lines(found.err);
    }
    EXPECT_EQ(found.exit_code, expected.exit_code) << found.err;
    EXPECT_GE(expected.out.size(), least) << expected.err;
    EXPECT_TRUE(without_heights(found.out) == without_heights(expected.out))
        << found.out.substr(0, 1000) << "\ninstead of\n"
        << expected.out.substr(0, 1000);
    EXPECT_EQ(known_lines(found.err), known_lines(expected.err));
    EXPECT_TRUE(scratch_.names().empty());
  }

  void expect_same_error(const Arguments& arguments, const std::string& input,
                         const std::string& more = {}) const {
    const Finished expected = run(Arguments{"replay"} + arguments, input);
    const Finished found = small(arguments, input);
    EXPECT_NE(expected.exit_code, 0);
    EXPECT_EQ(found.exit_code, expected.exit_code);
    EXPECT_EQ(found.out, "");
    if (more.empty()) {
      EXPECT_EQ(found.err, expected.err);
    } else {
      expect_parts(found.err, {more});
    }
  }

  // Of a hundred bees, which all report once a second; in windows of time.
  [[nodiscard]] std::string flight(const std::string& name, int seconds = 2000) const {
    const std::string path = folder_.path(name);
    EXPECT_EQ(run({"generate", "--scene", "flight", "--points", "100", "--size", "200",
                   "--duration", std::to_string(seconds), "--quiet", "--output", path})
                  .exit_code,
              0);
    return path;
  }

  TemporaryFolder folder_;
  TemporaryFolder scratch_;
};

TEST_F(ReplayOutOfCore, AnswersInEveryForm) {
  // To and fro on a line, at speeds of their own: some gaps, and more fixes than a window has.
  std::string text = "id,time_s,x,y\n";
  for (int second = 0; second < 10'000; ++second) {
    for (int bee = 0; bee < 50; ++bee) {
      if ((second + 13 * bee) % 1000 < 3) continue;
      const int at = (second * (bee % 7 + 1) + 37 * bee) % 400;
      text += std::to_string(bee) + "," + std::to_string(second) + "," +
              std::to_string(std::min(at, 400 - at)) + "," + std::to_string(20 * (bee % 25)) + "\n";
    }
  }
  const std::string file = folder_.file("lines.csv", text);
  for (const Arguments& more :
       {Arguments{}, Arguments{"--json", "--inclusive"}, Arguments{"--report", "bees", "--csv"},
        Arguments{"--report", "pairs"}, Arguments{"--max-gap", "3", "--csv"}}) {
    expect_same(Arguments{file, "--threshold", "5"} + more);
  }
  for (const Arguments& more : {Arguments{}, Arguments{"--json", "--units", "aviation"},
                                Arguments{"--report", "bees", "--csv"}}) {
    expect_same(Arguments{file, "--threshold", "5", "--vertical", "2", "--max-gap", "never"} +
                more);
  }
  const Finished told = small({file, "--threshold", "5", "--output", folder_.path("answer.tsv")});
  EXPECT_EQ(told.err.find("over time"), std::string::npos);
  EXPECT_NE(told.err.find("windows of time"), std::string::npos) << told.err;
}

TEST_F(ReplayOutOfCore, ReadsSeveralFilesCompressedOnesAndStandardInput) {
  const std::string file = flight("flight.csv", 300);
  const std::vector<std::string> lines = lines_of(folder_.read("flight.csv"));
  std::string even = lines[0] + '\n';
  std::string odd = even;
  std::string mixed = even;
  for (std::size_t at = 1; at < lines.size(); ++at) {
    (at % 2 == 0 ? even : odd) += lines[at] + '\n';
    // Back in time, again and again; and now and then a line comes again.
    const std::string& other = lines[1 + (at * 7919) % (lines.size() - 1)];
    mixed += other + '\n';
    if (at % 1000 == 0) mixed += other + '\n';
  }
  const std::string first = folder_.file("first.csv", even);
  const std::string second = folder_.file("second.csv", odd);
  ASSERT_EQ(std::system(("gzip -k " + second).c_str()), 0);
  expect_same({first, second + ".gz", "--threshold", "5"});
  expect_same({"--threshold", "5"}, mixed);
  expect_same({folder_.path(""), "--threshold", "5", "--one-clock"});
}

TEST_F(ReplayOutOfCore, DegreesAndHeightsInFeet) {
  std::string text = "id,time_s,lon,lat,altitude_ft\n";
  for (int second = 0; second < 3000; ++second) {
    for (int bee = 0; bee < 10; ++bee) {
      // To and fro: who jumps back is not known meanwhile.
      const int way = (second * (bee + 3)) % 1'940;
      const double away = 1e-5 * std::min(way, 1'940 - way);
      text += "a" + std::to_string(bee) + "," + std::to_string(second) + "," +
              std::to_string(8.5 + away) + "," + std::to_string(47.4 - away) + "," +
              std::to_string(1000 + 30 * bee + second % 7) + "\n";
    }
  }
  const std::string file = folder_.file("air.csv", text);
  expect_same({file, "--threshold", "50"});
  expect_same({file, "--threshold", "50", "--vertical", "60 ft"});
  expect_same({file, "--threshold", "50", "--vertical", "60 ft", "--inclusive", "--csv"});
  expect_same({file, "--threshold", "50", "--vertical", "15 m", "--report", "bees"});
  expect_same({file, "--threshold", "50", "--vertical", "60 ft", "--json"});
}

// When two are closest lies between two fixes, at one, at the first and at the last; heights are z.
TEST_F(ReplayOutOfCore, HowFarApartTwoWereIsReadBack) {
  std::string text = "id,time_s,x,y,z\n";
  for (int second = 0; second <= 4000; second += 4) {
    for (int bee = 0; bee < 20; ++bee) {
      if (second % 400 < 4 * (bee % 3)) continue;
      const int at = (second * (bee % 5 + 1) + 53 * bee) % 600;
      text += "b" + std::to_string(bee) + "," + std::to_string(second + bee % 2) + "," +
              std::to_string(0.37 * std::min(at, 600 - at)) + "," + std::to_string(7 * (bee % 6)) +
              "," + std::to_string(0.71 * ((second / 4 + bee) % 11)) + "\n";
    }
  }
  const std::string file = folder_.file("up.csv", text);
  const Arguments asked = {file, "--threshold", "8", "--vertical", "3", "--max-gap", "20"};
  expect_same(asked + Arguments{"--csv"}, {}, 20'000);
  expect_same(asked + Arguments{"--report", "bees"});
}

// As Movebank has them: a column of heights, and none in it.
TEST_F(ReplayOutOfCore, HeightsThatAreEmptyThroughoutAreNone) {
  std::string text =
      "event.id,visible,timestamp,location.long,location.lat,height.above.ellipsoid,"
      "individual.local.identifier\n";
  constexpr int kRows = 24'000;  // more than are looked at before the first is read
  for (int row = 0; row < kRows; ++row) {
    const int second = row / 2;
    const auto two = [](int number) { return std::to_string(100 + number).substr(1); };
    text += std::to_string(row) + (row % 500 == 7 ? ",FALSE," : ",TRUE,") + "2020-05-01 " +
            two(second / 3600) + ":" + two(second / 60 % 60) + ":" + two(second % 60) + "," +
            std::to_string(9.1 + 1e-6 * (row % 2 == 0 ? second % 50 : 49 - second % 50)) +
            ",47.5,NA," + (row % 2 == 0 ? "Anna" : "Bert") + "\n";
  }
  ASSERT_GT(text.size(), (std::size_t{1} << 20U) + (std::size_t{1} << 17U));
  const std::string file = folder_.file("birds.csv", text);
  expect_same({file, "--threshold", "1", "--csv"}, {}, 10'000);
  expect_same({file, "--threshold", "1", "--vertical", "5"});
  expect_same({"--threshold", "1"}, text.substr(0, text.find('\n', 5000) + 1));

  // In memory, all records without one are left out then.
  const std::string late = text + "x,TRUE,2020-05-01 07:00:00,9.2,47.5,55.5,Anna\n";
  for (const Arguments& more : {Arguments{}, Arguments{"--skip-bad"}}) {
    const Finished finished = small(Arguments{"--threshold", "1"} + more, late);
    EXPECT_EQ(finished.exit_code, 3);
    EXPECT_EQ(finished.out, "");
    expect_parts(finished.err, {"<stdin>:24002:6: a height, '55.5', comes here", "--columns"});
  }
  const Arguments flat = {"--threshold", "1", "--columns", "id=7,time=3,lon=4,lat=5"};
  expect_same(flat, late, 10'000);
}

// That they are metres is said by values that are not the last ones.
TEST_F(ReplayOutOfCore, ValuesOfAllFixesMayContradictDegrees) {
  expect_same({"--threshold", "10"},
              "id,time_s,x,y\na,0,500,700\na,1,250,350\na,2,1.5,2.5\nb,0,900,100\nb,1,400,50\n"
              "b,2,8.5,3.25\n",
              10);
}

// Without a conflict, and what is unknown: never a false all-clear.
TEST_F(ReplayOutOfCore, SaysWhatIsUnknown) {
  const std::string header = "id,time_s,x,y,z\n";
  std::string text = header;
  for (int t = 0; t <= 7230; ++t) {
    text += "b," + std::to_string(t) + ",0,0,0\n";
    if (t <= 10) text += "a," + std::to_string(t) + ",-1000,0,0\n";
    if (t >= 7211) text += "a," + std::to_string(t) + ",1000,0,0\n";
  }
  const Finished finished = small({"--threshold", "5", "--fail-on-risk"}, text);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"no conflict in the known time; 1 bee unknown for 2 h in all",
                "5 s, 5 times the typical interval of 1 s (--max-gap)", "a from 10.00 s for 2 h"});
  EXPECT_EQ(finished.err.find("keeps its distance"), std::string::npos);
  EXPECT_EQ(finished.err.find("closest"), std::string::npos);
  const Finished clear = small({"--threshold", "5"}, header + "a,0,0,0,0\nb,0,9,9,9\n");
  expect_parts(clear.err, {"verdict    keeps its distance"});
  const Finished none = small({"--threshold", "5"}, header + "a,0,0,0,0\nb,1,9,9,9\n");
  expect_parts(none.err, {"nothing to compare"});
  const Finished skipped = small({"--threshold", "5", "--skip-bad", "--fail-on-risk"},
                                 header + "a,0,0,0,0\nb,0,9,9,9\nc,0,9,x,9\n");
  EXPECT_EQ(skipped.exit_code, 1);
  expect_parts(skipped.err, {"1 bee is known nowhere, 1 record was left out"});
}

TEST_F(ReplayOutOfCore, ErrorsAreThoseInMemory) {
  const std::string header = "id,time_s,x,y,z\n";
  for (const std::string& text :
       {header, std::string(), header + "a,0,0,0,0\na,1,0,x,0\n", header + "a,0,0,0\n",
        std::string("id,time_s,east\n1,2,3\n"), header + "a,0,nan,0,0\n"}) {
    expect_same_error({"--threshold", "5"}, text);
  }
  expect_same_error({"--threshold", "-1"}, header + "a,0,0,0,0\n");
  expect_same_error({"--threshold", "5", "--max-results", "0"}, header + "a,0,0,0,0\nb,0,1,0,0\n");
  expect_same_error({folder_.path("missing.csv")}, {});
  // Of bees at two places at one time the first line that says so.
  std::string clash = header;
  for (int t = 0; t < 50'000; ++t) clash += "a," + std::to_string(t) + ",1,2,3\n";
  clash += "b,7,0,0,0\na,49000,5,5,5\na,7,6,6,6\n";
  expect_same_error({"--threshold", "5"}, clash,
                    "<stdin>:50003: bee 'a' is at another place at the same time, 49000 s, in "
                    "<stdin>, line 49002");
}

TEST_F(ReplayOutOfCore, RefusesWhatItCannotDo) {
  const std::string table = "id,time_s,x,y,z\na,0,0,0,0\n";
  const auto refused = [&](const Arguments& arguments, std::string_view input, int code,
                           const std::string& message) {
    const Finished finished = small(arguments, input);
    EXPECT_EQ(finished.exit_code, code);
    EXPECT_EQ(finished.out, "");
    expect_parts(finished.err, {message});
  };
  // What follows in such a line must not become a record, nor be left out unseen.
  for (const char filling : {' ', 'q'}) {
    const std::string long_line = std::string(3'000'000, filling) + "b,0,3,0,0\n";
    refused({"--skip-bad", "--fail-on-risk"}, table + long_line + "c,0,900,0,0\n", 3,
            "<stdin>:3: a line that begins with");
  }
  refused({}, "NAME sx sy sz vx vy vz time\n[none] [m] [m] [m] [m/s] [m/s] [m/s] [s]\n", 3,
          "an encounter of DAIDALUS, which is read as a whole");
  refused({}, "00:00:00.00>CRE KL1,B744,52,4,90,FL350,280\n", 3, "ask 'beespace predict'");
  refused({"--report", "separation"}, table, 2, "--memory does not take --report separation");
  refused({"--report", "events"}, table, 2, "--memory does not take --report events");
  refused({}, "{\"swarm\": {}}", 3, "read as a whole; leave --memory out");
  refused({},
          "MSG,3,1,1,4B1815,1,2020/01/01,00:00:00.000,2020/01/01,00:00:00.000,,100,,,1,2,,,,,,0\n",
          3, "read as a whole; leave --memory out");
  const Finished alone = run({"replay", "--temporary", scratch_.path("")}, table);
  EXPECT_EQ(alone.exit_code, 2);
  expect_parts(alone.err, {"--temporary goes with --memory"});
  const Finished little = run({"replay", "--memory", "1MB", "--threads", "1"}, table);
  EXPECT_EQ(little.exit_code, 2);
  expect_parts(little.err, {"16 MiB"});
  const Finished nowhere =
      run({"replay", "--memory", "20MB", "--threads", "1", "--temporary", "/no/such"}, table);
  EXPECT_EQ(nowhere.exit_code, 4);
}

// What hides conflicts without gaps between fixes is looked at, too.
TEST_F(ReplayOutOfCore, WhereBeesAreNotKnownIsNoAllClearEither) {
  const auto unknown = [&](const std::string& table, const std::string& why,
                           const Arguments& more = {}) {
    const Arguments asked = (more.empty() ? Arguments{"--threshold", "1"} : more) +
                            Arguments{"--fail-on-risk", "--straight"};
    const Finished expected = run(Arguments{"replay"} + asked, table);
    const Finished found = small(asked, table);
    EXPECT_EQ(expected.exit_code, 1) << expected.err;
    EXPECT_EQ(found.exit_code, 1) << found.err;
    // The closest encounter is not looked for with --memory.
    const std::string known = known_lines(expected.err);
    EXPECT_EQ(known_lines(found.err), known.substr(0, known.find("  closest")));
    expect_parts(found.err, {why});
  };
  // Failed fixes in a row, in order and not.
  std::string forth = "id,time_s,x_m,y_m\n";
  std::string back = forth;
  for (int t = 0; t < 40; ++t) {
    const auto rows = [](int at) {
      const std::string time = "," + std::to_string(at) + ",";
      const bool lost = at >= 20 && at < 23;
      return "a" + time + std::to_string(at) + ",0\nb" + time +
             (lost ? "NA,NA\n" : std::to_string(at) + ",90\n");
    };
    forth += rows(t);
    back += rows(39 - t);
  }
  unknown(forth, "1 bee unknown for 4 s in all");
  EXPECT_EQ(small({"--threshold", "1", "--fail-on-risk", "--straight"}, back).exit_code, 1);
  // In the midst of a video.
  std::string video = "id,frame,x_mm,y_mm\n";
  for (int frame = 0; frame < 60; ++frame) {
    const std::string at = "," + std::to_string(frame) + ",";
    video += "a" + at + std::to_string(10 * frame) + ",0\nc" + at + "0," +
             std::to_string(10 * frame + 50) + "\n";
    if (frame < 30) video += "b" + at + "300," + std::to_string(300 - frame) + "\n";
  }
  unknown(video, "1 of which appears or vanishes on its way",
          {"--fps", "10", "--threshold", "2mm"});
  // On the Earth, without heights.
  std::string earth = "id,time_s,lon,lat\n";
  for (int t = 0; t < 60; ++t) {
    const std::string at = "," + std::to_string(t) + ",";
    earth += "a" + at + std::to_string(8.0 + 1e-4 * t) + ",47\nc" + at + "8.003," +
             std::to_string(46.99 + 1e-3 * t) + "\n";
    if (t < 30) earth += "b" + at + std::to_string(8.001 + 1e-5 * t) + ",47.005\n";
  }
  unknown(earth, "1 of which appears or vanishes on its way");
  // Against stated rates: b climbs 3,000 m in a second, as it would not by its own climb rate, and
  // stays there.
  std::string rates = "id,time_s,lon,lat,height_m,ve,vn,vu\n";
  for (int t = 0; t < 40; ++t) {
    const std::string at = "," + std::to_string(t) + ",";
    rates += "a" + at + "8,47,100,0,0,0\nb" + at + "8.1,47," + (t >= 20 ? "3100" : "100") +
             ",0.1,0.1,0.1\n";
  }
  unknown(rates, "1 bee jumps");
}

TEST_F(ReplayOutOfCore, AFullDiskIsAnErrorThatLeavesNothing) {
  const std::string file = flight("flight.csv");
  Surroundings narrow;
  narrow.file_bytes = 1'000'000;
  const Finished finished = small({file, "--output", folder_.path("answer.txt")}, {}, narrow);
  EXPECT_EQ(finished.exit_code, 4);
  expect_parts(finished.err, {"cannot write a temporary file in", scratch_.path("")});
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"flight.csv"});
  EXPECT_TRUE(scratch_.names().empty());
}

TEST_F(ReplayOutOfCore, SignalsEndItAndLeaveNothing) {
  for (const auto& [signal, exit_code] :
       {std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGKILL, -1)}) {
    folder_.file("answer.txt", "old");
    Running running({"replay", "-", "--memory", "17MB", "--threads", "1", "--temporary",
                     scratch_.path(""), "--output", folder_.path("answer.txt")});
    std::string text = "id,time_s,x,y,z\n";
    for (int t = 0; t < 400'000; ++t) text += "a," + std::to_string(t) + ",1.25,2.5,3.75\n";
    running.send(text);
    running.signal(signal);
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(folder_.read("answer.txt"), "old");
    EXPECT_TRUE(scratch_.names().empty());
  }
}

}  // namespace
}  // namespace beespace::cli_test
