// Lines above the header: Excel's "sep=;" and titles are passed over and said; what may be more
// than a title is an error.
#include "io/load_points.hpp"
#include "io/load_recording.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

const std::string kBelowTitle = "id;time_s;x_m;y_m\na;0;1,5;2,5\na;1;2,5;2,5\n";

Result<Recording> read_below(const std::string& above, const std::string& table = kBelowTitle) {
  return load_recording_from_memory(above + table, "bees.csv", {});
}

bool says_aloud(const Recording& recording, std::string_view part) {
  return std::any_of(
      recording.notes.begin(), recording.notes.end(),
      [part](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(TitleLines, ExcelsFirstLineNamesTheDelimiter) {
  for (const std::string above :
       {"sep=;\n", "SEP=;\r\n", "\"sep=;\"\n", "\n# made by hand\nsep=;\n"}) {
    const auto loaded = read_below(above);
    ASSERT_TRUE(loaded) << above << loaded.error().message;
    ASSERT_EQ(loaded->bees.size(), 1u);
    EXPECT_EQ(loaded->bees[0].fixes[1].position.x, 2.5);
  }
  const auto points = load_points_from_memory("sep=,\nx,y,z\n1,2,3\n", "bees.csv", {});
  ASSERT_TRUE(points) << points.error().message;
  EXPECT_EQ(points->points[0].z, 3.0);
}

TEST(TitleLines, ADelimiterThatIsNotReadIsAnError) {
  const auto loaded = read_below("sep=|\n", "id|time_s|x_m|y_m\na|0|1|2\n");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().location.line, 1u);
  EXPECT_NE(loaded.error().message.find("names a delimiter that is not read"), std::string::npos);
}

TEST(TitleLines, ATitleIsPassedOverAndSaid) {
  for (const std::string above :
       {"Cage 3, first week\n", "Cage 3, first week;;;\n", "Cage 3, first week\n\n",
        "sep=;\nCage 3, first week\nby Anna;;;\n\n"}) {
    const auto loaded = read_below(above);
    ASSERT_TRUE(loaded) << above << loaded.error().message;
    EXPECT_EQ(loaded->bees[0].fixes.size(), 2u);
    EXPECT_TRUE(
        says_aloud(*loaded, "what stands above the header is passed over: 'Cage 3, first week"));
  }
  const auto points = load_points_from_memory("Cage 3\nx,y,z\n1,2,3\n", "bees.csv", {});
  ASSERT_TRUE(points) << points.error().message;
  EXPECT_EQ(points->points.size(), 1u);
  ASSERT_FALSE(points->notes.empty());
  EXPECT_NE(points->notes[0].find("passed over: 'Cage 3'"), std::string::npos);
}

// Errors count all lines.
TEST(TitleLines, LinesBelowATitleKeepTheirNumbers) {
  const auto loaded = read_below("Cage 3\n\n", "id;time_s;x_m;y_m\na;0;1,5;2,5\na;1;five;2,5\n");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().location.line, 5u);
}

TEST(TitleLines, WhatMayBeMoreThanATitleIsAnError) {
  for (const std::string above : {"rate;25\n", "a;0;1,5\n", "2.5\n"}) {
    const auto loaded = read_below(above);
    ASSERT_FALSE(loaded) << above;
    EXPECT_EQ(loaded.error().location.line, 1u);
    EXPECT_NE(loaded.error().message.find("stands above the header and has values in it"),
              std::string::npos)
        << loaded.error().message;
  }
}

}  // namespace
}  // namespace beespace::io
