// Places that are none, and places where nothing can be so fast.
#include "io/stream_recording.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kDegrees = "id,time_s,lon,lat,height_m\n";

// A bee that moves 1 m a second or so, and one that is elsewhere at 3 s.
std::string with_place(const std::string& at_3_s) {
  std::string text = kDegrees;
  for (int t = 0; t < 8; ++t) {
    text += "a," + std::to_string(t) + ",8.5000" + std::to_string(t) + ",47,100\n";
    text += "b," + std::to_string(t) + "," + (t == 3 ? at_3_s : "8.6,47,100") + "\n";
  }
  return text;
}

Recording streamed(const std::string& text) {
  const TemporaryFolder folder;
  auto stream = RecordingStream::open({folder.write("bees.csv", text)}, {}, 64);
  EXPECT_TRUE(stream.has_value());
  std::vector<StreamedFix> fixes;
  do {
    EXPECT_TRUE(stream->next(fixes));
    for (const StreamedFix& fix : fixes) EXPECT_NE(fix.fix.position.y, 0.0);
  } while (!fixes.empty());
  return recording_of(stream->finish(0));
}

TEST(ZeroPlaces, AreLeftOutAndCounted) {
  for (const char* const zero : {"0,0,0", "0.0,-0.0,100", "-180,-90,0"}) {
    const auto read = recording_of(record(with_place(zero)));
    EXPECT_EQ(read.missing.count, 1u) << zero;
    EXPECT_EQ(read.missing.jumping, 0u) << zero;
    EXPECT_EQ(times_of(read.bees[1]), (std::vector<double>{0, 1, 2, 4, 5, 6, 7})) << zero;
    EXPECT_TRUE(has_note(read, "1 record at longitude 0 and latitude 0 exactly")) << zero;
    EXPECT_EQ(streamed(with_place(zero)).missing.count, 1u) << zero;
  }
}

// As of empty places: two in a row, or more, are a gap.
TEST(ZeroPlaces, AndBadOnesInARowMakeTheTrackUnknown) {
  RecordingOptions skip;
  skip.skip_bad = true;
  for (const char* const none : {"0,0,0", "No Fix,No Fix,1", "8.6,97,1"}) {
    std::string text = kDegrees;
    for (int t = 0; t < 8; ++t) {
      text += "b," + std::to_string(t) + "," + (t == 3 || t == 4 ? none : "8.6,47,100") + "\n";
    }
    const Recording read = recording_of(record(text, skip));
    ASSERT_EQ(read.bees[0].lost.size(), 1u) << none;
    EXPECT_EQ(read.bees[0].lost[0].begins_s, 2.0);
    EXPECT_EQ(read.bees[0].lost[0].ends_s, 5.0);
  }
}

TEST(ZeroPlaces, AreKeptWhereOthersAreNear) {
  const auto read = recording_of(
      record(kDegrees + "a,0,0,0,100\na,1,0.00001,0,100\nb,0,0.5,-0.5,100\nb,1000,0,0,100\n"));
  EXPECT_TRUE(read.missing.none());
  EXPECT_EQ(read.bees[0].fixes.size() + read.bees[1].fixes.size(), 4u);
}

TEST(ZeroPlaces, ABeeThatIsNowhereElseIsKnownNowhere) {
  const auto read = recording_of(record(with_place("8.6,47,1") + "c,0,0,0,0\nc,1,0,0,0\n"));
  EXPECT_EQ(ids_of(read), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(read.missing.nowhere_ids, std::vector<std::string>{"c"});
  const auto none = record(kDegrees + "c,0,0,0,0\nc,1,0,0,0\n");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kNoPoints);
}

TEST(ZeroPlaces, OfMetresIsAPlace) {
  EXPECT_TRUE(recording_of(record("id,time_s,x_m,y_m\na,0,0,0\nb,0,5,5\n")).missing.none());
}

