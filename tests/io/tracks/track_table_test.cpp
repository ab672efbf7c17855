#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Fixes = std::vector<Fix>;
using Ids = std::vector<std::string>;
using Times = std::vector<double>;

TEST(TrackTable, ReadsBeesByTheNamesOfTheColumns) {
  const auto recording =
      recording_of(record("z,x,y,id,time_s\n3,1,2,a,0\n6,4,5,b,0\n3.5,1,2,a,0.5\n7,4,5,\"b\",1\n"));
  ASSERT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{0, {1, 2, 3}}, {0.5, {1, 2, 3.5}}}));
  EXPECT_EQ(recording.bees[1].fixes, (Fixes{{0, {4, 5, 6}}, {1, {4, 5, 7}}}));
  EXPECT_TRUE(recording.bees[0].velocities.empty());
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_FALSE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "text, comma-separated");
  EXPECT_TRUE(has_note(recording, "times are read from column 5 'time_s' in seconds"));
  EXPECT_TRUE(has_note(recording, "x, y, z are read from column 2 'x', column 3 'y', column 1"));
}

// As states of robots are written; two of them alone may be pixels.
TEST(TrackTable, ThreeAxesWithAPAreAPlace) {
  const auto recording =
      recording_of(record("time_s,id,px,py,pz,vx,vy,vz\n0,a,1,2,3,0,0,0\n1,a,1,2,4,0,0,1\n"));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{0, {1, 2, 3}}, {1, {1, 2, 4}}}));
  EXPECT_FALSE(recording.bees[0].velocities.empty());
  EXPECT_FALSE(record("time_s,id,px,py\n0,a,1,2\n1,a,1,2\n"));
}

TEST(TrackTable, DegreesStayAsTheyAre) {
  const auto recording = recording_of(
      record("id;time_s;lat;lon;alt\na;0;6.3161;-75.5499;1683.7\na;1;6.3162;-75.5499;1684\n"));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{-75.5499, 6.3161, 1683.7}));
}

TEST(TrackTable, EveryUnitOfTimeBecomesSeconds) {
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"time_s", "1.25"},
                                                        {"Time [msec]", "1250"},
                                                        {"timestamp_us", "1250000"},
                                                        {"t_ns", "1250000000"},
                                                        {"t_ms", "1.25e3"},
                                                        {"time_ms", "+1250.0"}}) {
    const auto recording = recording_of(record(name + ",x,y,z\n" + text + ",1,2,3\n"));
    ASSERT_EQ(recording.bees.size(), 1u) << name;
    EXPECT_EQ(times_of(recording.bees[0]), Times{1.25}) << name;
  }
}

TEST(TrackTable, TheCallerMaySayTheUnit) {
  RecordingOptions options;
  options.time_unit = Unit::kMillisecond;
  const auto recording = recording_of(record("time,x,y,z\n1250,1,2,3\n", options));
  EXPECT_EQ(times_of(recording.bees[0]), Times{1.25});
  EXPECT_TRUE(has_note(recording, "in milliseconds, as asked for"));
}

TEST(TrackTable, DatesAreTimesSince1970) {
  const auto recording = recording_of(record(
      "id,time,x,y,z\na,2024-05-01T12:00:00.25Z,1,2,3\na,2024-05-01T14:00:01+02:00,1,2,4\n"));
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(times_of(recording.bees[0]), (Times{1714564800.25, 1714564801}));
  EXPECT_TRUE(has_note(recording, "as dates and times (ISO 8601)"));
}

TEST(TrackTable, UnixTimesAreSince1970Too) {
  const auto recording = recording_of(record("unix_time_s,x,y,z\n1714564800.25,1,2,3\n"));
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(times_of(recording.bees[0]), Times{1714564800.25});
}

TEST(TrackTable, NegativeTimesAreTimes) {
  const auto recording = recording_of(record("time_s,x,y,z\n-2.5,1,2,3\n-1,1,2,3\n0,1,2,3\n"));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{-2.5, -1, 0}));
}

