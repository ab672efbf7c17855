// `beespace verify`: recordings whose distances, speeds and accelerations are computed by hand.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// They pass at 4 m, in the middle of the first second; at their fixes they are far apart. c is far
// from all.
constexpr std::string_view kPassing =
    "id,time_s,x,y,z\n"
    "a,0,0,0,0\nb,0,20,4,0\nc,0,0,0,900\n"
    "a,1,20,0,0\nb,1,0,4,0\nc,1,0,0,900\n"
    "a,2,40,0,0\nb,2,-20,4,0\nc,2,0,0,900\n";

// In straight lines they keep 8 m. But each sets out towards the other at 4 m/s and turns back with
// 8 m/s^2: after half a second it is 1 m off its line.
constexpr std::string_view kBulging =
    "time_s,id,x,y,z,vx,vy,vz\n"
    "0,a,0,0,0,0,4,0\n0,b,0,8,0,0,-4,0\n"
    "1,a,0,0,0,0,-4,0\n1,b,0,8,0,0,4,0\n";

// From rest with 3 m/s^2 for 2 s, then on.
constexpr std::string_view kSpeedingUp =
    "time_s,id,x,y,z,vx,vy,vz\n"
    "0,a,0,0,0,0,0,0\n2,a,6,0,0,6,0,0\n4,a,18,0,0,6,0,0\n";

TEST(Verify, APassBetweenFixesIsFound) {
  const Finished finished = run({"verify"}, kPassing);
  EXPECT_EQ(finished.exit_code, 1);
  expect_rows(rows_of(finished.out), {{"loss", "a", "b", "0", "1", "4"}});
  expect_parts(
      finished.err,
      {"bees       3\n", "from       0.00 s to 2.00 s (2.00 s)\n",
       "motion     straight lines from fix to fix: there are no velocities\n",
       "threshold  5 m (closer than), the default (--threshold)\n",
       "limits     not checked (--max-speed, --max-acceleration)\n", "checked    2 steps\n",
       "closest    a and b, 4.000 m apart in the step from 0.00 s", "peak speed 20.000 m/s\n",
       "peak accel not known of straight lines\n", "losses     1 pair in a step\n",
       "breaches   none\n", "verdict    does not keep its distance\n", "time       read "});
}

TEST(Verify, ARecordingWithSeparationHolds) {
  const Finished finished = run({"verify", "--threshold", "3.99", "--max-speed", "20"}, kPassing);
  EXPECT_EQ(finished.exit_code, 0) << finished.out;
  EXPECT_EQ(below_header(finished.out), "");
  expect_parts(finished.err, {"limits     20 m/s\n", "losses     none\n", "verdict    holds\n"});
  expect_parts(run({"verify", "--threshold", "1"}, kPassing).err,
               {"closest    no two came closer than 2 m\n"});
}

// There is nothing that it could be too close to: what holds is named, and where nothing was
// checked it is no all-clear.
TEST(Verify, OneBeeAloneIsNoPair) {
  for (const std::string limit : {"--max-speed", "--max-horizontal"}) {
    const Finished limited = run({"verify", limit, "10"}, kSpeedingUp);
    EXPECT_EQ(limited.exit_code, 0) << limited.err;
    expect_parts(limited.err,
                 {"closest    there is one bee, and no pair\n",
                  "verdict    one bee, so that there is no pair to compare; its limits "
                  "hold\n"});
  }
  const Finished nothing = run({"verify"}, kSpeedingUp);
  EXPECT_EQ(nothing.exit_code, 1);
  expect_parts(nothing.err, {"verdict    nothing to compare: there is one bee, so that there is no "
                             "pair, and no limit to check it by (--max-speed, ...)\n"});
  EXPECT_NE(run({"verify", "--json"}, kSpeedingUp).out.find("\"holds\": false"), std::string::npos);
}

