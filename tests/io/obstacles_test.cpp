#include "io/load_obstacles.hpp"

#include "tests/io/bytes/gzipping.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Result<std::vector<Obstacle>> load(std::string_view text) {
  return load_obstacles_from_memory(text, "city.json");
}

// A file with a sphere, and this behind it.
Result<std::vector<Obstacle>> with(const std::string& obstacle) {
  return load(R"({"obstacles": [{"kind": "sphere", "center": [1, 2, 3], "radius_m": 4}, )" +
              obstacle + "]}");
}

std::vector<Obstacle> obstacles_of(const Result<std::vector<Obstacle>>& loaded) {
  EXPECT_TRUE(loaded.has_value()) << (loaded ? "" : to_string(loaded.error()));
  return loaded ? *loaded : std::vector<Obstacle>();
}

constexpr std::string_view kAll = R"({
  "obstacles": [
    {"kind": "sphere", "center": [1, 2, 3], "radius_m": 4.5},
    {"high": [4, 5, 6], "low": [1, 2, 3], "kind": "box"},
    {"kind": "ground", "height_m": -7},
    {"kind": "cylinder", "center": [1, 2], "radius_m": 3, "low_m": 0, "high_m": 40},
    {"kind": "prism", "outline": [[0, 0], [10, 0], [0, 10.5]], "high_m": 20}
  ]
})";

void expect_all(const std::vector<Obstacle>& obstacles) {
  ASSERT_EQ(obstacles.size(), 5u);
  const auto& sphere = std::get<Sphere>(obstacles[0]);
  EXPECT_EQ(sphere.center, (Point{1, 2, 3}));
  EXPECT_EQ(sphere.radius_m, 4.5);
  const auto& box = std::get<Box>(obstacles[1]);
  EXPECT_EQ(box.low, (Point{1, 2, 3}));
  EXPECT_EQ(box.high, (Point{4, 5, 6}));
  EXPECT_EQ(std::get<Ground>(obstacles[2]).height_m, -7);
  const auto& cylinder = std::get<UprightCylinder>(obstacles[3]);
  EXPECT_EQ(cylinder.x, 1);
  EXPECT_EQ(cylinder.y, 2);
  EXPECT_EQ(cylinder.radius_m, 3);
  EXPECT_EQ(cylinder.heights.low_m, 0);
  EXPECT_EQ(cylinder.heights.high_m, 40);
  const auto& prism = std::get<UprightPrism>(obstacles[4]);
  ASSERT_EQ(prism.outline.size(), 3u);
  EXPECT_EQ(prism.outline[1].x, 10);
  EXPECT_EQ(prism.outline[2].y, 10.5);
  EXPECT_EQ(prism.heights.low_m, -kInfinite);
  EXPECT_EQ(prism.heights.high_m, 20);
}

TEST(Obstacles, OfAllKinds) {
  expect_all(obstacles_of(load(kAll)));
  expect_all(obstacles_of(load("\xEF\xBB\xBF" + std::string(kAll))));
  expect_all(obstacles_of(load(gzipped(kAll))));
}

TEST(Obstacles, OfAFile) {
  const TemporaryFolder folder;
  expect_all(obstacles_of(load_obstacles(folder.write("city.json", kAll))));
  const std::string nowhere = folder.file("nowhere.json");
  expect_error(load_obstacles(nowhere), {ErrorCode::kCannotOpen, nowhere, "no such file"});
}

TEST(Obstacles, MayBeNone) {
  EXPECT_EQ(obstacles_of(load(R"({"obstacles": []})")).size(), 0u);
}

TEST(Obstacles, WithoutHeightsTheyHaveNoEnd) {
  for (const char* heights : {"", R"(, "low_m": null, "high_m": null)"}) {
    const auto obstacles = obstacles_of(with(
        R"({"kind": "cylinder", "center": [1, 2], "radius_m": 3)" + std::string(heights) + "}"));
    ASSERT_EQ(obstacles.size(), 2u);
    const Heights& found = std::get<UprightCylinder>(obstacles[1]).heights;
    EXPECT_EQ(found.low_m, -kInfinite);
    EXPECT_EQ(found.high_m, kInfinite);
  }
}

TEST(BadObstacles, WhatIsNoJson) {
  expect_error(load(""), {ErrorCode::kNoPoints, "city.json", "the input is empty"});
  expect_error(load("{\n  \"obstacles\": [\n    oops]}"),
               {ErrorCode::kCorrupt, "city.json:3:5", "this is no JSON: a value is expected"});
  expect_error(load("{\"obstacles\": [{\"kind\": \"ground\", \"height_m\": NaN}]}"),
               {ErrorCode::kCorrupt, "city.json:1:47", "a value is expected, not 'NaN"});
  expect_error(load("{\"obstacles\": [{"),
               {ErrorCode::kTruncated, "city.json:1:17", "the JSON ends too early"});
  expect_error(load(gzipped(gzipped(kAll))),
               {ErrorCode::kUnsupportedFormat, "city.json", "compressed twice"});
}

