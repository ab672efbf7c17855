// The worst moment of a conflict with two thresholds, against a search that looks at very many
// instants and knows nothing of the shape of what it looks for.
#include "analysis/recorded/worst_moment.hpp"

#include <beespace/find_conflicts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using beespace::Conflict;
using beespace::Track;
using beespace::analysis::kAsBad;
using beespace::analysis::Minima;
using beespace::analysis::rank_of;
using beespace::analysis::worst_of;

constexpr Minima kEnRoute{9260.0, 304.8};

// By hand, without any function of the house.
struct Sampled {
  double share = std::numeric_limits<double>::infinity();
  double time_s = 0.0;
};

double value_at(const Track& track, double time_s, double (*of)(const Track&, std::size_t)) {
  std::size_t next = 1;
  while (next + 1 < track.fixes.size() && track.fixes[next].time_s < time_s) ++next;
  const double from_s = track.fixes[next - 1].time_s;
  const double part = (time_s - from_s) / (track.fixes[next].time_s - from_s);
  return (1.0 - part) * of(track, next - 1) + part * of(track, next);
}

double x_of(const Track& track, std::size_t i) {
  return track.fixes[i].position.x;
}
double y_of(const Track& track, std::size_t i) {
  return track.fixes[i].position.y;
}
double z_of(const Track& track, std::size_t i) {
  return track.fixes[i].position.z;
}

Sampled sampled(const std::vector<Track>& tracks, const Conflict& conflict, const Minima& minima) {
  constexpr int kSamples = 50'000;
  Sampled least;
  for (int k = 0; k <= kSamples; ++k) {
    const double time_s =
        conflict.begins_s + (conflict.ends_s - conflict.begins_s) * k / double{kSamples};
    const auto apart = [&](double (*of)(const Track&, std::size_t)) {
      return value_at(tracks[conflict.first], time_s, of) -
             value_at(tracks[conflict.second], time_s, of);
    };
    const double across = std::sqrt(apart(x_of) * apart(x_of) + apart(y_of) * apart(y_of));
    const double share =
        std::max(across / minima.threshold_m, std::abs(apart(z_of)) / minima.vertical_m);
    if (share < least.share) least = {share, time_s};
  }
  return least;
}

