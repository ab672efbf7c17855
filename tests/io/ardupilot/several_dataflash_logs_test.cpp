// Several DataFlash logs of ArduPilot: drones on one clock, or on none that they share.
#include "tests/io/ardupilot/dataflash_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

class SeveralDataflashLogs : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) {
    return folder_.write(name, content);
  }

  TemporaryFolder folder_;
};

TEST_F(SeveralDataflashLogs, AreDronesOnOneClock) {
  DataflashMaking other = ardupilot_log();  // switched on 100 s later
  other.gps(1'000'000, kWeek, kWeekMs + 96'000).pos(2'000'000, 47.3);
  write("1.BIN", small_dataflash_log().bytes());
  write("2.bin", other.bytes());
  write("notes.md", "nothing");
  const auto recording = recording_of(load_recording({folder_.file("")}, {}));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(times_of(recording.bees[0])[0], kStarted_s);
  EXPECT_EQ(times_of(recording.bees[1])[0], kStarted_s + 97);
}

TEST_F(SeveralDataflashLogs, OfAnArchiveAreReadByTheirNames) {
  const std::string path = write("logs.zip", zipped({{"1.bin", small_dataflash_log().bytes()},
                                                     {"2.bin", small_dataflash_log().bytes()}}));
  EXPECT_EQ(ids_of(recording_of(load_recording({path}, {}))), (std::vector<std::string>{"1", "2"}));
}

// As the card of a flight controller has them.
TEST_F(SeveralDataflashLogs, HaveTheNumberOfTheLastOneBesideThem) {
  const std::string one = write("00000001.BIN", small_dataflash_log().bytes());
  const std::string two = write("00000002.BIN", small_dataflash_log().bytes());
  const std::string number = write("LASTLOG.TXT", "2\r\n");
  write("vehicle.params", "1\t1\tARMING_CHECK\t1\t6\n");
  const std::vector<std::vector<std::string>> ways = {{folder_.file("")}, {one, two, number}};
  for (const auto& named : ways) {
    const auto recording = recording_of(load_recording(named, {}));
    EXPECT_EQ(recording.bees.size(), 2u);
    EXPECT_TRUE(has_note(recording, "the number of the last log of ArduPilot and no places: "));
    EXPECT_FALSE(has_note(recording, "left out"));
  }
  EXPECT_FALSE(load_recording({number}, {}));
}

TEST_F(SeveralDataflashLogs, WithoutATimeOfGpsShareNoClock) {
  DataflashMaking other = ardupilot_log();
  other.pos(2'000'000);
  const std::string with = write("1.bin", small_dataflash_log().bytes());
  const std::string without = write("2.bin", other.bytes());
  expect_error(load_recording({with, without}, {}),
               {ErrorCode::kInvalidArgument, without, "it shares no clock with other inputs"});
  RecordingOptions one_clock;
  one_clock.one_clock = true;
  EXPECT_TRUE(load_recording({without, without}, one_clock));
  EXPECT_TRUE(load_recording({without}, {}));
}

TEST_F(SeveralDataflashLogs, WhoseClocksContradictGpsAreRefused) {
  DataflashMaking other = small_dataflash_log();
  other.gps(6'000'000, kWeek, kWeekMs + 3'000);
  const std::string one = write("1.bin", small_dataflash_log().bytes());
  const std::string two = write("2.bin", other.bytes());
  expect_error(load_recording({one, two}, {}),
               {ErrorCode::kInvalidArgument, two, "contradict its own clock by 2000 ms"});
}

}  // namespace
}  // namespace beespace::io
