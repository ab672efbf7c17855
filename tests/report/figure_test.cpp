// Whole figures, as shapes: what is marked, where, and that it stays small.
#include "report/figure/figure.hpp"
#include "tests/report/figure_facts.hpp"

#include "report/drawing/png.hpp"
#include "report/drawing/svg.hpp"
#include "report/figure/nearest_histogram.hpp"
#include "report/figure/separation_chart.hpp"
#include "report/figure/style.hpp"
#include "report/figure/view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace beespace::report {
namespace {

TEST(Figure, MarksThoseAtRiskWhereTheyAreInBothViews) {
  const SnapshotFacts facts = three_bees();
  const Drawing drawing = figure_of(facts);
  Extent extent;
  for (const Point& p : facts.positions) extent.add(p);
  const auto views = views_of(extent, facts.swarm, {100.0, 152.0}, 648.0);
  const auto marks = named_marks(drawing);
  ASSERT_EQ(marks.size(), 4u);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Spot expected = views[i / 2].spot_of(facts.positions[i % 2]);
    EXPECT_NEAR(marks[i].centre.x, expected.x, 1e-9);
    EXPECT_NEAR(marks[i].centre.y, expected.y, 1e-9);
    EXPECT_EQ(marks[i].name, i % 2 == 0 ? "maya" : "willi");
  }
  EXPECT_TRUE(says(drawing, "3 bees. 2 are at risk: 1 pair closer than 100 m, in 1 group."));
  EXPECT_TRUE(says(drawing, "maya \u2013 willi"));
  EXPECT_TRUE(says(drawing, "threshold 100 m"));
  expect_inside(drawing);
}

// What has no heights has no side.
TEST(Figure, WhoIsUnknownIsNotCutOffALongVerdict) {
  SnapshotFacts facts = three_bees();
  facts.unknown =
      "1,234 bees are known nowhere, as none of their records has a position, and 567 "
      "records were left out, as what they say is no number; see the end";
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "see the end."));
  for (const Text& text : shapes_of<Text>(drawing)) {
    EXPECT_EQ(text.text.find("\u2026"), std::string::npos) << text.text;
  }
  expect_inside(drawing);
}

TEST(Figure, WhatIsFlatIsSeenFromAboveOnly) {
  SnapshotFacts facts = three_bees();
  facts.swarm.flat = true;
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "From above"));
  EXPECT_FALSE(says(drawing, "From the side"));
  EXPECT_EQ(named_marks(drawing).size(), 2u);
  expect_inside(drawing);
}

RecordingFacts anna_and_bert() {
  RecordingFacts facts;
  facts.swarm.threshold_m = 1.0;
  facts.swarm.flat = true;
  facts.swarm.names.texts = {"Anna", "Bert"};
  facts.tracks = {Track{{{0.0, {0, 0, 0}}, {1.0, {100, 90, 0}}}},
                  Track{{{0.0, {0, 50, 0}}, {1.0, {100, 20, 0}}}}};
  return facts;
}

// Who is who among a few paths.
TEST(Figure, AFewPathsHaveTheirNamesAtTheirEnds) {
  RecordingFacts facts = anna_and_bert();
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "Anna"));
  EXPECT_TRUE(says(drawing, "Bert"));
  expect_inside(drawing);
  facts.tracks.resize(13, facts.tracks.front());
  EXPECT_FALSE(says(figure_of(facts), "Anna"));
  // Of two that end in one place one has room, or both beside each other.
  facts = anna_and_bert();
  facts.tracks[1] = facts.tracks[0];
  EXPECT_TRUE(says(figure_of(facts), "Anna"));
}

TEST(Figure, OfAVideoIsAsItIs) {
  RecordingFacts facts = anna_and_bert();
  facts.swarm.y_is_down = true;
  facts.swarm.noun = {"animal", "animals"};
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "As in the video, y downward"));
  EXPECT_TRUE(says(drawing, "2 animals. No animal comes closer than 1 m to another."));
  const auto at_y = [&](const std::string& name) {
    for (const Text& text : shapes_of<Text>(drawing)) {
      if (text.text == name) return text.at.y;
    }
    return 0.0;
  };
  EXPECT_GT(at_y("Anna"), at_y("Bert"));  // whose y is the greater one
}

