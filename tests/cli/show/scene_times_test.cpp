// Tables with times, for pages, pictures and map files: a snapshot is what is of one time.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

using report_test::text_of;

constexpr std::string_view kApartInTime = "id,time_s,x,y,z\na,0,0,0,0\nb,1,1,0,0\nc,5,2,0,0\n";
constexpr std::string_view kAtOnce = "id,time_s,x,y,z\na,7,0,0,0\nb,7.0,1,0,0\nc,7,2,0,0\n";

std::string summary(const Arguments& arguments, std::string_view input) {
  return run(arguments + Arguments{"-o", "/dev/null"}, input).err;
}

const Arguments kTable = {"export", "--format", "csv"};
const Arguments kIdIsSaid = {"--columns", "id=1"};

TEST(SeenTimes, ABeeAtAnotherTimeMeetsNone) {
  expect_failure(kTable, kApartInTime, 3, "which column is the id? By column 1 'id' each of the 3");
  expect_parts(
      summary(kTable + kIdIsSaid, kApartInTime),
      {"bees       3\n", "at risk    nothing to compare: no two bees are there at the same time",
       "each bee is there for a moment only"});
  EXPECT_EQ(lines_of(run(kTable + kIdIsSaid, kApartInTime).out).size(),
            1u);  // no conflict below the header
}

TEST(SeenTimes, BeesAtTheSameTimeAreASnapshot) {
  const std::string said = summary(kTable, kAtOnce);
  expect_parts(said, {"at risk    3 of 3: 3 pairs in 1 group\n"});
  EXPECT_EQ(said.find("moment"), std::string::npos);
}

TEST(SeenTimes, VelocitiesMakeNoSnapshotOfATableEither) {
  const std::string_view flying = "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\nb,1,1,0,0,1,0,0\n";
  expect_parts(summary(kTable, flying),
               {"at risk    nothing to compare: no two bees are there at the same time"});
}

TEST(SeenTimes, ATimeOfWhichTheUnitIsNotKnownIsNotPassedOver) {
  const std::string message = "column 2 't' holds the time, but in which unit? Say it with";
  const std::string_view apart = "id,t,x,y,z\na,0,0,0,0\nb,1,1,0,0\n";
  expect_failure(kTable, apart, 2, message);
  expect_parts(summary(kTable + Arguments{"--time-unit", "s"}, apart),
               {"at risk    nothing to compare: no two bees are there at the same time"});
  // With one time only, its unit does not matter.
  expect_parts(summary(kTable, "id,t,x,y,z\na,1,0,0,0\nb,1,1,0,0\n"), {"at risk    2 of 2"});
}

TEST(SeenTimes, OfSeveralFilesTheTimesDecideToo) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.csv", "id,time_s,x,y,z\na,3,0,0,0\n");
  const std::string b = folder.file("b.csv", "id,time_s,x,y,z\nb,3,9,0,0\n");
  const std::string c = folder.file("c.csv", "id,time_s,x,y,z\nc,4,9,0,0\n");
  expect_parts(summary(kTable + Arguments{a, b}, {}), {"at risk    2 of 2: 1 pair in 1 group\n"});
  expect_parts(summary(kTable + Arguments{a, c}, {}),
               {"at risk    nothing to compare: no two bees are there at the same time"});
}

class SeenTimesPage : public PageCommand {};

TEST_F(SeenTimesPage, SaysWhichItIs) {
  EXPECT_EQ(text_of(reported(kIdIsSaid, kApartInTime).swarm()["kind"]), "recording");
  EXPECT_EQ(text_of(reported({}, kAtOnce).swarm()["kind"]), "snapshot");
}

}  // namespace
}  // namespace beespace::cli_test