// One that goes on by 10 mm each 0.1 s, and is at 0, 0 in these records.
std::string with_zeros(std::size_t begin, std::size_t end, const std::string& zero = "0,0.0,-0.0") {
  std::string text = "id,time_s,x_m,y_m,z_m\n";
  for (std::size_t i = 0; i < 30; ++i) {
    text += "a," + std::to_string(i) + "," +
            (i >= begin && i < end ? zero : "3." + std::to_string(10 + i) + ",2,1") + "\n";
  }
  return text;
}

TEST(ZeroRuns, ThatABeeOnlyJumpsToAreLeftOutAndCounted) {
  for (const auto& [begin, end] : {std::pair{0, 3}, std::pair{5, 6}, std::pair{5, 9}}) {
    const auto read = recording_of(
        record(with_zeros(static_cast<std::size_t>(begin), static_cast<std::size_t>(end))));
    EXPECT_EQ(read.bees[0].fixes.size(), 30u - static_cast<std::size_t>(end - begin)) << begin;
    EXPECT_EQ(read.missing.count, static_cast<std::uint64_t>(end - begin)) << begin;
    EXPECT_TRUE(has_note(read, "at 0, 0, 0 exactly, or at one number for all coordinates"));
  }
  EXPECT_EQ(recording_of(record(with_zeros(27, 30))).missing.count, 3u);
}

TEST(ZeroRuns, AtOneNumberForAllCoordinatesAreLeftOutLikewise) {
  for (const char* const none : {"-1,-1,-1", "-999,-999,0", "9999,9999,9999"}) {
    const auto read = recording_of(record(with_zeros(5, 9, none)));
    EXPECT_EQ(read.missing.count, 4u) << none;
    EXPECT_EQ(read.missing.jumping, 0u) << none;
  }
  // Somewhere else for a while, and back, is known for what it is.
  const auto other = recording_of(record(with_zeros(5, 9, "-999,-998,0")));
  EXPECT_FALSE(has_note(other, "at one number for all coordinates"));
  EXPECT_EQ(other.missing.jumping, 1u);
}

// What a stream says at its end; its fixes are of no account.
Result<Recording> at_the_end_of_a_stream(const std::string& text) {
  const TemporaryFolder folder;
  auto stream = RecordingStream::open({folder.write("bees.csv", text)}, {}, 64);
  EXPECT_TRUE(stream.has_value());
  std::vector<StreamedFix> fixes;
  do {
    EXPECT_TRUE(stream->next(fixes));
  } while (!fixes.empty());
  return stream->finish(0);
}

TEST(ZeroRuns, OfAStreamAreRefusedAsTheyCannotBeLeftOut) {
  for (const auto& [begin, end] :
       {std::pair{0, 3}, std::pair{5, 6}, std::pair{5, 9}, std::pair{27, 30}}) {
    const auto read = at_the_end_of_a_stream(
        with_zeros(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)));
    ASSERT_FALSE(read) << begin;
    EXPECT_EQ(read.error().location.line, static_cast<std::uint64_t>(begin + 2)) << begin;
    EXPECT_NE(read.error().message.find("cannot be left out with --memory"), std::string::npos)
        << read.error().message;
  }
  EXPECT_TRUE(at_the_end_of_a_stream(with_zeros(0, 2)));
  EXPECT_TRUE(at_the_end_of_a_stream(with_zeros(9, 30)));
  EXPECT_TRUE(at_the_end_of_a_stream(with_zeros(5, 9, "0,0,0.001")));
}

TEST(TextOfWindows, IsReadByAStreamAsItWasWritten) {
  std::string text =
      "id,time_s,x_m,y_m,z_m,ma\xF1"
      "ana\n";
  for (int t = 0; t < 20; ++t) text += "Jos\xE9," + std::to_string(t) + ",1,2,3,\xE1\n";
  const Recording recording = recording_of(at_the_end_of_a_stream(text));
  EXPECT_EQ(ids_of(recording), std::vector<std::string>{"Jos\u00e9"});
  EXPECT_TRUE(has_note(recording, "taken for Windows-1252"));
}

