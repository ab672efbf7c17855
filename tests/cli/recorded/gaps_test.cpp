// A gap is unknown, neither a straight line nor absence: the answers about such recordings.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// A fix a second from begins to ends, but none between the two of a gap; standing at x.
std::string standing(const std::string& id, double x, int begins, int ends, int gap_from = 0,
                     int gap_to = 0) {
  std::string text;
  for (int t = begins; t <= ends; ++t) {
    if (t > gap_from && t < gap_to) continue;
    text += id + "," + std::to_string(t) + "," + std::to_string(x) + ",0,0\n";
  }
  return text;
}

const std::string kHeader = "id,time_s,x,y,z\n";

// a flies through b's place, but only as the straight line across its gap of two hours would.
std::string through_the_gap() {
  std::string text = kHeader + standing("b", 0, 0, 7230);
  for (int t = 0; t <= 10; ++t) text += "a," + std::to_string(t) + ",-1000,0,0\n";
  for (int t = 7211; t <= 7230; ++t) text += "a," + std::to_string(t) + ",1000,0,0\n";
  return text;
}

Finished ask(const Arguments& arguments, const std::string& input) {
  return run(arguments, input);
}

class Gaps : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string file_ = folder_.file("flown.csv", through_the_gap());
};

// The same gaps as all other reports have, neither longer ones nor shorter ones.
TEST_F(Gaps, EventsHaveThemToo) {
  // A picture every 40 ms, and 2 is lost for 4.5 s, in which the line passes 1 by.
  std::string text = kHeader;
  for (int i = 0; i <= 500; ++i) {
    const std::string time = std::to_string(0.04 * i);
    text += "1," + time + ",0,0,0\n";
    if (i < 150 || i > 262) text += "2," + time + (i < 150 ? ",9,0,0\n" : ",9,3,0\n");
  }
  const std::string file = folder_.file("fish.csv", text);
  for (const char* report : {"events", "conflicts"}) {
    const Finished finished =
        run({"replay", file, "--threshold", "5", "--report", report, "--fail-on-risk"});
    EXPECT_EQ(finished.exit_code, 1) << report << finished.err;
    expect_parts(finished.err, {"max gap    0.2 s, 5 times the typical interval of 0.04 s",
                                "no conflict in the known time; 1 bee unknown for 4.56 s in all"});
  }
  const Finished events =
      run({"replay", file, "--threshold", "5", "--report", "events", "--horizon", "0", "--quiet"});
  const auto lines = lines_of(events.out);
  ASSERT_EQ(lines.size(), 2u) << events.out;
  expect_parts(lines[0], {R"({"event": "stale", "time_s": 5.96, "id": "2"})"});
  expect_parts(lines[1], {R"({"event": "heard", "time_s": 10.52, "since_s": 5.96, "id": "2"})"});
  // Who has a fix every five minutes is not silent in between.
  std::string collars = kHeader;
  for (int i = 0; i <= 20; ++i) {
    for (const char* id : {"a", "b"}) {
      collars +=
          std::string(id) + "," + std::to_string(300 * i) + (*id == 'a' ? ",0" : ",90") + ",0,0\n";
    }
  }
  const std::string slow = folder_.file("collars.csv", collars);
  const Finished known =
      run({"replay", slow, "--threshold", "50", "--report", "events", "--fail-on-risk"});
  EXPECT_EQ(known.out, "");
  EXPECT_EQ(known.exit_code, 0);
  expect_parts(known.err, {"keeps its distance"});
}

