#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

constexpr const char* kTrajectory = R"({"points": [[0, [1, 2, 0]], [5, [1, 2, 5]]]})";

std::string drone(const std::string& trajectory, const std::string& more = "") {
  return R"({"settings": {"name": "a", "trajectory": )" + trajectory + more + "}}";
}

std::string show(const std::string& drones, const std::string& settings = "{}") {
  return R"({"settings": )" + settings + R"(, "swarm": {"drones": [)" + drones + "]}}";
}

Result<Recording> load(const std::string& json, const RecordingOptions& options = {}) {
  return load_recording_from_memory(json, "show.json", options);
}

Result<Recording> with_points(const std::string& points) {
  return load(show(drone(R"({"points": )" + points + "}")));
}

Result<Recording> zip_with(const std::string& reference, const Members& more = {}) {
  Members members = {{"show.json", show(drone(R"({"$ref": ")" + reference + "\"}"))}};
  members.insert(members.end(), more.begin(), more.end());
  return load_recording_from_memory(zipped(members), "show.skyc");
}

TEST(BadShow, InvalidJsonOrNoShow) {
  expect_error(load("{\"swarm\": {\"drones\": [NaN]}}"),
               {ErrorCode::kCorrupt, "show.json:1:23", "this is no JSON: a value is expected"});
  expect_error(load("{\"swarm\": {\"drones\": ["),
               {ErrorCode::kTruncated, "show.json:1:23", "the JSON ends too early"});
  expect_error(load("{\"planes\": []}"), {ErrorCode::kUnsupportedFormat, "show.json",
                                          "nor a Skybrush show, as it has no 'swarm'"});
  RecordingOptions options;
  options.format = RecordingFormat::kSkybrushShow;
  expect_error(load("id,time_s,x,y,z\n", options),
               {ErrorCode::kUnsupportedFormat, "show.json", "this is no Skybrush show"});
  expect_error(load(zipped({{"a.csv", "id"}}), options),
               {ErrorCode::kCannotOpen, "show.json", "there is no file 'show.json'"});
}

TEST(BadShow, NoDrones) {
  expect_error(load("{\"swarm\": {}}"), {ErrorCode::kNoPoints, "show.json", "has no drones"});
  expect_error(load(show("")), {ErrorCode::kNoPoints, "show.json", "has no drones"});
  expect_error(load("{\"swarm\": {\"drones\": 3}}"), {ErrorCode::kNoPoints, "show.json", "no dr"});
}

TEST(BadShow, WithoutDrones) {
  expect_error(with_points("[[0, [0, 0, 0]], [9, [0, 0, 0]]]"),
               {ErrorCode::kNoPoints, "show.json", "no drone of this show leaves the ground"});
}

TEST(BadShow, OtherVersions) {
  expect_error(load(R"({"version": 2, "swarm": {"drones": []}})"),
               {ErrorCode::kUnsupportedFormat, "show.json", "the show is of another version"});
  expect_error(load(show(drone(R"({"version": "x", "points": []})"))),
               {ErrorCode::kUnsupportedFormat, "show.json", "trajectory is of another version"});
}

TEST(BadShow, NoTrajectory) {
  const auto missing = load(show(drone(kTrajectory) + R"(, {"settings": {"name": "b"}})"));
  expect_error(missing, {ErrorCode::kMissingColumn, "show.json",
                         "drone 2 has no settings.trajectory; export the show again"});
  EXPECT_FALSE(missing.error().location.record);  // the message names the drone
  expect_error(load(show("7")), {ErrorCode::kMissingColumn, "show.json", "drone 1 has no"});
  expect_error(load(show(drone("3"))),
               {ErrorCode::kMalformedRecord, "show.json",
                "drone 'a': the trajectory is a number where an object should be"});
  expect_error(load(show(drone("{}"))),
               {ErrorCode::kMissingColumn, "show.json", "the trajectory has no 'points'"});
}

TEST(BadShow, PointsThatAreNone) {
  expect_error(with_points("7"),
               {ErrorCode::kMalformedRecord, "show.json", "points is a number where an array"});
  expect_error(with_points("[]"), {ErrorCode::kNoPoints, "show.json", "points is empty"});
  expect_error(with_points("[[0]]"),
               {ErrorCode::kMalformedRecord, "show.json", "drone 'a': points[0] is no [time, [x"});
  expect_error(with_points("[[0, [1, 2, 3], [], 4]]"),
               {ErrorCode::kMalformedRecord, "show.json", "points[0] is no [time"});
  expect_error(with_points("[[\"0\", [1, 2, 3]]]"),
               {ErrorCode::kNotANumber, "show.json", "points[0][0] is a string where a number"});
  expect_error(with_points("[[0, [1, 2]]]"), {ErrorCode::kColumnCount, "show.json",
                                              "points[0][1] is an array of 2 values where"});
  expect_error(with_points("[[0, [1, null, 3]]]"),
               {ErrorCode::kNotANumber, "show.json", "points[0][1][1] is null where a number"});
  expect_error(with_points("[[0, [1, 2, 1e31]]]"),
               {ErrorCode::kOutsideDomain, "show.json", "points[0][1][2] cannot be computed with"});
  expect_error(with_points("[[0, 7]]"),
               {ErrorCode::kColumnCount, "show.json", "points[0][1] is a number where a position"});
}

