// Poses that freeze and never thaw, and what truly stands.
#include "io/recording/frozen_places.hpp"
#include "io/stream_recording.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Way = std::function<Point(int i)>;

constexpr int kRecords = 120;

// Of places ten times a second, and of velocities where there are some.
std::string track_text(const std::string& id, const Way& way, const Way& velocity = {}) {
  std::string text;
  for (int i = 0; i < kRecords; ++i) {
    const Point at = way(i);
    char line[160];
    std::snprintf(line, sizeof line, "%s,%.1f,%.4f,%.4f,%.4f", id.c_str(), 0.1 * i, at.x, at.y,
                  at.z);
    text += line;
    if (velocity) {
      const Point moves = velocity(i);
      std::snprintf(line, sizeof line, ",%.3f,%.3f,%.3f", moves.x, moves.y, moves.z);
      text += line;
    }
    text += "\n";
  }
  return text;
}

std::string table_of(const Way& way, const Way& velocity = {}) {
  return std::string("id,time_s,x_m,y_m,z_m") + (velocity ? ",vx,vy,vz\n" : "\n") +
         track_text("a", way, velocity);
}

// White, of about a millimetre, the same each time.
double noise(int i) {
  const double turned = std::sin(12.9898 * i) * 43758.5453;
  return 0.002 * (turned - std::floor(turned) - 0.5);
}

Point measured(int i) {
  return {2.0 + 0.05 * i + noise(i), 1.0 + noise(i + 500), 0.5};
}

// Which stays where it is from the `from`th on.
Way frozen(const Way& way, int from) {
  return [=](int i) { return way(std::min(i, from)); };
}

Result<Recording> after_a_stream(const std::string& text) {
  const TemporaryFolder folder;
  auto stream = RecordingStream::open({folder.write("bees.csv", text)}, {}, 64);
  EXPECT_TRUE(stream.has_value());
  std::vector<StreamedFix> fixes;
  do {
    EXPECT_TRUE(stream->next(fixes));
  } while (!fixes.empty());
  return stream->finish(0);
}

void expect_unknown_from(const std::string& text, std::size_t fixes, const std::string& why) {
  const Recording read = recording_of(record(text));
  EXPECT_EQ(read.bees[0].fixes.size(), fixes);
  EXPECT_EQ(read.missing.count, kRecords - fixes);
  ASSERT_TRUE(read.bees[0].unplaced_until_s);
  EXPECT_EQ(read.bees[0].unplaced_until_s, 0.1 * (kRecords - 1));
  EXPECT_TRUE(has_note(read, why));
  const auto streamed = after_a_stream(text);
  ASSERT_FALSE(streamed);
  EXPECT_NE(streamed.error().message.find("cannot be left out with --memory"), std::string::npos);
}

// Nor is a word said of it, but for what stops at once.
void expect_known(const std::string& text, bool told = false) {
  for (const auto& read : {record(text), after_a_stream(text)}) {
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->missing.none()) << text;
    EXPECT_EQ(has_note(*read, "at once, from one fix to the next"), told) << text;
  }
}

const Way kMoves = [](int) { return Point{0.5, 0.0, 0.0}; };

TEST(FrozenToTheEnd, AgainstItsOwnVelocityIsUnknownFromTheFirstRepeat) {
  const Way drives = [](int i) { return Point{2.0 + 0.05 * i, 1.0, 0.0}; };
  expect_unknown_from(table_of(frozen(drives, 50), kMoves), 51, "by its own velocity");
  // Where it thaws close to where it was, too.
  const Way comes_back = [&](int i) { return i < 80 ? drives(std::min(i, 50)) : drives(51); };
  EXPECT_EQ(recording_of(record(table_of(comes_back, kMoves))).bees[0].fixes.size(), 52u);
}

