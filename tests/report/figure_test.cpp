// Whole figures, as shapes: what is marked, where, and that it stays small.
#include "report/figure/figure.hpp"

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

template <class Kind>
std::vector<Kind> shapes_of(const Drawing& drawing) {
  std::vector<Kind> all;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* found = std::get_if<Kind>(&shape)) all.push_back(*found);
  }
  return all;
}

bool says(const Drawing& drawing, const std::string& part) {
  const auto texts = shapes_of<Text>(drawing);
  return std::any_of(texts.begin(), texts.end(), [&part](const Text& text) {
    return text.text.find(part) != std::string::npos;
  });
}

// Those with names, which are not of the key.
std::vector<Diamond> named_marks(const Drawing& drawing) {
  std::vector<Diamond> marks;
  for (const Diamonds& diamonds : shapes_of<Diamonds>(drawing)) {
    for (const Diamond& mark : diamonds.marks) {
      if (!mark.name.empty()) marks.push_back(mark);
    }
  }
  return marks;
}

void expect_inside(const Drawing& drawing) {
  const auto inside = [&drawing](const Spot& spot) {
    return spot.x >= 0.0 && spot.x <= drawing.width && spot.y >= 0.0 && spot.y <= drawing.height;
  };
  for (const Text& text : shapes_of<Text>(drawing)) EXPECT_TRUE(inside(text.at)) << text.text;
  for (const Dots& dots : shapes_of<Dots>(drawing)) {
    EXPECT_TRUE(std::all_of(dots.centres.begin(), dots.centres.end(), inside));
  }
  for (const Lines& lines : shapes_of<Lines>(drawing)) {
    for (const auto& run : lines.runs) EXPECT_TRUE(std::all_of(run.begin(), run.end(), inside));
  }
}

// Maya and Willi are 50 m apart, Flip is by himself.
SnapshotFacts three_bees() {
  SnapshotFacts facts;
  facts.swarm.title = "three.csv";
  facts.swarm.threshold_m = 100.0;
  facts.swarm.names.texts = {"maya", "willi", "flip"};
  facts.positions = {{0, 0, 0}, {30, 40, 0}, {1000, 500, 200}};
  facts.at_risk = {0, 1};
  facts.nearest = {{1, 50.0}, {0, 50.0}, {1, 1090.0}};
  facts.pair_count = 1;
  facts.group_count = 1;
  facts.largest_group = 2;
  facts.closest = ClosestPair{0, 1, 50.0};
  facts.pairs = {{0, 1}};
  facts.distances_m = {50.0};
  return facts;
}

SnapshotFacts many_bees(std::size_t count, std::size_t at_risk) {
  SnapshotFacts facts;
  facts.swarm.title = "many";
  facts.swarm.threshold_m = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i);
    facts.positions.push_back(
        {std::fmod(k * 37.7, 1000.0), std::fmod(k * 91.3, 800.0), 50.0 * std::sin(k)});
    facts.nearest.push_back({0, 0.5 + std::fmod(k, 10.0)});
  }
  for (std::size_t i = 0; i < at_risk; ++i) facts.at_risk.push_back(static_cast<PointId>(i));
  return facts;
}

RecordingFacts two_tracks() {
  RecordingFacts facts;
  facts.swarm.title = "flight";
  facts.swarm.threshold_m = 5.0;
  facts.swarm.names.texts = {"a", "b"};
  facts.tracks = {Track{{{0.0, {0, 0, 10}}, {100.0, {100, 0, 10}}}},
                  Track{{{0.0, {100, 3, 10}}, {100.0, {0, 3, 10}}}}};
  facts.at_risk = {{0, {48.0, 52.0}}, {1, {48.0, 52.0}}};
  facts.conflicts = {{0, 1, 48.0, 50.0, 52.0, 3.0}};
  facts.conflict_count = 1;
  facts.pair_count = 1;
  facts.closest = facts.conflicts.front();
  for (double t = 0.0; t <= 100.0; t += 1.0) {
    facts.separation.push_back({t, {0, 1, std::hypot(100.0 - 2.0 * t, 3.0)}});
  }
  return facts;
}

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

TEST(Figure, OfARecordingPartsInConflictAreFat) {
  const RecordingFacts facts = two_tracks();
  const Drawing drawing = figure_of(facts);
  std::size_t found = 0;
  for (const Lines& lines : shapes_of<Lines>(drawing)) {
    if (lines.ink.rgb != kRisk.rgb || lines.runs.size() != 2) continue;
    ++found;
    EXPECT_GT(lines.width, 2.0);
  }
  EXPECT_EQ(found, 2u);  // in both views
  Extent extent;
  for (const Track& track : facts.tracks) {
    for (const Fix& fix : track.fixes) extent.add(fix.position);
  }
  const View view = views_of(extent, facts.swarm, {100.0, 152.0}, 648.0).front();
  const auto marks = named_marks(drawing);
  ASSERT_EQ(marks.size(), 4u);
  EXPECT_NEAR(marks.front().centre.x, view.spot_of({50, 0, 10}).x, 1e-9);
  EXPECT_TRUE(says(drawing, "3.000 m at 50.0 s"));
  expect_inside(drawing);
}

