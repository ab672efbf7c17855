// Logs that a ground station began anew have their drones twice: what joins them is told.
#include "io/recording/continued_logs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

RecordedBee heard(const std::string& id, double from_s, double until_s) {
  RecordedBee bee;
  bee.id = id;
  bee.fixes = {{from_s, {}}, {until_s, {}}};
  return bee;
}

TEST(ContinuedLogs, AreToBeJoinedInTheOrderOfTime) {
  const std::vector<std::string> sources = {"day/b.tlog", "day/a 2.tlog"};
  std::vector<RecordedBee> bees = {heard("b:1", 50, 90), heard("a 2:1", 0, 40),
                                   heard("a 2:2", 1, 41), heard("b:2", 51, 90)};
  const std::string text = continued_logs_note(bees, sources).value_or("");
  EXPECT_NE(text.find("cat 'day/a 2.tlog' day/b.tlog > joined.tlog"), std::string::npos) << text;
  // Of one time they are of two stations.
  bees[3].fixes.front().time_s = 40.5;
  EXPECT_FALSE(continued_logs_note(bees, sources));
  // Others are other drones, or no telemetry logs.
  EXPECT_FALSE(continued_logs_note({heard("b:1", 50, 90), heard("a 2:2", 0, 40)}, sources));
  EXPECT_FALSE(continued_logs_note({heard("b:1", 50, 90), heard("c:1", 0, 40)}, sources));
  EXPECT_FALSE(continued_logs_note({heard("b", 50, 90), heard("c", 0, 40)}, sources));
}

}  // namespace
}  // namespace beespace::io
