// Figures of recordings: parts in conflict, the list of pairs, what is drawn over time.
#include "report/figure/figure.hpp"

#include "report/drawing/svg.hpp"
#include "report/figure/separation_chart.hpp"
#include "report/figure/style.hpp"
#include "report/figure/view.hpp"
#include "tests/report/figure_facts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

TEST(FigureOfRecording, OfARecordingPartsInConflictAreFat) {
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

TEST(FigureOfRecording, APossibleConflictIsMarkedAsSuch) {
  RecordingFacts facts = two_tracks();
  EXPECT_FALSE(says(figure_of(facts), "possible"));
  facts.conflicts.front().certain = false;
  facts.conflicts.front().closest_m = 5.001;
  facts.possible_count = 1;
  EXPECT_TRUE(says(figure_of(facts), "5.001 m at 50.0 s, possible"));
}

TEST(FigureOfRecording, WhoFliesSeveralFlightsIsCalledAfterThatOfTheMoment) {
  RecordingFacts facts = two_tracks();
  const PointId bee = facts.conflicts.front().first;
  facts.swarm.names.texts[bee] = "4b1 (EZY1, EZY2)";
  facts.swarm.names.called = {{bee, 0.0, "4b1 (EZY1)"}, {bee, 40.0, "4b1 (EZY2)"}};
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "4b1 (EZY2) \u2013 "));
  EXPECT_FALSE(says(drawing, "4b1 (EZY1, EZY2) \u2013 "));
  EXPECT_EQ(facts.swarm.names.at(39.0, bee), "4b1 (EZY1)");
  EXPECT_EQ(facts.swarm.names.at(-1.0, bee), "4b1 (EZY1)");
}

// When few are known, at the beginning, the closest two may be far apart for a moment.
TEST(FigureOfRecording, AFewFarSecondsDoNotPressAllElseAgainstTheAxis) {
  RecordingFacts facts = two_tracks();
  facts.separation.clear();
  for (int t = 0; t <= 100; ++t) {
    facts.separation.push_back({1.0 * t, {0, 1, t < 5 ? 4'000.0 : 9.0 + 0.01 * t}});
  }
  EXPECT_TRUE(says(figure_of(facts), "Distance (m), cut off at the top"));
  EXPECT_FALSE(says(figure_of(facts), "powers of ten"));
  for (Separation& at : facts.separation) at.closest.distance_m = 9.0;
  EXPECT_FALSE(says(figure_of(facts), "cut off"));
}

// A straight line would tell distances that are not known.
TEST(FigureOfRecording, NoLineGoesThroughTimeInWhichTheClosestTwoAreNotKnown) {
  RecordingFacts facts = two_tracks();
  facts.separation = {{0.0, {0, 1, 9.0}}, {1.0, {0, 1, 8.0}}, {2.0, {0, 1, 9.0}}};
  const auto runs_of = [](const RecordingFacts& of) {
    std::size_t runs = 0;
    for (const Lines& lines : shapes_of<Lines>(figure_of(of))) {
      if (lines.width == 1.3) runs += lines.runs.size();
    }
    return runs;
  };
  const std::size_t runs = runs_of(facts);
  facts.separation_open = {{0.0, 1.0}};
  EXPECT_EQ(runs_of(facts), runs + 1);
  facts.separation_open = {{0.9, 1.1}};
  EXPECT_EQ(runs_of(facts), runs);
}

// Of two axes above each other there is no room for it in the titles.
TEST(FigureOfRecording, AxesByPowersOfTenHaveATickAtTheLimit) {
  RecordingFacts facts = two_tracks();
  facts.swarm.threshold_m = 7.0;
  facts.swarm.vertical_m = 3.0;
  for (Separation& at : facts.separation) {
    at.apart = Apart{at.closest.distance_m, 0.5 * at.closest.distance_m};
  }
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "Nearest to a conflict, by powers of ten"));
  EXPECT_TRUE(says(drawing, "The same two, by powers of ten"));
  const auto texts = shapes_of<Text>(drawing);
  const auto is_tick = [&](const std::string& label) {
    return std::any_of(texts.begin(), texts.end(), [&label](const Text& text) {
      return text.anchor == Anchor::kEnd && text.text == label;
    });
  };
  EXPECT_TRUE(is_tick("7"));
  EXPECT_TRUE(is_tick("3"));
  EXPECT_FALSE(says(drawing, "Distance (m), by"));
}

TEST(FigureOfRecording, TwoThatBothStandAreNotPassedOverInSilence) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  EXPECT_FALSE(says(figure_of(facts), "but for"));
  facts.standing_count = 1;
  EXPECT_TRUE(says(figure_of(facts), "but for 1 conflict of two that both stand on the ground"));
}