// Who is lost while two touch: not two contacts that are over, but perhaps one.
TEST_F(Gaps, ConflictsThatBeginOrEndInOneAreMarked) {
  std::string text = kHeader;
  for (int i = 0; i <= 100; ++i) {
    const std::string time = std::to_string(i);
    text += "a," + time + ",0,0,0\n";
    const bool near = i >= 20 && i <= 60;
    if (i <= 30 || i >= 40) text += "b," + time + (near ? ",3,0,0\n" : ",30,0,0\n");
  }
  const std::string file = folder_.file("touch.csv", text);
  const Finished all = run({"replay", file, "--threshold", "5", "--csv"});
  const auto rows = lines_of(all.out);
  ASSERT_EQ(rows.size(), 3u) << all.out;
  EXPECT_TRUE(rows[0].ends_with(",lasts_s,unknown_before,unknown_after")) << rows[0];
  EXPECT_TRUE(rows[1].ends_with(",no,yes")) << rows[1];
  EXPECT_TRUE(rows[2].ends_with(",yes,no")) << rows[2];
  expect_parts(all.err, {"2 conflicts begin or end where one of the two is not known"});
  expect_parts(run({"replay", file, "--threshold", "5", "--json"}).out,
               {R"("unknown_before": false, "unknown_after": true)"});
  const auto pairs =
      lines_of(run({"replay", file, "--threshold", "5", "--report", "pairs", "--csv"}).out);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_TRUE(pairs[0].ends_with(",closest_m,unknown_s")) << pairs[0];
  EXPECT_TRUE(pairs[1].ends_with(",10")) << pairs[1];
  // With --memory the same.
  EXPECT_EQ(run({"replay", file, "--threshold", "5", "--csv", "--memory", "64MB"}).out, all.out);
}