TEST(ZeroRuns, PlacesThereAreKept) {
  // At an end a record or two tell little; neither do a few others.
  EXPECT_TRUE(recording_of(record(with_zeros(0, 2))).missing.none());
  EXPECT_TRUE(recording_of(record(with_zeros(9, 30))).missing.none());
  EXPECT_TRUE(recording_of(record(with_zeros(5, 9, "0,0,0.001"))).missing.none());
  // Where it goes through as fast as ever.
  std::string through = "id,time_s,x_m,y_m,z_m\n";
  for (int i = -15; i < 15; ++i) {
    through += "a," + std::to_string(i) + "," + std::to_string(i) + ",0,0\n";
  }
  EXPECT_EQ(recording_of(record(through)).bees[0].fixes.size(), 30u);
}

// One that moves by `step` a record, ten a second, and is said to be at one place in [begin, end).
std::string with_a_frozen_pose(int begin, int end, const std::string& header = "id,time_s,x_m,y_m",
                               const std::string& more = "", double step = 0.05) {
  std::string text = header + "\n";
  for (int i = 0; i < 100; ++i) {
    const int at = i >= begin && i < end ? begin : i;
    text += "a," + std::to_string(i / 10) + "." + std::to_string(i % 10) + "," +
            std::to_string(2.0 + step * at) + ",1" + more + "\n";
  }
  return text;
}

TEST(FrozenPlaces, FromWhichABeeJumpsAreLeftOutAndCounted) {
  for (const auto& [begin, end] : {std::pair{40, 90}, std::pair{0, 30}, std::pair{60, 75}}) {
    const auto text = with_a_frozen_pose(begin, end);
    const auto read = recording_of(record(text));
    EXPECT_EQ(read.missing.count, static_cast<std::uint64_t>(end - begin - 1)) << begin;
    EXPECT_EQ(read.bees[0].fixes.size(), 101u - static_cast<std::size_t>(end - begin)) << begin;
    EXPECT_TRUE(has_note(read, "repeat a place exactly, from which the bee then jumps"));
    EXPECT_TRUE(read.bees[0].unplaced_from_s);
    const auto streamed = at_the_end_of_a_stream(text);
    ASSERT_FALSE(streamed) << begin;
    EXPECT_EQ(streamed.error().location.line, static_cast<std::uint64_t>(end + 2)) << begin;
  }
  // Who says that it moves, slowly, too.
  EXPECT_EQ(recording_of(record(with_a_frozen_pose(40, 90, "id,time_s,x_m,y_m,vx,vy", ",0.5,0")))
                .missing.count,
            49u);
}

TEST(FrozenPlaces, OfWhatStandsAndOfRoundedPlacesAreKept) {
  const auto kept = [](const std::string& text) {
    EXPECT_EQ(recording_of(record(text)).bees[0].fixes.size(), 100u) << text;
    EXPECT_TRUE(at_the_end_of_a_stream(text)) << text;
  };
  // To the end: nothing tells. For half a second, or as it says itself.
  kept(with_a_frozen_pose(40, 100));
  kept(with_a_frozen_pose(40, 45));
  // One that stands, without any noise, and goes on as it came.
  std::string stands = "id,time_s,x_m,y_m\n";
  // Rounded to a metre, while it moves by 0.05 m a record: it stands for two seconds each time.
  std::string rounded = stands;
  // Held until the next place is known, for a second or two.
  std::string held = stands;
  for (int i = 0; i < 100; ++i) {
    const std::string time = "a," + std::to_string(i / 10) + "." + std::to_string(i % 10) + ",";
    stands += time + std::to_string(0.05 * std::min(i, std::max(40, i - 40))) + ",1\n";
    rounded += time + std::to_string(i / 20) + ",1\n";
    held += time + std::to_string(0.5 * (i / 10 - (i / 30 == 1 ? i / 10 % 2 : 0))) + ",1\n";
  }
  kept(stands);
  kept(rounded);
  kept(held);
  EXPECT_EQ(recording_of(record(with_a_frozen_pose(40, 90, "id,time_s,x_m,y_m,vx,vy", ",0,0")))
                .bees[0]
                .fixes.size(),
            100u);
}

