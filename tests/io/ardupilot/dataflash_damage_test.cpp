// DataFlash logs of ArduPilot that are damaged, cut short, or only begun.
#include "tests/io/ardupilot/dataflash_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

Result<Recording> load_bytes(std::string_view bytes) {
  return load_recording_from_memory(bytes, "flights/00000012.BIN", {});
}

TEST(Dataflash, DamageIsPassedOverAndCounted) {
  for (const std::string_view damage :
       {std::string_view("\xFF\xFFnothing that is a message", 27),
        std::string_view("\xA3\x95\xC8 of a type that is not defined", 27),
        std::string_view("\xA3\x95\xA3\x95\xA3", 5)}) {
    DataflashMaking log = small_dataflash_log();
    const std::size_t at = log.bytes().size();
    log.raw(damage).pos(6'000'000);
    const auto recording = recording_of(load_bytes(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 3u);
    EXPECT_TRUE(has_note(recording, std::to_string(damage.size()) + " bytes in 1 place are no"));
    EXPECT_TRUE(has_note(recording, "the first at byte " + std::to_string(at)));
    EXPECT_EQ(recording.missing.count, 1u);
  }
}

TEST(Dataflash, AMessageThatIsCutIsSaidToBe) {
  DataflashMaking log = small_dataflash_log();
  const std::size_t at = log.bytes().size();
  log.pos(6'000'000);
  for (std::size_t end = at + 1; end < log.bytes().size(); ++end) {
    const auto recording = recording_of(load_bytes(log.bytes().substr(0, end)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << end;
    EXPECT_TRUE(has_note(recording, "ends within a message, at byte " + std::to_string(at)));
    EXPECT_EQ(recording.missing.count, 1u);
  }
}

TEST(Dataflash, PagesThatWereNeverWrittenAreNoDamage) {
  for (const char unwritten : {'\0', '\xFF'}) {
    const DataflashMaking log = small_dataflash_log().raw(std::string(4096, unwritten));
    const auto recording = recording_of(load_bytes(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
    EXPECT_TRUE(recording.missing.none());
  }
}

TEST(Dataflash, ADefinitionThatContradictsItselfHasNoFields) {
  DataflashMaking log;
  log.define(kPos, 32, "POS", "QLLfff", "TimeUS,Lat,Lng,Alt,RelHomeAlt,RelOriginAlt");
  log.data(kPos, DataflashBody().text("", 29));
  expect_error(load_bytes(log.bytes()),
               {ErrorCode::kCorrupt, "flights/00000012.BIN", "has POS, but its definition"});
  DataflashMaking unknown;
  unknown.define(kPos, 31, "POS", "QLL?ff", "TimeUS,Lat,Lng,Alt,RelHomeAlt,RelOriginAlt");
  EXPECT_FALSE(load_bytes(unknown.pos(5'000'000).bytes()));
}

// Whatever a byte of it says instead, nothing is told that was not there: all places are those that
// were written, or one that is damaged itself.
TEST(Dataflash, OneDamagedByteAddsNoPlace) {
  const std::string whole = small_dataflash_log().pos(6'000'000).pos(6'500'000).bytes();
  for (std::size_t at = 5; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x11);
    const auto loaded = load_bytes(damaged);
    if (!loaded) continue;
    EXPECT_LE(loaded.value().bees.at(0).fixes.size(), 4u) << at;
  }
}

}  // namespace
}  // namespace beespace::io
