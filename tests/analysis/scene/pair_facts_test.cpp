// How far apart those are that are too close, or nearest to that: horizontally, in height, and on
// their way past each other.
#include "analysis/scene/load_scene.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace beespace::analysis {
namespace {

class PairFacts : public testing::Test {
 protected:
  PairFacts()
      : path_(std::filesystem::path(testing::TempDir()) /
              ("beespace-pairs-" + std::to_string(::getpid()) + ".csv")) {}
  ~PairFacts() override { std::filesystem::remove(path_); }
  PairFacts(const PairFacts&) = delete;
  PairFacts& operator=(const PairFacts&) = delete;

  template <class Facts>
  [[nodiscard]] Facts facts(const std::string& text, SceneRequest request) const {
    std::ofstream(path_) << text;
    auto scene = load_scene({path_.string()}, request);
    if (!scene) throw std::runtime_error(to_string(scene.error()));
    return std::get<Facts>(*std::move(scene));
  }

  static SceneRequest within(double threshold_m, std::optional<double> vertical_m) {
    SceneRequest request;
    request.threshold_m = threshold_m;
    if (vertical_m) request.vertical = io::StatedLength{*vertical_m, *vertical_m, io::Unit::kMetre};
    return request;
  }

 private:
  std::filesystem::path path_;
};

Point ground(double longitude_deg, double latitude_deg) {
  return *to_ecef(GeographicPosition{longitude_deg, latitude_deg, 0.0});
}

// Both pass the same meridian at 10 s, a thousandth of a degree and 100 m of height apart.
constexpr const char* kPassing =
    "id,time_s,longitude,latitude,height_m\n"
    "a,0,8.49,47,11000\na,20,8.51,47,11000\n"
    "b,0,8.51,47.001,11100\nb,20,8.49,47.001,11100\n";

TEST_F(PairFacts, OnTheEarthAreHorizontalAtHeightZero) {
  const auto facts = this->facts<report::RecordingFacts>(kPassing, within(1'000.0, 300.0));
  const double horizontal_m = distance(ground(8.5, 47.0), ground(8.5, 47.001));
  ASSERT_EQ(facts.conflicts.size(), 1U);
  ASSERT_EQ(facts.conflicts_apart.size(), 1U);
  EXPECT_NEAR(facts.conflicts_apart[0].horizontal_m, horizontal_m, 0.05);
  EXPECT_NEAR(facts.conflicts_apart[0].height_m, 100.0, 1e-6);
  ASSERT_TRUE(facts.closest_apart.has_value());
  EXPECT_NEAR(facts.closest_apart->height_m, 100.0, 1e-6);
  // The straight line of a conflict is that of both.
  EXPECT_NEAR(facts.conflicts[0].closest_m, std::hypot(horizontal_m, 100.0), 0.05);

  ASSERT_EQ(facts.pair_ways.size(), 1U);
  const report::PairWay& way = facts.pair_ways[0];
  const auto at = std::find(way.times_s.begin(), way.times_s.end(), facts.conflicts[0].closest_s);
  ASSERT_NE(at, way.times_s.end());
  const auto place = static_cast<std::size_t>(at - way.times_s.begin());
  EXPECT_NEAR(distance({0, 0, 0}, way.ground_ways[place]), horizontal_m, 0.05);
  EXPECT_NEAR(way.heights_m[place], 100.0, 1e-6);
  EXPECT_EQ(way.times_s.front(), 0.0);
  EXPECT_EQ(way.times_s.back(), 20.0);
}

TEST_F(PairFacts, BetweenMetresAreAlongZ) {
  const auto facts = this->facts<report::RecordingFacts>(
      "id,time_s,x,y,z\na,0,0,0,0\na,10,0,0,0\nb,0,-30,3,4\nb,10,30,3,4\n", within(20.0, {}));
  ASSERT_EQ(facts.conflicts_apart.size(), 1U);
  EXPECT_NEAR(facts.conflicts_apart[0].horizontal_m, 3.0, 1e-9);
  EXPECT_NEAR(facts.conflicts_apart[0].height_m, 4.0, 1e-9);
  EXPECT_TRUE(facts.pair_ways.at(0).ground_ways.empty());
  EXPECT_FALSE(facts.separation.front().apart.has_value());
}

// Short ones, between moments of which some hundred are looked at.
TEST_F(PairFacts, EveryConflictIsSeenInTheSeparationOverTime) {
  std::string text = "id,time_s,x,y\n";
  const auto add = [&text](const char* id, double time_s, double x) {
    text += std::string(id) + "," + std::to_string(time_s) + "," + std::to_string(x) + ",0\n";
  };
  for (int i = 0; i < 60; ++i) {
    const double begins_s = 997.0 * i;
    add("a", begins_s, 0.0);
    // Close for a second, far for the rest.
    for (const auto& [after_s, x] : {std::pair(0.0, 90.0), std::pair(500.3, 90.0),
                                     std::pair(500.8, 1.0), std::pair(501.3, 90.0)}) {
      add("b", begins_s + after_s, x);
    }
  }
  add("a", 997.0 * 60, 0.0);
  auto request = within(20.0, {});
  request.max_gap_s = 2'000.0;
  const auto facts = this->facts<report::RecordingFacts>(text, request);
  ASSERT_EQ(facts.conflicts.size(), 60U);
  const auto dips =
      std::count_if(facts.separation.begin(), facts.separation.end(),
                    [](const report::Separation& at) { return at.closest.distance_m < 20.0; });
  EXPECT_EQ(dips, 60);
  const auto twice =
      std::adjacent_find(facts.separation.begin(), facts.separation.end(),
                         [](const report::Separation& a, const report::Separation& b) {
                           return a.time_s >= b.time_s;
                         });
  EXPECT_EQ(twice, facts.separation.end()) << "no moment comes twice";
}

TEST_F(PairFacts, WaysEndWhereABeeIsUnknown) {
  // Known from 0 to 4 s and from 100 s on; closest at 2 s.
  auto request = within(20.0, {});
  request.max_gap_s = 5.0;
  const auto facts = this->facts<report::RecordingFacts>(
      "id,time_s,x,y,z\na,0,0,0,0\na,4,0,0,0\na,100,0,0,0\na,104,0,0,0\n"
      "b,0,-10,5,0\nb,4,10,5,0\nb,100,900,5,0\nb,104,920,5,0\n",
      request);
  ASSERT_EQ(facts.pair_ways.size(), 1U);
  EXPECT_EQ(facts.pair_ways[0].times_s.front(), 0.0);
  EXPECT_EQ(facts.pair_ways[0].times_s.back(), 4.0);
}

// From the last moment before to the first one after the gap.
TEST_F(PairFacts, InAGapTheClosestTwoAreNotKnown) {
  constexpr const char* kInAGap =
      "id,time_s,x,y,z\na,0,0,0,0\na,4,0,0,0\na,100,0,0,0\na,104,0,0,0\n"
      "b,0,-10,5,0\nb,4,10,5,0\nb,8,20,5,0\nb,12,30,5,0\n";
  for (const std::optional<double> vertical_m : {std::optional<double>{}, {3.0}}) {
    auto request = within(20.0, vertical_m);
    request.max_gap_s = 5.0;
    const auto facts = this->facts<report::RecordingFacts>(kInAGap, request);
    // The other falls silent at 12 s, while it moves.
    EXPECT_EQ(facts.unknown_spans, (std::vector<Gap>{{0, 4.0, 100.0}, {1, 12.0, 104.0}}));
    ASSERT_EQ(facts.separation_open.size(), 1U);
    const double step_s = 104.0 / 600.0;
    EXPECT_NEAR(facts.separation_open[0].begins_s, 4.0, 1.1 * step_s);
    // From 12 s on none is known.
    EXPECT_EQ(facts.separation_open[0].ends_s, 104.0);
    for (const report::Separation& at : facts.separation) EXPECT_LE(at.time_s, 4.0);
  }
}

// Faster than anything flies: on the line from one place to the other it never was.
TEST_F(PairFacts, WhereABeeJumpsTheClosestTwoAreNotKnown) {
  const auto facts = this->facts<report::RecordingFacts>(
      "id,time_s,x_m,y_m,z_m\na,0,0,0,5\na,10,0,0,5\na,20,90000,0,5\na,30,90000,0,5\n"
      "b,0,200,0,5\nb,10,200,0,5\nb,20,200,0,5\nb,30,200,0,5\n",
      within(20.0, {}));
  EXPECT_EQ(facts.gaps, (std::vector<Gap>{{0, 10.0, 20.0}}));
  EXPECT_EQ(facts.unknown_spans, facts.gaps);
  ASSERT_EQ(facts.separation_open.size(), 1U);
  EXPECT_NEAR(facts.separation_open[0].begins_s, 10.0, 0.1);
  EXPECT_TRUE(facts.hidden);
}

TEST_F(PairFacts, OfPairsThatKeepApartTheClosestHasItsWay) {
  const auto facts = this->facts<report::RecordingFacts>(
      "id,time_s,x,y,z\na,0,0,0,0\na,10,0,0,0\nb,0,-50,30,0\nb,10,50,30,0\n", within(20.0, {}));
  EXPECT_TRUE(facts.conflicts.empty());
  ASSERT_EQ(facts.pair_ways.size(), 1U);
  EXPECT_NE(std::find(facts.pair_ways[0].times_s.begin(), facts.pair_ways[0].times_s.end(), 5.0),
            facts.pair_ways[0].times_s.end());
}

TEST_F(PairFacts, OfASnapshotAreThoseOfItsPairs) {
  const auto facts = this->facts<report::SnapshotFacts>(
      "id,longitude,latitude,height_m\na,8.5,47,11000\nb,8.5,47.001,11100\nc,9,48,0\n",
      within(1'000.0, 300.0));
  ASSERT_EQ(facts.apart.size(), 1U);
  EXPECT_NEAR(facts.apart[0].horizontal_m, distance(ground(8.5, 47.0), ground(8.5, 47.001)), 1e-4);
  EXPECT_NEAR(facts.apart[0].height_m, 100.0, 1e-4);
}

// Every moment has the pair whose greater share of both thresholds is least, as all pairs say.
TEST_F(PairFacts, TheNearestToAConflictIsThatOfAllPairs) {
  constexpr std::size_t kBees = 12;
  constexpr double kThreshold_m = 40.0;
  constexpr double kVertical_m = 5.0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-400.0, 400.0);
  struct Flight {
    Point from;
    Point to;
  };
  std::vector<Flight> flights;
  std::string text = "id,time_s,x,y,z\n";
  for (std::size_t bee = 0; bee < kBees; ++bee) {
    const auto anywhere = [&] { return Point{place(random), place(random), 0.1 * place(random)}; };
    const auto rounded = [](const Point& p) {
      return Point{std::round(p.x), std::round(p.y), std::round(p.z)};
    };
    flights.push_back({rounded(anywhere()), rounded(anywhere())});
    for (const auto& [time, p] : {std::pair("0", flights.back().from), {"60", flights.back().to}}) {
      text += std::to_string(bee) + "," + time + "," + std::to_string(p.x) + "," +
              std::to_string(p.y) + "," + std::to_string(p.z) + "\n";
    }
  }
  const auto facts = this->facts<report::RecordingFacts>(text, within(kThreshold_m, kVertical_m));
  ASSERT_GT(facts.separation.size(), 500U);
  for (const report::Separation& at : facts.separation) {
    const auto where = [&](std::size_t bee) {
      const auto& [from, to] = flights[bee];
      const double share = at.time_s / 60.0;
      return Point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                   from.z + share * (to.z - from.z)};
    };
    const auto share_of = [&](std::size_t a, std::size_t b) {
      const Point p = where(a);
      const Point q = where(b);
      return std::max(
          std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y)) / kThreshold_m,
          std::abs(p.z - q.z) / kVertical_m);
    };
    double least = 1e300;
    for (std::size_t a = 0; a < kBees; ++a) {
      for (std::size_t b = a + 1; b < kBees; ++b) least = std::min(least, share_of(a, b));
    }
    ASSERT_TRUE(at.apart.has_value());
    const double told =
        std::max(at.apart->horizontal_m / kThreshold_m, at.apart->height_m / kVertical_m);
    ASSERT_NEAR(told, least, 1e-9 * (1.0 + least)) << at.time_s;
    ASSERT_NEAR(share_of(at.closest.first, at.closest.second), least, 1e-9 * (1.0 + least));
  }
}

}  // namespace
}  // namespace beespace::analysis