// In mm beside a threshold in mm, in steps and along curves.
TEST(Verify, SmallDistancesAreInTheUnitOfTheThreshold) {
  const std::string header = "id,time_s,x_mm,y_mm,z_mm\n";
  const std::string apart = "a,0,0,0,0\nb,0,4.56,0,0\na,1,0,0,0\nb,1,4.56,0,0\n";
  for (const std::string more : {"", "b,1.5,4.56,0,0\n"}) {
    const Finished finished = run({"verify", "--threshold", "2mm"}, header + apart + more);
    expect_parts(finished.err, {more.empty() ? "no two came closer than 4.0 mm" : "4.6 mm apart"});
  }
  expect_parts(run({"verify", "--threshold", "3mm"}, header + apart).err, {"4.6 mm apart"});
}

TEST(Verify, ABeeThatIsTooFastIsFound) {
  const Finished finished =
      run({"verify", "--threshold", "1", "--max-speed", "19.9", "--threads", "1"}, kPassing);
  EXPECT_EQ(finished.exit_code, 1);
  expect_rows(rows_of(finished.out), {{"speed", "a", "", "0", "1", "20"},
                                      {"speed", "b", "", "0", "1", "20"},
                                      {"speed", "a", "", "1", "2", "20"},
                                      {"speed", "b", "", "1", "2", "20"}});
  expect_parts(finished.err,
               {"breaches   4 times a limit in a step\n", "verdict    breaks the limits\n"});
}

TEST(Verify, VelocitiesBendTheWayBetweenFixes) {
  const Finished finished = run({"verify", "--threshold", "6.01"}, kBulging);
  EXPECT_EQ(finished.exit_code, 1);
  expect_rows(rows_of(finished.out), {{"loss", "a", "b", "0", "1", "6"}});
  expect_parts(finished.err, {"motion     curves from fix to fix, with the velocities at both",
                              "peak speed 4.000 m/s\n", "peak accel 8.000 m/s^2\n"});
  EXPECT_EQ(run({"verify", "--threshold", "5.99"}, kBulging).exit_code, 0);
  const Finished straight = run({"verify", "--threshold", "6.01", "--straight"}, kBulging);
  EXPECT_EQ(straight.exit_code, 0) << straight.out;
  expect_parts(straight.err, {"motion     straight lines from fix to fix (--straight)\n"});
}

TEST(Verify, ABeeThatAcceleratesTooHardIsFound) {
  const Arguments question = {"verify", "--max-speed", "6", "--max-acceleration"};
  EXPECT_EQ(run(question + Arguments{"3"}, kSpeedingUp).exit_code, 0);
  const Finished finished = run(question + Arguments{"2.9"}, kSpeedingUp);
  EXPECT_EQ(finished.exit_code, 1);
  expect_rows(rows_of(finished.out), {{"acceleration", "a", "", "0", "2", "3"}});
  expect_parts(finished.err, {"limits     6 m/s, 2.9 m/s^2\n", "peak accel 3.000 m/s^2\n",
                              "breaches   1 limit in a step\n"});
}

TEST(Verify, LossesAndBreachesComeTogether) {
  const Finished finished = run({"verify", "--max-speed", "19"}, kPassing);
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(rows_of(finished.out).size(), 5u);
  expect_parts(finished.err, {"verdict    does not keep its distance, and breaks the limits\n"});
}

TEST(Verify, TheSameFindingsComeInEveryForm) {
  const Finished csv = run({"verify", "--csv", "--max-speed", "19"}, kPassing);
  const TextRows rows = rows_of(csv.out, ',');
  ASSERT_EQ(rows.size(), 6u);
  expect_rows({rows[0], rows[1], rows[2]},
              {{"finding", "first", "second", "begins_s", "ends_s", "value"},
               {"loss", "a", "b", "0", "1", "4"},
               {"speed", "a", "", "0", "1", "20"}});
  const Finished json = run({"verify", "--json", "--max-speed", "19"}, kPassing);
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out,
               {R"("command": "verify")", R"("threshold_m": 5)", R"("max_speed_mps": 19)",
                R"("max_acceleration_mps2": null)", R"("straight": true)", R"("steps": 2)",
                R"("holds": false)", R"("loss_count": 1)", R"("breach_count": 4)",
                R"("peak_speed_mps": 20)", R"("peak_acceleration_mps2": null)",
                R"("closest": {"first": "a", "second": "b", "step_begins_s": 0, "distance_m": )",
                R"({"finding": "loss", "first": "a", "second": "b", "begins_s": 0, "ends_s": 1,)",
                R"({"finding": "speed", "first": "a", "second": null, "begins_s": 0,)"});
  const Finished fine = run({"verify", "--json", "--threshold", "1", "--quiet"}, kPassing);
  EXPECT_TRUE(is_json(fine.out)) << fine.out;
  expect_parts(fine.out, {R"("holds": true)", R"("closest": null)", R"("findings": [])"});
  EXPECT_EQ(fine.err, "");
}

