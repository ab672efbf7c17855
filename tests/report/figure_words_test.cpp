// What figures say of aircraft: in miles and feet, horizontally and in height, at UTC times.
#include "report/drawing/text_fit.hpp"
#include "report/figure/figure.hpp"
#include "report/figure/style.hpp"
#include "report/separation_words.hpp"
#include "tests/report/figure_facts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace beespace::report {
namespace {

std::vector<std::string> texts_of(const Drawing& drawing) {
  std::vector<std::string> texts;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) texts.push_back(text->text);
  }
  return texts;
}

bool says(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(), [&part](const std::string& text) {
    return text.find(part) != std::string::npos;
  });
}

constexpr double kFoot_m = 0.3048;

// 3.19 NM beside each other and 800 ft above, from 23:55 to 00:05 UTC.
RecordingFacts crossing() {
  constexpr double kBegins_s = 1'539'388'500.0;  // 2018-10-12T23:55:00Z
  RecordingFacts facts;
  facts.swarm.title = "traffic.csv";
  facts.swarm.origin = GeographicPosition{7.5, 50.0, 0.0};
  facts.swarm.aviation = true;
  facts.swarm.threshold_m = 5.0 * 1852.0;
  facts.swarm.vertical_m = 1000.0 * kFoot_m;
  facts.swarm.names.texts = {"3c6444 (LUFTHANSA2A)", "4ca7b3 (RYANAIR12AB)"};
  facts.calendar.since_1970 = true;
  const double across_m = 3.19 * 1852.0;
  const double up_m = 800.0 * kFoot_m;
  facts.tracks = {Track{{{kBegins_s, {0, 0, 10'000}}, {kBegins_s + 600, {140'000, 0, 10'000}}}},
                  Track{{{kBegins_s, {0, across_m, 10'000 + up_m}},
                         {kBegins_s + 600, {140'000, across_m, 10'000 + up_m}}}}};
  const double slant_m = std::hypot(across_m, up_m);
  facts.conflicts = {{0, 1, kBegins_s, kBegins_s + 313, kBegins_s + 600, slant_m}};
  facts.conflict_count = facts.pair_count = 1;
  facts.at_risk = {{0, {kBegins_s, kBegins_s + 600}}, {1, {kBegins_s, kBegins_s + 600}}};
  facts.closest = facts.conflicts.front();
  facts.closest_apart = Apart{across_m, up_m};
  facts.conflicts_apart = {*facts.closest_apart};
  for (int t = 0; t <= 600; ++t) {
    facts.separation.push_back({kBegins_s + t, {0, 1, slant_m}, facts.closest_apart});
  }
  return facts;
}

TEST(FigureWords, AviationIsToldInMilesAndFeet) {
  const auto texts = texts_of(figure_of(crossing()));
  EXPECT_TRUE(says(texts, "closer than 5 NM across and closer than 1,000 ft in height"));
  EXPECT_TRUE(says(texts, "closest: 3.19 NM across, 800 ft in height"));
  EXPECT_TRUE(says(texts, "3.19 NM, 800 ft at 00:00:13"));
  EXPECT_TRUE(says(texts, "horizontally 5 NM"));
  EXPECT_TRUE(says(texts, "in height 1,000 ft"));
  for (const char* axis : {"East (NM)", "North (NM)", "Height (ft)", "Distance (NM)"}) {
    EXPECT_TRUE(says(texts, axis)) << axis;
  }
  EXPECT_FALSE(says(texts, " km"));
  EXPECT_FALSE(says(texts, "5,91"));
}

TEST(FigureWords, OthersAreToldInMetres) {
  RecordingFacts facts = crossing();
  facts.swarm.aviation = false;
  const auto texts = texts_of(figure_of(facts));
  EXPECT_TRUE(says(texts, "5,907.9 m across, 243.840 m in height at 00:00:13") ||
              says(texts, "5,907.9 m across, 243.8 m in height at 00:00:13"));
  EXPECT_TRUE(says(texts, "Distance (m)"));
}

// Feet both ways, or millimetres: not metres across beside feet upwards.
TEST(FigureWords, AxesAreInTheUnitsOfWhatIsTooClose) {
  RecordingFacts facts = crossing();
  facts.swarm.origin.reset();
  facts.swarm.vertical_m.reset();
  facts.swarm.threshold_m = 5.0 * kFoot_m;
  const double from_s = facts.conflicts[0].begins_s;
  const double to_s = facts.conflicts[0].ends_s;
  facts.tracks = {Track{{{from_s, {0, 0, 0}}, {to_s, {30, 0, 10}}}},
                  Track{{{from_s, {0, 1, 0}}, {to_s, {30, 20, 10}}}}};
  facts.closest_apart.reset();
  facts.conflicts_apart.clear();
  facts.conflicts[0].closest_m = 1.15 * kFoot_m;
  facts.closest = facts.conflicts[0];
  for (Separation& at : facts.separation) at.apart.reset();
  const auto feet = texts_of(figure_of(facts));
  for (const char* part : {"x (ft)", "y (ft)", "z (ft)", "Distance (ft)", "closest: 1.15 ft",
                           "1.15 ft at ", "closer than 5 ft"}) {
    EXPECT_TRUE(says(feet, part)) << part;
  }
  facts.swarm.aviation = false;
  facts.swarm.threshold_m = 0.003;
  facts.tracks = {Track{{{from_s, {0, 0, 0}}, {to_s, {0.4, 0, 0.1}}}},
                  Track{{{from_s, {0, 0.01, 0}}, {to_s, {0.3, 0.2, 0.1}}}}};
  const auto small = texts_of(figure_of(facts));
  for (const char* part : {"x (mm)", "y (mm)", "z (mm)", "Distance (mm)", "closer than 3 mm"}) {
    EXPECT_TRUE(says(small, part)) << part;
  }
  EXPECT_FALSE(says(small, "(m)"));
}

// Of aircraft these may be by pressure: it is not said that they are above the ellipsoid.
TEST(FigureWords, HeightsAreAboveNothingThatTheInputDoesNotSay) {
  RecordingFacts facts = crossing();
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "heights are above the ellipsoid"));
  facts.swarm.heights.unstated = true;
  const auto texts = texts_of(figure_of(facts));
  EXPECT_TRUE(says(texts, "heights are those of the input, taken as above the ellipsoid"));
  EXPECT_FALSE(says(texts, "heights are above"));
}

// Beside a panel there are the labels of its axes.
TEST(FigureWords, TheLabelOfTheClosestTwoStaysWithinItsPanel) {
  constexpr double kLeft = 100.0;
  constexpr double kRightEnd = 748.0;
  RecordingFacts facts = crossing();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  facts.at_risk.clear();
  for (double share = 0.0; share <= 1.0; share += 0.05) {
    const double begins_s = facts.separation.front().time_s;
    facts.closest->closest_s = begins_s + share * 600.0;
    const Drawing drawing = figure_of(facts);
    const auto is_label = [](const Shape& shape) {
      const auto* text = std::get_if<Text>(&shape);
      return text != nullptr && text->text.starts_with("closest, not too close: ");
    };
    const auto label = std::find_if(drawing.shapes.begin(), drawing.shapes.end(), is_label);
    ASSERT_NE(label, drawing.shapes.end());
    const auto& text = std::get<Text>(*label);
    const double width = text_width(text.text, text.size);
    const double left = text.anchor == Anchor::kEnd ? text.at.x - width : text.at.x;
    EXPECT_GE(left, kLeft) << share;
    EXPECT_LE(left + width, kRightEnd) << share;
  }
}

// In a gap two may have been closer.
TEST(FigureWords, TheClosestTwoAreThoseOfTheKnownTime) {
  RecordingFacts facts = crossing();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  facts.at_risk.clear();
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "closest, not too close: "));
  facts.unknown = "1 bee unknown for 10 s in all";
  const auto texts = texts_of(figure_of(facts));
  EXPECT_TRUE(says(texts, "closest in the known time: "));
  EXPECT_FALSE(says(texts, "not too close"));
}

// Of a show with drones on the ground those in the air are named, and others as what they are.
TEST(FigureWords, TheClosestInTheAirComesFirst) {
  RecordingFacts facts = crossing();
  facts.swarm.vertical_m.reset();
  facts.swarm.aviation = false;
  facts.closest_apart.reset();
  facts.closest_stands = true;
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "m, with one on the ground"));
  facts.closest_in_the_air = facts.closest;
  facts.closest_in_the_air->closest_m = 7'000.0;
  facts.swarm.threshold_m = 6'500.0;
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "closest in the air, not too close: 7,000 m"));
}

