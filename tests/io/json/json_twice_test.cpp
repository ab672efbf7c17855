// A key that is there twice in an object: no two readers take it alike, so that it is bad input.
#include "tests/io/live/report_lines_reading.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

std::string look(const std::string& more) {
  return R"({"now": 10, "aircraft": [{"hex": "a", "lat": 1, "lon": 2, "seen_pos": 0, "alt_geom": 35025)" +
         more + R"(}, {"hex": "b", "lat": 1, "lon": 2, "seen_pos": 0, "alt_geom": 5000}]})";
}

TEST(JsonTwice, OfAircraftItIsABadRecord) {
  for (const char* more : {R"(, "alt_geom": 5000)", R"(, "alt_geom": null)"}) {
    const auto refused = record(look(more));
    expect_error(refused, {ErrorCode::kMalformedRecord, "bees.csv: point 0",
                           "'alt_geom' is there twice; keep one"});
  }
  const Recording skipped = recording_of(record(look(R"(, "lat": 3)"), skipping_bad()));
  EXPECT_EQ(ids_of(skipped), std::vector<std::string>{"b"});
  EXPECT_EQ(skipped.missing.nowhere_ids, std::vector<std::string>{"a"});
  // A key that is not read may occur several times.
  EXPECT_TRUE(record(look(R"(, "rssi": 1, "rssi": 2)")).has_value());
  expect_error(record(R"({"now": 1, "now": 2, "aircraft": []})"),
               {ErrorCode::kMalformedRecord, "bees.csv", "'now' is there twice"});
  expect_error(record(R"({"states": [], "states": []})"),
               {ErrorCode::kMalformedRecord, "bees.csv", "'states' is there twice"});
}

TEST(JsonTwice, OfAircraftOnALineTheSame) {
  ReportLines lines;
  const auto refused = lines.take(
      R"({"now": 10, "hex": "a", "lat": 1, "lon": 2, "seen_pos": 0, "alt_geom": 5, "alt_geom": 6})");
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("'alt_geom' is there twice"), std::string::npos);
}

TEST(JsonTwice, OfShowsToo) {
  const std::string points = R"("points": [[0, [1, 2, 0]], [5, [1, 2, 5]]])";
  const auto show = [](const std::string& trajectory, const std::string& more) {
    return R"({"swarm": {"drones": [{"settings": {"name": "a", "trajectory": {)" + trajectory +
           "}" + more + "}}]}}";
  };
  EXPECT_TRUE(record(show(points, "")).has_value());
  for (const std::string& text :
       {show(points + ", " + points, ""), show(points, R"(, "name": "b")"),
        show(points, R"(, "trajectory": {)" + points + "}")}) {
    expect_error(record(text), {ErrorCode::kMalformedRecord, "bees.csv", "is there twice"});
  }
}

}  // namespace
}  // namespace beespace::io
