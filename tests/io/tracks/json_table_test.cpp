// Tables of fixes as JSON: every form says the same, and what is broken says where.
#include "tests/io/tracks/recording_loading.hpp"

#include <string>

namespace beespace::io {
namespace {

constexpr std::string_view kRecords =
    R"([{"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3}, {"id": "b", "time_s": 1, "x": 4.5, "y": 5, "z": 6}])";

void expect_two(std::string_view text) {
  const Recording recording = recording_of(record(text));
  ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"a", "b"})) << text;
  EXPECT_EQ(recording.bees[0].fixes.at(0), (Fix{0.0, {1, 2, 3}})) << text;
  EXPECT_EQ(recording.bees[1].fixes.at(0), (Fix{1.0, {4.5, 5, 6}})) << text;
  EXPECT_EQ(recording.frame, Frame::kMetres);
}

TEST(JsonTable, EveryFormSaysTheSame) {
  expect_two(kRecords);
  expect_two(std::string("\xEF\xBB\xBF \n ") + std::string(kRecords));
  expect_two(R"({"id": {"0": "a", "1": "b"}, "time_s": {"0": 0, "1": 1}, "x": {"0": 1, "1": 4.5},
                 "y": {"0": 2, "1": 5}, "z": {"0": 3, "1": 6}})");
  expect_two(R"({"id": ["a", "b"], "time_s": [0, 1], "x": [1, 4.5], "y": [2, 5], "z": [3, 6]})");
  expect_two(R"({"columns": ["id", "time_s", "x", "y", "z"], "index": [0, 1],
                 "data": [["a", 0, 1, 2, 3], ["b", 1, 4.5, 5, 6]]})");
  expect_two(R"({"7": {"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3},
                 "9": {"id": "b", "time_s": 1, "x": 4.5, "y": 5, "z": 6}})");
  expect_two(R"({"schema": {"fields": []}, "data": )" + std::string(kRecords) + "}");
  expect_two(
      "{\"id\": \"a\", \"time_s\": 0, \"x\": 1, \"y\": 2, \"z\": 3}\n\n"
      "{\"id\": \"b\", \"time_s\": 1, \"x\": 4.5, \"y\": 5, \"z\": 6}\n");
  // Keys in another order, and one that others lack.
  expect_two(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3},
                 {"note": "late", "z": 6, "y": 5, "x": 4.5, "time_s": 1, "id": "b"}])");
}

TEST(JsonTable, NumbersAreTheSameDoubles) {
  const Recording recording = recording_of(record(
      R"([{"id": 18446744073709551615, "time_s": 0.1, "x": 0.30000000000000004, "y": -5e-7, "z": 1e22}])"));
  ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"18446744073709551615"}));
  EXPECT_EQ(recording.bees[0].fixes.at(0), (Fix{0.1, {0.30000000000000004, -5e-7, 1e22}}));
}

TEST(JsonTable, TextsMayHoldWhatTablesAreMadeOf) {
  const Recording recording = recording_of(record(
      R"([{"id": "a, \"b\"", "time_s": 0, "x": 1, "y": 2, "z": 3},
          {"id": "c", "note": "d\n\u001fe", "time_s": 0, "x": 1, "y": 2, "z": 9}])"));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"a, \"b\"", "c"}));
  EXPECT_EQ(recording.bees[1].fixes.at(0), (Fix{0.0, {1, 2, 9}}));
}

// With pandas: set_index("icao24"), then to_json().
TEST(JsonTable, KeysOfRowsAreIdsWhereNoColumnIs) {
  for (const std::string_view text : {
           R"({"3c6501": {"time_s": 0, "x": 1, "y": 2, "z": 3},
               "406102": {"time_s": 1, "x": 4.5, "y": 5, "z": 6}})",
           R"({"time_s": {"3c6501": 0, "406102": 1}, "x": {"3c6501": 1, "406102": 4.5},
               "y": {"3c6501": 2, "406102": 5}, "z": {"3c6501": 3, "406102": 6}})",
           R"({"columns": ["time_s", "x", "y", "z"], "index": ["3c6501", "406102"],
               "data": [[0, 1, 2, 3], [1, 4.5, 5, 6]]})",
       }) {
    const Recording recording = recording_of(record(text));
    ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"3c6501", "406102"})) << text;
    EXPECT_EQ(recording.bees[1].fixes.at(0), (Fix{1.0, {4.5, 5, 6}})) << text;
    EXPECT_TRUE(has_note(recording, "the keys of the rows are taken for the ids")) << text;
  }
}

