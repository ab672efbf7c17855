// Map files: where things are, what is left out, and hostile names.
#include "report/map/map_obstacles.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"
#include "report/map/risk_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

double apart(const GeographicPosition& a, const GeographicPosition& b) {
  const Point p = *to_ecef(a);
  const Point q = *to_ecef(b);
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

TEST(EarthFrame, FindsPlacesAgainToAMillimetre) {
  for (const double latitude_deg : {-90.0, -60.0, 0.0, 6.3, 89.0}) {
    for (const double longitude_deg : {-180.0, -75.6, 0.0, 179.99}) {
      std::vector<GeographicPosition> given;
      std::vector<Point> ecef;
      for (const double height_m : {-400.0, 0.0, 1'500.0, 12'000.0}) {
        for (const double away_deg : {0.0, 0.001, 0.5}) {
          given.push_back({longitude_deg + away_deg, latitude_deg + away_deg, height_m});
          ecef.push_back(*to_ecef(given.back()));
        }
      }
      const LocalPlaces local = around_middle(ecef);
      SwarmFacts swarm;
      swarm.origin = local.origin;
      const MapPlaces places(swarm);
      for (std::size_t i = 0; i < given.size(); ++i) {
        EXPECT_LT(apart(places.of(local.places[i]), given[i]), 1e-3)
            << longitude_deg << ", " << latitude_deg << ", " << given[i].height_m;
      }
    }
  }
}

TEST(LocalPlaces, HaveTheirOriginBelowTheMiddle) {
  const std::vector<Point> ecef = {*to_ecef({-75.5, 6.25, 1500.0}),
                                   *to_ecef({-75.5, 6.35, 1500.0})};
  const LocalPlaces local = around_middle(ecef);
  EXPECT_NEAR(local.origin.latitude_deg, 6.3, 1e-4);
  EXPECT_NEAR(local.places[0].y, -local.places[1].y, 1.0);
}

TEST(MapPlaces, AreWrittenAsShortAsTheyWere) {
  const GeographicPosition given{-75.5, 6.25, 1500.0};
  const LocalPlaces local = around_middle(std::vector<Point>{*to_ecef(given)});
  SwarmFacts swarm;
  swarm.origin = local.origin;
  EXPECT_EQ(place_text(MapPlaces(swarm).of(local.places[0]), ','), "-75.5,6.25,1500");
}

TEST(MapTracks, PreferThoseInConflictAndSayWhatIsLeftOut) {
  RecordingFacts facts;
  for (int i = 0; i < 10; ++i) {
    Track track;
    for (int k = 0; k < 100; ++k) track.fixes.push_back({double(k), {double(k), double(i), 0}});
    facts.tracks.push_back(track);
  }
  facts.at_risk = {{7, {1.0, 2.0}}, {8, {1.0, 2.0}}};
  facts.gaps = {{7, 10.0, 11.0}};
  const MapTracks map = map_tracks(facts, 3, 100);
  ASSERT_EQ(map.tracks.size(), 3u);
  EXPECT_EQ(map.tracks[0].bee, 0u);
  EXPECT_EQ(map.tracks[1].bee, 7u);
  EXPECT_EQ(map.tracks[2].bee, 8u);
  ASSERT_EQ(map.tracks[1].runs.size(), 2u);
  EXPECT_EQ(map.tracks[1].runs[0].back().time_s, 10.0);
  EXPECT_EQ(map.tracks[1].runs[1].front().time_s, 11.0);
  EXPECT_EQ(map.tracks[0].runs[0].back().time_s, 99.0);
  EXPECT_EQ(map.notes,
            (std::vector<std::string>{"of 10 paths, 3 are in the file, those in conflict first",
                                      "one fix in 3 is in the file"}));
  EXPECT_TRUE(map_tracks(facts, 10, 1'000).notes.empty());
}

TEST(MapTracks, MarksBeyondTheMostAreLeftOutAndThatIsReported) {
  std::vector<std::string> notes;
  EXPECT_EQ(marks_shown(20'000, "pairs", notes), 20'000u);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(marks_shown(20'001, "pairs", notes), 20'000u);
  EXPECT_EQ(notes, std::vector<std::string>{"of 20,001 pairs, 20,000 are in the file"});
}

TEST(MapWords, HoldNamesAsTextInHtml) {
  SwarmFacts swarm;
  swarm.threshold_m = 100.0;
  swarm.names.texts = {"<script>"};
  EXPECT_EQ(nearest_words({0, 57.3}, swarm), "57.3 m from &lt;script&gt;");
  EXPECT_EQ(nearest_words({0, 99.9996}, swarm), "99.9996 m from &lt;script&gt;");
  EXPECT_EQ(nearest_words({}, swarm), "");
}

TEST(MapWords, SayHowCloseAndWhetherItIsCertain) {
  RecordingFacts facts;
  facts.swarm.threshold_m = 100.0;
  facts.conflicts = {{0, 1, 0.0, 1.0, 2.0, 99.9996, true}, {0, 1, 0.0, 1.0, 2.0, 100.0, false}};
  EXPECT_EQ(conflict_words(facts, 0), "99.9996 m apart at 1.00 s");
  EXPECT_EQ(conflict_words(facts, 1), "100 m apart at 1.00 s; possible, not certain");
}

TEST(MapWords, TellAcrossAndInHeightWhereBothHaveALimit) {
  RecordingFacts facts;
  facts.swarm.threshold_m = 9'260.0;
  facts.swarm.vertical_m = 304.8;
  facts.swarm.aviation = true;
  facts.conflicts = {{0, 1, 0.0, 1.0, 2.0, 5'000.0, true}, {0, 1, 0.0, 1.0, 2.0, 5'000.0, true}};
  facts.conflicts_apart = {{4'630.0, 243.84}, {std::nan(""), std::nan("")}};
  EXPECT_EQ(conflict_words(facts, 0), "2.50 NM across, 800 ft in height at 1.00 s");
  EXPECT_EQ(conflict_words(facts, 1), "2.70 NM apart at 1.00 s");
}

TEST(MapWords, SayWhatHeightsAreCountedFrom) {
  const auto words = [](const HeightWords& heights) {
    SwarmFacts swarm;
    swarm.heights = heights;
    return document_words(swarm, {}, {});
  };
  EXPECT_NE(words({}).find("above the WGS84 ellipsoid"), std::string::npos);
  EXPECT_EQ(words({.above_sea = true}).find("Heights are metres above mean sea level"), 0u);
  EXPECT_EQ(words({.by_pressure = true}).find("Heights are those by pressure"), 0u);
  EXPECT_NE(words({.unstated = true, .above_home = true}).find("in KML they are above the ground"),
            std::string::npos);
  SwarmFacts venue;
  venue.placed = Placement{.origin = {19.0, 47.0, 105.0}, .words = {}, .above_sea = true};
  EXPECT_EQ(document_words(venue, {}, {}).find("Heights are metres above mean sea level"), 0u);
}

SnapshotFacts beside(const std::vector<Obstacle>& obstacles, double heading_deg) {
  SnapshotFacts facts;
  facts.swarm.placed = Placement{{19.0, 47.0, 100.0}, heading_deg, false, {}};
  facts.swarm.origin = GeographicPosition{19.0, 47.0, 0.0};
  facts.swarm.obstacles = obstacles;
  facts.positions = {{0, 0, 101}, {0, 0, 150}};
  return facts;
}

TEST(MapObstacles, LieWhereTheMetresOfTheInputDo) {
  // 10 m along x, which points north.
  const MapObstacles map = map_obstacles(beside({Box{{10, -2, 0}, {20, 2, 7}}}, 0.0));
  ASSERT_EQ(map.obstacles.size(), 1u);
  const MapObstacle& box = map.obstacles[0];
  EXPECT_EQ(box.name, "obstacles[0], a box");
  EXPECT_EQ(box.words, "100 m to 107 m high");
  ASSERT_EQ(box.outline.size(), 4u);
  const GeographicPosition origin{19.0, 47.0, 100.0};
  for (const GeographicPosition& corner : box.outline) {
    EXPECT_GT(corner.latitude_deg, 47.0);
    EXPECT_EQ(corner.height_m, 100.0);
    const double away_m = apart(origin, corner);
    EXPECT_LT(std::min(std::abs(away_m - std::hypot(10, 2)), std::abs(away_m - std::hypot(20, 2))),
              1e-3);
  }
}

// Seen from above, in degrees.
double doubled_area(const std::vector<GeographicPosition>& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const GeographicPosition& a = outline[i];
    const GeographicPosition& b = outline[(i + 1) % outline.size()];
    sum += (a.longitude_deg - 19.0) * (b.latitude_deg - 47.0) -
           (b.longitude_deg - 19.0) * (a.latitude_deg - 47.0);
  }
  return sum;
}

TEST(MapObstacles, GoRoundCounterclockwiseAlsoWhereTheAxesAreMirrored) {
  const UprightPrism prism{{{0, 0}, {40, 0}, {0, 30}, {0, 0}}, {0, 5}};
  const UprightPrism reversed{{{0, 30}, {40, 0}, {0, 0}}, {0, 5}};
  SnapshotFacts facts = beside({prism, reversed}, 30.0);
  for (const bool mirrored : {false, true}) {
    facts.swarm.placed->y_to_the_right = mirrored;
    for (const MapObstacle& obstacle : map_obstacles(facts).obstacles) {
      EXPECT_EQ(obstacle.outline.size(), 3u);
      EXPECT_GT(doubled_area(obstacle.outline), 0.0);
    }
  }
}

TEST(MapObstacles, HaveRoundOnesWithinTheirOutline) {
  const MapObstacles map =
      map_obstacles(beside({UprightCylinder{5, 5, 4.0, {0, 9}}, Sphere{{5, 5, 20}, 4.0}}, 30.0));
  ASSERT_EQ(map.obstacles.size(), 2u);
  for (const MapObstacle& round : map.obstacles) {
    ASSERT_TRUE(round.round);
    EXPECT_EQ(round.round->radius_m, 4.0);
    for (std::size_t i = 0; i < round.outline.size(); ++i) {
      GeographicPosition side = round.outline[i];
      const GeographicPosition& next = round.outline[(i + 1) % round.outline.size()];
      side.longitude_deg = 0.5 * (side.longitude_deg + next.longitude_deg);
      side.latitude_deg = 0.5 * (side.latitude_deg + next.latitude_deg);
      GeographicPosition middle = round.round->middle;
      middle.height_m = side.height_m;
      EXPECT_NEAR(apart(middle, side), 4.0, 2e-4);
    }
  }
  EXPECT_EQ(map.obstacles[0].words, "radius 4 m, 100 m to 109 m high");
  EXPECT_EQ(map.obstacles[0].round->middle.height_m, 104.5);
  EXPECT_EQ(map.obstacles[1].words, "radius 4 m, 116 m to 124 m high");
  EXPECT_EQ(map.obstacles[1].round->middle.height_m, 120.0);
}

TEST(MapObstacles, WithoutAnEndReachBeyondWhereBeesFly) {
  const Heights open;
  const MapObstacles map = map_obstacles(
      beside({UprightCylinder{0, 0, 1, open}, UprightCylinder{0, 0, 1, {0, open.high_m}},
              UprightCylinder{0, 0, 1, {open.low_m, 200}}},
             0.0));
  ASSERT_EQ(map.obstacles.size(), 3u);
  const auto drawn = [&](std::size_t i) {
    return std::pair(map.obstacles[i].low_m, map.obstacles[i].high_m);
  };
  EXPECT_EQ(drawn(0), std::pair(91.0, 160.0));
  EXPECT_EQ(drawn(1), std::pair(100.0, 160.0));
  EXPECT_EQ(drawn(2), std::pair(91.0, 300.0));
  EXPECT_EQ(map.obstacles[0].words, "radius 1 m, at all heights");
  EXPECT_EQ(map.obstacles[1].words, "radius 1 m, from 100 m upwards, with no upper end");
  EXPECT_EQ(map.obstacles[2].words, "radius 1 m, up to 300 m, with no lower end");
}

TEST(MapObstacles, TheGroundIsLeftOutAndThatIsReported) {
  const MapObstacles map = map_obstacles(beside({Ground{0.0}, Box{{0, 0, 0}, {1, 1, 1}}}, 0.0));
  ASSERT_EQ(map.obstacles.size(), 1u);
  EXPECT_EQ(map.obstacles[0].name, "obstacles[1], a box");
  EXPECT_EQ(map.notes,
            std::vector<std::string>{"obstacles[0], the ground, is everywhere, and is not drawn"});
}

TEST(MapObstacles, ThatAreThinAreWideEnoughToBeSeen) {
  const MapObstacles map =
      map_obstacles(beside({UprightCylinder{0, 0, 0, {0, 9}}, Box{{5, 5, 0}, {5, 9, 9}}}, 0.0));
  ASSERT_EQ(map.obstacles.size(), 2u);
  for (const MapObstacle& thin : map.obstacles) EXPECT_GT(doubled_area(thin.outline), 0.0);
}

TEST(RiskTable, KeepsSpreadsheetsFromTakingIdsForFormulas) {
  EXPECT_EQ(harmless_in_spreadsheets("=1+1"), "'=1+1");
  EXPECT_EQ(harmless_in_spreadsheets("@x"), "'@x");
  EXPECT_EQ(harmless_in_spreadsheets("-2+3"), "'-2+3");
  EXPECT_EQ(harmless_in_spreadsheets("+a"), "'+a");
  EXPECT_EQ(harmless_in_spreadsheets("\t=1"), "'\t=1");
  EXPECT_EQ(harmless_in_spreadsheets("-5"), "-5");
  EXPECT_EQ(harmless_in_spreadsheets("+5.5e3"), "+5.5e3");
  for (const char* formula : {"-nan(x)", "-inf", "-infinity", "+nan", "+-5", "-", "-.5", "-0x1",
                              "\uff1d1+1", "\uff0b1", "\uff0d2+3", "\uff20x"}) {
    EXPECT_EQ(harmless_in_spreadsheets(formula), std::string("'") + formula);
  }
  EXPECT_EQ(harmless_in_spreadsheets("maya"), "maya");
  EXPECT_EQ(harmless_in_spreadsheets(""), "");
}

}  // namespace
}  // namespace beespace::report