TEST(WorstMoment, IsThatOfAClimbThroughALevelAndNotItsEnd) {
  // Level at 10,000 m, and from 500 m below to 500 m above it, 2 km beside.
  const std::vector<Track> tracks{{{{0.0, {0, 0, 10'000}}, {100.0, {20'000, 0, 10'000}}}},
                                  {{{0.0, {0, 3'000, 9'500}}, {100.0, {20'000, 2'000, 10'500}}}}};
  const auto found = beespace::find_conflicts(
      tracks, {.threshold_m = kEnRoute.threshold_m, .vertical_m = kEnRoute.vertical_m});
  ASSERT_TRUE(found && found->conflicts.size() == 1);
  const Conflict& conflict = found->conflicts.front();
  // What the straight line says: when it ends, 1,000 ft apart in height.
  EXPECT_NEAR(conflict.closest_s, conflict.ends_s, 1e-6);
  const auto worst = worst_of(tracks, 1.0, kEnRoute)(conflict);
  ASSERT_TRUE(worst);
  const Sampled by_hand = sampled(tracks, conflict, kEnRoute);
  EXPECT_NEAR(worst->share, by_hand.share, 1e-4);
  EXPECT_LT(worst->apart.vertical_m, 100.0);
  EXPECT_LT(worst->share, 0.27);
  EXPECT_EQ(rank_of(conflict, worst_of(tracks, 1.0, kEnRoute)), worst->share);
  EXPECT_EQ(rank_of(conflict, {}), conflict.closest_m);
}

TEST(WorstMoment, IsWhenTwoAreClosestWhereTheirHeightsKeepTheSameDistance) {
  // 900 ft apart all the time: more of its limit than they ever are across.
  const std::vector<Track> tracks{{{{0.0, {-8'000, 0, 10'000}}, {100.0, {8'000, 0, 10'000}}}},
                                  {{{0.0, {0, 500, 10'274.32}}, {100.0, {0, 500, 10'274.32}}}}};
  const Conflict conflict{0, 1, 0.0, 50.0, 100.0, 571.0};
  const auto worst = worst_of(tracks, 1.0, kEnRoute)(conflict);
  ASSERT_TRUE(worst);
  EXPECT_NEAR(worst->share, 0.9, 1e-9);
  EXPECT_NEAR(worst->time_s, 50.0, 1e-9);
  EXPECT_NEAR(worst->apart.horizontal_m, 500.0, 1e-9);
}

// Side by side at a steady distance, written to the metre: which moment the shares differ by then
// is chance, and what counts is that one passes the level of the other.
TEST(WorstMoment, IsThatOfAPassedLevelWhereTheDistanceIsSteadyButForRounding) {
  std::vector<Track> tracks(2);
  for (int i = 0; i <= 20; ++i) {
    const double time_s = 10.0 * i;
    tracks[0].fixes.push_back({time_s, {2'000.0 * i, 0.0, 10'000.0}});
    const double wavers = 0.5 * ((i * 7) % 5);
    tracks[1].fixes.push_back({time_s, {2'000.0 * i, 7'408.0 - wavers, 9'750.0 + 27.0 * i}});
  }
  const auto found = beespace::find_conflicts(
      tracks, {.threshold_m = kEnRoute.threshold_m, .vertical_m = kEnRoute.vertical_m});
  ASSERT_TRUE(found && found->conflicts.size() == 1);
  const auto worst = worst_of(tracks, 1.0, kEnRoute)(found->conflicts.front());
  ASSERT_TRUE(worst);
  EXPECT_NEAR(worst->apart.vertical_m, 0.0, 1e-6);
  EXPECT_NEAR(worst->time_s, 10.0 * 250.0 / 27.0, 1e-6);
  EXPECT_NEAR(worst->share, 0.8, 1e-3);
}

TEST(WorstMoment, IsThatOfVeryManyInstantsOfRandomTracks) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> across(-12'000.0, 12'000.0);
  std::uniform_real_distribution<double> up(9'600.0, 10'400.0);
  std::uniform_real_distribution<double> step_s(2.0, 40.0);
  std::size_t compared = 0;
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<Track> tracks(2);
    for (Track& track : tracks) {
      double time_s = 0.0;
      for (int i = 0; i < 6; ++i) {
        // Some keep their height, as most of those in cruise do.
        const double z = scene % 3 == 0 ? 10'000.0 + 50.0 * scene : up(random);
        track.fixes.push_back({time_s, {across(random), across(random), z}});
        time_s += step_s(random);
      }
    }
    const auto found = beespace::find_conflicts(
        tracks, {.threshold_m = kEnRoute.threshold_m, .vertical_m = kEnRoute.vertical_m});
    ASSERT_TRUE(found);
    for (const Conflict& conflict : found->conflicts) {
      const auto worst = worst_of(tracks, 1.0, kEnRoute)(conflict);
      ASSERT_TRUE(worst);
      const Sampled by_hand = sampled(tracks, conflict, kEnRoute);
      EXPECT_LE(worst->share, by_hand.share + kAsBad + 1e-12) << "scene " << scene;
      EXPECT_GE(worst->share, by_hand.share - 1e-3) << "scene " << scene;
      EXPECT_GE(worst->time_s, conflict.begins_s);
      EXPECT_LE(worst->time_s, conflict.ends_s);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20u);
}

TEST(WorstMoment, OfHeightsBesidePlacesCountsInTheirUnit) {
  // In feet; x, y and z are all horizontal then.
  std::vector<Track> tracks{{{{0.0, {0, 0, 0}}, {10.0, {0, 0, 1'000}}}},
                            {{{0.0, {0, 300, 0}}, {10.0, {0, 300, 1'000}}}}};
  tracks[0].heights_m = {10'000, 10'000};
  tracks[1].heights_m = {10'500, 9'900};
  const Conflict conflict{0, 1, 0.0, 5.0, 10.0, 300.0};
  const auto worst = worst_of(tracks, 0.3048, kEnRoute)(conflict);
  ASSERT_TRUE(worst);
  EXPECT_NEAR(worst->apart.horizontal_m, 300.0, 1e-9);
  EXPECT_NEAR(worst->share, 300.0 / 9260.0, 1e-12);
  EXPECT_NEAR(worst->apart.vertical_m, 0.0, 300.0 / 9260.0 * 304.8 + 1e-9);
}

}  // namespace
