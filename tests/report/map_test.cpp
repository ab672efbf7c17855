// Map files: where things are, what is left out, and hostile names.
#include "report/map/map_places.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"
#include "report/map/risk_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
  SwarmFacts swarm;
  swarm.threshold_m = 100.0;
  EXPECT_EQ(conflict_words({0, 1, 0.0, 1.0, 2.0, 99.9996, true}, swarm),
            "99.9996 m apart at 1970-01-01T00:00:01Z");
  EXPECT_EQ(conflict_words({0, 1, 0.0, 1.0, 2.0, 100.0, false}, swarm),
            "100 m apart at 1970-01-01T00:00:01Z; possible, not certain");
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
