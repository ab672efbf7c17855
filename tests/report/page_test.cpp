// One HTML file with the data in it, whatever users call their swarms.
#include "report/page.hpp"

#include "report/recording_json.hpp"
#include "report/snapshot_json.hpp"
#include "tests/report/page_reader.hpp"

#include <beespace/version.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>

namespace beespace::report {
namespace {

using report_test::PageParts;
using report_test::ParsedJson;
using report_test::parts_of;
using report_test::text_of;

// It also contains characters that regular expressions and the like might replace.
constexpr std::string_view kBefore =
    "<!doctype html>\n<p>$& \\1 %s</p>\n<script>const a = '<b>';</script>\n";
constexpr std::string_view kAfter = "\n<script>start();</script>\n</html>\n";

std::string written(const auto& swarms, Columns& columns) {
  const std::string json = page_json([&](io::JsonWriter& out) {
    for (const auto& facts : swarms) write_swarm(out, facts, columns);
  });
  std::string page;
  write_page(std::string(kBefore) + "<!-- beespace: data -->" + std::string(kAfter), json, columns,
             [&](std::string_view text) { page += text; });
  return page;
}

SnapshotFacts called(const std::string& text) {
  SnapshotFacts facts;
  facts.swarm.title = text;
  facts.swarm.source = text;
  facts.swarm.notes = {text, "", text};
  facts.swarm.names.texts = {text, "b"};
  facts.positions = {{0, 0, 0}, {1, 0, 0}};
  facts.nearest = {{1, 1.0}, {0, 1.0}};
  return facts;
}

const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> kTexts = {
      "</script><script>alert(1)</script>",
      "<!--",
      "<!-- <script>",
      "-->",
      "]]>",
      "</SCRIPT\t>",
      "<!-- beespace: data -->",
      "\"quotes\" and 'others' \\ and \\u003c",
      "&lt;&amp;&",
      "🐝🐝",
      "\xE2\x80\xA8\xE2\x80\xA9",
      std::string("zero\0and\x01\x1F\x7F", 12),
      std::string(10'000, '<'),
      std::string(10'000, 'x'),
  };
  return kTexts;
}

void expect_nothing_to_end_it(const std::string& json) {
  for (const char c : {'<', '>', '&'}) EXPECT_EQ(json.find(c), std::string::npos) << c;
}

// As RFC 1950 has it, by sums of all bytes.
std::uint32_t adler32_of(std::string_view text) {
  std::uint64_t a = 1;
  std::uint64_t b = 0;
  for (const char c : text) {
    a = (a + static_cast<unsigned char>(c)) % 65'521;
    b = (b + a) % 65'521;
  }
  return static_cast<std::uint32_t>(b << 16u | a);
}

TEST(Page, EndsWithTheChecksumOfItsJsonAndTheCountOfItsElements) {
  for (const std::string text : {"a", "\U0001F41D <b>", ""}) {
    Columns columns;
    const PageParts parts = parts_of(written(std::array{called(text)}, columns));
    std::array<char, 9> digits{};
    std::snprintf(digits.data(), digits.size(), "%08x", adler32_of(parts.json));
    EXPECT_EQ(parts.end, std::string(digits.data()) + " " + std::to_string(parts.elements.size()));
  }
}

TEST(Page, NoTextOfAUserEndsTheElement) {
  for (const std::string& text : hostile_texts()) {
    Columns columns;
    const PageParts parts = parts_of(written(std::array{called(text)}, columns));
    expect_nothing_to_end_it(parts.json);
    const ParsedJson json(parts.json);
    const auto read = json["swarms"].at(0).value();
    EXPECT_EQ(text_of(read["title"]), text);
    EXPECT_EQ(text_of(read["source"]), text);
    EXPECT_EQ(report_test::texts_of(read["notes"]), (std::vector<std::string>{text, "", text}));
    const auto names = report_test::column_of(read["names"]["texts"], parts.elements);
    EXPECT_EQ(names.texts, (std::vector<std::string>{text, "b"}));
    EXPECT_EQ(parts.before, kBefore);
    EXPECT_EQ(parts.after, kAfter);
  }
}

TEST(Page, NoTextOfARecordingEndsItEither) {
  for (const std::string& text : hostile_texts()) {
    RecordingFacts facts;
    facts.swarm = called(text).swarm;
    facts.tracks = {{{{0.0, {0, 0, 0}}}}, {}};
    Columns columns;
    const PageParts parts = parts_of(written(std::array{facts}, columns));
    expect_nothing_to_end_it(parts.json);
    EXPECT_EQ(text_of(ParsedJson(parts.json)["swarms"].at(0)["title"]), text);
  }
}

TEST(Page, WhatIsNotUtf8IsReplacedAndTheRestStays) {
  Columns columns;
  const PageParts parts = parts_of(written(std::array{called("a\xFF<\xC3")}, columns));
  expect_nothing_to_end_it(parts.json);
  EXPECT_EQ(text_of(ParsedJson(parts.json)["swarms"].at(0)["title"]), "a\xEF\xBF\xBD<\xEF\xBF\xBD");
}

TEST(Page, ColumnsOfBothSwarmsAreNumberedThroughInOrder) {
  Columns columns;
  const PageParts parts = parts_of(written(std::array{called("before"), called("after")}, columns));
  EXPECT_EQ(parts.elements, columns.elements());
  EXPECT_GT(parts.elements.size(), 10u);
  const ParsedJson json(parts.json);
  EXPECT_EQ(std::uint64_t(json["format"]), 1u);
  EXPECT_EQ(text_of(json["beespace"]), version());
  const simdjson::dom::array read(json["swarms"]);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(text_of(read.at(0)["title"]), "before");
  EXPECT_EQ(text_of(read.at(1)["title"]), "after");
  for (const char* axis : {"x", "y", "z"}) {
    EXPECT_NE(std::uint64_t(read.at(0)["positions"][axis]["at"]),
              std::uint64_t(read.at(1)["positions"][axis]["at"]));
  }
}

TEST(Page, TheGroundStaysWhereItIsWanted) {
  const std::string page =
      "<p>a</p>\n<script type=\"text/plain\" id=\"beespace-ground\">eJw</script>\n"
      "<!-- beespace: data -->\n<p>b</p>\n";
  const auto with = [&](Ground ground) {
    std::string written;
    const Columns none;
    write_page(
        page, "{}", none, [&](std::string_view text) { written += text; }, ground);
    return written;
  };
  const std::string wide = with(Ground::kWith);
  const std::string local = with(Ground::kWithout);
  EXPECT_EQ(
      wide.find(
          "<p>a</p>\n<script type=\"text/plain\" id=\"beespace-ground\">eJw</script>\n<script"),
      0u);
  EXPECT_EQ(local.find("<p>a</p>\n<script type=\"application/json\""), 0u);
  EXPECT_EQ(local.find("beespace-ground"), std::string::npos);
  // Nothing else is different.
  EXPECT_EQ(wide.substr(wide.find("<script type=\"application")),
            local.substr(local.find("<script type=\"application")));
}

TEST(Page, TheGroundIsOfWidePartsOfTheEarthOnly) {
  SnapshotFacts facts;
  facts.positions = {{0, 0, 0}, {99'000, 5, 20}, {10, -900, 0}};
  EXPECT_EQ(ground_of(facts), Ground::kWithout);
  facts.swarm.origin = GeographicPosition{};
  EXPECT_EQ(ground_of(facts), Ground::kWithout);
  facts.positions.push_back({-2'000, 0, 0});
  EXPECT_EQ(ground_of(facts), Ground::kWith);
  // Of no place on the Earth, however wide.
  facts.swarm.origin = {};
  EXPECT_EQ(ground_of(facts), Ground::kWithout);

  RecordingFacts recording;
  recording.swarm.origin = GeographicPosition{};
  EXPECT_EQ(ground_of(recording), Ground::kWithout);
  recording.tracks = {Track{.fixes = {{0.0, {0, -60'000, 0}}}},
                      Track{.fixes = {{0.0, {0, 0, 0}}, {1.0, {0, 60'000, 0}}}}};
  EXPECT_EQ(ground_of(recording), Ground::kWith);
}

TEST(Page, TheOneInThisBuildIsLight) {
  if (page_template().empty()) GTEST_SKIP() << "there is none";
  EXPECT_LE(page_template().size(), 480'000u);
  EXPECT_FALSE(around_ground(page_template()).second.empty());
}

TEST(Page, TheOneInThisBuildHasThePlaceOnce) {
  if (page_template().empty()) GTEST_SKIP() << "there is none";
  const std::string_view page = page_template();
  const std::string_view place = "\n<!-- beespace: data -->\n";
  const std::size_t at = page.find(place);
  ASSERT_NE(at, std::string_view::npos);
  EXPECT_EQ(page.find("<!-- beespace: data -->", at + place.size()), std::string_view::npos);
  EXPECT_EQ(page.find("<!-- beespace: data -->"), at + 1);
}

}  // namespace
}  // namespace beespace::report