// The slanted lines of what is hatched.
std::vector<Spot> hatched(const Drawing& drawing) {
  std::vector<Spot> spots;
  for (const Shape& shape : drawing.shapes) {
    const auto* lines = std::get_if<Lines>(&shape);
    if (lines == nullptr || lines->ink.rgb != kAxis.rgb) continue;
    for (const auto& run : lines->runs) {
      const bool slanted = run.size() == 2 && run[0].x != run[1].x && run[0].y != run[1].y;
      if (slanted) spots.insert(spots.end(), run.begin(), run.end());
    }
  }
  return spots;
}

double highest_in_the_chart(const Drawing& drawing) {
  constexpr double kChartLeft = 800.0;
  double y = HUGE_VAL;
  for (const Spot& spot : hatched(drawing)) {
    if (spot.x > kChartLeft) y = std::min(y, spot.y);
  }
  return y;
}

// Over the chart where the closest two are unknown, and at its foot where any bee is.
TEST(FigureWords, WhatIsUnknownIsHatched) {
  RecordingFacts facts = crossing();
  const double begins_s = facts.at_risk[0].span.begins_s;
  EXPECT_TRUE(hatched(figure_of(facts)).empty());
  EXPECT_FALSE(says(texts_of(figure_of(facts)), "a bee unknown"));
  facts.unknown_spans = {{0, begins_s + 100, begins_s + 200}};
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "a bee unknown"));
  const double foot = highest_in_the_chart(figure_of(facts));
  facts.separation_open = {{begins_s + 100, begins_s + 200}};
  EXPECT_LT(highest_in_the_chart(figure_of(facts)), foot - 80.0);
}

