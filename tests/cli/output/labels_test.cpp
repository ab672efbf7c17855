// What bees are called beside their ids, as flights are: shown behind the id for people, and in
// columns of their own for programs.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

// Two that hover 1.1 km apart for 30 s, as a receiver hears them. Who flies as what is heard of
// one.
std::string heard() {
  std::string text =
      "MSG,1,1,1,4B1814,1,2024/05/01,12:00:00.000,2024/05/01,12:00:00.000,SWR12AB "
      ",,,,,,,,0,0,0,0\n";
  for (const std::string second : {"01", "03", "05", "07"}) {
    const std::string time = "2024/05/01,12:00:" + second + ".000";
    text += "MSG,3,1,1,4B1814,1," + time + "," + time + ",,10000,,,47.25,8.5,,,0,0,0,0\n";
    text += "MSG,3,1,1,A1B2C3,1," + time + "," + time + ",,10000,,,47.26,8.5,,,0,0,0,0\n";
  }
  return text;
}

Finished ask(const std::string& command, const Arguments& more = {}) {
  return run(Arguments{command, "--threshold", "2000"} + more, heard());
}

class Labels : public testing::TestWithParam<const char*> {};

TEST_P(Labels, AreShownBehindTheIdInTheTextAndTheSummary) {
  const Finished finished = ask(GetParam());
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u) << finished.err;
  EXPECT_EQ(rows[0].size(), 7u);
  EXPECT_EQ(rows[0][0], "4b1814 (SWR12AB)");
  EXPECT_EQ(rows[0][1], "a1b2c3");
  expect_parts(finished.err, {"closest    4b1814 (SWR12AB) and a1b2c3, "});
}

TEST_P(Labels, HaveColumnsOfTheirOwnBehindAllOthers) {
  const TextRows rows = rows_of(ask(GetParam(), {"--csv"}).out, ',');
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"first", "second", "begins_s", "closest_s",
                                               "closest_m", "ends_s", "lasts_s", "first_label",
                                               "second_label", "begins", "closest", "ends"}));
  EXPECT_EQ(rows[1].at(0), "4b1814");
  EXPECT_EQ(rows[1].at(1), "a1b2c3");
  EXPECT_EQ(rows[1].at(7), "SWR12AB");
  EXPECT_EQ(rows[1].at(8), "");
  const std::string json = ask(GetParam(), {"--json"}).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"({"first": "4b1814", "second": "a1b2c3", "begins_s": )",
                      R"(, "first_label": "SWR12AB", "second_label": null})"});
}

INSTANTIATE_TEST_SUITE_P(Both, Labels, testing::Values("predict", "replay"),
                         [](const auto& command) { return std::string(command.param); });

TEST(Labels, AreInEveryReportOfReplay) {
  const auto header_and_first = [](const Arguments& more) {
    const auto lines = lines_of(ask("replay", Arguments{"--csv"} + more).out);
    return lines.size() < 2 ? TextRows()
                            : TextRows{fields_of(lines[0], ','), fields_of(lines[1], ',')};
  };
  const TextRows bees = header_and_first({"--report", "bees"});
  ASSERT_EQ(bees.size(), 2u);
  EXPECT_EQ(bees[0].at(8), "closest_label");
  EXPECT_EQ(bees[0].at(7), "label");
  EXPECT_EQ(bees[1].at(7), "SWR12AB");
  const TextRows separation = header_and_first({"--report", "separation"});
  ASSERT_EQ(separation.size(), 2u);
  EXPECT_EQ(separation[0].at(5), "first_label");
  EXPECT_EQ(separation[1].at(5), "SWR12AB");
  const TextRows events = header_and_first({"--report", "events"});
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].at(8), "first_label");
  EXPECT_EQ(events[1].at(8), "SWR12AB");
  expect_parts(ask("replay", {"--json"}).out,
               {R"("closest": {"first": "4b1814", "second": "a1b2c3", )"});
}

TEST(Labels, StandAtTheEndOfTheEventsOfWatchAsOfReplay) {
  const Finished watched = ask("watch");
  ASSERT_FALSE(watched.out.empty()) << watched.err;
  for (const std::string& line : lines_of(watched.out)) {
    EXPECT_TRUE(is_json(line)) << line;
    EXPECT_TRUE(line.ends_with(R"(, "first_label": "SWR12AB"})")) << line;
  }
  EXPECT_EQ(watched.out, ask("replay", {"--report", "events"}).out);
  // A silent bee has one, too.
  const std::string silent = heard() +
                             "MSG,3,1,1,A1B2C3,1,2024/05/01,12:00:30.000,2024/05/01,"
                             "12:00:30.000,,10000,,,47.26,8.5,,,0,0,0,0\n";
  expect_parts(run({"watch", "--threshold", "2000"}, silent).out,
               {R"("id": "4b1814", "label": "SWR12AB"})"});
}

TEST(Labels, WhereThereIsNoneNothingChanges) {
  constexpr std::string_view table =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,0,1,0,0\nb,1,1,0,0\n";
  EXPECT_EQ(lines_of(run({"replay", "--csv"}, table).out).at(0),
            "first,second,begins_s,closest_s,closest_m,ends_s,lasts_s");
  EXPECT_EQ(run({"replay", "--json"}, table).out.find("label"), std::string::npos);
  EXPECT_EQ(run({"watch"}, table).out.find("label"), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