TEST(Figure, APossibleConflictIsMarkedAsSuch) {
  RecordingFacts facts = two_tracks();
  EXPECT_FALSE(says(figure_of(facts), "possible"));
  facts.conflicts.front().certain = false;
  facts.conflicts.front().closest_m = 5.001;
  facts.possible_count = 1;
  EXPECT_TRUE(says(figure_of(facts), "5.001 m at 50.0 s, possible"));
}

TEST(Figure, TwoThatBothStandAreNotPassedOverInSilence) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  EXPECT_FALSE(says(figure_of(facts), "but for"));
  facts.standing_count = 1;
  EXPECT_TRUE(says(figure_of(facts), "but for 1 conflict of two that both stand on the ground"));
}

TEST(Figure, ListsNothingAtTheThresholdThatIsBelowIt) {
  SnapshotFacts facts = three_bees();
  facts.distances_m = {99.99996};
  facts.closest->distance_m = 99.99996;
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "99.99996 m"));
  EXPECT_FALSE(says(drawing, "100.000 m"));
  EXPECT_TRUE(says(drawing, "closest: 99.99996 m"));
}

TEST(Figure, TheHeadingOfTheListGivesTheTotal) {
  SnapshotFacts facts = three_bees();
  EXPECT_TRUE(says(figure_of(facts), "Closest pairs"));
  EXPECT_FALSE(says(figure_of(facts), "Closest pairs: "));
  facts.pair_count = 1'503;
  EXPECT_TRUE(says(figure_of(facts), "Closest pairs: 1 of 1,503"));
  // Where not all pairs fit, the shown ones are counted.
  facts.pairs.assign(100, {0, 1});
  facts.distances_m.assign(100, 50.0);
  facts.pair_count = 100;
  const Drawing drawing = figure_of(facts);
  const auto texts = shapes_of<Text>(drawing);
  const auto rows = std::count_if(texts.begin(), texts.end(),
                                  [](const Text& text) { return text.text == "50.000 m"; });
  EXPECT_GT(rows, 1);
  EXPECT_TRUE(says(drawing, "Closest pairs: " + std::to_string(rows) + " of 100"));
  RecordingFacts flown = two_tracks();
  flown.conflict_count = 26;
  flown.pair_count = 26;
  EXPECT_TRUE(says(figure_of(flown), "Closest pairs in conflict: 1 of 26"));
}

TEST(Figure, ListsEachPairOnceAndThoseOnTheGroundBehindThoseInTheAir) {
  RecordingFacts facts = two_tracks();
  const Track third = facts.tracks[0];
  facts.tracks.push_back(third);
  facts.swarm.names.texts = {"a", "b", "c"};
  facts.conflicts = {{0, 2, 0.0, 0.5, 1.0, 1.0},
                     {0, 1, 0.0, 0.5, 1.0, 1.5},
                     {0, 1, 2.0, 2.5, 3.0, 1.8},
                     {0, 1, 4.0, 4.5, 5.0, 1.9}};
  facts.conflict_count = 4;
  facts.pair_count = 2;
  facts.with_standing = {facts.conflicts[0], facts.conflicts[1]};
  const Drawing drawing = figure_of(facts);
  EXPECT_FALSE(says(drawing, "1.500 m"));
  EXPECT_FALSE(says(drawing, "1.900 m"));
  EXPECT_TRUE(says(drawing, ", with one on the ground"));
  const auto texts = shapes_of<Text>(drawing);
  const auto place_of = [&texts](const std::string& part) {
    return std::find_if(texts.begin(), texts.end(),
                        [&part](const Text& text) {
                          return text.text.find(part) != std::string::npos &&
                                 text.text.find(" at ") != std::string::npos;
                        }) -
           texts.begin();
  };
  EXPECT_LT(place_of("1.800 m"), place_of("1.000 m"));
}

TEST(Figure, OfManyPathsTheClosestTwoAreNamedWhereTheyAre) {
  RecordingFacts facts = two_tracks();
  const Track one = facts.tracks[0];
  facts.tracks.resize(20, one);
  facts.swarm.names.texts.resize(20, "c");
  const auto texts = shapes_of<Text>(figure_of(facts));
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const Text& text) {
    return text.text.starts_with("closest") && text.text.find(" \u2013 ") != std::string::npos;
  }));
}

// An encounter that is not too close is not "possible".
TEST(Figure, AnEncounterThatIsNoConflictIsNotCalledPossible) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.clear();
  facts.conflict_count = 0;
  facts.at_risk.clear();
  facts.closest->certain = false;
  EXPECT_FALSE(says(figure_of(facts), "possible"));
}

