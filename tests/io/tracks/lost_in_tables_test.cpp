// Tables, and JSON, whose columns say that a drone has lost its place, as its log would.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

// What remains of three records of which the second one says that in that column.
std::size_t places_left(const std::string& header, const std::string& well,
                        const std::string& lost) {
  const auto row = [](const std::string& time, const std::string& says) {
    return "a," + time + ",8.5,47.25,500," + says + "\n";
  };
  const Recording recording = recording_of(
      record("id,unix_time_s,lon,lat,height_m," + header + "\n" + row("1795867200", well) +
             row("1795867201", lost) + row("1795867202", well)));
  if (recording.bees.empty()) return 0;
  EXPECT_EQ(recording.missing.none(), recording.bees[0].fixes.size() == 3) << header;
  return recording.bees[0].fixes.size();
}

TEST(LostInTables, AsPx4SaysItOfGlobalPositions) {
  EXPECT_EQ(places_left("eph,epv,dead_reckoning", "0.5,0.8,0", "0.5,0.8,1"), 2u);
  EXPECT_EQ(places_left("eph,epv,dead_reckoning", "0.5,0.8,0", "10.5,0.8,0"), 2u);
  EXPECT_EQ(places_left("eph,epv,dead_reckoning", "0.5,0.8,0", "0.5,60,0"), 2u);
  EXPECT_EQ(places_left("eph,epv,dead_reckoning", "0.5,0.8,False", "10,10,False"), 3u);
  // Elsewhere it may be a dilution of precision in hundredths.
  EXPECT_EQ(places_left("eph,epv", "121,200", "9999,200"), 3u);
}

TEST(LostInTables, AsTrackersSayIt) {
  EXPECT_EQ(places_left("tracking_valid", "True", "False"), 2u);
  EXPECT_EQ(places_left("position_valid", "1", "0"), 2u);
  EXPECT_EQ(places_left("tracked", "yes", "no"), 2u);
  EXPECT_EQ(places_left("lost", "0", "1"), 2u);
}

TEST(LostInTables, AsQGroundControlSaysIt) {
  EXPECT_EQ(places_left("gps.lock", "3", "1"), 2u);
  EXPECT_EQ(places_left("gps.lock", "3D Lock", "None"), 2u);
}

// Each drone counts from where it was switched on: in JSON, too.
TEST(LocalOrigins, OfJsonAreThoseOfTables) {
  const auto line = [](const std::string& id, const std::string& latitude, const std::string& x) {
    return R"({"id": ")" + id + R"(", "time_s": 1795867200.0, "x": )" + x +
           R"(, "y": 0, "z": 0, "ref_lat": )" + latitude +
           R"(, "ref_lon": 8.5, "ref_alt": 500, "xy_global": true, "z_global": true})" + "\n";
  };
  const std::string lines = line("a", "47.25", "0") + line("b", "47.26", "0");
  const Recording recording = recording_of(load_recording_from_memory(lines, "b.ndjson", {}));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  ASSERT_EQ(recording.bees.size(), 2u);
  EXPECT_NEAR(recording.bees[1].fixes[0].position.y, 47.26, 1e-9);
  EXPECT_NEAR(recording.bees[1].fixes[0].position.z, 500.0, 1e-9);
}

}  // namespace
}  // namespace beespace::io