TEST(JsonTable, AFlightIsNoIdBesideKeys) {
  const Recording recording = recording_of(record(
      R"({"3c6501": {"time_s": 0, "lat": 47, "lon": 8, "alt_m": 900, "callsign": "BEE1"},
          "406102": {"time_s": 0, "lat": 48, "lon": 8, "alt_m": 900, "callsign": "BEE1"}})"));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"3c6501", "406102"}));
}

// Rows of a frame that was filtered are numbered with gaps.
TEST(JsonTable, NumbersOfRowsAreNoIds) {
  for (const std::string_view text : {
           R"({"5": {"time_s": 0, "x": 1, "y": 2, "z": 3},
               "17": {"time_s": 1, "x": 4.5, "y": 5, "z": 6}})",
           R"({"time_s": {"5": 0, "17": 1}, "x": {"5": 1, "17": 4.5}, "y": {"5": 2, "17": 5},
               "z": {"5": 3, "17": 6}})",
           R"({"columns": ["time_s", "x", "y", "z"], "index": [5, 17],
               "data": [[0, 1, 2, 3], [1, 4.5, 5, 6]]})",
           R"({"columns": ["time_s", "x", "y", "z"], "data": [[0, 1, 2, 3], [1, 4.5, 5, 6]]})",
       }) {
    const Recording recording = recording_of(record(text));
    EXPECT_EQ(ids_of(recording), std::vector<std::string>{"bees"}) << text;
  }
  // Nor is anything beside an id.
  expect_two(R"({"first": {"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3},
                 "second": {"id": "b", "time_s": 1, "x": 4.5, "y": 5, "z": 6}})");
  expect_two(R"({"columns": ["id", "time_s", "x", "y", "z"], "index": ["first", "second"],
                 "data": [["a", 0, 1, 2, 3], ["b", 1, 4.5, 5, 6]]})");
}

TEST(JsonTable, WholeNumbersAreIdsToTheirLastDigit) {
  const Recording recording =
      recording_of(record(R"([{"id": -9007199254740993, "time_s": 0, "x": 1, "y": 2, "z": 3},
                 {"id": -9007199254740992, "time_s": 0, "x": 1, "y": 2, "z": 3}])"));
  EXPECT_EQ(ids_of(recording),
            (std::vector<std::string>{"-9007199254740993", "-9007199254740992"}));
}

void expect_problem(std::string_view text, ErrorCode code, std::string_view part) {
  const auto loaded = record(text);
  ASSERT_FALSE(loaded.has_value()) << text;
  EXPECT_EQ(loaded.error().code, code) << to_string(loaded.error());
  EXPECT_NE(to_string(loaded.error()).find(part), std::string::npos) << to_string(loaded.error());
}