TEST(TrackTable, NumbersAreTheNearestDoubles) {
  const auto recording =
      recording_of(record("time_s,x,y,z\n"
                          "0.1,-75.5499363497,123456789012345.6,1e-20\n"
                          "1714564800.123456,0.30000000000000004,-0.0000001,.5\n"));
  const auto& fixes = recording.bees[0].fixes;
  EXPECT_EQ(fixes[0], (Fix{0.1, {-75.5499363497, 123456789012345.6, 1e-20}}));
  EXPECT_EQ(fixes[1], (Fix{1714564800.123456, {0.30000000000000004, -0.0000001, 0.5}}));
}

TEST(TrackTable, RecordsThatGoBackAreBroughtIntoOrderAndCounted) {
  const auto recording = recording_of(
      record("id,time_s,x,y,z\na,2,3,0,0\na,0,1,0,0\nb,1,9,9,9\na,1,2,0,0\nb,0,8,8,8\n"));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{0, {1, 0, 0}}, {1, {2, 0, 0}}, {2, {3, 0, 0}}}));
  EXPECT_EQ(times_of(recording.bees[1]), (Times{0, 1}));
  EXPECT_TRUE(has_note(recording, "2 records go back in time"));
}

TEST(TrackTable, RepeatedRecordsAreLeftOutAndCounted) {
  const auto recording = recording_of(
      record("id,time_s,x,y,z\na,0,1,2,3\na,0,1,2,3\nb,0,1,2,3\na,1,1,2,3\na,0,1,2,3\n"));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{0, 1}));
  EXPECT_TRUE(has_note(recording, "2 records repeat a time and place of the same bee"));
}

TEST(TrackTable, WithoutIdsTheFileIsTheBee) {
  const auto recording = recording_of(record("time_s,x,y,z\n0,1,2,3\n"));
  EXPECT_EQ(ids_of(recording), Ids{"bees"});
  EXPECT_TRUE(has_note(recording, "there is no id: each file is taken for one bee"));
}

TEST(TrackTable, OfSeveralIdsTheWholeWordIsTakenAndThatIsReported) {
  const auto recording = recording_of(
      record("track_id,time_s,id,callsign,x_m,y_m,z_m\n1,0,a,FOO,1,2,3\n2,0,b,BAR,4,5,6\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_TRUE(has_note(recording, "ids are read from column 3 'id', not from column 1 'track_id'"));
  EXPECT_TRUE(has_note(recording,
                       "how they are called beside from column 4 'callsign'; --columns "
                       "id=4 would take that for the id"));
  EXPECT_EQ(recording.bees[0].label, "FOO");
}

// An aircraft that lands and leaves as another flight.
TEST(TrackTable, OfSeveralFlightsEachIsKnownWithItsTime) {
  const auto recording = recording_of(
      record("time_s,icao24,callsign,x_m,y_m,z_m\n0,3c6444,DLH1,1,2,3\n1,3c6444,,2,2,3\n"
             "2,3c6444,DLH1,3,2,3\n9,3c6444,DLH2,4,2,3\n0,4b1812,SWR5,1,9,3\n"));
  ASSERT_EQ(recording.bees.size(), 2u);
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.label, "DLH1, DLH2");
  ASSERT_EQ(bee.called.size(), 2u);
  EXPECT_EQ(bee.called[0].since_s, 0.0);
  EXPECT_EQ(bee.called[1].label, "DLH2");
  EXPECT_EQ(bee.called[1].since_s, 9.0);
  EXPECT_EQ(recording.bees[1].label, "SWR5");
  EXPECT_TRUE(recording.bees[1].called.empty());
}

// One failed fix is bridged; of two and more in a row the bee is lost.
TEST(TrackTable, FailedFixesInARowAreKept) {
  const auto recording = recording_of(
      record("time_s,id,x_m,y_m,z_m\n0,a,1,2,3\n1,a,NA,NA,NA\n2,a,2,2,3\n3,a,NA,NA,NA\n"
             "4,a,NA,NA,NA\n5,a,3,2,3\n6,a,NA,NA,NA\n7,a,NA,NA,NA\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].lost, (std::vector<TimeSpan>{{2.0, 5.0}}));
  EXPECT_EQ(recording.bees[0].unplaced_until_s, 7.0);
}

TEST(TrackTable, WithoutHeightsTheyAreZero) {
  const auto flat = recording_of(record("id,time_s,x [m],y [m]\na,0,1,2\n"));
  EXPECT_EQ(flat.bees[0].fixes, (Fixes{{0, {1, 2, 0}}}));
  EXPECT_TRUE(has_note(flat, "there is no z: distances are within the plane"));
  const auto globe = recording_of(record("id,time_s,lon,lat\na,0,1,2\n"));
  EXPECT_TRUE(has_note(globe, "there is no height: distances are of the ground"));
}

TEST(TrackTable, TheCallerMaySayTheColumns) {
  const auto recording =
      recording_of(record("a,7,-75.5,6.25,100,1,2,3\n",
                          columns_are("id=1,time=2,lon=3,lat=4,height=5,ve=6,vn=7,vu=8")));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{7, {-75.5, 6.25, 100}}}));
  EXPECT_EQ(recording.bees[0].velocities, (std::vector<Velocity>{{1, 2, 3}}));
}

