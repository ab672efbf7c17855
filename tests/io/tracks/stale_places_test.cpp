// Places that are repeated though the bee's own speed says that it has left them.
#include "io/recording/stale_places.hpp"

#include "io/stream_recording.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kWithSpeeds = "id,time_s,lon,lat,height_m,ve,vn\n";

// Every second from 0 s to `until_s`; the place goes on until `last_s`.
std::string stale_flight(const std::string& id, int until_s, int last_s,
                         const std::string& speed_mps) {
  std::string text;
  for (int t = 0; t <= until_s; ++t) {
    text += id + "," + std::to_string(t) + "," + std::to_string(8.0 + 0.001 * std::min(t, last_s)) +
            ",48,9000," + speed_mps + ",0\n";
  }
  return text;
}

TEST(StalePlaces, WhereTheyStayThoughTheBeeMovesTheyAreUnknown) {
  const Recording recording = recording_of(record(kWithSpeeds + stale_flight("a", 20, 10, "75")));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.back().time_s, 13.0);
  EXPECT_EQ(recording.bees[0].unplaced_from_s, 14.0);
  EXPECT_EQ(recording.bees[0].unplaced_until_s, 20.0);
  EXPECT_EQ(recording.missing.count, 7u);
  EXPECT_TRUE(
      has_note(recording, "7 records whose place stays exactly the same for more than 3 s"));
}

TEST(StalePlaces, WhoStandsOrSaysNoSpeedIsWhereItSays) {
  for (const char* const speed_mps : {"0", "1.5", "", "NaN"}) {
    const Recording recording =
        recording_of(record(kWithSpeeds + stale_flight("a", 20, 10, speed_mps)));
    EXPECT_EQ(recording.bees.at(0).fixes.size(), 21u) << speed_mps;
    EXPECT_TRUE(recording.missing.none()) << speed_mps;
  }
}

TEST(StalePlaces, RecordsThatComeMoreOftenThanPlacesAreNone) {
  std::string text = kWithSpeeds;
  for (int t = 0; t <= 20; ++t) {
    text +=
        "a," + std::to_string(t) + "," + std::to_string(8.0 + 0.003 * (t / 3)) + ",48,9000,75,0\n";
  }
  EXPECT_TRUE(recording_of(record(text)).missing.none());
}

TEST(StalePlaces, OneThatComesBackOrGoesOnIsNone) {
  StalePlaces places;
  const Velocity fast = {20.0, 0.0, 0.0};
  const Velocity slow = {2.0, 0.0, 9.0};
  const auto take = [&places](double time_s, double x, const Velocity* velocity) {
    return places.take({time_s, {x, 0.0, time_s}}, velocity);
  };
  EXPECT_FALSE(take(0.0, 1.0, &fast));
  EXPECT_FALSE(take(3.0, 1.0, &fast));
  EXPECT_TRUE(take(3.5, 1.0, &fast)) << "the height says nothing";
  EXPECT_FALSE(take(4.0, 2.0, &fast));
  EXPECT_FALSE(take(8.0, 1.0, &fast));
  EXPECT_FALSE(take(20.0, 1.0, &slow)) << "it may have stood there";
  EXPECT_FALSE(take(21.0, 1.0, &fast));
  EXPECT_FALSE(take(30.0, 1.0, nullptr));
}

TEST(StalePlaces, AircraftOfReadsbAndOpenSkySayThemToo) {
  std::string lines;
  std::string states;
  for (int t = 0; t <= 20; ++t) {
    const std::string now = std::to_string(1700000000 + t);
    const std::string longitude = std::to_string(8.0 + 0.001 * std::min(t, 10));
    lines += R"({"now":)" + now + R"(,"hex":"4b1814","lat":48,"lon":)" + longitude +
             R"(,"alt_geom":30000,"gs":150,"track":90,"geom_rate":0,"seen_pos":0})" + "\n";
    states += R"({"time":)" + now + R"(,"states":[["4b1814","AB1","CH",)" + now + "," + now + "," +
              longitude + R"(,48,9000,false,75,90,0,null,9000,null,false,0]]})" + "\n";
  }
  for (const std::string& text : {lines, states}) {
    const Recording recording = recording_of(record(text));
    ASSERT_EQ(recording.bees.size(), 1u);
    EXPECT_EQ(recording.bees[0].fixes.back().time_s, 1700000013.0) << text;
    EXPECT_EQ(recording.missing.count, 7u) << text;
  }
}

TEST(StalePlaces, APlaceOfReadsbWhoseAgeGrowsIsHeardOnce) {
  std::string lines;
  for (int t = 0; t <= 20; ++t) {
    lines += R"({"now":)" + std::to_string(1700000000 + t) +
             R"(,"hex":"4b1814","lat":48,"lon":8,"alt_geom":30000,"gs":150,"track":90,)" +
             R"("geom_rate":0,"seen_pos":)" + std::to_string(t) + "}\n";
  }
  const Recording recording = recording_of(record(lines));
  EXPECT_EQ(recording.bees.at(0).fixes.size(), 1u);
  EXPECT_TRUE(recording.missing.none());
}

TEST(StalePlaces, AStreamKnowsThemToo) {
  const TemporaryFolder folder;
  const std::string path = folder.write("bees.csv", kWithSpeeds + stale_flight("a", 20, 10, "75"));
  auto stream = RecordingStream::open({path}, {}, 64);
  ASSERT_TRUE(stream.has_value());
  std::vector<StreamedFix> some;
  std::size_t fixes = 0;
  do {
    ASSERT_TRUE(stream->next(some).has_value());
    fixes += some.size();
  } while (!some.empty());
  EXPECT_EQ(fixes, 14u);
  EXPECT_EQ(recording_of(stream->finish(0)).missing.count, 7u);
}

}  // namespace
}  // namespace beespace::io