TEST(Figure, FromAboveAMetreIsAsLongOnBothAxes) {
  for (const double wide : {10.0, 1000.0, 1e6}) {
    for (const double deep : {1.0, 500.0, 2e6}) {
      Extent extent;
      extent.add({0, 0, 0});
      extent.add({wide, deep, 7});
      const auto views = views_of(extent, three_bees().swarm, {100.0, 150.0}, 648.0);
      const Panel& above = views.front().panel;
      const double across = above.box.width / above.across.scale.values().size();
      const double along = above.box.height / above.upwards.scale.values().size();
      EXPECT_NEAR(across / along, 1.0, 1e-9);
      const Range& x = above.across.scale.values();
      const Range& y = above.upwards.scale.values();
      EXPECT_TRUE(x.low < 0.0 && x.high > wide && y.low < 0.0 && y.high > deep);
    }
  }
}

TEST(Figure, DistancesBelowTheThresholdAreInADarkBarAndTheThresholdIsAnEdge) {
  const auto histogram = nearest_histogram(three_bees());
  ASSERT_TRUE(histogram.has_value());
  EXPECT_EQ(std::accumulate(histogram->counts.begin(), histogram->counts.end(), std::uint64_t{0}),
            3u);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < histogram->counts.size(); ++i) {
    if (histogram->edges_m[i + 1] <= 100.0) below += histogram->counts[i];
  }
  EXPECT_EQ(below, 2u);
  EXPECT_NE(std::find(histogram->edges_m.begin(), histogram->edges_m.end(), 100.0),
            histogram->edges_m.end());
}

// With heights compared apart, a near bee need not be at risk.
TEST(Figure, BarsAreDarkByTheBeesAtRisk) {
  SnapshotFacts facts = three_bees();
  facts.swarm.vertical_m = 5.0;
  facts.positions.push_back({30, 0, 40});
  facts.nearest.push_back({0, 50.0});
  const auto histogram = nearest_histogram(facts);
  ASSERT_TRUE(histogram.has_value());
  const auto bar = std::find(histogram->counts.begin(), histogram->counts.end(), 3u);
  ASSERT_NE(bar, histogram->counts.end());
  EXPECT_EQ(histogram->at_risk[static_cast<std::size_t>(bar - histogram->counts.begin())], 2u);
  EXPECT_EQ(std::accumulate(histogram->at_risk.begin(), histogram->at_risk.end(), 0u), 2u);
  const Drawing drawing = figure_of(facts);
  double dark = 0.0;
  double light = 0.0;
  for (const Area& area : shapes_of<Area>(drawing)) {
    const double height = area.corners[0].y - area.corners[1].y;
    if (area.ink.rgb == kRisk.rgb) dark += height;
    if (area.ink.rgb == kBee.rgb) light += height;
  }
  EXPECT_NEAR(dark, light, 1e-9);  // two each
  EXPECT_TRUE(says(drawing, "horizontally 100 m"));
  EXPECT_FALSE(says(drawing, "threshold"));
}

TEST(Figure, DistancesOverManyPowersOfTenAreShownByThem) {
  SnapshotFacts facts = three_bees();
  facts.nearest = {{1, 1e-3}, {0, 1e-3}, {1, 1e6}};
  EXPECT_TRUE(nearest_histogram(facts)->logarithmic);
  facts.nearest = {{1, 0.0}, {0, 0.0}, {1, 0.0}};
  const auto all_at_one_place = nearest_histogram(facts);
  EXPECT_FALSE(all_at_one_place->logarithmic);
  EXPECT_EQ(all_at_one_place->counts.front(), 3u);
  facts.nearest = {{}, {}, {}};
  EXPECT_FALSE(nearest_histogram(facts).has_value());
}