TEST(FigureOfRecording, ListsNothingAtTheThresholdThatIsBelowIt) {
  SnapshotFacts facts = three_bees();
  facts.distances_m = {99.99996};
  facts.closest->distance_m = 99.99996;
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "99.99996 m"));
  EXPECT_FALSE(says(drawing, "100.000 m"));
  EXPECT_TRUE(says(drawing, "closest: 99.99996 m"));
}

TEST(FigureOfRecording, TheHeadingOfTheListGivesTheTotal) {
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

// Of drones the closest come first.
TEST(FigureOfRecording, AnimalsThatAreTogetherForLongestComeFirst) {
  RecordingFacts facts = two_tracks();
  facts.tracks.push_back(facts.tracks.back());
  facts.swarm.names.texts = {"Ada", "Bo", "Cy"};
  facts.conflicts = {{0, 1, 1.0, 1.5, 2.0, 0.5}, {0, 2, 1.0, 1.5, 9.0, 2.5}};
  facts.pairs = {{0, 1, 1, 1.0}, {0, 2, 1, 8.0}};
  facts.conflict_count = facts.pair_count = 2;
  const auto order = [&facts] {
    std::vector<std::string> pairs;
    for (const Text& text : shapes_of<Text>(figure_of(facts))) {
      if (text.text.starts_with("Ada \u2013 ")) pairs.push_back(text.text);
    }
    return pairs;
  };
  EXPECT_EQ(order(), (std::vector<std::string>{"Ada \u2013 Bo", "Ada \u2013 Cy"}));
  facts.swarm.noun = {"animal", "animals"};
  EXPECT_EQ(order(), (std::vector<std::string>{"Ada \u2013 Cy", "Ada \u2013 Bo"}));
  EXPECT_TRUE(says(figure_of(facts), "Pairs that are together for longest"));
}

TEST(FigureOfRecording, ListsEachPairOnceAndThoseOnTheGroundBehindThoseInTheAir) {
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

TEST(FigureOfRecording, OfManyPathsTheClosestTwoAreNamedWhereTheyAre) {
  RecordingFacts facts = two_tracks();
  const Track one = facts.tracks[0];
  facts.tracks.resize(20, one);
  facts.swarm.names.texts.resize(20, "c");
  const auto texts = shapes_of<Text>(figure_of(facts));
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const Text& text) {
    return text.text.starts_with("closest") && text.text.find(" \u2013 ") != std::string::npos;
  }));
}