TEST(Verify, OfManyFindingsTheFirstThousandAreListed) {
  // 50 at one place: 1225 pairs.
  std::string crowd = "id,time_s,x,y,z\n";
  for (const char* time : {"0", "1"}) {
    for (int bee = 0; bee < 50; ++bee) {
      crowd += std::to_string(bee) + "," + time + ",0,0,0\n";
    }
  }
  const Finished finished = run({"verify"}, crowd);
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(rows_of(finished.out).size(), 1000u);
  expect_parts(
      finished.err,
      {"losses     1,225 times a pair in a step, of which the answer has the first 1,000\n"});
  expect_parts(run({"verify", "--json"}, crowd).out, {R"("loss_count": 1225)"});
}

// In metres each is followed along its own times: b passes a at 4 m between the fixes of both.
TEST(Verify, BeesInMetresMayHaveFixesAtTimesOfTheirOwn) {
  const std::string_view flight =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,10,0,0\na,2,20,0,0\nb,0.5,20,4,0\nb,1.5,0,4,0\n";
  const Finished lost = run({"verify"}, flight);
  EXPECT_EQ(lost.exit_code, 1);
  const TextRows rows = rows_of(lost.out);
  ASSERT_EQ(rows.size(), 1u) << lost.out;
  EXPECT_EQ(rows[0][0], "loss");
  EXPECT_NEAR(std::stod(rows[0][5]), 4.0, 1e-6);
  EXPECT_EQ(rows[0][6], "5");
  expect_parts(lost.err, {"motion     straight lines from fix to fix: there are no velocities\n"});
  EXPECT_EQ(run({"verify", "--threshold", "4"}, flight).exit_code, 0);
  EXPECT_EQ(run({"verify", "--threshold", "4", "--max-speed", "19"}, flight).exit_code, 1);
}

TEST(Verify, OneTimeIsNoFlight) {
  expect_failure({"verify"}, "id,time_s,x,y,z\na,0,0,0,0\nb,0,9,0,0\n", kBadInput,
                 "there is one time only");
  expect_failure({"verify"}, "id,time_s,lon,lat,height\na,0,8,47,0\nb,1,9,47,0\n", kBadInput,
                 "bee 'b' has no fix at 0 s, where bee 'a' has one");
}

TEST(Verify, AccelerationsNeedVelocities) {
  expect_failure({"verify", "--max-acceleration", "5"}, kPassing, kBadInput,
                 "--max-acceleration needs velocities, and bee 'a' has none at 0 s");
  expect_usage_error({"verify", "--max-acceleration", "5", "--straight"},
                     "--max-acceleration needs the velocities, and --straight ignores them");
}

