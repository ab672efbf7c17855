// Two bees under one id, and what looks like it and is one bee: wild fixes, noise, places that are
// rounded, flights to and fro.
#include "io/recording/shared_id.hpp"
#include "io/stream_recording.hpp"
#include "tests/io/mavlink/telemetry_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Random = std::mt19937_64;

// Whether a bee whose report `i` is at `place(i)`, `every_s` apart, is taken for two.
bool taken_for_two(int reports, double every_s, const std::function<Point(int)>& place,
                   Frame frame = Frame::kMetres) {
  SharedId shared;
  for (int i = 0; i < reports; ++i) shared.take({every_s * i, place(i)}, frame);
  return shared.found().has_value();
}

// Two that fly towards each other on lines a metre apart, each ten times a second.
Point in_turn(int i) {
  const double t = 0.05 * i;
  return i % 2 == 0 ? Point{2 * t, 0, 10} : Point{80 - 2 * t, 1, 10};
}

TEST(SharedId, TwoThatReportInTurnAreFound) {
  SharedId shared;
  int needed = 0;
  for (; !shared.found() && needed < 100; ++needed) shared.take({0.05 * needed, in_turn(needed)});
  EXPECT_LT(needed, 30);
  EXPECT_EQ(shared.found(), 1u);
  EXPECT_TRUE(taken_for_two(
      200, 0.05,
      [](int i) {
        const Point p = in_turn(i);
        return Point{8 + p.x / 75'000, 47 + p.y / 111'000, p.z};
      },
      Frame::kWgs84));
}

TEST(SharedId, TwoOfWhomReportsAreLostAreFound) {
  Random random(1);
  std::bernoulli_distribution lost(0.05);
  SharedId shared;
  for (int i = 0; i < 600; ++i) {
    if (!lost(random)) shared.take({0.05 * i, in_turn(i)});
  }
  EXPECT_TRUE(shared.found().has_value());
}

TEST(SharedId, TwoAircraftOfOneAddressAreFound) {
  EXPECT_TRUE(taken_for_two(
      60, 5,
      [](int i) {
        return i % 2 == 0 ? Point{8 + 0.01 * i, 47, 11'000} : Point{9, 47.3 - 0.01 * i, 10'000};
      },
      Frame::kWgs84));
}

// Robots a metre or two apart, at half a metre a second, each at its own rate.
bool mixture_is_found(const std::vector<double>& rates_hz, double apart_m, double noise_m) {
  Random random(1);
  std::normal_distribution<double> noise(0.0, noise_m);
  std::vector<Fix> fixes;
  for (std::size_t k = 0; k < rates_hz.size(); ++k) {
    const double angle = 2.1 * static_cast<double>(k);
    for (double t = 0.013 * static_cast<double>(k); t < 20.0; t += 1.0 / rates_hz[k]) {
      const double x = apart_m * static_cast<double>(k) + 0.5 * std::cos(angle) * t;
      fixes.push_back({t, {x + noise(random), 0.5 * std::sin(angle) * t + noise(random), 0}});
    }
  }
  std::sort(fixes.begin(), fixes.end(),
            [](const Fix& a, const Fix& b) { return a.time_s < b.time_s; });
  SharedId shared;
  for (const Fix& fix : fixes) shared.take(fix);
  return shared.found().has_value();
}

TEST(SharedId, SeveralAtAnyRatesAreFound) {
  EXPECT_TRUE(mixture_is_found({10, 10, 10}, 2, 0.01));
  EXPECT_TRUE(mixture_is_found({4, 4, 4}, 10, 0.3));
  EXPECT_TRUE(mixture_is_found({10, 4}, 1, 0.01));
  EXPECT_TRUE(mixture_is_found({10, 1}, 1, 0.01));
  EXPECT_TRUE(mixture_is_found({10, 7, 3}, 2, 0.01));
  EXPECT_TRUE(mixture_is_found({10, 10, 10, 10, 10, 10}, 2, 0.01));
  EXPECT_FALSE(mixture_is_found({10}, 1, 0.01));
}

