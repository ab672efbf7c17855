#include "io/load_plans.hpp"

#include "tests/io/bytes/gzipping.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace beespace::io {
namespace {

constexpr std::string_view kHeader =
    "id,x,y,z,goal_x,goal_y,goal_z,vx,vy,vz,max_speed_mps,max_acceleration_mps2\n";
constexpr std::string_view kGood = "a,0,1,2,3,4,5,6,7,8,9,10\n";

Result<FlightPlans> load(std::string_view text, PlanNeed need = PlanNeed::kGoals) {
  return load_flight_plans_from_memory(text, "bees.csv", need);
}

Result<FlightPlans> with_row(std::string_view row) {
  return load(std::string(kHeader) + std::string(kGood) + std::string(row) + "\n");
}

TEST(BadPlans, EmptyInputAndNothingBehindTheHeader) {
  expect_error(load(""), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(load("\xEF\xBB\xBF"), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(load("\n \n"), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(load(kHeader), {ErrorCode::kNoPoints, "bees.csv", "a header and no record"});
}

TEST(BadPlans, WhatIsNoTextTable) {
  expect_error(load(std::string("\x93NUMPY\x01\0", 8)),
               {ErrorCode::kUnsupportedFormat, "bees.csv", ""});
  const std::string packed = gzipped(kHeader);
  expect_error(load(packed.substr(0, packed.size() / 2)),
               {ErrorCode::kTruncated, "bees.csv", "the gzip data ends too"});
  expect_error(load(gzipped(packed)),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "compressed twice"});
}

TEST(BadPlans, WithoutAHeaderNothingIsGuessed) {
  expect_error(load("a,1,2,3,4,5,6\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "there is no header that names the columns; put one before the first record, for "
                "example id,x,y,z,goal_x,goal_y,goal_z"});
  expect_error(load("\n\n1,2,3,4,5,6\n"),
               {ErrorCode::kMissingColumn, "bees.csv:3", "there is no header"});
}

TEST(BadPlans, MissingColumnsAreNamedWithThoseThatAreThere) {
  expect_error(load("id,goal_x,goal_y,goal_z\na,1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the header names no position: x, y and z are needed (the columns are 1 'id', 2 "
                "'goal_x', 3 'goal_y', 4 'goal_z')"});
  expect_error(load("id,x,y,goal_x,goal_y,goal_z\na,1,2,3,4,5\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "a position needs three columns, and beside 'x', 'y' there is no z; add it (the"});
  expect_error(load("id,x,y,z,Goal X\na,1,2,3,4\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "a goal needs three columns, and beside 'Goal X' there is no goal_y, goal_z"});
  expect_error(load("id,x,y,z,goal_x,goal_y,goal_z,vx,vy\na,1,2,3,4,5,6,7,8\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "a velocity needs three columns, and beside 'vx', 'vy' there is no vz"});
  expect_error(
      load("x,y,z,want_vx\n1,2,3,4\n", PlanNeed::kGoalsOrPreferred),
      {ErrorCode::kMissingColumn, "bees.csv:1",
       "a preferred velocity needs three columns, and beside 'want_vx' there is no want_vy,"});
}

TEST(BadPlans, SomethingMustBeIntended) {
  constexpr std::string_view kWishes = "x,y,z,want_vx,want_vy,want_vz\n1,2,3,4,5,6\n";
  expect_error(load("x,y,z\n1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the header names no goals: goal_x, goal_y and goal_z are needed (the columns"});
  expect_error(load(kWishes), {ErrorCode::kMissingColumn, "bees.csv:1", "names no goals"});
  EXPECT_TRUE(load(kWishes, PlanNeed::kGoalsOrPreferred).has_value());
  expect_error(load("x,y,z\n1,2,3\n", PlanNeed::kGoalsOrPreferred),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the header names neither goals nor preferred velocities: goal_x, goal_y, goal_z "
                "or want_vx, "
                "want_vy, want_vz are needed"});
}

TEST(BadPlans, ColumnsThatLookAlike) {
  expect_error(load("x,y,z,goal_x,goal_y,goal_z,target_y\n1,2,3,4,5,6,7\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1:7",
                "both column 5 'goal_y' and column 7 'target_y' look like the same; keep one"});
  expect_error(load("x,y,z,goal_x,goal_y,goal_z,vmax,max_speed\n1,2,3,4,5,6,7,8\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1:8", "look like the same"});
}

TEST(BadPlans, UnitsThatAreNotRead) {
  expect_error(load("x,y,z,goal_x,goal_y,goal_z,max_acceleration_g\n1,2,3,4,5,6,7\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1:7", "is in 'g'; convert it first"});
  expect_error(load("id,lon,lat,height,goal_lon,goal_lat,goal_height\na,1,2,3,4,5,6\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1",
                "positions in degrees are not read here; convert them to metres"});
}

TEST(BadPlans, NumbersThatAreNone) {
  expect_error(with_row("b,oops,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "'oops' is not a number (x); correct it"});
  expect_error(with_row("b,0,1,2,3,,5,6,7,8,9,10"),
               {ErrorCode::kNotANumber, "bees.csv:3:6",
                "the field is empty where a number should be (goal_y); fill it in"});
  expect_error(with_row("b,0,1,nan,3,4,5,6,7,8,9,10"),
               {ErrorCode::kNotFinite, "bees.csv:3:4", "'nan' is no number of m (z); correct it"});
  expect_error(with_row("b,0,1,2,3,4,-inf,6,7,8,9,10"),
               {ErrorCode::kNotFinite, "bees.csv:3:7", "'-inf' is no number of m (goal_z)"});
  expect_error(with_row("b,0,1,2,3,4,5,6,7,NaN,9,10"),
               {ErrorCode::kNotFinite, "bees.csv:3:10", "'NaN' is no number of m/s (vz)"});
  expect_error(with_row("b,0,1,2,3,4,5,6,7,8,9,inf"),
               {ErrorCode::kNotFinite, "bees.csv:3:12",
                "'inf' is no number of m/s^2 (the greatest acceleration)"});
  expect_error(with_row("b,1e999,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kNotFinite, "bees.csv:3:2", "too large for a number"});
}

TEST(BadPlans, NumbersThatMotionCannotBeComputedWith) {
  expect_error(with_row("b,1e31,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:2",
                "'1e31' cannot be computed with exactly (x); use a size of 7.9e-31 to 1.3e+30 m, "
                "or 0"});
  expect_error(with_row("b,0,1,2,3,4,5,6,7,8,1e-40,10"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:11", "(the greatest speed)"});
}

TEST(BadPlans, NumbersThatAreTooSmallCountAsZero) {
  EXPECT_TRUE(with_row("b,0,-9.8e-32,2,3,4,5,1e-40,7,8,9,10").has_value());
}

TEST(BadPlans, LimitsAreAboveZero) {
  expect_error(with_row("b,0,1,2,3,4,5,6,7,8,0,10"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:11",
                "'0' is not above zero (the greatest speed); correct it"});
  expect_error(with_row("b,0,1,2,3,4,5,6,7,8,9,-1"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:12",
                "'-1' is not above zero (the greatest acceleration)"});
}

TEST(BadPlans, RecordsThatAreDamaged) {
  expect_error(with_row("b,0,1,2"), {ErrorCode::kColumnCount, "bees.csv:3",
                                     "4 columns where the header has 12: 'b,0,1,2'; correct it"});
  expect_error(with_row("\"b,0,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:1", "may not span several lines"});
  expect_error(with_row("# b,0,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "a comment, or a record?"});
  expect_error(with_row(",0,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:1", "the id is empty; fill it in"});
}

TEST(BadPlans, NoBeeIsThereTwice) {
  expect_error(with_row("\na,0,1,2,3,4,5,6,7,8,9,10"),
               {ErrorCode::kMalformedRecord, "bees.csv:4:1",
                "the bee 'a' is on line 2 already; give each an id of its own"});
}

TEST(BadPlans, NoErrorSpeaksOfOptionsThatAreNotThere) {
  for (const char* row : {"b,oops,1,2,3,4,5,6,7,8,9,10", "b,,1,2,3,4,5,6,7,8,9,10", "b,0", "\"b",
                          "b,nan,1,2,3,4,5,6,7,8,9,10"}) {
    const auto loaded = with_row(row);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_EQ(loaded.error().message.find("--"), std::string::npos) << loaded.error().message;
  }
}

}  // namespace
}  // namespace beespace::io
