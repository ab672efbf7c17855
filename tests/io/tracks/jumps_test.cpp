// From where on a step between two fixes is a jump: by all speeds, by what a bee tells of its own,
// and by those of the rest of its track.
#include "io/recording/jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace beespace::io {
namespace {

TEST(JumpsOfTracks, BeginAtTheGreatestSpeed) {
  const double most_m = Jumps::kMostSpeed_mps * (1.0 + Jumps::kTimesDiffer_s);
  const auto jumps = [](double by_m, const Velocity* velocity) {
    Jumps track;
    EXPECT_FALSE(track.take({0.0, {0, 0, 0}}, velocity));
    return track.take({1.0, {by_m, 0, 0}}, velocity);
  };
  EXPECT_FALSE(jumps(most_m, nullptr));
  EXPECT_TRUE(jumps(std::nextafter(most_m, 1e9), nullptr));
  // Who says that it does 4 m/s does not do 140 m/s.
  const Velocity slow = {0, 4, std::nan("")};
  EXPECT_FALSE(jumps(140.0 * 1.5, &slow));
  EXPECT_TRUE(jumps(140.1 * 1.5, &slow));
  const Velocity none = {0, 0, 0};
  EXPECT_FALSE(jumps(most_m, &none));
}

// Who tells no speed, by the steps of all of its track: nearly all of them at 2 m/s.
TEST(JumpsOfTracks, OfWholeTracksBeginAtTimesTheUsualSpeed) {
  const auto jumps = [](std::size_t steps, double by_m) {
    std::vector<Fix> fixes;
    for (std::size_t i = 0; i <= steps; ++i) {
      const auto tenths = static_cast<double>(i);
      fixes.push_back({tenths / 10.0, {0.2 * tenths + (i < steps / 2 ? 0.0 : by_m), 0, 0}});
    }
    Jumps track(fixes, {}, Frame::kMetres);
    bool any = false;
    for (const Fix& fix : fixes) any = track.take(fix, nullptr) || any;
    return any;
  };
  // In a tenth of a second, with half a second for times that are not exact.
  EXPECT_FALSE(jumps(100, 70.0));
  EXPECT_TRUE(jumps(100, 80.0));
  EXPECT_FALSE(jumps(19, 300.0)) << "of so few nothing is usual";
}

TEST(JumpsOfTracks, ThatGoOnBeginAtTimesTheFastestStepBefore) {
  // It taxis, takes off and cruises.
  Jumps aircraft;
  double at_m = 0.0;
  for (int second = 0; second < 300; ++second) {
    at_m += second < 200 ? 5.0 : second < 230 ? 75.0 : 250.0;
    EXPECT_FALSE(aircraft.take({static_cast<double>(second), {at_m, 0, 0}}, nullptr)) << second;
  }
  Jumps drone;
  for (int tenth = 0; tenth < 40; ++tenth) {
    const double aside_m = tenth == 30 ? 300.0 : 0.0;
    const Fix fix{tenth / 10.0, {0.2 * tenth + aside_m, 0, 0}};
    EXPECT_EQ(drone.take(fix, nullptr), tenth == 30 || tenth == 31) << tenth;
  }
}

TEST(JumpsOfTracks, SatellitesDoNot) {
  Jumps track;
  EXPECT_FALSE(track.take({0.0, {7'000'000, 0, 0}}, nullptr));
  EXPECT_FALSE(track.take({10.0, {7'000'000, 75'000, 0}}, nullptr));
  EXPECT_TRUE(track.take({20.0, {0, 0, 0}}, nullptr));
}

}  // namespace
}  // namespace beespace::io
