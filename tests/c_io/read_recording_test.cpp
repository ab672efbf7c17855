// Recordings that C reads from files: fixes in columns, agent by agent.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

using Numbers = std::vector<std::int64_t>;

class CReadRecording : public testing::Test {
 protected:
  static void expect_columns(const Recording& recording, const std::vector<double>& times_s,
                             const std::vector<double>& xyz, const Numbers& agent,
                             const Numbers& offsets) {
    const auto* const r = recording.get();
    const std::int64_t fixes = beespace_io_recording_fixes(r);
    EXPECT_EQ(numbers_of(beespace_io_recording_times_s(r), fixes), times_s);
    EXPECT_EQ(numbers_of(beespace_io_recording_xyz(r), 3 * fixes), xyz);
    EXPECT_EQ(numbers_of(beespace_io_recording_agent(r), fixes), agent);
    EXPECT_EQ(numbers_of(beespace_io_recording_offsets(r), beespace_io_recording_agents(r) + 1),
              offsets);
  }

  TestFolder folder_;
};

TEST_F(CReadRecording, StandsInColumnsAgentByAgent) {
  const auto read = read_recording(
      {folder_.file("flight.csv",
                    "id,time_s,x [m],y [m],z "
                    "[m]\nb,0,1,2,3\na,0,4,5,6\nb,1.5,7,8,9\na,2,10,11,12\nc,1,0,0,-1\n")});
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  expect_columns(read.recording, {0, 1.5, 0, 2, 1},
                 {1, 2, 3, 7, 8, 9, 4, 5, 6, 10, 11, 12, 0, 0, -1}, {0, 0, 1, 1, 2}, {0, 2, 4, 5});
  const auto* const r = read.recording.get();
  EXPECT_STREQ(beespace_io_recording_id(r, 0), "b");
  EXPECT_STREQ(beespace_io_recording_id(r, 2), "c");
  EXPECT_EQ(beespace_io_recording_id(r, 3), nullptr);
  EXPECT_STREQ(beespace_io_recording_label(r, 0), "");
  const std::int64_t* ends = nullptr;
  const char* const ids = beespace_io_recording_ids(r, &ends);
  EXPECT_EQ(std::string(ids, 6), std::string("b\0a\0c\0", 6));
  EXPECT_EQ(numbers_of(ends, 4), (Numbers{0, 2, 4, 6}));
  EXPECT_EQ(beespace_io_recording_since_1970(r), 0);
  EXPECT_EQ(beespace_io_recording_missing(r), 0);
  EXPECT_EQ(beespace_io_recording_degrees(r), nullptr);
  EXPECT_STREQ(beespace_io_facts_frame(beespace_io_recording_facts(r)), "metres");
}

TEST_F(CReadRecording, OfDegreesIsEarthCentredAndKeepsThem) {
  const auto read = read_recording(
      {folder_.file("flight.csv",
                    "id,timestamp,lon_deg,lat_deg,height_m\na,2026-01-01T00:00:00Z,90,0,7\n"
                    "a,2026-01-01T00:00:01Z,0,90,0\n")});
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  const auto* const r = read.recording.get();
  const double* const xyz = beespace_io_recording_xyz(r);
  constexpr double kA = 6378137.0;
  EXPECT_NEAR(xyz[1], kA + 7, 1e-8);
  EXPECT_NEAR(xyz[5], kA * (1.0 - 1.0 / 298.257223563), 1e-8);
  EXPECT_EQ(numbers_of(beespace_io_recording_degrees(r), 6),
            (std::vector<double>{90, 0, 7, 0, 90, 0}));
  // 20,454 days after the first of January 1970.
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(r), 2),
            (std::vector<double>{20454.0 * 86400, 20454.0 * 86400 + 1}));
  EXPECT_EQ(beespace_io_recording_since_1970(r), 1);
}

TEST_F(CReadRecording, OfSeveralFilesOrAFolderIsOne) {
  const std::string one = folder_.file("one.csv", "time_s,x [m],y [m],z [m]\n0,1,2,3\n1,4,5,6\n");
  const std::string two = folder_.gzip_file("two.csv.gz", "time_s,x [m],y [m],z [m]\n1,7,8,9\n");
  for (const auto& paths : {std::vector<std::string>{one, two}, {folder_.path("")}}) {
    const auto read = read_recording(paths);
    ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    expect_columns(read.recording, {0, 1, 1}, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {0, 0, 1}, {0, 2, 3});
    EXPECT_STREQ(beespace_io_recording_id(read.recording.get(), 1), "two");
  }
}

