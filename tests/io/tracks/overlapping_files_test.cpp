// One id in several files at the same time: two logs of one vehicle are one, two trials are not.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

constexpr int kFixes = 20;

// A fix a second, `late_s` behind whole ones, on the way of a vehicle at `speed_mps`.
std::string way_of(const std::string& id, double late_s, double speed_mps, double beside_m) {
  std::string text = "time_s,id,x_m,y_m\n";
  for (int i = 0; i < kFixes; ++i) {
    const double at_s = i + late_s;
    text += std::to_string(at_s) + "," + id + "," + std::to_string(speed_mps * at_s) + "," +
            std::to_string(beside_m) + "\n";
  }
  return text;
}

Result<Recording> merged(const std::string& first, const std::string& second) {
  const TemporaryFolder folder;
  return load_recording({folder.write("one.csv", first), folder.write("two.csv", second)});
}

TEST(OverlappingFiles, TwoLogsOfOneVehicleAreOne) {
  const auto recording =
      recording_of(merged(way_of("a", 0.0, 3.0, 0.0), way_of("a", 0.25, 3.0, 0.5)));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u * kFixes);
  EXPECT_TRUE(has_note(recording, "1 bee is in several files under the same id"));
}

TEST(OverlappingFiles, TwoTrialsAreNotOneAnimal) {
  const auto loaded = merged(way_of("1", 0.0, 0.002, 0.0), way_of("1", 0.5, 0.002, 0.05));
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::kTimeOrder);
  EXPECT_NE(loaded.error().message.find("bee '1' is in several files at the same time"),
            std::string::npos)
      << loaded.error().message;
  EXPECT_NE(loaded.error().message.find("one.csv, line 2: are they two?"), std::string::npos)
      << loaded.error().message;
  EXPECT_TRUE(loaded.error().location.source.ends_with("two.csv"));
  EXPECT_EQ(loaded.error().location.line, 2u);
}

TEST(OverlappingFiles, OneFileAfterTheOtherIsOne) {
  EXPECT_TRUE(merged(way_of("a", 0.0, 0.002, 0.0), way_of("a", 100.0, 0.002, 5.0)));
  // A file with a hole that another one fills.
  std::string holed = "time_s,id,x_m,y_m\n";
  for (const int second : {0, 1, 2, 3, 100, 101, 102}) {
    holed += std::to_string(second) + ",a," + std::to_string(second) + ",0\n";
  }
  EXPECT_TRUE(merged(holed, way_of("a", 50.0, 1.0, 0.5)));
}

// Reports as several receivers heard them may be of clocks that differ: they are said, and no
// verdict is an all-clear.
TEST(OverlappingFiles, OfReceiversIsNoAllClear) {
  const auto snapshot_at = [](double now, double longitude) {
    return R"({"now":)" + std::to_string(1.7e9 + now) +
           R"(,"aircraft":[{"hex":"4b1814","lat":47,"lon":)" + std::to_string(longitude) +
           R"(,"alt_geom":30000,"gs":400,"track":90,"seen_pos":0}]})" + "\n";
  };
  std::string first;
  std::string second;
  for (int i = 0; i < kFixes; ++i) {
    first += snapshot_at(2.0 * i, 8.0 + 0.005 * i);
    second += snapshot_at(2.0 * i + 1.0, 9.0 + 0.005 * i);
  }
  const TemporaryFolder folder;
  const auto recording = recording_of(
      load_recording({folder.write("one.json", first), folder.write("two.json", second)}));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.missing.shared, 1u);
}

}  // namespace
}  // namespace beespace::io