TEST(JumpsOfTracks, AreSaidAndNotKnown) {
  const auto read = recording_of(record(with_place("8.9,47,100")));
  EXPECT_EQ(read.missing.jumping_ids, std::vector<std::string>{"b"});
  EXPECT_FALSE(read.missing.none());
  EXPECT_TRUE(has_note(read, "bee 'b' jumps to where it is in bees.csv, line 9, 3.00 s"));
  EXPECT_EQ(streamed(with_place("8.9,47,100")).missing.jumping, 1u);
  // 750 m in a second is possible.
  EXPECT_TRUE(recording_of(record(with_place("8.61,47,100"))).missing.none());
}

// The record there is no place; without a way back both are.
TEST(JumpsOfTracks, ToAndFroWithinAMinuteAreLeftOutAndLost) {
  const auto read = recording_of(record(with_place("8.9,47,100")));
  EXPECT_EQ(times_of(read.bees[1]), (std::vector<double>{0, 1, 2, 4, 5, 6, 7}));
  EXPECT_EQ(read.bees[1].lost, (std::vector<TimeSpan>{{2.0, 4.0}}));
  EXPECT_EQ(read.missing.count, 1u);
  EXPECT_TRUE(has_note(read, "1 record to which its bee jumps, and back from there"));
  std::string text = kDegrees;
  for (int t = 0; t < 8; ++t) {
    text += "b," + std::to_string(t) + (t < 3 ? ",8.6" : ",8.9") + ",47,100\n";
  }
  const auto away = recording_of(record(text));
  EXPECT_EQ(away.bees[0].fixes.size(), 8u);
  EXPECT_EQ(away.missing.jumping, 1u);
  EXPECT_EQ(away.missing.count, 0u);
}

// Motion capture takes one body for another for a while.
TEST(JumpsOfTracks, AwayAndBackAreLeftOutAndLost) {
  const auto with_height = [](const std::string& away, const std::string& header) {
    std::string text = header + "\n";
    for (int i = 0; i < 100; ++i) {
      const std::string at = std::to_string(i / 2) + (i % 2 == 0 ? "0" : "5");
      text += "a," + std::to_string(100 + i) + ",1." + (at.size() < 3 ? "0" : "") + at + ",2," +
              (i >= 40 && i < 50 ? away : "1") + "\n";
    }
    return text;
  };
  const std::string table = with_height("31", "id,time_ms,x_m,y_m,z_m");
  const auto read = recording_of(record(table));
  EXPECT_EQ(read.bees[0].fixes.size(), 90u);
  EXPECT_EQ(read.missing.count, 10u);
  EXPECT_EQ(read.missing.jumping, 1u);
  EXPECT_EQ(read.bees[0].lost.size(), 1u);
  EXPECT_TRUE(has_note(read, "there and back, than it ever moves elsewhere"));
  EXPECT_EQ(streamed(table).missing.jumping, 1u);
  // Heights of aircraft go in steps.
  const auto of_aircraft = recording_of(record(with_height("31", "icao24,time_ms,x_m,y_m,z_m")));
  EXPECT_TRUE(of_aircraft.of_aircraft);
  EXPECT_EQ(of_aircraft.missing.jumping, 0u);
}

void expect_one_left_out(const std::string& header, const std::string& good,
                         const std::string& bad) {
  std::string text = header + "\n";
  for (int t = 0; t < 5; ++t) {
    text += "a," + std::to_string(t) + ",8.5,47,100," + (t == 2 ? bad : good) + "\n";
  }
  const auto read = recording_of(record(text));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 1, 3, 4})) << header << " " << bad;
  EXPECT_EQ(read.missing.count, 1u) << header << " " << bad;
  EXPECT_TRUE(has_note(read, "1 record of receivers that say that they had no fix")) << header;
}