// The closest of them says little of the others.
TEST(FigureOfRecording, OfAPairAllConflictsAreTold) {
  RecordingFacts facts = two_tracks();
  facts.pairs = {{0, 1, 19, 7'800.0}};
  EXPECT_TRUE(
      says(figure_of(facts), "3.000 m at 50.0 s; 19 conflicts, 2\u00a0h\u00a010\u00a0min in all"));
  facts.pairs = {{0, 1, 1, 4.0}};
  EXPECT_TRUE(says(figure_of(facts), "3.000 m at 50.0 s, for 4\u00a0s"));
}

TEST(FigureOfRecording, AFewPathsHaveColoursOfTheirOwnWhichTheListHasToo) {
  RecordingFacts facts = two_tracks();
  const auto has_path = [](const Drawing& drawing, const Ink& ink) {
    const auto lines = shapes_of<Lines>(drawing);
    return std::any_of(lines.begin(), lines.end(),
                       [&ink](const Lines& line) { return line.ink.rgb == ink.rgb; });
  };
  const auto dots_of = [](const Drawing& drawing, const Ink& ink) {
    const auto dots = shapes_of<Dots>(drawing);
    return std::count_if(dots.begin(), dots.end(), [&ink](const Dots& of) {
      return of.ink.rgb == ink.rgb && of.outline == 0.0;
    });
  };
  const Drawing few = figure_of(facts);
  for (std::size_t path = 0; path < 2; ++path) {
    EXPECT_TRUE(has_path(few, kFewPathInks[path]));
    EXPECT_GE(dots_of(few, kFewPathInks[path]), 1) << "in the list";
  }
  facts.tracks.resize(9, facts.tracks[0]);
  facts.swarm.names.texts.resize(9, "c");
  const Drawing many = figure_of(facts);
  EXPECT_TRUE(has_path(many, kPath));
  EXPECT_EQ(dots_of(many, kFewPathInks[0]), 0);
}

// Also where the first places for it are taken, or outside; and of many paths.
TEST(FigureOfRecording, WhoIsInConflictHasItsNameOnTheMap) {
  RecordingFacts facts = two_tracks();
  facts.swarm.names.texts = {"Findelkind / DER A8K4 (eobs 3339)", "Niclas / DER AU051 (eobs 3335)"};
  facts.tracks[1].fixes.back().position = facts.tracks[0].fixes.front().position;
  const auto names_on_map = [&facts](const std::string& name) {
    constexpr double kList = 760.0;  // is to the right of that
    const auto texts = shapes_of<Text>(figure_of(facts));
    return std::count_if(texts.begin(), texts.end(), [&name](const Text& text) {
      return text.text == name && text.at.x < kList;
    });
  };
  EXPECT_EQ(names_on_map(facts.swarm.names.texts[0]), 1);
  EXPECT_EQ(names_on_map(facts.swarm.names.texts[1]), 1);
  const Track other{{{0.0, {10, 40, 10}}, {100.0, {20, 50, 10}}}};
  facts.tracks.resize(40, other);
  facts.swarm.names.texts = {"Findelkind", "Niclas"};
  facts.swarm.names.texts.resize(40, "other");
  EXPECT_EQ(names_on_map("Findelkind"), 1);
  EXPECT_EQ(names_on_map("Niclas"), 1);
  EXPECT_EQ(names_on_map("other"), 0);
}

TEST(FigureOfRecording, WhereNothingIsComparedThatIsSaidOfAll) {
  RecordingFacts facts = two_tracks();
  facts.tracks.pop_back();
  facts.conflicts.clear();
  facts.conflict_count = facts.pair_count = 0;
  facts.at_risk.clear();
  facts.separation.clear();
  facts.closest.reset();
  facts.nowhere_count = 1;
  facts.nothing_compared = true;
  facts.unknown = "1 bee is known nowhere, 100 records were left out";
  EXPECT_TRUE(says(figure_of(facts),
                   "2 bees. Nothing to compare: no two bees are there at the same time; 1 bee is "
                   "known nowhere"));
}

// An encounter that is not too close is not "possible".
TEST(FigureOfRecording, AnEncounterThatIsNoConflictIsNotCalledPossible) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.clear();
  facts.conflict_count = 0;
  facts.at_risk.clear();
  facts.closest->certain = false;
  EXPECT_FALSE(says(figure_of(facts), "possible"));
}

TEST(FigureOfRecording, NoLabelOfTheSeparationIsStruckThroughByTheThreshold) {
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

TEST(FigureOfRecording, TimesInConflictThatTouchAreOneBand) {
  const auto bands =
      times_in_conflict({{0, {5.0, 7.0}}, {1, {1.0, 2.0}}, {2, {2.0, 3.0}}, {3, {2.5, 2.6}}});
  EXPECT_EQ(bands, (std::vector<TimeSpan>{{1.0, 3.0}, {5.0, 7.0}}));
}

// However many of them are narrower than what can be seen.
TEST(FigureOfRecording, BandsAndHatchingLieAtTheirTimes) {
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

TEST(FigureOfRecording, TheKeyHasOnlyWhatIsDrawn) {
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

TEST(FigureOfRecording, TheKeySaysThatOnlyTheClosestConflictsAreCounted) {
  RecordingFacts facts = two_tracks();
  facts.conflicts.assign(400, facts.conflicts.front());
  facts.conflict_count = 300'000;
  const Drawing drawing = figure_of(facts);
  EXPECT_TRUE(says(drawing, "closest 400 conflicts: area by number, up to 400 from above"));
  expect_inside(drawing);
}

TEST(FigureOfRecording, ManyPathsAreShades) {
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

// Of several days the time of day alone says little.
TEST(FigureOfRecording, TimesOfSeveralDaysAreListedWithTheirDates) {
  constexpr double kMay24_s = 1'684'886'400.0;  // 2023-05-24
  RecordingFacts facts = two_tracks();
  facts.calendar.since_1970 = true;
  for (Track& track : facts.tracks) {
    for (Fix& fix : track.fixes) fix.time_s += kMay24_s + 3'600.0;
  }
  for (Conflict& conflict : facts.conflicts) {
    conflict.begins_s += kMay24_s + 3'600.0;
    conflict.closest_s += kMay24_s + 3'600.0;
    conflict.ends_s += kMay24_s + 3'600.0;
  }
  EXPECT_TRUE(says(figure_of(facts), " at 01:00:"));
  EXPECT_FALSE(says(figure_of(facts), " at 05-24 01:00:"));
  for (Track& track : facts.tracks) track.fixes.back().time_s += 86'400.0;
  EXPECT_TRUE(says(figure_of(facts), " at 05-24 01:00:"));
}

}  // namespace
}  // namespace beespace::report