TEST(BadShow, ControlPointsThatAreNone) {
  expect_error(with_points("[[0, [1, 2, 3]], [1, [1, 2, 3], [[1, 2, 3], 7]]]"),
               {ErrorCode::kColumnCount, "show.json", "points[1][2][1] is a number where a"});
  expect_error(
      with_points("[[0, [1, 2, 3]], [1, [1, 2, 3], 7]]"),
      {ErrorCode::kMalformedRecord, "show.json", "points[1][2] is a number where the con"});
  expect_error(
      with_points("[[0, [1, 2, 3]], [1, [1, 2, 3], [[1, 2, 3], [1, 2, 3], [1, 2, 3]]]]"),
      {ErrorCode::kUnsupportedFormat, "show.json", "points[1][2] has 3 control points; up to two"});
  expect_error(with_points("[[0, [1, 2, 3], [[1, 2, 3]]]]"),
               {ErrorCode::kMalformedRecord, "show.json", "no piece ends there"});
}

TEST(BadShow, TimesThatDoNotAscend) {
  expect_error(with_points("[[0, [1, 2, 3]], [1, [1, 2, 4]], [1, [1, 2, 5]]]"),
               {ErrorCode::kTimeOrder, "show.json",
                "the time of points[2] does not come after the one before it"});
  expect_error(
      load(show(drone(R"({"takeoffTime": 5, "landingTime": 4, "points": [[0, [1, 2, 3]]]})"))),
      {ErrorCode::kTimeOrder, "show.json", "landingTime comes before takeoffTime"});
  expect_error(load(show(drone(R"({"takeoffTime": "5", "points": [[0, [1, 2, 3]]]})"))),
               {ErrorCode::kNotANumber, "show.json", "takeoffTime is a string where a number"});
}

TEST(BadShow, AnInvalidHome) {
  expect_error(load(show(drone(kTrajectory, R"(, "home": [1, 2])"))),
               {ErrorCode::kColumnCount, "show.json", "drone 'a': home is an array of 2 values"});
}

TEST(BadShow, AnInvalidDeclaredThreshold) {
  const auto declared = [](const std::string& distance) {
    return load(show(drone(kTrajectory), R"({"validation": {"minDistance": )" + distance + "}}"));
  };
  expect_error(declared("-1"), {ErrorCode::kInvalidThreshold, "show.json",
                                "settings.validation.minDistance is not above zero"});
  expect_error(declared("\"5\""), {ErrorCode::kNotANumber, "show.json", "is a string where a num"});
  expect_error(declared("1e99"), {ErrorCode::kOutsideDomain, "show.json", "exactly"});
}

TEST(BadShow, ReferencesThatLeadOut) {
  for (const std::string reference : {"../secret.json", "./drones/../../secret.json", "/etc/passwd",
                                      "https://example.org/x.json", "..\\\\secret.json", "."}) {
    expect_error(zip_with(reference), {ErrorCode::kUnsupportedFormat, "show.skyc!show.json",
                                       "leads out of the archive"});
  }
  expect_error(load(show(drone(R"({"$ref": "./trajectory.json"})"))),
               {ErrorCode::kUnsupportedFormat, "show.json",
                "leads to another file; name the .skyc archive"});
}

TEST(BadShow, DanglingReferences) {
  expect_error(zip_with("./a.json#"),
               {ErrorCode::kMissingColumn, "show.skyc!show.json",
                "the reference './a.json#' leads to a file that is not in the archive"});
  expect_error(zip_with("./a.json#/b", {{"a.json", "{}"}}),
               {ErrorCode::kMissingColumn, "show.skyc!show.json", "leads nowhere"});
  expect_error(zip_with("#nonsense"),
               {ErrorCode::kMissingColumn, "show.skyc!show.json", "leads nowhere"});
}

TEST(BadShow, ReferencesInACircle) {
  expect_error(zip_with("a.json", {{"a.json", R"({"$ref": "b.json"})"},
                                   {"b.json", R"({"$ref": "./a.json#"})"}}),
               {ErrorCode::kCorrupt, "show.skyc!a.json", "leads back to itself"});
}

TEST(BadShow, WhatIsWrongInAPartIsBlamedOnIt) {
  expect_error(zip_with("d/t.json", {{"d/t.json", "{\"points\":\n [[0, [1, 2, 3],]}"}}),
               {ErrorCode::kCorrupt, "show.skyc!d/t.json:2:17", "this is no JSON"});
  expect_error(zip_with("d/t.json", {{"d/t.json", R"({"points": [[0, [1, 2]]]})"}}),
               {ErrorCode::kColumnCount, "show.skyc!d/t.json", "drone 'a': points[0][1] is"});
}

TEST(BadShow, BadDronesAreSkippedAndListedWhereThatIsWished) {
  RecordingOptions options;
  options.skip_bad = true;
  const auto recording = recording_of(
      load(show(drone("7") + "," + drone(kTrajectory) + R"(, {"settings": {}})"), options));
  EXPECT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.skipped_count, 2u);
  ASSERT_EQ(recording.skipped.size(), 2u);
  EXPECT_FALSE(recording.skipped[1].location.record);
  expect_error(load(show(drone("7")), options),
               {ErrorCode::kNoPoints, "show.json", "the only record is bad: drone 'a': the traj"});
}

TEST(BadShow, OptionsThatAreForTables) {
  RecordingOptions degrees;
  degrees.frame = Frame::kWgs84;
  expect_error(load(show(drone(kTrajectory)), degrees),
               {ErrorCode::kInvalidArgument, "show.json", "in metres, but --crs wgs84 is given"});
  expect_error(load(show(drone(kTrajectory)), columns_are("x=1,y=2", Unit::kUnstated)),
               {ErrorCode::kInvalidArgument, "show.json", "--columns is for text tables"});
  expect_error(load(show(drone(kTrajectory)), columns_are("")),
               {ErrorCode::kInvalidArgument, "show.json", "leave --time-unit out"});
}

}  // namespace
}  // namespace beespace::io
