// Drones of a show that are known on the ground only, or for a part of the time.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two drones that fly for a minute, and a third one that stands beside them for as long as that.
class UnseenDrones : public testing::Test {
 protected:
  std::string show(int third_until_s) {
    folder_.file("left.csv", rows(0, 70, true));
    folder_.file("right.csv", rows(10, 70, true));
    const std::string third = folder_.file("third.csv", rows(20, third_until_s, false));
    return third.substr(0, third.rfind('/'));
  }

 private:
  static std::string rows(int x, int until_s, bool flies) {
    std::string text = "Time [msec],x [m],y [m],z [m]\n";
    for (int second = 0; second <= until_s; ++second) {
      const int up_m = std::max(0, std::min({10, 2 * (second - 5), 2 * (65 - second)}));
      text += std::to_string(1000 * second) + "," + std::to_string(x) + ",0," +
              std::to_string(flies ? up_m : 0) + "\n";
    }
    return text;
  }

  TemporaryFolder folder_;
};

TEST_F(UnseenDrones, WhoseTableEndsBeforeOthersFlyIsNoAllClear) {
  const std::string cut = show(2);
  const Finished finished = run({"replay", cut, "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"threshold  2 m (closer than)",
                              "(1 of which known on the ground only, and not while others fly: "
                              "third)\n",
                              "1 of them on the ground by all its records, while others fly\n"});
  EXPECT_EQ(run({"verify", cut}).exit_code, 1);
  const Finished json = run({"replay", cut, "--json", "--quiet"});
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("bees_on_ground_only": 1)", R"("longest_bridged": null)"});
}

TEST_F(UnseenDrones, WhoStandsAllTheTimeIsKnown) {
  const Finished finished = run({"replay", show(70), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"1 drone never leaves the ground", "keeps its distance"});
}

}  // namespace
}  // namespace beespace::cli_test