// Where some are never known, the first words are no verdict on all.
TEST(FigureWords, WhoIsNeverKnownIsSaidFirst) {
  RecordingFacts facts = crossing();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  facts.unknown = "1 id seems to be of two drones";
  EXPECT_FALSE(says(texts_of(figure_of(facts)), "Not seen as a whole"));
  facts.never_known = true;
  EXPECT_TRUE(
      says(texts_of(figure_of(facts)), "Not seen as a whole: 1 id seems to be of two drones; no"));
}

// What is below a limit is never rounded up to it.
TEST(FigureWords, NothingBelowALimitLooksAsIfItWereNot) {
  SwarmFacts swarm = crossing().swarm;
  EXPECT_EQ(distance_words(swarm, 4.9996 * 1852.0), "4.9996 NM");
  EXPECT_EQ(height_words(swarm, 999.8 * kFoot_m), "999.8 ft");
  EXPECT_EQ(distance_words(swarm, 5.0 * 1852.0), "5 NM");
  swarm.threshold_m = 500.0 * kFoot_m;
  EXPECT_EQ(distance_words(swarm, 137.0 * kFoot_m), "137 ft");
}

// A day has 24 hours: after midnight the axis says the day, and then what tables say.
TEST(FigureWords, TheTimeAxisAgreesWithTables) {
  const auto texts = texts_of(figure_of(crossing()));
  EXPECT_TRUE(says(texts, "Time (UTC, from 2018-10-12)"));
  EXPECT_TRUE(says(texts, "23:56"));
  EXPECT_TRUE(says(texts, "10-13"));
  EXPECT_TRUE(says(texts, "00:02"));
  EXPECT_FALSE(says(texts, "24:0"));
}

// The curve goes on from one pair to the next without a word of it.
TEST(FigureWords, WhereOtherTwoAreNearestToAConflictThatIsSaid) {
  RecordingFacts facts = crossing();
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "The same two"));
  facts.tracks.push_back(facts.tracks.front());
  facts.swarm.names.texts.emplace_back("c");
  facts.separation.back().closest.second = 2;
  EXPECT_TRUE(says(texts_of(figure_of(facts)), "The same (2 pairs in turn)"));
}

// Distances to the nearest are those in a straight line; 1,000 ft above is no conflict.
TEST(FigureWords, WhoIsApartInHeightIsCountedBesideTheHorizontalLimit) {
  SnapshotFacts facts = three_bees();
  facts.at_risk.clear();
  facts.pairs.clear();
  facts.pair_count = 0;
  facts.swarm.noun = {"aircraft", "aircraft"};
  EXPECT_FALSE(says(texts_of(figure_of(facts)), "apart in height"));
  facts.swarm.vertical_m = 20.0;
  const auto texts = texts_of(figure_of(facts));
  EXPECT_TRUE(says(texts, "Distance (m); 2 left of the line are apart in height"));
  EXPECT_TRUE(says(texts, "Distance to the nearest other aircraft"));
  EXPECT_TRUE(says(texts, "Aircraft"));
}