TEST(FixQuality, OfReceiversIsLookedAt) {
  const std::string columns = "id,time_s,lon,lat,height_m,";
  expect_one_left_out(columns + "status.status", "0", "-1");
  expect_one_left_out(columns + "field.status.status", "2", "-1");
  expect_one_left_out(columns + "Status,NSats,HDop", "3,9,1.2", "1,9,99");
  expect_one_left_out(columns + "fix_type", "3", "0");
  expect_one_left_out(columns + "GPS_RAW_INT.fix_type", "2", "1");
  expect_one_left_out(columns + "gps:fix-type", "3D", "no fix");
  expect_one_left_out(columns + "fix", "1", "0");
  for (const char* const name :
       {"Fix Status", "fix_status", "gps-fix-status", "GPS Fix Attempt", "FixType", "Status"}) {
    for (const char* const none : {"No Fix", "Not fixed", "0D"}) {
      expect_one_left_out(columns + name, "3D Fix", none);
    }
  }
  for (const char* const none : {"Failed", "GPS timeout", "Unresolved QFP", "Invalid"}) {
    expect_one_left_out(columns + "GPS Fix Attempt", "Succeeded (3D)", none);
    expect_one_left_out(columns + "FixType", "val. GPS-3D", none);
  }
  expect_one_left_out(columns + "eobs:status", "A", "D");
  // What is not known is asked about.
  expect_error(record(columns + "Fix Status\na,0,8,47,100,3D Fix\na,1,8,47,100,Perhaps\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:6", "'Perhaps' is not known"});
  // Any other status says something else.
  EXPECT_TRUE(recording_of(record(columns + "status\na,0,8,47,100,0\n")).missing.none());
}

TEST(Heights, WithoutAUnitAreAskedAboutWhereNothingFliesSoHigh) {
  const auto at = [](const std::string& name, const std::string& height) {
    return "id,time_s,lon,lat," + name + "\na,0,8,47," + height + "\na,1,8,47," + height + "\n";
  };
  expect_error(record(at("Altitude", "35000")),
               {ErrorCode::kInvalidArgument, "bees.csv", "heights go up to 35000, but no unit"});
  EXPECT_TRUE(recording_of(record(at("Altitude", "20000"))).missing.none());
  EXPECT_TRUE(recording_of(record(at("Altitude [m]", "35000"))).missing.none());
  RecordingOptions options;
  options.units.spoken_of = "--separation enroute";
  expect_error(record(at("Altitude", "900"), options),
               {ErrorCode::kInvalidArgument, "bees.csv:1:5",
                "column 5 'Altitude' holds the height, but in which unit? --separation enroute "
                "speaks of aviation, where it may be ft or m"});
  EXPECT_TRUE(recording_of(record(at("Altitude [m]", "900"), options)).missing.none());
  options.units.height = Unit::kFoot;
  EXPECT_DOUBLE_EQ(
      recording_of(record(at("Altitude", "1000"), options)).bees[0].fixes[0].position.z, 304.8);
}

// Two that stand 3 km apart, and are heard in turn.
std::string in_turn(const std::string& header, const std::string& one, const std::string& other) {
  std::string text = header + ",time_s,lon,lat\n";
  for (int t = 0; t < 20; ++t) {
    text += (t % 2 == 0 ? one : other) + "," + std::to_string(600 * t) +
            (t % 2 == 0 ? ",8.5,47.000" : ",8.54,47.000") + std::to_string(t) + "\n";
  }
  return text;
}

TEST(Columns, AnIdThatIsNotUnderstoodIsAskedFor) {
  for (const char* const header : {"Wirt", "Sender", "track"}) {
    expect_error(
        record(in_turn(header, "Anna", "Clara")),
        {ErrorCode::kMissingColumn, "bees.csv:1",
         "but column 1 '" + std::string(header) +
             "' ('Anna', 'Clara') may: taken for one "
             "bee, the records go to and fro between its values; say --columns id=1, or, if "
             "all are of one bee, --columns time=2,lon=3,lat=4"});
  }
  expect_error(record(in_turn("track", "1", "2")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "id=1"});
  RecordingOptions options;
  options.columns = "id=1";
  EXPECT_EQ(recording_of(record(in_turn("Wirt", "Anna", "Clara"), options)).bees.size(), 2u);
  options.columns = "time=2,lon=3,lat=4";
  EXPECT_EQ(recording_of(record(in_turn("Wirt", "Anna", "Clara"), options)).bees.size(), 1u);
}