TEST(JsonTable, WhatIsBrokenSaysWhere) {
  expect_problem(
      R"([{"id": "a", "time_s": 0, "x": 1, "y": 2}, {"id": "b", "time_s": 0, "x": "east", "y": 2}])",
      ErrorCode::kNotANumber, "point 1: 'x': 'east' is not a number (x)");
  expect_problem(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2}, {"id": "b", "x": 1, "y": 2}])",
                 ErrorCode::kNotANumber, "point 1: 'time_s': the field is empty");
  expect_problem(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2}, 7])", ErrorCode::kColumnCount,
                 "a number where an object should be");
  expect_problem(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2, "x": 3}])", ErrorCode::kColumnCount,
                 "the key x twice");
  expect_problem(R"([{"id": "a", "time_s": 0, "x": [1], "y": 2}])", ErrorCode::kNotANumber,
                 "'x': ");
  expect_problem(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2)", ErrorCode::kTruncated,
                 "bees.csv:1:");
  expect_problem(R"({"id": {"0": "a"}, "time_s": {"0": 1}, "x": {"0": 1, "1": 2}, "y": {"0": 1}})",
                 ErrorCode::kMalformedRecord, "the column 'x' has 2 values, but 'id' has 1");
  expect_problem(R"({"id": {"0": "a"}, "time_s": {"0": 1}, "x": {"1": 1}, "y": {"0": 1}})",
                 ErrorCode::kMalformedRecord, "the column 'x' has other rows than 'id'");
  expect_problem(R"({"id": ["a"], "time_s": [1], "x": [1], "y": [1], "x": [2]})",
                 ErrorCode::kMalformedRecord, "the column 'x' is there twice");
  expect_problem(R"({"id": ["a"], "time_s": [1], "x": 1, "y": [1]})", ErrorCode::kMalformedRecord,
                 "the column 'x' is a number where its values should be");
  expect_problem(
      R"({"columns": ["id", "time_s", "x", "y"], "data": [["a", 0, 1, 2], ["b", 0, 1]]})",
      ErrorCode::kColumnCount, "point 1: it does not have the 4 values of 'columns'");
  expect_problem(R"({"columns": ["id", 5, "x", "y"], "data": []})", ErrorCode::kMalformedRecord,
                 "'columns' names a column by a number");
  expect_problem("[1, 2, 3]", ErrorCode::kUnsupportedFormat, "this is JSON of a kind that");
  expect_problem("[]", ErrorCode::kUnsupportedFormat, "this is JSON of a kind that");
  expect_problem(R"([{"time_s": 0, "id": "a"}])", ErrorCode::kUnsupportedFormat,
                 "a list, but no table");
  expect_problem(R"([{"x": 1, "y": 2}])", ErrorCode::kMissingColumn,
                 "there is neither a time nor a velocity");
}

// Two of them would be written alike.
TEST(JsonTable, WhatIsNoIdIsABadRecord) {
  const auto expect_no_id = [](const std::string& id, std::string_view what) {
    const std::string rest = R"(, "time_s": 0, "x": 1, "y": 2, "z": 3})";
    const std::string text =
        R"([{"id": "a")" + rest + R"(, {"id": )" + id + rest + R"(, {"id": "b")" + rest + "]";
    expect_problem(text, ErrorCode::kColumnCount, std::string("point 1: ") + "1 column where");
    expect_problem(text, ErrorCode::kColumnCount, what);
    const Recording skipped = recording_of(record(text, skipping_bad()));
    EXPECT_EQ(ids_of(skipped), (std::vector<std::string>{"a", "b"})) << id;
    EXPECT_EQ(skipped.missing.count, 1u) << id;
  };
  expect_no_id(R"("d\u0001")", "a control character as the id");
  expect_no_id(R"("d\n")", "a control character as the id");
  expect_no_id("[1]", "an array as the id");
  expect_no_id("{}", "an object as the id");
  expect_no_id("9007199254740993.0", "a rounded number as the id");
  expect_problem(R"({"d\u0001": {"time_s": 0, "x": 1, "y": 2}})", ErrorCode::kColumnCount,
                 "a control character as the id");
  expect_problem(R"({"columns": ["time_s", "x", "y"], "index": [["a", 0]], "data": [[0, 1, 2]]})",
                 ErrorCode::kColumnCount, "an array as the id");
  expect_problem(R"({"columns": ["time_s", "x", "y"], "index": ["a"], "data": []})",
                 ErrorCode::kMalformedRecord, "'index' names 1 rows, but 'data' has 0");
  expect_problem(R"json({"('a', 0)": {"time_s": 0, "x": 1, "y": 2}})json",
                 ErrorCode::kMalformedRecord, "rows are named by several values at once");
}

TEST(JsonTable, LinesHaveTheirNumbers) {
  const std::string good = R"({"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3})";
  expect_problem(good + "\n\n{\"id\": \"b\", \"time_s\": 0, \"x\": 1, \"y\": 2, \"z\": \"up\"}\n",
                 ErrorCode::kNotANumber, "bees.csv:3: 'z': 'up' is not a number (z)");
  expect_problem(good + "\n{\"id\": \"b\", \"time_s\"\n", ErrorCode::kTruncated, "bees.csv:2:");
  const Recording skipped =
      recording_of(record(good + "\n{\"id\": \"b\", \"time_s\"\n" +
                              R"({"id": "c", "time_s": 0, "x": 1, "y": 2, "z": 3})",
                          skipping_bad()));
  EXPECT_EQ(ids_of(skipped), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(skipped.skipped_count, 1u);
  EXPECT_EQ(skipped.missing.count, 1u);
}