TEST(Verify, AShowFliesAlongItsCurves) {
  const TemporaryFolder folder;
  const auto show_with = [&folder](const char* name, const std::string& controls) {
    return folder.file(name,
                       R"({"version": 1, "settings": {}, "swarm": {"drones": [{"type": "generic",
        "settings": {"name": "a", "trajectory": {"version": 1,
        "points": [[0, [0, 0, 0], []], [9, [0, 0, 9], [)" +
                           controls + "]]]}}}]}}");
  };
  const std::string curved = show_with("curved.json", "[0, 1, 3], [0, 1, 6]");
  expect_parts(run({"verify", curved}).err, {"motion     along the curves of the show\n"});
  const std::string show = show_with("show.json", "");
  expect_parts(run({"verify", show}).err, {"motion     along the straight lines of the show\n"});
  EXPECT_EQ(run({"verify", show, "--max-climb", "1"}).exit_code, 0);
  const Finished fast = run({"verify", show, "--max-climb", "0.9"});
  EXPECT_EQ(fast.exit_code, 1);
  expect_rows(rows_of(fast.out), {{"climb", "a", "", "0", "9", "1", "0.9", "0"}});
  const Finished straight = run({"verify", show, "--straight"});
  EXPECT_NE(straight.exit_code, 0);
  expect_parts(straight.err, {"drones of a show fly along their curves; leave --straight out"});
}

TEST(Verify, BadInputIsRefusedWithItsPlace) {
  expect_failure({"verify"}, "id,time_s,x,y,z\na,0,0,0,0\na,1,zero,0,0\n", kBadInput, ":3:");
  expect_failure({"verify"}, "id,time_s,x,y,z\na,0,0,0,0\na,1,inf,0,0\n", kBadInput, ":3:");
  expect_failure({"verify"}, "", kBadInput, "<stdin>");
  expect_failure({"verify", "there-is-none.csv"}, {}, 4, "there-is-none.csv");
  const Finished json = run({"verify", "--json"}, "id,time_s,x,y,z\na,0,0,0,0\nb,0,9,0,0\n");
  EXPECT_EQ(json.exit_code, kBadInput);
  EXPECT_TRUE(is_json(json.out)) << json.out;
}

TEST(Verify, SeveralFilesAreOneRecording) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.csv", "time_s,x,y,z\n1,0,0,0\n2,20,0,0\n");
  const std::string b = folder.file("b.csv", "time_s,x,y,z\n1,20,4,0\n2,0,4,0\n");
  const Finished finished = run({"verify", a, b});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_rows(rows_of(finished.out), {{"loss", "a", "b", "1", "2", "4"}});
}

TEST(Verify, DegreesBecomeMetres) {
  // On the equator, 0.0001 degrees are 11.132 m; they fly north side by side at 10 m/s.
  const std::string text =
      "id,time_s,lon,lat,height,ve,vn,vu\n"
      "a,0,0,0,100,0,10,0\nb,0,0.0001,0,100,0,10,0\n"
      "a,1,0,0.0000904366,100,0,10,0\nb,1,0.0001,0.0000904366,100,0,10,0\n";
  const Finished finished = run({"verify", "--threshold", "11.14"}, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(std::stod(rows[0].at(5)), 11.1321, 0.0005);
  expect_parts(finished.err, {"frame      WGS84 longitude, latitude, height", "peak speed 10.0"});
  EXPECT_EQ(run({"verify", "--threshold", "11.12"}, text).exit_code, 0);
}

TEST(Verify, InvalidNumbersAreRefused) {
  for (const std::string bad : {"-1", "nan", "inf", "fast"}) {
    expect_usage_error({"verify", "--max-speed=" + bad},
                       "--max-speed '" + bad + "' is not a number of metres per second from 0 on");
    expect_usage_error(
        {"verify", "--max-acceleration=" + bad},
        "--max-acceleration '" + bad + "' is not a number of metres per second squared from 0 on");
  }
  expect_usage_error({"verify", "--threshold", "0"}, "the threshold is 0 m");
  EXPECT_EQ(run({"verify", "--csv", "--json"}, kPassing).exit_code, 2);
  expect_usage_error({"verify", "--fail-on-risk"}, "'--fail-on-risk' is no option");
  expect_usage_error({"verify", "--vertical=-5"}, "--vertical");
}

TEST(Verify, AnAnswerThatCannotBeWrittenIsAnError) {
  EXPECT_EQ(run({"verify", "--output", "/dev/full"}, kPassing).exit_code, 4);
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  const Finished finished = run({"verify"}, kPassing, closed);
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

TEST(Verify, TheAnswerIsTheSameWithAnyNumberOfThreads) {
  const Arguments question = {"verify", "--max-speed", "9"};
  EXPECT_EQ(run(question + Arguments{"--threads", "1"}, kPassing).out,
            run(question + Arguments{"--threads", "3"}, kPassing).out);
}

}  // namespace
}  // namespace beespace::cli_test
