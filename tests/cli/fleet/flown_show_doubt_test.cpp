// `beespace fleet` of a show and a log of it in which not all is known, or not said.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/cli/fleet/small_show.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kRisk = 1;
constexpr int kAskedForMore = 2;

class DoubtfulShow : public ::testing::Test {
 protected:
  Finished compare(const std::string& log, const std::vector<std::string>& more = {}) {
    std::vector<std::string> typed = {"fleet", "--set", set_, "--fail-on-risk"};
    typed.insert(typed.end(), more.begin(), more.end());
    return run(typed, log);
  }
  Finished compare_begun(const std::string& log, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--set-begins", "2025-11-27T19:00:00Z"});
    return compare(log, more);
  }

 private:
  TemporaryFolder folder_;
  std::string set_ = folder_.file("show.json", show_with(kLocation));
};

// At 20 s it strays.
const IsThere kWithAGap = [](std::size_t bee, int second) {
  return bee == 0 || second <= 14 || second >= 26;
};

TEST_F(DoubtfulShow, IsNoAllClearWhileADroneIsLost) {
  const std::string log = log_of({"1", "2"}, kLogHeader, kWithAGap);
  const Finished finished = compare_begun(log);
  EXPECT_EQ(finished.exit_code, kRisk);
  expect_parts(finished.out, {"\t20\t12\n"});
  expect_parts(finished.err, {"unknown    1 drone for 12 s in all of what was set: 2 (Drone 2) for "
                              "12 s from 2025-11-27T19:00:14.000Z on\n",
                              "deviation  in the known time at most 0.0"});
  const Finished json = compare_begun(log, {"--json"});
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("known": false)", R"("unknown_s": 12)"});
  EXPECT_EQ(compare_begun(log_of({"1", "2"})).exit_code, 0);
  expect_parts(compare_begun(log, {"--max-deviation", "5m"}).err,
               {"verdict    not known: stays within 5 m in the known time"});
}

TEST_F(DoubtfulShow, NamesWhoStraysFartherThanTheLimit) {
  const Finished farther = compare_begun(log_of({"1", "2"}), {"--max-deviation", "0.5m"});
  EXPECT_EQ(farther.exit_code, kRisk);
  expect_parts(farther.err, {"verdict    1 drone farther than 0.5 m: 2 (Drone 2)\n"});
  const Finished within = compare_begun(log_of({"1", "2"}), {"--max-deviation", "2m"});
  EXPECT_EQ(within.exit_code, 0);
  expect_parts(within.err, {"verdict    stays within 2 m\n"});
}

TEST_F(DoubtfulShow, NamesWhoWasSetOrFlownAlone) {
  const IsThere kFirstAlone = [](std::size_t bee, int /*second*/) { return bee == 0; };
  const Finished missing = compare_begun(log_of({"1", "2"}, kLogHeader, kFirstAlone));
  EXPECT_EQ(missing.exit_code, kRisk);
  expect_parts(missing.err, {"not flown  Drone 2: set, and not in what was flown"});
  expect_parts(missing.out, {"\n\tDrone 2\t\t\t\t\t0\t30\n"});
}

TEST_F(DoubtfulShow, ASpareFliesWhatWasSetToBeginWhereItBegins) {
  const Finished spare = compare_begun(log_of({"1", "12"}));
  EXPECT_EQ(spare.exit_code, 0);
  expect_parts(spare.err, {"'12' was not set to fly, and begins where 'Drone 2' was set to",
                           "farthest   12 (Drone 2), 1.000 m"});
}

TEST_F(DoubtfulShow, IdsThatHaveNothingInCommonAreMatchedByWhereEachBegins) {
  const Finished asked = compare(log_of({"41", "17"}));
  expect_parts(asked.err, {"by the take-off of 2 drones", "--set-begins 2025-11-27T19:00:00.000Z"});
  const Finished finished = compare_begun(log_of({"41", "17"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"'41' that of 'Drone 1'", "farthest   17 (Drone 2), 1.000 m"});
  // Elsewhere none is told.
  const Finished elsewhere =
      compare_begun(log_of({"41", "17"}), {"--origin", "19.07,47.4731,102.5,90"});
  EXPECT_EQ(elsewhere.exit_code, kBadInput);
  expect_parts(elsewhere.err,
               {"no bee was both set and flown: their ids differ ('41' and 'Drone 1')",
                "give both the same ids"});
}

TEST_F(DoubtfulShow, ABeginningInTheAirTellsNoTakeOff) {
  const IsThere kLate = [](std::size_t /*bee*/, int second) { return second >= 12; };
  const Finished asked = compare(log_of({"1", "2"}, kLogHeader, kLate));
  EXPECT_EQ(asked.exit_code, kAskedForMore);
  expect_parts(asked.err,
               {"that must be known, as 2 of 2 drones may be in the air already at their "
                "first fixes, so that no take-off tells it, as in --set-begins 2024"});
}

TEST_F(DoubtfulShow, EachOfSeveralFlightsIsNamed) {
  const std::string log = log_of({"1", "2"}, kLogHeader, {}, 140);
  expect_parts(
      compare(log).err,
      {"that is --set-begins 2025-11-27T19:00:00.000Z; but they take off again: for flight "
       "2 it is --set-begins 2025-11-27T19:01:40.000Z"});
  expect_parts(
      compare_begun(log).err,
      {"what was flown has another flight, which is not compared: 2 drones take off for it "
       "after this one; --set-begins 2025-11-27T19:01:40.000Z compares that"});
}

TEST_F(DoubtfulShow, ABeginningBesideTheTakeOffIsNoted) {
  const Finished late = compare(log_of({"1", "2"}), {"--set-begins", "2025-11-27T19:00:03Z"});
  expect_parts(late.err, {"2 drones take off 3.0 s earlier than set",
                          "by the take-off it is --set-begins 2025-11-27T19:00:00.000Z"});
}

TEST_F(DoubtfulShow, DatesWithoutAZoneNeedOne) {
  std::string log = log_of({"1", "2"});
  for (std::size_t at = log.find("Z,"); at != std::string::npos; at = log.find("Z,", at)) {
    log.erase(at, 1);
  }
  const Finished asked = compare_begun(log);
  EXPECT_EQ(asked.exit_code, kAskedForMore);
  expect_parts(asked.err, {"say it with --time-zone"});
  EXPECT_EQ(compare_begun(log, {"--time-zone", "UTC"}).exit_code, 0);
}

// What is said of tables is not said of the show; and who says a unit in the header need not.
TEST_F(DoubtfulShow, UnitsOfWhatWasFlownAreTaken) {
  EXPECT_EQ(compare_begun(log_of({"1", "2"}), {"--units", "height=m"}).exit_code, 0);
  const Finished named = compare_begun(log_of(
      {"1", "2"}, "timestamp,drone_id,gps.lat,gps.lon,altitudeAMSL [m],altitudeRelative [m]"));
  EXPECT_EQ(named.exit_code, 0) << named.err;
  expect_parts(named.err, {"farthest   2 (Drone 2), 1.000 m", "above mean sea level"});
}

}  // namespace
}  // namespace beespace::cli_test