TEST(JsonTable, BadRecordsAreLeftOutAndCounted) {
  const Recording recording = recording_of(record(
      R"([{"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3}, null, {"id": "b", "time_s": 0, "x": null, "y": 2, "z": 3}])",
      skipping_bad()));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"a"}));
  EXPECT_EQ(recording.missing.count, 2u);
  EXPECT_EQ(recording.missing.nowhere, 1u);
}

TEST(JsonTable, ShowsAndAircraftAreStillTheirOwn) {
  const Recording aircraft = recording_of(record(
      R"({"now": 100, "aircraft": [{"hex": "a1", "lat": 47, "lon": 8, "seen_pos": 0, "alt_geom": 1000}]})"));
  EXPECT_EQ(aircraft.format_description, "aircraft.json of readsb or dump1090");
}

TEST(JsonTable, OneObjectIsOneRecord) {
  const Recording one = recording_of(record(R"({"id": "a", "time_s": 0, "x": 1, "y": 2, "z": 3})"));
  EXPECT_EQ(ids_of(one), (std::vector<std::string>{"a"}));
}

// A list has no lines that say anything: places are records.
TEST(JsonTable, TwoPlacesAtOneTimeAreNamedByTheirRecords) {
  expect_error(record(R"([{"id": "a", "time_s": 0, "x": 1, "y": 2}, {"id": "b", "time_s": 0,
                         "x": 1, "y": 9}, {"id": "a", "time_s": 0, "x": 5, "y": 2}])"),
               {ErrorCode::kTimeOrder, "bees.csv: point 2",
                "bee 'a' is at another place at the same time, 0 s, in bees.csv, record 0"});
}

TEST(JsonTable, PlacesInObjectsWithinObjectsAreNamed) {
  expect_error(record("{\"robot\":\"a\",\"time_s\":0,\"pose\":{\"x\":1,\"y\":2}}\n"
                      "{\"robot\":\"a\",\"time_s\":1,\"pose\":{\"x\":1,\"y\":2}}\n"),
               {ErrorCode::kMissingColumn, "bees.csv", "| from_entries' FILE > flat.ndjson"});
}

TEST(JsonTable, ListsOfAllThatIsSomewhereAtOneTimeAreNamed) {
  expect_error(record("{\"t\":0,\"agents\":[{\"id\":1,\"pos\":[1,2,3]}]}\n"
                      "{\"t\":1,\"agents\":[{\"id\":1,\"pos\":[1,2,3]}]}\n"),
               {ErrorCode::kMissingColumn, "bees.csv",
                "jq -c '. as $all | .agents[] | ($all | del(.agents)) + . | . + {x: .pos[0], y: "
                ".pos[1], z: .pos[2]} | del(.pos)' FILE > flat.ndjson; and in which unit is 't'"});
  const std::string pose =
      "{\"header\":{\"stamp\":{\"nsec\":0}},\"pose\":[{\"name\":\"x500_1\",\"position\":{}}]}\n";
  expect_error(record(pose + pose), {ErrorCode::kMissingColumn, "bees.csv",
                                     "x: (.position.x // 0), y: (.position.y // 0)"});
}

TEST(JsonTable, MessagesOfRosbridgeAreKnownByTheirTopics) {
  const std::string line =
      "{\"topic\":\"/cf1/pose\",\"msg\":{\"pose\":{\"position\":{\"x\":1,\"y\":2,\"z\":3}}}}\n";
  expect_error(record(line + line), {ErrorCode::kUnsupportedFormat, "bees.csv",
                                     "select((.op // \"publish\") == \"publish\" and .msg.pose)"});
}

TEST(JsonTable, WhatIsAskedOfTheTimeIsAskedBesideThePlace) {
  expect_error(record("{\"time\":0,\"id\":1,\"position\":[1,2,3]}\n"
                      "{\"time\":1,\"id\":1,\"position\":[1,2,3]}\n"),
               {ErrorCode::kMissingColumn, "bees.csv",
                "> xyz.ndjson (or lon, lat, height, where these are degrees); and column 1 'time' "
                "holds the time, but in which unit?"});
}

}  // namespace
}  // namespace beespace::io