TEST(Columns, WhatABeeDoesIsNoId) {
  std::string text = "behaviour,time_s,lon,lat\n";
  for (int t = 0; t < 40; ++t) {
    text += std::string(t / 2 % 2 == 0 ? "flies" : "walks") + "," + std::to_string(t) +
            ",8.5,47.00" + std::to_string(10 + t) + "\n";
  }
  EXPECT_EQ(ids_of(recording_of(record(text))), std::vector<std::string>{"bees"});
}

TEST(Columns, WordsOfManyForIds) {
  for (const char* const name :
       {"AnimalID", "TagID", "DeviceID", "TrackID", "trackId", "CollarID", "collar", "particle",
        "ring", "band", "mouse", "sysid", "trajectory", "Tier"}) {
    EXPECT_EQ(recording_of(record(in_turn(name, "1", "2"))).bees.size(), 2u) << name;
  }
}

TEST(Columns, DegreesAreNotTakenForMetres) {
  const std::string table = "id,time_s,location-long,location-lat\na,0,8.5,47\nb,0,8.6,47\n";
  expect_error(record(table, columns_are("x=location-long,y=location-lat")),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "x is in metres, but column 3 'location-long' is a longitude; write lon=...,lat="});
  EXPECT_EQ(recording_of(record(table, columns_are("lon=3,lat=4"))).frame, Frame::kWgs84);
  RecordingOptions lengths = columns_are("x=3,y=4");
  lengths.frame = Frame::kMetres;
  EXPECT_EQ(recording_of(record(table, lengths)).frame, Frame::kMetres);
}

TEST(Columns, ARecordWithoutAnAnimalIsMissing) {
  const auto read =
      recording_of(record("timestamp,location-long,location-lat,individual-local-identifier\n"
                          "2024-05-01 10:00:00.000,8.9,47,A\n2024-05-01 10:00:00.000,8.8,47,\n"));
  EXPECT_EQ(read.missing.without_id, 1u);
  EXPECT_FALSE(read.missing.none());
}

TEST(FixQuality, WhoIsMissingInAPictureOfTRexIsKnownNowhereThen) {
  const auto read = recording_of(
      record("frame,missing,time,X (cm),Y (cm)\n0,0,0,1,1\n1,1,0.1,9,9\n2,0,0.2,1,1\n"));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 0.2}));
  EXPECT_TRUE(has_note(read, "1 record without a place"));
}

// As spreadsheets and statistics write that there is nothing.
TEST(UnknownPlaces, AreSaidInManyWays) {
  for (const std::string nothing : {"", "NA", "nan", "#N/A", ".", "-", "--"}) {
    const auto recording = recording_of(load_recording_from_memory(
        "id,time_s,x,y\na,0,-1,2000\na,1," + nothing + "," + nothing + "\na,2,-.5,4000\n",
        "bees.csv", {}));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << nothing;
    EXPECT_TRUE(has_note(recording, "1 record without a place")) << nothing;
  }
}

TEST(UnknownPlaces, HalfAPlaceIsNone) {
  for (const std::string place : {"1,NA,3", "NA,2,3", "1,2,NA", "1,,"}) {
    const auto recording =
        recording_of(record("id,time_s,x_m,y_m,z_m\na,0,1,2,3\na,1," + place + "\na,2,1,2,3\n"));
    EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{0, 2})) << place;
    EXPECT_TRUE(has_note(recording, "1 record with half a place")) << place;
    EXPECT_EQ(recording.missing.count, 1u) << place;
  }
}

TEST(SameTracks, AreSaid) {
  std::string text = "id,time_s,x_m,y_m\n";
  for (int t = 0; t < 5; ++t) {
    const std::string place = "," + std::to_string(t) + "," + std::to_string(3 * t) + ",";
    text += "a" + place + "1\nb" + place + "2\nc" + place + "1\n";
  }
  EXPECT_TRUE(has_note(recording_of(record(text)), "'a' and 'c' have the same track, so that"));
  text += "c,5,30,1\n";
  EXPECT_FALSE(has_note(recording_of(record(text)), "have the same track"));
}

}  // namespace
}  // namespace beespace::io