TEST(Figure, NoLabelOfTheSeparationIsStruckThroughByTheThreshold) {
  for (const double threshold_m : {1.0, 3.0, 3.5, 5.0, 8.0, 20.0, 90.0}) {
    RecordingFacts facts = two_tracks();
    facts.swarm.threshold_m = threshold_m;
    const Drawing drawing = figure_of(facts);
    for (const Lines& lines : shapes_of<Lines>(drawing)) {
      if (!lines.dashed) continue;
      const double line_y = lines.runs.front().front().y;
      const double left = lines.runs.front().front().x;
      for (const Text& text : shapes_of<Text>(drawing)) {
        const bool in_the_chart = text.at.x > left && text.at.y < line_y + 40.0;
        if (!in_the_chart || !text.halo) continue;
        EXPECT_TRUE(text.at.y <= line_y - 4.0 || text.at.y - 0.75 * text.size >= line_y + 1.0)
            << text.text << " at " << threshold_m;
      }
    }
  }
}

TEST(Figure, TimesInConflictThatTouchAreOneBand) {
  const auto bands =
      times_in_conflict({{0, {5.0, 7.0}}, {1, {1.0, 2.0}}, {2, {2.0, 3.0}}, {3, {2.5, 2.6}}});
  EXPECT_EQ(bands, (std::vector<TimeSpan>{{1.0, 3.0}, {5.0, 7.0}}));
}

// However many of them are narrower than what can be seen.
TEST(Figure, BandsAndHatchingLieAtTheirTimes) {
  RecordingFacts facts;
  facts.swarm.threshold_m = 5.0;
  facts.tracks = {{{{0.0, {0, 0, 0}}, {1'000.0, {100, 0, 0}}}},
                  {{{0.0, {0, 50, 0}}, {1'000.0, {100, 50, 0}}}}};
  facts.separation = {{0.0, {0, 1, 50.0}}, {1'000.0, {0, 1, 50.0}}};
  for (int i = 0; i < 400; ++i) {
    const double begins_s = 0.25 * i;
    facts.at_risk.push_back({0, {begins_s, begins_s + 0.01}});
    facts.unknown_spans.push_back({1, begins_s, begins_s + 0.01});
  }
  facts.at_risk.push_back({0, {999.99, 1'000.0}});
  const Drawing drawing = figure_of(facts);
  double last = 0.0;
  double right = 0.0;
  std::size_t bands = 0;
  for (const Area& area : shapes_of<Area>(drawing)) {
    if (area.ink.rgb != kRiskBand.rgb || area.corners[1].x - area.corners[0].x == 14.0) continue;
    last = std::max(right, area.corners[0].x);
    right = std::max(right, area.corners[1].x);
    ++bands;
  }
  ASSERT_EQ(bands, 2U) << "joined where they overlap";
  EXPECT_LE(right, kRight + 1e-9) << "none is beyond the axis";
  EXPECT_NEAR(last, right - 1.0, 1e-9);
  expect_inside(drawing);
}

// In conflict all the time on a path of so many corners.
RecordingFacts winding(int corners) {
  RecordingFacts facts = two_tracks();
  for (Track& track : facts.tracks) {
    const double x = track.fixes.front().position.x;
    track.fixes.clear();
    for (int i = 0; i < corners; ++i) {
      track.fixes.push_back({double(i), {x + (i % 2) * 50.0, (i % 3) * 40.0, (i % 5) * 20.0}});
    }
  }
  facts.at_risk = {{0, {0.0, corners - 1.0}}, {1, {0.0, corners - 1.0}}};
  return facts;
}

bool has_fat_parts(const Drawing& drawing) {
  const auto lines = shapes_of<Lines>(drawing);
  return std::any_of(lines.begin(), lines.end(), [](const Lines& some) {
    return some.ink.rgb == kRisk.rgb && some.width > 2.0 && !some.runs.empty();
  });
}

TEST(Figure, TheKeyHasOnlyWhatIsDrawn) {
  const Drawing some = figure_of(winding(1'000));
  EXPECT_TRUE(has_fat_parts(some));  // of the key too
  EXPECT_TRUE(says(some, "in conflict, and where it is closest"));
  RecordingFacts many = winding(40'000);
  const Drawing without = figure_of(many);
  EXPECT_FALSE(has_fat_parts(without));
  EXPECT_TRUE(says(without, "in conflict, where it is closest"));
  many.conflicts.assign(301, many.conflicts.front());
  many.conflict_count = 301;
  const Drawing binned = figure_of(many);
  EXPECT_FALSE(has_fat_parts(binned));
  EXPECT_TRUE(says(binned, "conflicts: area by their number, up to 301 from above"));
  EXPECT_FALSE(says(binned, "closest 301"));
}

TEST(Figure, TheKeySaysThatOnlyTheClosestConflictsAreCounted) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.assign(400, facts.conflicts.front());
  facts.conflict_count = 300'000;
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "closest 400 conflicts: area by number, up to 400 from above"));
  expect_inside(drawing);
}

TEST(Figure, ManyPathsAreShades) {
  RecordingFacts facts;
  facts.swarm.threshold_m = 1.0;
  for (int i = 0; i < 2'000; ++i) {
    const double y = i;
    facts.tracks.push_back(Track{{{0.0, {0, y, 0}}, {10.0, {1000, 2000 - y, 100}}}});
  }
  const Drawing drawing = figure_of(facts);
  EXPECT_EQ(shapes_of<Cells>(drawing).size(), 2u);
  EXPECT_LT(svg(drawing, 1200).size(), 2'000'000u);
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
