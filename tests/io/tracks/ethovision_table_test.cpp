// Raw data of EthoVision: a file for each animal, lines above the columns, a row of units, UTF-16.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

std::string lines_above(const std::string& trial, const std::string& arena) {
  return "\"Number of header lines:\";\"8\"\r\n\"Experiment\";\"zebrafish\"\r\n\"Trial name\";\"" +
         trial + "\"\r\n\"Arena name\";\"" + arena +
         "\"\r\n\"Subject name\";\"Subject 1\"\r\n\"Start time\";\"06/05/2024 10:00:00\"\r\n";
}

// An animal that goes along y = `y`, in cm, with a place that is not known.
std::string columns(const std::string& y) {
  return "\"Trial time\";\"Recording time\";\"X center\";\"Y center\";\"Area\"\r\n"
         "\"s\";\"s\";\"cm\";\"cm\";\"cm\xC2\xB2\"\r\n"
         "0.000;0.000;-5.0;" +
         y + ";0.5\r\n0.040;0.040;-4.5;" + y + ";0.5\r\n0.080;0.080;-;-;0.5\r\n0.120;0.120;-4.0;" +
         y + ";0.5\r\n";
}

std::string raw_data(const std::string& y, const std::string& trial = "Trial     1",
                     const std::string& arena = "Arena 1") {
  return lines_above(trial, arena) + columns(y);
}

// Of characters up to U+00FF.
std::string as_utf16(std::string_view text, bool little) {
  std::string bytes = little ? "\xFF\xFE" : "\xFE\xFF";
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto character = static_cast<unsigned char>(text[i]);
    if (character == 0xC2) character = static_cast<unsigned char>(text[++i]);
    const char first = static_cast<char>(character);
    bytes += little ? std::string{first, '\0'} : std::string{'\0', first};
  }
  return bytes;
}

Result<Recording> both(const std::string& first, const std::string& second,
                       const RecordingOptions& options = {}) {
  const TemporaryFolder folder;
  auto loaded = load_recording({folder.write("Raw data-Subject 1.txt", first),
                                folder.write("Raw data-Subject 2.txt", second)},
                               options);
  if (loaded) return loaded;
  Error error = std::move(loaded).error();
  error.location.source.erase(0, error.location.source.find("Raw"));
  return error;
}

TEST(EthovisionTable, TheUnitIsInTheRowBelowTheNames) {
  const auto recording = recording_of(record(raw_data("1.0")));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].fixes, (std::vector<Fix>{{0.0, {-0.05, 0.01, 0.0}},
                                                       {0.04, {-0.045, 0.01, 0.0}},
                                                       {0.12, {-0.04, 0.01, 0.0}}}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(has_note(recording, "raw data as EthoVision exports them"));
}

TEST(EthovisionTable, Utf16IsRead) {
  for (const bool little : {true, false}) {
    const auto recording = recording_of(record(as_utf16(raw_data("1.0"), little)));
    ASSERT_EQ(recording.bees.size(), 1U);
    EXPECT_EQ(recording.bees[0].fixes.size(), 3U);
    EXPECT_TRUE(has_note(recording, "the text is UTF-16, as its byte-order mark says"));
  }
}

TEST(EthovisionTable, FilesOfOneTrialHaveOneClock) {
  std::string second = raw_data("2.0");
  EXPECT_EQ(ids_of(recording_of(both(raw_data("1.0"), second))),
            (std::vector<std::string>{"Subject 1", "Raw data-Subject 2"}));
  second.replace(second.find("Subject 1"), 9, "Subject 2");
  const auto recording = recording_of(both(raw_data("1.0"), second));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"Subject 1", "Subject 2"}));
  EXPECT_TRUE(recording.of_animals);
}

TEST(EthovisionTable, TrialsAreNotCompared) {
  const std::string other = raw_data("2.0", "Trial     2");
  expect_error(both(raw_data("1.0"), other),
               {ErrorCode::kInvalidArgument, "Raw data-Subject 2.txt",
                "count from the beginning of trial 'Trial     2' of '06/05/2024 10:00:00'"});
  RecordingOptions options;
  options.one_clock = true;
  EXPECT_TRUE(both(raw_data("1.0"), other, options));
}

TEST(EthovisionTable, ArenasMayHaveOriginsOfTheirOwn) {
  const std::string other = raw_data("2.0", "Trial     1", "Arena 2");
  expect_error(both(raw_data("1.0"), other),
               {ErrorCode::kUnknownFrame, "Raw data-Subject 2.txt", "say so with --crs metres"});
  RecordingOptions options;
  options.frame = Frame::kMetres;
  EXPECT_TRUE(both(raw_data("1.0"), other, options));
}

TEST(EthovisionTable, TheColumnsAloneAreKnown) {
  EXPECT_EQ(recording_of(record(columns("1.0"))).bees.size(), 1U);
  // Nothing says what clock they have, then.
  expect_error(both(columns("1.0"), columns("2.0")),
               {ErrorCode::kInvalidArgument, "Raw data-Subject 2.txt", "both begin at 0"});
}

TEST(EthovisionTable, AUnitThatNoRowSaysIsAskedFor) {
  std::string text = columns("1.0");
  text.erase(text.find("\"s\";"), text.find("0.000;") - text.find("\"s\";"));
  expect_error(record(text), {ErrorCode::kInvalidArgument, "bees.csv", "--units position=cm"});
  RecordingOptions options;
  options.units.position = Unit::kCentimetre;
  EXPECT_TRUE(record(text, options));
}

TEST(EthovisionTable, TheLineOfABadRecordIsNamed) {
  std::string text = raw_data("1.0");
  text.replace(text.find("-4.5;"), 5, "oops;");
  expect_error(record(text), {ErrorCode::kNotANumber, "bees.csv:10", "'oops'"});
}

}  // namespace
}  // namespace beespace::io