TEST_F(CReadRecording, SaysWhatIsNotKnown) {
  const std::string path = folder_.file(
      "flight.csv", "id,time_s,x [m],y [m],z [m]\na,0,1,2,3\nb,0,one,2,3\na,1,4,5,6\n");
  EXPECT_EQ(read_recording({path}).code, BEESPACE_NOT_A_NUMBER);
  auto options = io_options();
  options.flags = BEESPACE_IO_SKIP_BAD;
  const auto read = read_recording({path}, &options);
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  const auto* const r = read.recording.get();
  EXPECT_EQ(beespace_io_recording_missing(r), 1);
  EXPECT_EQ(beespace_io_facts_skipped(beespace_io_recording_facts(r)), 1);
  const auto notes = notes_of(beespace_io_recording_facts(r));
  EXPECT_NE(notes.back().find("those that are known"), std::string::npos) << notes.back();
}

TEST_F(CReadRecording, TimesAreInTheUnitThatIsAsked) {
  auto options = io_options();
  options.time_unit = "ms";
  const auto read = read_recording(
      {folder_.file("flight.csv", "id,time,x [m],y [m],z [m]\na,0,1,2,3\na,250,4,5,6\n")},
      &options);
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(read.recording.get()), 2),
            (std::vector<double>{0, 0.25}));
}

TEST_F(CReadRecording, TheirUnitDoesNotSayThatSeveralFilesHaveOneClock) {
  const std::vector<std::string> paths = {
      folder_.file("a.csv", "time,x [m],y [m],z [m]\n0,1,2,3\n250,4,5,6\n"),
      folder_.file("b.csv", "time,x [m],y [m],z [m]\n0,11,2,3\n250,14,5,6\n")};
  auto options = io_options();
  options.time_unit = "ms";
  const auto asked = read_recording(paths, &options);
  EXPECT_NE(asked.code, BEESPACE_OK);
  EXPECT_NE(text_of(asked.error).find("one_clock"), std::string::npos) << text_of(asked.error);
  options.flags = BEESPACE_IO_ONE_CLOCK;
  const auto said = read_recording(paths, &options);
  EXPECT_EQ(said.code, BEESPACE_OK) << text_of(said.error);
}

TEST_F(CReadRecording, ZonesFramesAndPixelsAreAsTheyAreSaid) {
  auto options = io_options();
  options.time_zone = "+02:00";
  const std::string dated = folder_.file(
      "dated.csv", "id,time,x [m],y [m]\na,1970-01-01 02:00:00,1,2\na,1970-01-01 02:00:01,1,2\n");
  const auto zoned = read_recording({dated}, &options);
  ASSERT_EQ(zoned.code, BEESPACE_OK) << text_of(zoned.error);
  EXPECT_EQ(beespace_io_recording_since_1970(zoned.recording.get()), 1);
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(zoned.recording.get()), 2),
            (std::vector<double>{0, 1}));
  const auto bare = read_recording({dated}, nullptr);
  ASSERT_EQ(bare.code, BEESPACE_OK) << text_of(bare.error);
  EXPECT_EQ(beespace_io_recording_since_1970(bare.recording.get()), 0);
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(bare.recording.get()), 2),
            (std::vector<double>{7200, 7201}));
  const std::string either =
      folder_.file("either.csv", "id,time,x [m],y [m]\na,02/01/1970 00:00:00,1,2\n");
  const auto asked = read_recording({either}, nullptr);
  EXPECT_EQ(asked.code, BEESPACE_INVALID_ARGUMENT);
  EXPECT_NE(text_of(asked.error).find("say it with dates day-first"), std::string::npos);
  options.time_zone = "UTC";
  options.dates = "day-first";
  const auto ordered = read_recording({either}, &options);
  ASSERT_EQ(ordered.code, BEESPACE_OK) << text_of(ordered.error);
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(ordered.recording.get()), 1),
            std::vector<double>{86400});
  options = io_options();
  options.fps = 4;
  options.scale = "50cm";
  const auto video = read_recording(
      {folder_.file("video.csv", "frame,id,x,y\n0,a,200,300\n1,a,201,302\n")}, &options);
  ASSERT_EQ(video.code, BEESPACE_OK) << text_of(video.error);
  EXPECT_EQ(numbers_of(beespace_io_recording_times_s(video.recording.get()), 2),
            (std::vector<double>{0, 0.25}));
  EXPECT_EQ(numbers_of(beespace_io_recording_xyz(video.recording.get()), 6),
            (std::vector<double>{100, 150, 0, 100.5, 151, 0}));
  options.fps = -1;
  EXPECT_EQ(read_recording({dated}, &options).code, BEESPACE_INVALID_ARGUMENT);
  options = io_options();
  options.time_zone = "Nowhere";
  EXPECT_EQ(read_recording({dated}, &options).code, BEESPACE_INVALID_ARGUMENT);
  options = io_options();
  options.scale = "long";
  EXPECT_EQ(read_recording({dated}, &options).code, BEESPACE_INVALID_ARGUMENT);
}