TEST(TrackTable, TheCallerMaySaySomeColumnsAndTheHeaderTheRest) {
  RecordingOptions options;
  options.columns = "time=when_s,id=who";
  options.time_unit = Unit::kSecond;
  const auto recording = recording_of(record("who,when_s,x,y,z\na,7,1,2,3\n", options));
  EXPECT_EQ(ids_of(recording), Ids{"a"});
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{7, {1, 2, 3}}}));
}

TEST(TrackTable, TabsCarriageReturnsAndByteOrderMarksAreRead) {
  const auto recording = recording_of(
      record("\xEF\xBB\xBFid\ttime_s\tx\ty\tz\r\nfirst bee\t0\t1\t2\t3\r\n\r\nb\t0\t4\t5\t6"));
  EXPECT_EQ(ids_of(recording), (Ids{"first bee", "b"}));
  EXPECT_EQ(recording.format_description, "text, tab-separated");
}

TEST(TrackTable, IdsKeepTheirText) {
  const auto recording = recording_of(record(
      "id,time_s,x,y,z\n007,0,1,2,3\n7,0,1,2,3\n\"a,\"\"b\"\"\",0,1,2,3\n\xC3\xA9,0,1,2,3\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"007", "7", "a,\"b\"", "\xC3\xA9"}));
}

TEST(TrackTable, VelocitiesBesideMetresAreAlongTheAxes) {
  const auto recording =
      recording_of(record("id,time_s,x,y,z,vx,vy,vz\na,0,1,2,3,4,5,6\na,1,5,7,9,,nan,-1.5\n"));
  const auto& velocities = recording.bees[0].velocities;
  ASSERT_EQ(velocities.size(), 2u);
  EXPECT_EQ(velocities[0], (Velocity{4, 5, 6}));
  EXPECT_TRUE(std::isnan(velocities[1].x) && std::isnan(velocities[1].y));
  EXPECT_EQ(velocities[1].z, -1.5);
  EXPECT_TRUE(has_note(recording, "velocities along x, y, z are read from columns 6, 7, 8"));
}

TEST(TrackTable, VelocitiesBesideDegreesAreEastNorthAndUp) {
  const auto up = recording_of(
      record("id,time_s,lon,lat,alt,velocity_north,velocity_east,velocity_up\na,0,1,2,3,4,5,6\n"));
  EXPECT_EQ(up.bees[0].velocities, (std::vector<Velocity>{{5, 4, 6}}));
  const auto down =
      recording_of(record("id,time_s,lon,lat,alt,vel_n,vel_e,vel_d\na,0,1,2,3,4,5,6\n"));
  EXPECT_EQ(down.bees[0].velocities, (std::vector<Velocity>{{5, 4, -6}}));
  EXPECT_TRUE(has_note(down, "velocities east, north, down"));
}

TEST(TrackTable, VelocitiesThatMayMeanAnythingAreLeftOutAndThatIsReported) {
  const auto axes = recording_of(record("id,time_s,lon,lat,alt,vx,vy,vz\na,0,1,2,3,4,5,6\n"));
  EXPECT_TRUE(axes.bees[0].velocities.empty());
  EXPECT_TRUE(has_note(axes,
                       "velocities are not read: beside such positions they must be named "
                       "east and north"));
  const auto lengths = recording_of(record("id,time_s,x,y,z,vx_km,vy_km\na,0,1,2,3,4,5\n"));
  EXPECT_TRUE(lengths.bees[0].velocities.empty());
  EXPECT_TRUE(has_note(lengths, "'vx_km' is in 'km', which is no unit of a speed"));
}