// Of a receiver that stands: its places are rounded to as many digits of a degree as some have, on
// a lattice of metres, and spread over a few of its points, at random.
TEST(SharedId, NoiseThatIsRoundedIsNoSecondBee) {
  for (const double rounded : {1e-4, 1e-5, 1e-6, 1e-7}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      Random random(seed);
      std::normal_distribution<double> noise(0.0, 1.0);
      const auto near = [&](double degrees) {
        return rounded * std::round((degrees + noise(random) / 111'000) / rounded);
      };
      EXPECT_FALSE(taken_for_two(
          1000, 0.1,
          [&](int) {
            return Point{near(8 + rounded / 2), near(47 + rounded / 3), 500};
          },
          Frame::kWgs84))
          << rounded << ", " << seed;
    }
  }
}

// Now and then in the wrong place, each time in another one; and an animal that goes to and fro
// between two places, as it is told each minute.
TEST(SharedId, OutliersAndAnimalsAreNoSecondBee) {
  Random random(1);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::normal_distribution<double> wild(0.0, 50.0);
  for (const double share : {0.02, 0.1, 0.4}) {
    std::bernoulli_distribution is_wild(share);
    EXPECT_FALSE(taken_for_two(3000, 0.1, [&](int i) {
      auto& off = is_wild(random) ? wild : noise;
      return Point{0.2 * i + off(random), off(random), 0};
    })) << share;
  }
  EXPECT_FALSE(taken_for_two(3000, 60, [&](int i) {
    return Point{i / 3 % 2 * 800.0 + noise(random), noise(random), 0};
  }));
}

TEST(SharedId, OneBeeIsOneBee) {
  const std::vector<std::function<Point(int)>> flights = {
      [](int i) {
        return Point{0.2 * i, 0, 10};
      },
      [](int i) {
        return Point{40 * std::cos(0.1 * i), 40 * std::sin(0.1 * i), 10};
      },
      // A wild fix now and then, also twice in a row, and one that has moved for good.
      [](int i) {
        return Point{i % 10 == 0 ? 500.0 + 37.0 * (i % 70) : 0.2 * i, 0, 10};
      },
      [](int i) {
        return Point{i % 10 < 2 ? 500.0 + 37.0 * (i % 77) : 0.2 * i, 0, 10};
      },
      [](int i) {
        return Point{i < 300 ? 0.0 : 10'000.0, 0, 10};
      }};
  for (const auto& flight : flights) EXPECT_FALSE(taken_for_two(1000, 0.1, flight));
  // To and fro between two points, each of which is a fix.
  EXPECT_FALSE(taken_for_two(1000, 10, [](int i) { return Point{i % 2 * 100.0, 0, 10}; }));
}

TEST(SharedId, NoiseIsNoSecondBee) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Random random(seed);
    std::normal_distribution<double> noise(0.0, 5.0);
    EXPECT_FALSE(taken_for_two(2000, 0.1, [&](int i) {
      return Point{0.2 * i + noise(random), noise(random), noise(random)};
    })) << seed;
  }
}

// A place that is rounded to five digits of a degree, and lies between two of them: a coin decides.
TEST(SharedId, ACoinIsHardlyEverASecondBee) {
  int taken = 0;
  constexpr unsigned kBees = 1000;
  for (unsigned seed = 0; seed < kBees; ++seed) {
    Random random(seed);
    std::bernoulli_distribution coin(0.5);
    taken += taken_for_two(
        1000, 0.1,
        [&](int) {
          return Point{8, coin(random) ? 47.00001 : 47.0, 500};
        },
        Frame::kWgs84);
  }
  EXPECT_LE(taken, kBees / 1000);
}

TEST(SharedId, WhatGoesBackInTimeIsLeftOutOfAccount) {
  SharedId shared;
  for (int i = 0; i < 100; ++i) shared.take({i % 2 == 0 ? 0.1 * i : 0.0, {i % 2 * 50.0, 0, 0}});
  EXPECT_FALSE(shared.found().has_value());
}

std::string table_of(const std::string& second) {
  std::string text = "id,time_s,x,y,z\n";
  for (int i = 0; i < 60; ++i) {
    const Point p = in_turn(i);
    text += (i % 2 == 0 ? "a," : second + ",") + std::to_string(0.05 * i) + "," +
            std::to_string(p.x) + "," + std::to_string(p.y) + ",10\n";
  }
  return text;
}

TEST(SharedId, OfARecordingItIsSaidWithItsPlace) {
  const auto two = recording_of(record(table_of("b")));
  EXPECT_TRUE(two.missing.none());
  const auto one = recording_of(record(table_of("a")));
  EXPECT_EQ(one.missing.shared, 1u);
  EXPECT_EQ(one.missing.shared_ids, std::vector<std::string>{"a"});
  EXPECT_FALSE(one.missing.none());
  EXPECT_EQ(one.missing.count, 0u);
  EXPECT_TRUE(has_note(one, "bee 'a' is at two places in turn, from bees.csv, line 3 on"));
}

TEST(SharedId, OfAStreamToo) {
  const TemporaryFolder folder;
  const std::string path = folder.write("bees.csv", table_of("a"));
  auto stream = RecordingStream::open({path}, {}, 256);
  ASSERT_TRUE(stream.has_value());
  std::vector<StreamedFix> fixes;
  do {
    ASSERT_TRUE(stream->next(fixes));
  } while (!fixes.empty());
  const auto recording = recording_of(stream->finish(0));
  EXPECT_EQ(recording.missing.shared_ids, std::vector<std::string>{"a"});
}

// A ground station stamps what comes in one packet with one time.
TEST(SharedId, TwoDronesWhosePositionsComeTogetherAreFound) {
  std::string log;
  for (int i = 0; i < 40; ++i) {
    for (const int north : {0, 5000}) {
      log += logged(
          1714564800'000'000 + 100'000 * static_cast<std::uint64_t>(i),
          frame_v2(1, 33,
                   global_payload(470'000'000 + north + 10 * i, 80'000'000, 500'000, 0, 0, 0)));
    }
  }
  const auto recording = recording_of(load_recording_from_memory(log, "one.tlog", {}));
  EXPECT_EQ(recording.missing.shared_ids, std::vector<std::string>{"1"});
  EXPECT_TRUE(has_note(recording, "give each vehicle a number of its own (MAV_SYS_ID of PX4"));
}

}  // namespace
}  // namespace beespace::io