// A place of the first frame is sure, of the second one not.
TEST_F(CReadRecording, PlacesOfPosesAreAsLikelyAsIsAsked) {
  const std::string path = folder_.file("mouse.csv",
                                        "scorer,net,net,net\nbodyparts,nose,nose,nose\n"
                                        "coords,x,y,likelihood\n0,10,20,0.99\n1,11,21,0.5\n");
  const auto fixes = [&](double least, std::uint32_t flags) {
    auto options = io_options();
    options.fps = 2;
    options.scale = "1m";
    options.least_likelihood = least;
    options.flags = flags;
    const auto read = read_recording({path}, &options);
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    return beespace_io_recording_fixes(read.recording.get());
  };
  EXPECT_EQ(fixes(0, 0), 1);
  EXPECT_EQ(fixes(0.5, 0), 2);
  EXPECT_EQ(fixes(0.99, 0), 1);
  EXPECT_EQ(fixes(0, BEESPACE_IO_ANY_LIKELIHOOD), 2);
  for (const double wrong : {-0.1, 1.1, static_cast<double>(NAN)}) {
    auto options = io_options();
    options.least_likelihood = wrong;
    EXPECT_EQ(read_recording({path}, &options).code, BEESPACE_INVALID_ARGUMENT);
  }
  auto both = io_options();
  both.least_likelihood = 0.5;
  both.flags = BEESPACE_IO_ANY_LIKELIHOOD;
  EXPECT_EQ(read_recording({path}, &both).code, BEESPACE_INVALID_ARGUMENT);
  both = io_options();
  both.fps = 2;
  both.scale = "1m";
  const auto said = read_recording({path}, &both);
  ASSERT_EQ(said.code, BEESPACE_OK) << text_of(said.error);
  std::string notes;
  for (const auto& note : notes_of(beespace_io_recording_facts(said.recording.get())))
    notes += note;
  EXPECT_NE(notes.find("(least_likelihood)"), std::string::npos) << notes;
}

// A curve has as many lines as it needs to stay that close.
TEST_F(CReadRecording, CurvesOfShowsAreFollowedAsCloselyAsIsAsked) {
  const std::string show = std::string(BEESPACE_SHOWS) + "/ring.skyc";
  const auto fixes = [&](double tolerance_m) {
    auto options = io_options();
    options.tolerance_m = tolerance_m;
    const auto read = read_recording({show}, &options);
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    return beespace_io_recording_fixes(read.recording.get());
  };
  EXPECT_EQ(fixes(0), fixes(0.001));
  EXPECT_LT(fixes(0.1), fixes(0.001));
  auto options = io_options();
  options.tolerance_m = -1;
  EXPECT_EQ(read_recording({show}, &options).code, BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CReadRecording, ArgumentsThatMakeNoSenseAreRefused) {
  auto error = io_error();
  beespace_io_recording* recording = nullptr;
  const char* const paths[] = {"/none", nullptr};
  EXPECT_EQ(beespace_io_read_recording(nullptr, 1, nullptr, &recording, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_read_recording(paths, 0, nullptr, &recording, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_read_recording(paths, 2, nullptr, &recording, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "paths");
  EXPECT_EQ(error.record, 1);
  EXPECT_EQ(beespace_io_read_recording(paths, 1, nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_read_recording(paths, 1, nullptr, &recording, &error),
            BEESPACE_CANNOT_OPEN);
  auto options = io_options();
  options.format = "npy";
  const auto read = read_recording({"/none"}, &options);
  EXPECT_EQ(read.code, BEESPACE_INVALID_ARGUMENT);
  EXPECT_NE(std::strstr(read.error.message, "format is for points"), nullptr);
  EXPECT_EQ(beespace_io_recording_agents(nullptr), 0);
  EXPECT_EQ(beespace_io_recording_fixes(nullptr), 0);
  EXPECT_EQ(beespace_io_recording_ids(nullptr, nullptr), nullptr);
  beespace_io_recording_free(nullptr);
}

}  // namespace
}  // namespace beespace::test