TEST_F(Gaps, NoStraightLineJoinsFixesThatAreHoursApart) {
  const Finished finished = run({"replay", file_, "--threshold", "5"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(lines_of(finished.out).size(), 1u) << finished.out;  // the header
  expect_parts(finished.err,
               {"no conflict in the known time; 1 bee unknown for 2 h in all",
                "5 s, 5 times the typical interval of 1 s (--max-gap)", "a from 10.00 s for 2 h"});
  EXPECT_EQ(finished.err.find("keeps its distance"), std::string::npos) << finished.err;
  // The straight line is used where it is asked for.
  const Finished joined = run({"replay", file_, "--threshold", "5", "--max-gap", "never"});
  EXPECT_EQ(lines_of(joined.out).size(), 2u) << joined.out;
  expect_parts(joined.err, {"does not keep its distance: 1 conflict of 1 pair"});
}

TEST_F(Gaps, WithoutGapsItKeepsItsDistance) {
  const std::string whole = kHeader + standing("a", 0, 0, 60) + standing("b", 100, 0, 60);
  const Finished finished = ask({"replay", "--threshold", "5"}, whole);
  expect_parts(finished.err, {"verdict    keeps its distance\n"});
  const Finished json = ask({"replay", "--threshold", "5", "--json", "--quiet"}, whole);
  expect_parts(json.out, {"\"known\": {\"complete\": true, \"max_gap_s\": 5, "
                          "\"typical_interval_s\": 1, \"gap_count\": 0"});
}

// Absence before the first fix and after the last one is no knowledge either.
TEST_F(Gaps, BeesThatAreKnownForAPartOnlyAreNamed) {
  const std::string input =
      kHeader + standing("a", 0, 0, 60) + standing("b", 100, 0, 60) + standing("late", 200, 30, 60);
  const Finished finished = ask({"replay", "--threshold", "5"}, input);
  expect_parts(finished.err,
               {"no conflict in the known time; 1 bee known for a part of the recording only",
                "1 bee before the first or after the last fix, for 30 s in all"});
  EXPECT_EQ(finished.err.find("keeps its distance"), std::string::npos);
}

TEST_F(Gaps, JsonHasTheSameFacts) {
  const Finished finished = run({"replay", file_, "--threshold", "5", "--json", "--quiet"});
  EXPECT_TRUE(is_json(finished.out));
  expect_parts(finished.out,
               {"\"known\": {\"complete\": false, \"max_gap_s\": 5, \"typical_interval_s\": 1, "
                "\"gap_count\": 1, \"bees_with_gaps\": 1, \"in_gaps_s\": 7201, "
                "\"bees_partly_known\": 0",
                "{\"id\": \"a\", \"begins_s\": 10, \"ends_s\": 7211, \"lasts_s\": 7201}"});
}

TEST_F(Gaps, TheLongestAreNamedAndTheOthersCounted) {
  std::string input = kHeader + standing("calm", 500, 0, 500);
  for (int i = 1; i <= 5; ++i) {
    input += standing("bee" + std::to_string(i), 1000.0 * i, 0, 500, 100, 100 + 20 * i);
  }
  const Finished finished = ask({"replay", "--threshold", "5"}, input);
  expect_parts(finished.err,
               {"5 bees in 5 gaps between two fixes, for 5 min in all",
                "bee5 from 100.00 s for 1 min 40 s", "bee4 from", "bee3 from", "and shorter ones"});
  EXPECT_EQ(finished.err.find("bee2 from"), std::string::npos);
}

// The typical interval is that of most bees; bees with few fixes do not make hours usual.
TEST_F(Gaps, TheDefaultComesFromTheDataAndIsRobust) {
  const auto max_gap = [](const std::string& input) {
    const std::string json = ask({"replay", "--json", "--quiet"}, kHeader + input).out;
    const std::size_t from = json.find("\"max_gap_s\": ") + 13;
    return json.substr(from, json.find(',', from) - from);
  };
  EXPECT_EQ(max_gap("a,0,0,0,0\na,10,0,0,0\n"), "50");  // there is nothing else to go by
  std::string few;
  for (int i = 0; i < 9; ++i) {
    few += "few" + std::to_string(i) + ",0,0,0,0\nfew" + std::to_string(i) + ",7200,0,0,0\n";
  }
  EXPECT_EQ(max_gap(few + standing("a", 0, 0, 60)), "5");
  EXPECT_EQ(max_gap("a,0,0,0,0\n"), "null");  // one fix: no interval at all
  // One bee at ten a second among those at one a second does not make theirs gaps.
  std::string fast;
  for (int i = 0; i < 600; ++i) fast += "fast," + std::to_string(i / 10.0) + ",900,0,0\n";
  EXPECT_EQ(max_gap(fast + standing("a", 0, 0, 60) + standing("b", 50, 0, 60)), "5");
}

// Rows of one bee or one instant say how much of their time is unknown.
TEST_F(Gaps, BeesAndMomentsSayWhatIsUnknown) {
  const Arguments question = {"replay", file_, "--threshold", "5", "--quiet", "--report"};
  expect_rows(rows_of(run(question + Arguments{"bees"}).out),
              {{"b", "0", "0", "", "", "", "0"}, {"a", "0", "0", "", "", "", "7201"}});
  const TextRows moments = rows_of(run(question + Arguments{"separation", "--every", "3000"}).out);
  expect_rows(moments,
              {{"0", "1000", "b", "a", "0"}, {"3000", "", "", "", "1"}, {"6000", "", "", "", "1"}});
}

TEST_F(Gaps, VerifyDoesNotCertifyWhatItDidNotSee) {
  const std::string both =
      kHeader + standing("a", 0, 0, 60, 20, 40) + standing("b", 100, 0, 60, 20, 40);
  const Finished finished = ask({"verify", "--threshold", "5"}, both);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"not seen as a whole: holds in the known time; 2 bees unknown for 40 "
                              "s in all",
                              "a from 20.00 s for 20 s"});
  const Finished json = ask({"verify", "--threshold", "5", "--json", "--quiet"}, both);
  expect_parts(json.out, {"\"holds\": false", "\"gap_count\": 2", "\"loss_count\": 0"});
  for (const char* max_gap : {"never", "20"}) {
    const Finished asked = ask({"verify", "--threshold", "5", "--max-gap", max_gap}, both);
    EXPECT_EQ(asked.exit_code, 0) << asked.err;
    expect_parts(asked.err, {"verdict    holds\n"});
  }
}

