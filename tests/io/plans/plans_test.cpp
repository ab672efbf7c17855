#include "io/load_plans.hpp"

#include "tests/io/bytes/gzipping.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Points = std::vector<Point>;
using Velocities = std::vector<Velocity>;
using Numbers = std::vector<double>;

constexpr std::string_view kMission =
    "id,x,y,z,goal_x,goal_y,goal_z\n"
    "a,0,1,2,100,101,102\n"
    "b,-10,0.5,1e1,0,0,0\n";

FlightPlans plans_of(std::string_view text, PlanNeed need = PlanNeed::kGoals) {
  const auto plans = load_flight_plans_from_memory(text, "bees.csv", need);
  EXPECT_TRUE(plans.has_value()) << (plans ? "" : to_string(plans.error()));
  return plans ? *plans : FlightPlans();
}

void expect_mission(const FlightPlans& plans) {
  EXPECT_EQ(plans.ids, (Ids{"a", "b"}));
  EXPECT_EQ(plans.positions, (Points{{0, 1, 2}, {-10, 0.5, 10}}));
  EXPECT_EQ(plans.goals, (Points{{100, 101, 102}, {0, 0, 0}}));
  EXPECT_EQ(plans.velocities, Velocities());
  EXPECT_EQ(plans.preferred, Velocities());
  EXPECT_EQ(plans.max_speeds_mps, Numbers());
  EXPECT_EQ(plans.max_accelerations_mps2, Numbers());
}

TEST(FlightPlansOf, StartsAndGoals) {
  const FlightPlans plans = plans_of(kMission);
  expect_mission(plans);
  EXPECT_TRUE(plans.has_ids);
  EXPECT_EQ(plans.format_description, "text, comma-separated");
  EXPECT_EQ(plans.notes, std::vector<std::string>());
}

TEST(FlightPlansOf, PlansWithPositionsOnly) {
  EXPECT_EQ(plans_of("x,y,z\n1,2,3\n", PlanNeed::kNothing).positions, (Points{{1, 2, 3}}));
  const FlightPlans plans = plans_of("x,y,z,vx,vy,vz\n1,2,3,4,5,6\n", PlanNeed::kNothing);
  EXPECT_EQ(plans.velocities, (Velocities{{4, 5, 6}}));
  EXPECT_EQ(plans.goals, Points());
  expect_mission(plans_of(kMission, PlanNeed::kNothing));
}

TEST(FlightPlansOf, ASnapshotWithVelocitiesAndWishes) {
  const FlightPlans plans = plans_of(
      "id;x;y;z;vx;vy;vz;want_vx;want_vy;want_vz\n"
      "7;1;2;3;0.1;0.2;0.3;-1;-2;-3\n",
      PlanNeed::kGoalsOrPreferred);
  EXPECT_EQ(plans.ids, Ids{"7"});
  EXPECT_EQ(plans.positions, (Points{{1, 2, 3}}));
  EXPECT_EQ(plans.velocities, (Velocities{{0.1, 0.2, 0.3}}));
  EXPECT_EQ(plans.preferred, (Velocities{{-1, -2, -3}}));
  EXPECT_EQ(plans.goals, Points());
  EXPECT_EQ(plans.format_description, "text, semicolon-separated");
}

TEST(FlightPlansOf, ColumnsInAnyOrder) {
  const FlightPlans plans = plans_of(
      "max_acceleration_mps2\tgoal_z\tgoal_y\tgoal_x\tz\ty\tx\tmax_speed_mps\tid\n"
      "4\t6\t5\t4\t3\t2\t1\t12.5\tbee\n");
  EXPECT_EQ(plans.ids, Ids{"bee"});
  EXPECT_EQ(plans.positions, (Points{{1, 2, 3}}));
  EXPECT_EQ(plans.goals, (Points{{4, 5, 6}}));
  EXPECT_EQ(plans.max_speeds_mps, Numbers{12.5});
  EXPECT_EQ(plans.max_accelerations_mps2, Numbers{4});
}