TEST(TrackTable, ClimbRatesAreUnknownWhereTheyAreNotGiven) {
  const auto solid = recording_of(record("id,time_s,x,y,z,vx,vy\na,0,1,2,3,4,5\n"));
  EXPECT_TRUE(std::isnan(solid.bees[0].velocities[0].z));
  EXPECT_TRUE(has_note(solid, "how fast bees climb is not known"));
  const auto flat = recording_of(record("id,time_s,x [m],y [m],vx,vy\na,0,1,2,4,5\n"));
  EXPECT_EQ(flat.bees[0].velocities, (std::vector<Velocity>{{4, 5, 0}}));
}

TEST(TrackTable, VelocitiesFollowTheirFixesIntoTheOrderOfTime) {
  const auto recording =
      recording_of(record("id,time_s,x,y,z,vx,vy,vz\na,1,5,7,9,7,8,9\na,0,1,2,3,4,5,6\n"));
  EXPECT_EQ(recording.bees[0].velocities, (std::vector<Velocity>{{4, 5, 6}, {7, 8, 9}}));
}

TEST(TrackTable, ASnapshotWithVelocitiesNeedsNoTime) {
  const auto recording = recording_of(record("id,x,y,z,vx,vy,vz\na,1,2,3,4,5,6\nb,7,8,9,1,1,1\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(recording.bees[1].fixes, (Fixes{{0, {7, 8, 9}}}));
  EXPECT_EQ(recording.bees[1].velocities, (std::vector<Velocity>{{1, 1, 1}}));
}

TEST(TrackTable, TheBeesOfASnapshotWithoutIdsAreNumberedByTheirRows) {
  const auto recording = recording_of(
      record("x,y,z,vx,vy,vz\n1,2,3,4,5,6\n7,8,?,1,1,1\n7,8,9,1,1,1\n", skipping_bad()));
  EXPECT_EQ(ids_of(recording), (Ids{"0", "2"}));
  EXPECT_TRUE(has_note(recording, "bees are numbered in their order, from 0"));
}

TEST(TrackTable, BadRecordsAreSkippedAndListedWhereThatIsWished) {
  const auto recording = recording_of(record(
      "id,time_s,x,y,z\na,0,1,2,3\na,1,1,oops,3\na,1,1\na,2,5,5,5\na,2,6,6,6\n", skipping_bad()));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{0, 2}));
  EXPECT_EQ(recording.bees[0].fixes[1].position, (Point{5, 5, 5}));
  EXPECT_EQ(recording.skipped_count, 3u);
  ASSERT_EQ(recording.skipped.size(), 3u);
  EXPECT_EQ(to_string(recording.skipped[0]),
            "bees.csv:3:4: 'oops' is not a number (y); correct it");
  EXPECT_EQ(recording.skipped[1].code, ErrorCode::kColumnCount);
  EXPECT_EQ(recording.skipped[2].code, ErrorCode::kTimeOrder);
  EXPECT_EQ(recording.skipped[2].location.line, 6u);
}

TEST(TrackTable, ProgressEndsAtTheTotal) {
  std::string text = "id,time_s,x,y,z\n";
  for (int i = 0; i < 10000; ++i) text += "a," + std::to_string(i) + ",1,2,3\n";
  Progress progress;
  RecordingOptions options;
  options.progress = &progress;
  EXPECT_EQ(recording_of(record(text, options)).bees[0].fixes.size(), 10000u);
  EXPECT_EQ(progress.done, text.size());
  EXPECT_EQ(progress.total, text.size());
}

TEST(TrackTable, TextOfWindowsIsShownAsItWasWritten) {
  const auto recording =
      recording_of(record("id,time_s,x_m,y_m,z_m\nJos\xE9 \x80,0,1,2,3\nZo\xEB,0,1,2,4\n"));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"Jos\u00e9 \u20ac", "Zo\u00eb"}));
  EXPECT_TRUE(has_note(recording, "taken for Windows-1252"));
  const auto utf8 = recording_of(record("id,time_s,x_m,y_m,z_m\nJos\u00e9,0,1,2,3\n"));
  EXPECT_EQ(ids_of(utf8), std::vector<std::string>{"Jos\u00e9"});
  EXPECT_FALSE(has_note(utf8, "Windows"));
}

}  // namespace
}  // namespace beespace::io
