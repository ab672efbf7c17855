// Days without a time of day: R's midnights, or days of which the time is not known.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kMidnight_s = 1441843200.0;  // 2015-09-10T00:00:00Z
constexpr double kHour_s = 3600.0;

// One animal, a record an hour.
std::string collar(const std::vector<std::string>& times) {
  std::string text = "id,time,x_m,y_m\n";
  int at = 0;
  for (const std::string& time : times) text += "a," + time + "," + std::to_string(++at) + ",2\n";
  return text;
}

RecordingOptions utc() {
  RecordingOptions options;
  options.time_zone = TimeZone::utc();
  return options;
}

void expect_doubt(const std::vector<std::string>& times, std::string_view why) {
  const auto loaded = record(collar(times), utc());
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::kNotANumber);
  EXPECT_NE(loaded.error().message.find(why), std::string::npos) << loaded.error().message;
}

TEST(BareMidnights, OfRAreMidnightAndThatIsSaid) {
  const Recording recording = recording_of(record(
      collar({"2015-09-09 22:00:00", "2015-09-09 23:00:00", "2015-09-10", "2015-09-10 01:00:00"}),
      utc()));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(times_of(recording.bees[0]),
            (std::vector<double>{kMidnight_s - 2.0 * kHour_s, kMidnight_s - kHour_s, kMidnight_s,
                                 kMidnight_s + kHour_s}));
  EXPECT_TRUE(has_note(recording, "1 time is a day alone and is taken for midnight, as R writes"));
}

TEST(BareMidnights, MayBeTheFirstOfAll) {
  const Recording recording = recording_of(
      record(collar({"2015-09-10", "2015-09-10 01:00:00", "2015-09-10 02:00:00"}), utc()));
  EXPECT_EQ(times_of(recording.bees.at(0)).front(), kMidnight_s);
  // In a column that is named by the day alone, too.
  EXPECT_TRUE(
      record("id,date,x_m,y_m\na,2015-09-10,1,2\na,2015-09-10 01:00:00,2,2\n"
             "a,2015-09-10 02:00:00,3,2\n",
             utc()));
}

TEST(BareMidnights, AreNoneWhereADayMayBeMeant) {
  expect_doubt({"2015-09-09 22:00:00", "2015-09-09 23:00:00", "2015-09-10", "2015-09-10 01:00:00",
                "2015-09-11 00:00:00"},
               "other midnights are written as 00:00:00");
  expect_doubt({"2015-09-09 07:00:00", "2015-09-09 19:00:00", "2015-09-10", "2015-09-10 07:00:00",
                "2015-09-10 19:00:00"},
               "at midnight it would not come in step with the records beside it");
  expect_doubt({"2015-09-09 23:00:00", "2015-09-10"}, "would not come in step");
  // Where none has a time, none is midnight.
  const auto days = record(collar({"2015-09-09", "2015-09-10", "2015-09-11"}), utc());
  ASSERT_FALSE(days);
  EXPECT_NE(days.error().message.find("it is a day without a time"), std::string::npos);
}

}  // namespace
}  // namespace beespace::io
