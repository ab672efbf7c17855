// `beespace report --obstacles`: what stands in the way is in the page, and is what the file says.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kFlown = "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,3,0,0\nb,9,3,0,0\n";
constexpr std::string_view kAll =
    R"({"obstacles":[{"kind":"sphere","center":[1,2,3],"radius_m":4},)"
    R"({"kind":"box","low":[0,1,2],"high":[3,4,5]},{"kind":"ground","height_m":-7},)"
    R"({"kind":"cylinder","center":[5,6],"radius_m":1,"high_m":40},)"
    R"({"kind":"prism","outline":[[0,0],[4,0],[0,3]],"low_m":-1}]})";

class ReportObstacles : public PageCommand {};

TEST_F(ReportObstacles, AreInThePageAsInTheirFile) {
  const std::string obstacles = folder_.file("obstacles.json", kAll);
  for (const std::string_view input : {kFlown, std::string_view("x,y,z\n0,0,0\n1,0,0\n")}) {
    const Finished finished = run({"report", "--obstacles", obstacles, "--threshold", "1"}, input);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.out, {std::string(kAll.substr(1, kAll.size() - 2)),
                                "obstacles are drawn, and nothing is said of them"});
  }
}

TEST_F(ReportObstacles, AreLeftOutWhereTheyAreNotAskedFor) {
  const Finished finished = run({"report", "--threshold", "1"}, kFlown);
  EXPECT_EQ(finished.out.find(R"("obstacles":)"), std::string::npos);
}

TEST_F(ReportObstacles, AreInTheMetresOfTheInput) {
  const std::string obstacles = folder_.file("obstacles.json", kAll);
  expect_failure({"report", "--obstacles", obstacles, "--threshold", "1"},
                 "id,lon,lat,height\na,19,47,0\n", kBadInput, "obstacles are in metres");
}

TEST_F(ReportObstacles, ThatAreNoneAreNamed) {
  const std::string upside_down = folder_.file(
      "box.json", R"({"obstacles": [{"kind": "box", "low": [9, 0, 0], "high": [1, 1, 1]}]})");
  expect_failure({"report", "--obstacles", upside_down}, kFlown, kBadInput, "obstacles[0]");
  expect_failure({"report", "-", "--obstacles", "-"}, kFlown, kUsage, "can be read once");
}

}  // namespace
}  // namespace beespace::cli_test