TEST(FrozenToTheEnd, VelocitiesOfWhatStandsAndHeldOrRoundedPlacesAreNone) {
  const Way drives = [](int i) { return Point{2.0 + 0.05 * i, 1.0, 0.0}; };
  const Way brakes = [](int i) { return Point{2.0 + 0.5 * std::min(i, 60) / 10.0, 1.0, 0.0}; };
  const Way braking = [](int i) { return Point{i < 60 ? 0.5 : 0.0, 0.0, 0.0}; };
  expect_known(table_of(brakes, braking));
  // A ship in port, which says a knot's tenth.
  const Way moored = [](int i) { return Point{i < 50 ? 0.5 : 0.02, 0.0, 0.0}; };
  expect_known(table_of([&](int i) { return brakes(std::min(i, 50)); }, moored), true);
  // A drone on the ground, whose place changes by its last digit now and then.
  const Way parked = [](int i) { return Point{2.0 + 0.0001 * (i % 7 == 0), 1.0, 0.0}; };
  const Way drifts = [](int) { return Point{0.03, 0.0, 0.0}; };
  expect_known(table_of([&](int i) { return parked(std::min(i, 80)); }, drifts));
  // The place comes each second only; or is rounded to a metre.
  const Way held = [&](int i) { return drives(i / 10 * 10); };
  expect_known(table_of(held, kMoves));
  expect_known(table_of([&](int i) { return Point{std::round(drives(i).x), 1.0, 0.0}; }, kMoves));
}

TEST(FrozenToTheEnd, WhereItWasMeasuredBeforeIsUnknown) {
  const std::string why = "though the places before waver";
  expect_unknown_from(table_of(frozen(measured, 70)), 71, why);
  // Which had stood before, too, and came to rest slowly.
  const Way slow = [](int i) {
    const double along = i < 50 ? 0.0 : 0.0005 * (i - 50);
    return Point{2.0 + along + noise(i), 1.0 + noise(i + 500), 0.0};
  };
  expect_unknown_from(table_of(frozen(slow, 80)), 81, why);
}

TEST(FrozenToTheEnd, WhatTrulyStandsIsKnown) {
  // Who brakes, as a robot whose pose is exact while its wheels stand.
  const Way brakes = [](int i) {
    const double t = std::min(i, 80);
    return Point{2.0 + 0.05 * t - 0.05 / 160 * t * t + (i < 80 ? noise(i) / 4 : 0.0), 1.0, 0.0};
  };
  expect_known(table_of(brakes));
  // Who has stood exactly before, and gone on.
  const Way stood = [](int i) {
    const int at = std::min(i < 60 ? std::min(i, 30) : i - 30, 60);
    return measured(at);
  };
  expect_known(table_of(stood));
  // Rounded to whole pixels, an animal that swims, and sleeps.
  const Way fish = [](int i) {
    const double t = 1.0 - std::exp(-0.06 * std::min(i, 70));
    return Point{std::round(300 + 200 * t), std::round(200 + 40 * std::sin(6.0 * t)), 0.0};
  };
  expect_known(table_of(fish));
  // Who lands.
  const Way lands = [](int i) {
    return Point{2.0 + noise(i) * (i < 80), 1.0 + noise(i + 500) * (i < 80),
                 8.0 - 0.1 * std::min(i, 80)};
  };
  expect_known(table_of(lands));
}

TEST(FrozenToTheEnd, OfWhatIsComputedItIsToldThatItStopsAtOnce) {
  const Way straight = [](int i) { return Point{2.0 + 0.05 * std::min(i, 60), 1.0, 0.0}; };
  expect_known(table_of(straight), true);
  const Way round = [](int i) {
    const double turned = 0.05 * std::min(i, 60);
    return Point{5.0 * std::cos(turned), 5.0 * std::sin(turned), 0.0};
  };
  expect_known(table_of(round), true);
  EXPECT_TRUE(has_note(recording_of(record(table_of(straight))), "since 6 s"));
}

// As where each goes to its goal at random, and stays there.
TEST(FrozenToTheEnd, WhereMostComeToTheirEndSoThatIsHowTheyAre) {
  std::string goals = "id,time_s,x_m,y_m,z_m\n";
  std::string at_once = goals;
  for (int bee = 0; bee < 6; ++bee) {
    const std::string id = "a" + std::to_string(bee);
    const auto apart = [&](int from) {
      return [=](int i) {
        const Point at = measured(std::min(i, from));
        return Point{at.x, at.y + 100.0 * bee, at.z};
      };
    };
    goals += track_text(id, apart(60 + 5 * bee));
    at_once += track_text(id, apart(60));
  }
  expect_known(goals, true);
  EXPECT_EQ(recording_of(record(at_once)).missing.bees, 6u);
}

}  // namespace
}  // namespace beespace::io
