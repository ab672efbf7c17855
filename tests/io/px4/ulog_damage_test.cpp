// PX4 logs that are damaged, cut short, or appended to.
#include "tests/io/px4/ulog_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

Result<Recording> load_damaged(std::string_view log) {
  return load_recording_from_memory(log, "flights/north.ulg", {});
}

TEST(Ulog, DropoutsAreCountedAndSaid) {
  UlogMaking log = small_log();
  log.dropout(30).dropout(12);
  const auto recording = recording_of(load_damaged(log.bytes()));
  EXPECT_TRUE(has_note(recording, "the drone could not write all: 2 dropouts, 42 ms in all"));
}

TEST(Ulog, DamageIsPassedOverAndCounted) {
  for (const bool marked : {false, true}) {
    UlogMaking log = small_log();
    const std::size_t at = log.bytes().size();
    log.raw(std::string("\xFF\xFFnothing that is a message", 27));
    if (marked) log.sync();
    log.data(kGlobalNumber, global_message({.micros = 6'000'000}));
    const auto recording = recording_of(load_damaged(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 3u);
    EXPECT_TRUE(has_note(recording, "27 bytes in 1 place are no message of a log"));
    EXPECT_TRUE(has_note(recording, "the first at byte " + std::to_string(at)));
    EXPECT_EQ(recording.missing.count, 1u);
  }
}

TEST(Ulog, AMessageOfAnotherLengthThanItsDefinitionSaysIsDamage) {
  const std::string whole = global_message({.micros = 6'000'000}).bytes();
  for (const std::size_t length : {whole.size() - 1, whole.size() + 5}) {
    UlogMaking log = small_log();
    log.data(kGlobalNumber, UlogBody().text((whole + "12345").substr(0, length)));
    log.data(kGlobalNumber, global_message({.micros = 7'000'000}));
    const auto recording = recording_of(load_damaged(log.bytes()));
    EXPECT_EQ(recording.bees[0].fixes.size(), 3u) << length;
    EXPECT_TRUE(has_note(recording, "in 1 place")) << length;
  }
  UlogMaking padded = small_log();  // with the padding at its end, as other writers have it
  padded.data(kGlobalNumber, UlogBody().text(whole + std::string(4, '\0')));
  EXPECT_EQ(recording_of(load_damaged(padded.bytes())).bees[0].fixes.size(), 3u);
}

TEST(Ulog, ALogThatIsCutShortIsReadAsFarAsItGoes) {
  const std::string whole = small_log().bytes();
  const std::string next =
      small_log().data(kGlobalNumber, global_message({.micros = 6'000'000})).bytes();
  for (std::size_t length = whole.size() + 1; length < next.size(); ++length) {
    const auto recording = recording_of(load_damaged(next.substr(0, length)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << length;
    EXPECT_TRUE(
        has_note(recording, "ends within a message, at byte " + std::to_string(whole.size())))
        << length;
    EXPECT_EQ(recording.missing.count, 1u) << length;
  }
}

TEST(Ulog, ALogThatEndsBeforeItsDataSaysWhere) {
  const std::string whole = small_log().bytes();
  for (std::size_t length = 7; length < px4_log().bytes().size(); ++length) {
    const auto loaded = load_damaged(whole.substr(0, length));
    ASSERT_FALSE(loaded) << length;
    const Error& error = loaded.error();
    EXPECT_TRUE(error.code == ErrorCode::kTruncated || error.code == ErrorCode::kNoPoints)
        << length;
    EXPECT_NE(error.message.find("PX4 log"), std::string::npos) << error.message;
  }
  expect_error(load_damaged(whole.substr(0, 12)),
               {ErrorCode::kTruncated, "flights/north.ulg", "at byte 12"});
}

TEST(Ulog, AnyByteThatIsChangedIsNoCrash) {
  const std::string whole = small_log().dropout(3).sync().bytes();
  for (std::size_t at = 7; at < whole.size(); ++at) {
    for (const int bit : {1, 128}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ bit);
      const auto loaded = load_damaged(changed);
      if (!loaded) {
        EXPECT_FALSE(loaded.error().message.empty()) << at;
      }
    }
  }
}

TEST(Ulog, DefinitionsThatAreDamagedAreAnErrorOfTheirTopic) {
  UlogMaking log;
  log.format("vehicle_global_position:uint64_t timestamp;double lat;double lon;float[ alt;");
  log.subscribe(1, "vehicle_global_position");
  log.data(1, UlogBody().u64(1).f64(47).f64(8).f32(9));
  expect_error(load_damaged(log.bytes()), {ErrorCode::kCorrupt, "flights/north.ulg",
                                           "has vehicle_global_position, but its definition"});
}

TEST(Ulog, DataAppendedLaterIsReadBehindAMessageThatWasCut) {
  // What the flags say first is where the log ends; its last message is cut there.
  const auto made = [](std::uint64_t appended_at) {
    UlogMaking log;
    log.flags(appended_at == 0 ? 0 : 1, appended_at);
    log.format(kGlobalFormat).subscribe(kGlobalNumber, "vehicle_global_position");
    log.data(kGlobalNumber, global_message({.micros = 1'000'000}));
    const std::string cut =
        ulog_message('D', UlogBody().u16(kGlobalNumber).text(global_message({}).bytes()).bytes());
    return log.raw(cut.substr(0, 20));
  };
  UlogMaking log = made(made(0).bytes().size());
  log.data(kGlobalNumber, global_message({.micros = 2'000'000}));
  const auto recording = recording_of(load_damaged(log.bytes()));
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1, 2}));
  EXPECT_FALSE(has_note(recording, "damaged"));
}

TEST(Ulog, FeaturesThatAreNotKnownAreRefused) {
  UlogMaking log;
  log.flags(2);
  expect_error(load_damaged(log.bytes()), {ErrorCode::kUnsupportedFormat, "flights/north.ulg",
                                           "at byte 27 that it cannot be read without a feature"});
  UlogMaking newer(2);
  expect_error(load_damaged(newer.bytes()),
               {ErrorCode::kUnsupportedFormat, "flights/north.ulg", "version 2 of ULog"});
}

}  // namespace
}  // namespace beespace::io