TEST(BadObstacles, WhatListsNone) {
  expect_error(load("[]"), {ErrorCode::kMalformedRecord, "city.json",
                            "this document is an array where a list of obstacles should be"});
  expect_error(load("{}"),
               {ErrorCode::kMissingColumn, "city.json", "this document has no obstacles"});
  expect_error(load(R"({"obstacles": {}})"),
               {ErrorCode::kMalformedRecord, "city.json",
                "obstacles is an object where a list of them should be, in [ ]; correct it"});
  expect_error(load(R"({"obstacles": [], "walls": []})"),
               {ErrorCode::kUnsupportedFormat, "city.json",
                "this document has a member 'walls' that is not known; a list of obstacles has "
                "obstacles"});
}

TEST(BadObstacles, KindsThatAreNone) {
  expect_error(with("7"), {ErrorCode::kMalformedRecord, "city.json",
                           "obstacles[1] is a number where an obstacle should be, in { }"});
  expect_error(with("{}"),
               {ErrorCode::kMissingColumn, "city.json",
                "obstacles[1] has no kind; say which it is: \"kind\": one of sphere, box, ground, "
                "cylinder or prism"});
  expect_error(with(R"({"kind": 3})"), {ErrorCode::kMissingColumn, "city.json",
                                        "obstacles[1].kind is a number; say which"});
  expect_error(with(R"({"kind": "cone"})"),
               {ErrorCode::kUnsupportedFormat, "city.json",
                "obstacles[1].kind 'cone' is not known; it is one of sphere, box, ground"});
}

TEST(BadObstacles, MembersThatAreNotKnownOrThereTwiceOrMissing) {
  expect_error(with(R"({"kind": "sphere", "center": [1, 2, 3], "radius": 4})"),
               {ErrorCode::kUnsupportedFormat, "city.json",
                "obstacles[1] has a member 'radius' that is not known; a sphere has kind, center, "
                "radius_m"});
  expect_error(with(R"({"kind": "ground", "height_m": 1, "height_m": 2})"),
               {ErrorCode::kMalformedRecord, "city.json",
                "obstacles[1] has two members 'height_m'; keep one"});
  expect_error(with(R"({"kind": "sphere", "center": [1, 2, 3]})"),
               {ErrorCode::kMissingColumn, "city.json",
                "obstacles[1] has no radius_m, which a sphere needs; add it"});
  expect_error(with(R"({"kind": "box", "low": null, "high": [1, 2, 3]})"),
               {ErrorCode::kMissingColumn, "city.json", "obstacles[1] has no low, which a box"});
  expect_error(with(R"({"kind": "cylinder", "radius_m": 4})"),
               {ErrorCode::kMissingColumn, "city.json", "obstacles[1] has no center"});
  expect_error(with(R"({"kind": "prism"})"),
               {ErrorCode::kMissingColumn, "city.json", "obstacles[1] has no outline"});
}

TEST(BadObstacles, ValuesOfAnotherKind) {
  expect_error(with(R"({"kind": "ground", "height_m": "low"})"),
               {ErrorCode::kNotANumber, "city.json",
                "obstacles[1].height_m is a string where a number should be"});
  expect_error(with(R"({"kind": "sphere", "center": [1, 2], "radius_m": 3})"),
               {ErrorCode::kColumnCount, "city.json",
                "obstacles[1].center is an array of 2 values where a position [x, y, z] should"});
  expect_error(with(R"({"kind": "cylinder", "center": [1, 2, 3], "radius_m": 3})"),
               {ErrorCode::kColumnCount, "city.json",
                "obstacles[1].center is an array of 3 values where [x, y] should be"});
  expect_error(with(R"({"kind": "cylinder", "center": [1, "2"], "radius_m": 3})"),
               {ErrorCode::kNotANumber, "city.json", "obstacles[1].center[1] is a string"});
  expect_error(with(R"({"kind": "prism", "outline": 7})"),
               {ErrorCode::kMalformedRecord, "city.json",
                "obstacles[1].outline is a number where a list of corners [x, y] should be"});
  expect_error(with(R"({"kind": "prism", "outline": [[1, 2], [3, 4], {}]})"),
               {ErrorCode::kColumnCount, "city.json",
                "obstacles[1].outline[2] is an object where [x, y] should be"});
  expect_error(
      with(R"({"kind": "prism", "outline": [[1, 2], [3, true]]})"),
      {ErrorCode::kNotANumber, "city.json", "obstacles[1].outline[1][1] is true or false"});
  expect_error(with(R"({"kind": "cylinder", "center": [1, 2], "radius_m": 3, "low_m": "deep"})"),
               {ErrorCode::kNotANumber, "city.json", "obstacles[1].low_m is a string"});
}

TEST(BadObstacles, NumbersThatCannotBeComputedWith) {
  expect_error(with(R"({"kind": "ground", "height_m": 1e31})"),
               {ErrorCode::kOutsideDomain, "city.json",
                "obstacles[1].height_m cannot be computed with exactly"});
  expect_error(with(R"({"kind": "box", "low": [0, 0, 1e-40], "high": [1, 1, 1]})"),
               {ErrorCode::kOutsideDomain, "city.json", "obstacles[1].low[2] cannot be computed"});
  expect_error(with(R"({"kind": "ground", "height_m": 1e999})"),
               {ErrorCode::kCorrupt, "city.json", "this JSON cannot be read"});
}

}  // namespace
}  // namespace beespace::io
