// `beespace fleet`: set and flown positions whose differences are computed by hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kWrongUsage = 2;
// a is 0.25 m off, then 0.5 m, and then where it should be; b always is.
constexpr std::string_view kFlown =
    "id,time_s,x,y,z\n"
    "a,0,0.25,0,5\nb,0,0,9,5\na,1,10.5,0,5\nb,1,0,9,5\na,2,20,0,5\nb,2,0,9,5\n";
constexpr std::string_view kSet =
    "id,time_s,x,y,z\n"
    "a,0,0,0,5\nb,0,0,9,5\na,1,10,0,5\nb,1,0,9,5\na,2,20,0,5\nb,2,0,9,5\n";

TEST(Fleet, SaysHowFarAndHowFastBeesStray) {
  TemporaryFolder folder;
  const std::string set = folder.file("set.csv", kSet);
  const Finished finished = run({"fleet", "--set", set}, kFlown);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out,
            "id\tset_id\tfarthest_m\tfarthest_s\tmean_m\tp95_m\tfixes\tunknown_s\n"
            "a\ta\t0.5\t1\t0.25\t0.5\t3\t0\nb\tb\t0\t0\t0\t0\t3\t0\n");
  expect_parts(
      finished.err,
      {"compared   2 bees, 6 fixes\n", "deviation  at most 0.500 m (99.9 %: 0.500 m)\n",
       "farthest   a, 0.500 m from where it was set to be at 1.00 s\n", "rate       0.500 m/s",
       "changes by 0.750 m/s^2", "lag        none that could be told\n",
       "to plan    sensing_error_m = 0.500, deviation_mps = 0, correction_mps = 0.500; how wrong "
       "flown positions are themselves is not told"});
}

TEST(Fleet, ReadsBothFromColumnsOfOneTable) {
  TemporaryFolder folder;
  const std::string both = folder.file("log.csv",
                                       "id,time_s,x,y,z,set_x,set_y,set_z\n"
                                       "a,0,1,0,5,0,0,5\na,1,2,0,5,2,0,5\n");
  const Finished finished =
      run({"fleet", both, "--set", both, "--set-columns", "x=set_x,y=set_y,z=set_z", "--json"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out,
               {"\"bees\": 1", "\"fixes\": 2", "\"deviation_m\": {\"greatest\": 1, \"usual\": 1}",
                "\"rate_mps\": {\"greatest\": 1, \"usual\": 1}", "\"lag_s\": null"});
}

TEST(Fleet, SaysWhatCannotBeCompared) {
  TemporaryFolder folder;
  const std::string others = folder.file("set.csv", "id,time_s,x,y,z\nc,0,0,0,5\nc,1,0,0,5\n");
  const Finished ids = run({"fleet", "--set", others}, kFlown);
  EXPECT_EQ(ids.exit_code, kBadInput);
  expect_parts(ids.err, {"no bee was both set and flown: their ids differ"});
  const std::string later = folder.file("late.csv", "id,time_s,x,y,z\na,50,0,0,5\na,51,0,0,5\n");
  const Finished times = run({"fleet", "--set", later}, kFlown);
  EXPECT_EQ(times.exit_code, kBadInput);
  expect_parts(times.err, {"bring both to the same clock"});
  const Finished missing = run({"fleet"}, kFlown);
  EXPECT_EQ(missing.exit_code, kWrongUsage);
  expect_parts(missing.err, {"--set is missing"});
}

constexpr std::string_view kBoth =
    "id,time_s,x,y,z,set_x,set_y,set_z\n"
    "a,0,1,0,5,0,0,5\na,1,2,0,5,2,0,5\n";

TEST(Fleet, FlownAndSetAreNotTheSameColumnsOfOneFile) {
  TemporaryFolder folder;
  const std::string both = folder.file("log.csv", kBoth);
  const std::string link = folder.path("link.csv");
  std::filesystem::create_symlink("log.csv", link);
  const std::string message =
      "flown and set are the same columns; name those of what was set with "
      "--set-columns";
  const std::string columns = "x=set_x,y=set_y,z=set_z";
  for (const std::string& set : {both, link, folder.path("./log.csv")}) {
    expect_usage_error({"fleet", both, "--set", set}, message);
    expect_usage_error({"fleet", both, "--set", set, "--columns", columns}, message);
    expect_usage_error(
        {"fleet", both, "--set", set, "--columns", columns, "--set-columns", columns}, message);
    EXPECT_EQ(run({"fleet", both, "--set", set, "--set-columns", columns}).exit_code, 0);
  }
}

TEST(Fleet, StandardInputIsReadOnce) {
  const Finished finished = run({"fleet", "--set", "-", "--set-columns", "x=set_x"}, kBoth);
  EXPECT_EQ(finished.exit_code, kWrongUsage);
  expect_parts(finished.err, {"standard input can be read once; give --set a file"});
  TemporaryFolder folder;
  const std::string flown = folder.file("flown.csv", kFlown);
  EXPECT_EQ(run({"fleet", flown, "--set", "-"}, kSet).exit_code, 0);
}

TEST(Fleet, ErrorsOfWhatWasSetNameItsOption) {
  TemporaryFolder folder;
  const std::string both = folder.file("log.csv", kBoth);
  for (const std::string columns : {"q=set_x", "x=set_x"}) {
    const Finished set = run({"fleet", both, "--set", both, "--set-columns", columns});
    EXPECT_EQ(set.exit_code, kWrongUsage) << columns;
    expect_parts(set.err, {"log.csv", ": --set-columns: "});
    const Finished flown = run({"fleet", both, "--set", both, "--columns", columns, "--set-columns",
                                "x=set_x,y=set_y,z=set_z"});
    EXPECT_EQ(flown.exit_code, kWrongUsage) << columns;
    expect_parts(flown.err, {"log.csv", ": --columns: "});
  }
}

TEST(Fleet, JsonSaysWhatToPlanWith) {
  TemporaryFolder folder;
  const std::string set = folder.file("set.csv", kSet);
  const Finished finished = run({"fleet", "--set", set, "--json"}, kFlown);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {"\"version\": \"", "\"command\": \"fleet\"",
                              "\"plan\": {\"sensing_error_m\": 0.5, \"deviation_mps\": 0, "
                              "\"correction_mps\": 0.5}"});
}

TEST(Fleet, TheSummarySaysHowBothWereReadAndQuietLeavesItOut) {
  TemporaryFolder folder;
  const std::string set = folder.file("set.csv", std::string(kSet) + "a,nonsense,0,0,5\n");
  const Finished finished = run({"fleet", "--set", set, "--skip-bad"}, kFlown);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"input      standard input (", "input      " + set + " (",
                              "skipped    1 bad record\n"});
  const Finished quiet = run({"fleet", "--set", set, "--skip-bad", "--quiet"}, kFlown);
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, finished.out);
}

}  // namespace
}  // namespace beespace::cli_test