TEST(Figure, VeryManyBeesAreShadesAndTheFileStaysSmall) {
  const Drawing drawing = figure_of(many_bees(100'000, 60'000));
  EXPECT_EQ(shapes_of<Cells>(drawing).size(), 2u);
  EXPECT_TRUE(named_marks(drawing).empty());
  EXPECT_TRUE(says(drawing, "bees in a cell: 1 to "));
  EXPECT_TRUE(says(drawing, "at risk: area by their number, up to "));
  EXPECT_LT(svg(drawing, 1200).size(), 2'000'000u);
  expect_inside(drawing);
  EXPECT_EQ(named_marks(figure_of(many_bees(10'000, 500))).size(), 1'000u);
}

TEST(Figure, SwarmsWithoutAnyExtentCanBeDrawn) {
  SnapshotFacts facts;
  facts.swarm.threshold_m = 5.0;
  for (const Point& place : {Point{0, 0, 0}, Point{5e7, -5e7, 1}, Point{1e120, 0, 0}}) {
    facts.positions.assign(1, place);
    facts.nearest.assign(1, Nearest{});
    expect_inside(figure_of(facts));
    facts.positions.assign(2, place);
    facts.nearest = {{1, 0.0}, {0, 0.0}};
    facts.at_risk = {0, 1};
    expect_inside(figure_of(facts));
    facts.at_risk.clear();
  }
  facts.positions = {{-1e120, 0, 0}, {1e120, 0, 0}};
  facts.nearest = {{1, 2e120}, {0, 2e120}};
  expect_inside(figure_of(facts));
  RecordingFacts empty;
  empty.swarm.threshold_m = 5.0;
  expect_inside(figure_of(empty));
}

TEST(Svg, IsTheSameForTheSameFactsAndHoldsHostileNamesAsText) {
  SnapshotFacts facts = three_bees();
  facts.swarm.names.texts[0] = "<script>]]>\x01\xFF\"";
  facts.swarm.title = "a & b";
  const std::string once = svg(figure_of(facts), 800);
  EXPECT_EQ(once, svg(figure_of(facts), 800));
  EXPECT_EQ(once.find("<script"), std::string::npos);
  EXPECT_NE(once.find("<title>&lt;script&gt;]]&gt;\xEF\xBF\xBD\xEF\xBF\xBD&quot;</title>"),
            std::string::npos);
  EXPECT_NE(once.find(">a &amp; b</text>"), std::string::npos);
  EXPECT_NE(once.find(" width=\"800\" height="), std::string::npos);
}

TEST(Svg, PathsDoNotDriftByRounding) {
  Drawing drawing{100.0, 100.0, "", "", {}};
  std::vector<Spot> run;
  for (int i = 0; i <= 1'000; ++i) run.push_back({0.0333 * i, 50.0});
  drawing.shapes.emplace_back(Lines{{run}, {}});
  const std::string text = svg(drawing, 100);
  const std::size_t begin = text.find(" d=\"M0 50l") + 10;
  double x = 0.0;
  std::size_t at = begin;
  while (text[at] != '"') {
    std::size_t used = 0;
    x += std::stod(text.substr(at), &used);
    at += used;
    std::stod(text.substr(at), &used);
    at += used;
  }
  EXPECT_NEAR(x, 33.3, 1e-6);
}

TEST(Png, DrawsEveryKindOfShape) {
  if (!why_no_png().empty()) GTEST_SKIP() << why_no_png();
  SnapshotFacts hostile = three_bees();
  hostile.swarm.names.texts[0] = "\x01\xFF";  // cairo itself takes no text that is not UTF-8
  hostile.swarm.title = "\xC3";
  for (const Drawing& drawing :
       {figure_of(hostile), figure_of(many_bees(5'000, 3'000)), figure_of(two_tracks())}) {
    const auto made = png(drawing, 300);
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(made->bytes.substr(0, 8), "\x89PNG\r\n\x1A\n");
    EXPECT_EQ(made->bytes, png(drawing, 300)->bytes);
  }
}

}  // namespace
}  // namespace beespace::report