// A breach that only a straight line across a gap has is no finding; breaches outside of gaps are.
TEST_F(Gaps, VerifyFindsNothingInAGapAndAllBesideIt) {
  std::string input = kHeader;
  for (int t = 0; t <= 60; ++t) {
    if (t > 20 && t < 40) continue;
    const double x = t <= 20 ? -500.0 : (t < 50 ? 500.0 : 103.0);
    input += "a," + std::to_string(t) + "," + std::to_string(x) + ",0,0\n";
    input += "b," + std::to_string(t) + ",100,0,0\n";
  }
  const Arguments question = {"verify", "--threshold", "5", "--quiet"};
  for (const std::string& row : lines_of(ask(question, input).out)) {
    EXPECT_EQ(row.find("\t20\t40\t"), std::string::npos) << row;
  }
  EXPECT_NE(ask(question, input).out.find("loss\ta\tb\t50\t51\t"), std::string::npos);
}

// Status 0 would be an all-clear.
TEST_F(Gaps, AGapIsARiskWhereTheStatusIsAskedFor) {
  for (const Arguments& command :
       {Arguments{"replay", file_}, Arguments{"export", file_, "--format", "csv"},
        Arguments{"plot", file_, "-o", folder_.path("x.svg")}}) {
    const Arguments question = command + Arguments{"--threshold", "5", "--quiet"};
    EXPECT_EQ(run(question + Arguments{"--fail-on-risk"}).exit_code, 1) << command.front();
    EXPECT_EQ(run(question).exit_code, 0);
    EXPECT_EQ(run(question + Arguments{"--fail-on-risk", "--max-gap", "8000", "--threshold", "4"})
                  .exit_code,
              2);  // said twice
  }
  const std::string whole = kHeader + standing("a", 0, 0, 60) + standing("b", 100, 10, 50);
  EXPECT_EQ(ask({"replay", "--threshold", "5", "--fail-on-risk"}, whole).exit_code, 0);
}

TEST_F(Gaps, PicturesAndMapsSpeakOfTheKnownTime) {
  const Finished plot = run({"plot", file_, "--threshold", "5", "-o", folder_.path("x.svg")});
  EXPECT_EQ(plot.exit_code, 0) << plot.err;
  expect_parts(plot.err, {"none in the known time; 1 bee unknown for 2 h in all",
                          "the longest such gap: a from 10.00 s for 2 h"});
  EXPECT_NE(folder_.read("x.svg").find("in the known time"), std::string::npos);
  EXPECT_EQ(folder_.read("x.svg").find("No bee comes"), std::string::npos);
}

TEST_F(Gaps, MaxGapIsSecondsOrNever) {
  for (const char* bad : {"0", "-1", "x", "inf", "nan", "Never"}) {
    expect_usage_error({"replay", "--max-gap", bad},
                       "is not a number of seconds above 0, nor "
                       "'never'");
  }
  for (const char* command : {"verify", "report", "plot", "export", "view"}) {
    expect_usage_error({command, "--max-gap", "x"}, "--max-gap 'x' is not a number of seconds");
  }
}

// The velocity of a bee is not that of a straight line across hours, either.
TEST_F(Gaps, PredictTakesNoVelocityFromFixesThatAreFarApart) {
  const std::string input =
      kHeader + "a,0,0,0,0\na,3600,3600,0,0\nb,3599,3700,0,0\nb,3600,3699,0,0\n";
  const Finished finished = ask({"predict", "--threshold", "5"}, input);
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(
      finished.err,
      {"none of those that are known after the end of the recording; 1 bee is checked for now only",
       "neither a velocity (speed, direction and climb) nor two fixes, at most 30 s apart"});
  EXPECT_EQ(
      lines_of(
          ask({"predict", "--threshold", "5", "--max-age", "3600", "--horizon", "100"}, input).out)
          .size(),
      2u);
}

}  // namespace
}  // namespace beespace::cli_test
