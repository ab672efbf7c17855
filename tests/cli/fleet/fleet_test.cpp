// `beespace fleet`: set and flown positions whose differences are computed by hand.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kWrongUsage = 2;
constexpr int kBadInput = 3;

// a is 0.25 m off, then 0.5 m, and then where it should be; b always is.
constexpr std::string_view kFlown =
    "id,time_s,x,y,z\n"
    "a,0,0.25,0,5\nb,0,0,9,5\na,1,10.5,0,5\nb,1,0,9,5\na,2,20,0,5\nb,2,0,9,5\n";
constexpr std::string_view kSet =
    "id,time_s,x,y,z\n"
    "a,0,0,0,5\nb,0,0,9,5\na,1,10,0,5\nb,1,0,9,5\na,2,20,0,5\nb,2,0,9,5\n";

TEST(Fleet, SaysHowFarAndHowFastBeesStray) {
  TemporaryFolder folder;
  const std::string set = folder.write("set.csv", kSet);
  const Finished finished = run({"fleet", "--set", set}, kFlown);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out,
               {"2 bees, 6 fixes compared\n", "deviation     0.500 m (99.9 %: 0.500 m)\n",
                "rate          0.500 m/s", "acceleration  0.750 m/s^2",
                "lag           none that could be told\n",
                "to plan with  sensing_error_m = 0.501, deviation_mps = 0, correction_mps = 0.501",
                "Not told: how wrong flown positions are themselves."});
}

TEST(Fleet, ReadsBothFromColumnsOfOneTable) {
  TemporaryFolder folder;
  const std::string both = folder.write("log.csv",
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
  const std::string others = folder.write("set.csv", "id,time_s,x,y,z\nc,0,0,0,5\nc,1,0,0,5\n");
  const Finished ids = run({"fleet", "--set", others}, kFlown);
  EXPECT_EQ(ids.exit_code, kBadInput);
  expect_parts(ids.err, {"no bee was both set and flown: their ids differ"});
  const std::string later = folder.write("late.csv", "id,time_s,x,y,z\na,50,0,0,5\na,51,0,0,5\n");
  const Finished times = run({"fleet", "--set", later}, kFlown);
  EXPECT_EQ(times.exit_code, kBadInput);
  expect_parts(times.err, {"bring both to the same clock"});
  const Finished missing = run({"fleet"}, kFlown);
  EXPECT_EQ(missing.exit_code, kWrongUsage);
  expect_parts(missing.err, {"--set is missing"});
}

}  // namespace
}  // namespace beespace::cli_test