TEST(FlightPlansOf, TheSameInEveryNotation) {
  std::string text(kMission);
  expect_mission(plans_of("\xEF\xBB\xBF" + text));
  expect_mission(plans_of("# " + text));
  expect_mission(plans_of("\n  \n" + text + "\n\n"));
  expect_mission(plans_of(text.substr(0, text.size() - 1)));
  for (const char delimiter : {';', '\t', ' '}) {
    std::string other = text;
    for (char& c : other) c = c == ',' ? delimiter : c;
    expect_mission(plans_of(other));
  }
  std::string lines;
  for (const char c : text) lines += c == '\n' ? "\r\n" : std::string(1, c);
  expect_mission(plans_of(lines));
  expect_mission(plans_of(gzipped(text)));
  EXPECT_EQ(plans_of(gzipped(text)).format_description, "text, comma-separated, gzip-compressed");
  expect_mission(
      plans_of("Bee, start x [m], start y [m], start z [m], target x, target y, target z"
               "\n\"a\", 0, 1, 2, 100, 101, 102\nb, -10, \"0.5\", 10, 0, 0, 0\n"));
}

TEST(FlightPlansOf, AFile) {
  const TemporaryFolder folder;
  const auto plans = load_flight_plans(folder.write("bees.csv", kMission), PlanNeed::kGoals);
  ASSERT_TRUE(plans.has_value()) << to_string(plans.error());
  expect_mission(*plans);
  const std::string nowhere = folder.file("nowhere.csv");
  expect_error(load_flight_plans(nowhere, PlanNeed::kGoals),
               {ErrorCode::kCannotOpen, nowhere, "there is no such file"});
}

TEST(FlightPlansOf, WithoutIdsBeesAreNumbered) {
  const FlightPlans plans = plans_of("x,y,z,goal_x,goal_y,goal_z\n1,2,3,4,5,6\n7,8,9,1,2,3\n");
  EXPECT_EQ(plans.ids, (Ids{"0", "1"}));
  EXPECT_FALSE(plans.has_ids);
  EXPECT_EQ(plans.notes,
            std::vector<std::string>{"there is no id: bees are numbered in their order, from 0"});
}

TEST(FlightPlansOf, IdsAreAnyText) {
  EXPECT_EQ(plans_of("id,x,y,z,goal_x,goal_y,goal_z\n\"a, \"\"b\"\"\",1,2,3,4,5,6\n").ids,
            Ids{"a, \"b\""});
  // "id" before others that may be one.
  EXPECT_EQ(plans_of("name,id,x,y,z,goal_x,goal_y,goal_z\nmaya,7,1,2,3,4,5,6\n").ids, Ids{"7"});
  EXPECT_EQ(plans_of("name,x,y,z,goal_x,goal_y,goal_z\nmaya,1,2,3,4,5,6\n").ids, Ids{"maya"});
}

TEST(FlightPlansOf, UnreadColumnsAreReported) {
  const FlightPlans plans =
      plans_of("id,x,y,z,goal_x,goal_y,goal_z,battery,ve\na,1,2,3,4,5,6,full,7\n");
  EXPECT_EQ(plans.notes, std::vector<std::string>{"not read: column 8 'battery', column 9 've'"});
}

TEST(FlightPlansOf, LimitsAreFilledUp) {
  const FlightLimits usual{10.0, 5.0};
  EXPECT_EQ(limits_of(plans_of(kMission), usual), std::vector<FlightLimits>());
  const std::string header = "x,y,z,goal_x,goal_y,goal_z,";
  const std::string row = "\n1,2,3,4,5,6,";
  EXPECT_EQ(limits_of(plans_of(header + "max_speed" + row + "3" + row + "4"), usual),
            (std::vector<FlightLimits>{{3.0, 5.0}, {4.0, 5.0}}));
  EXPECT_EQ(limits_of(plans_of(header + "max_acceleration" + row + "3"), usual),
            (std::vector<FlightLimits>{{10.0, 3.0}}));
  EXPECT_EQ(limits_of(plans_of(header + "vmax,amax" + row + "3,4"), usual),
            (std::vector<FlightLimits>{{3.0, 4.0}}));
}

}  // namespace
}  // namespace beespace::io