// At the border there is no room on the side to which it does not fly.
TEST(FigureWords, TheNameOfOneAheadDoesNotCoverItsOwnRing) {
  SnapshotFacts facts = three_bees();
  facts.at_risk.clear();
  facts.pairs.clear();
  facts.pair_count = 0;
  facts.swarm.names.texts = {"4b1617 (SWR123)", "3c6444 (DLH4AB)", "flip"};
  facts.positions = {{0, 0, 0}, {200, 300, 0}, {1000, 500, 200}};
  facts.moment = "noon";
  facts.ahead = Ahead{60.0, 1, {}, true};
  facts.ahead->conflicts.push_back({0, 1, 5.0, 9.0, 1.0, {}, {90, 0, 0}, {100, 0, 0}});
  const Drawing drawing = figure_of(facts);
  std::vector<Spot> rings;
  for (const Dots& dots : shapes_of<Dots>(drawing)) {
    if (dots.ink.rgb == kRisk.rgb)
      rings.insert(rings.end(), dots.centres.begin(), dots.centres.end());
  }
  ASSERT_FALSE(rings.empty());
  std::size_t names = 0;
  for (const Text& text : shapes_of<Text>(drawing)) {
    if (text.text != "4b1617 (SWR123)") continue;
    ++names;
    const double right = text.at.x + text_width(text.text, text.size);
    for (const Spot& ring : rings) {
      EXPECT_FALSE(ring.x > text.at.x && ring.x < right && ring.y < text.at.y + 4.0 &&
                   ring.y > text.at.y - text.size);
    }
  }
  EXPECT_EQ(names, 1u);
}

TEST(FigureWords, NamesInListsAreNotCut) {
  const auto texts = texts_of(figure_of(crossing()));
  const auto has = [&texts](const char* line) {
    return std::find(texts.begin(), texts.end(), line) != texts.end();
  };
  EXPECT_TRUE(has("3c6444 (LUFTHANSA2A) \u2013"));
  EXPECT_TRUE(has("4ca7b3 (RYANAIR12AB)"));
}

// No name of a limit where the line of the separation goes.
TEST(FigureWords, NoNameOfALimitSitsOnTheLine) {
  const Drawing drawing = figure_of(crossing());
  std::vector<double> levels;  // of lines that go through all of the chart
  for (const Shape& shape : drawing.shapes) {
    const auto* lines = std::get_if<Lines>(&shape);
    if (lines == nullptr || lines->ink.rgb != kText.rgb || lines->runs.size() != 1) continue;
    if (lines->runs.front().size() > 100) levels.push_back(lines->runs.front().front().y);
  }
  ASSERT_EQ(levels.size(), 2u);
  for (const Shape& shape : drawing.shapes) {
    const auto* text = std::get_if<Text>(&shape);
    if (text == nullptr ||
        !(text->text.starts_with("horizontally ") || text->text.starts_with("in height "))) {
      continue;
    }
    for (const double level : levels) {
      EXPECT_TRUE(level < text->at.y - kLabelSize || level > text->at.y + 3.0) << text->text;
    }
  }
}

// However the line goes: a name over it looks like a gap in it.
TEST(FigureWords, NoNameOfALimitCoversALineThatIsEverywhere) {
  RecordingFacts facts = crossing();
  for (std::size_t i = 0; i < facts.separation.size(); ++i) {
    facts.separation[i].apart =
        Apart{2'000.0 * static_cast<double>(i % 8), 70.0 * static_cast<double>(i % 7)};
  }
  const Drawing drawing = figure_of(facts);
  std::vector<Text> names;
  for (const Shape& shape : drawing.shapes) {
    const auto* text = std::get_if<Text>(&shape);
    if (text == nullptr) continue;
    if (text->text == "horizontally 5 NM" || text->text == "in height 1,000 ft") {
      names.push_back(*text);
    }
  }
  ASSERT_EQ(names.size(), 2u);
  for (const Shape& shape : drawing.shapes) {
    const auto* lines = std::get_if<Lines>(&shape);
    if (lines == nullptr || lines->ink.rgb != kText.rgb) continue;
    for (const auto& run : lines->runs) {
      if (run.size() < 100) continue;
      for (const Spot& spot : run) {
        for (const Text& name : names) {
          const bool covered =
              spot.x > name.at.x && spot.y > name.at.y - kLabelSize && spot.y < name.at.y + 3.0;
          ASSERT_FALSE(covered) << name.text;
        }
      }
    }
  }
}

}  // namespace
}  // namespace beespace::report
