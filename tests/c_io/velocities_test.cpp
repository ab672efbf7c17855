// Velocities that C reads from files: in metres a second along the axes of the positions, whatever
// the file has, and not made up where it has none.
#include "tests/c_io/test_file.hpp"
#include "tests/io/mavlink/telemetry_making.hpp"

#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kFoot = 0.3048;

// East, north and up at a place, as the textbooks have them.
std::vector<double> earth_centred(double lon_deg, double lat_deg, double east, double north,
                                  double up) {
  const double lon = lon_deg * std::numbers::pi / 180.0;
  const double lat = lat_deg * std::numbers::pi / 180.0;
  const double outwards = up * std::cos(lat) - north * std::sin(lat);
  return {outwards * std::cos(lon) - east * std::sin(lon),
          outwards * std::sin(lon) + east * std::cos(lon),
          up * std::sin(lat) + north * std::cos(lat)};
}

class CVelocities : public testing::Test {
 protected:
  // Fails the test where the file cannot be read.
  static std::vector<double> velocities_of(const ReadRecording& read) {
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    const auto* const r = read.recording.get();
    return numbers_of(beespace_io_recording_velocities(r), 3 * beespace_io_recording_fixes(r));
  }
  static void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
  }
  static bool has_note(const ReadRecording& read, const std::string& part) {
    for (const std::string& note : notes_of(beespace_io_recording_facts(read.recording.get()))) {
      if (note.find(part) != std::string::npos) return true;
    }
    return false;
  }

  TestFolder folder_;
};

TEST_F(CVelocities, OfATableInMetresAreItsNumbers) {
  const auto read = read_recording(
      {folder_.file("flight.csv",
                    "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,-2.5,3\nb,0,9,9,9,0.1,0,-0.25\n"
                    "a,1,1,0,0,4,5,6\n")});
  EXPECT_EQ(velocities_of(read), (std::vector<double>{1, -2.5, 3, 4, 5, 6, 0.1, 0, -0.25}));
  EXPECT_FALSE(has_note(read, "no velocity is known"));
}

TEST_F(CVelocities, NeedNoTime) {
  const auto read = read_recording(
      {folder_.file("st.csv", "id,x,y,z,vx,vy,vz\na,0,0,0,1,0,0\nb,50,0,0,-1,0,0\n")});
  EXPECT_EQ(velocities_of(read), (std::vector<double>{1, 0, 0, -1, 0, 0}));
}

TEST_F(CVelocities, AreInMetresASecondWhateverTheFileHas) {
  const auto read =
      read_recording({folder_.file("flight.csv",
                                   "id,time_s,x [m],y [m],z [m],vx [km/h],vy [km/h],vz [ft/min]\n"
                                   "a,0,0,0,0,36,-18,600\n")});
  expect_near(velocities_of(read), {10, -5, 10 * kFoot});
}

TEST_F(CVelocities, BesideDegreesAreAlongTheAxesOfEcef) {
  const auto read = read_recording(
      {folder_.file("flight.csv",
                    "id,time_s,lon,lat,height_m,ve,vn,vu\na,0,8.5,47.25,500,3,-4,0.5\n"
                    "b,0,-123.4,-33.3,10,0,7,-1\n")});
  std::vector<double> expected = earth_centred(8.5, 47.25, 3, -4, 0.5);
  const std::vector<double> second = earth_centred(-123.4, -33.3, 0, 7, -1);
  expected.insert(expected.end(), second.begin(), second.end());
  expect_near(velocities_of(read), expected);
}

TEST_F(CVelocities, OfSpeedTrackAndClimbRateToo) {
  auto options = io_options();
  options.units = "height=ft,speed=kt,climb=ft/min";
  const auto read =
      read_recording({folder_.file("traffic.csv",
                                   "icao24,time_s,longitude,latitude,altitude,groundspeed,track,"
                                   "vertical_rate\na,0,8.5,47.25,30000,360,60,-1200\n")},
                     &options);
  const double speed = 360 * kKnot;
  const double track = std::numbers::pi / 3;
  expect_near(velocities_of(read), earth_centred(8.5, 47.25, speed * std::sin(track),
                                                 speed * std::cos(track), -20 * kFoot));
}

TEST_F(CVelocities, OfAircraft) {
  const auto read = read_recording({folder_.file(
      "aircraft.json", R"({"now": 1000000.5, "messages": 7, "aircraft": [{"hex":"4B1814",)"
                       R"("alt_geom":10000,"gs":360,"track":90,"geom_rate":600,)"
                       R"("lat":47.25,"lon":8.5,"seen_pos":0}]})")});
  expect_near(velocities_of(read), earth_centred(8.5, 47.25, 360 * kKnot, 0, 10 * kFoot));
}

TEST_F(CVelocities, OfTelemetryLogs) {
  using namespace beespace::io;  // NOLINT(google-build-using-namespace): what makes the log
  const std::string global =
      logged(1'700'000'000'000'000,
             frame_v2(3, 33, global_payload(470'000'000, 80'000'000, 500'000, 100, 200, 300)));
  const auto read = read_recording({folder_.file("flight.tlog", global)});
  expect_near(velocities_of(read), earth_centred(8, 47, 2, 1, -3));
  const std::string local =
      logged(1'700'000'000'000'000, frame_v1(3, 32, local_payload(1, 2, -3, 0.5F, 0.25F, -2)));
  expect_near(velocities_of(read_recording({folder_.file("local.tlog", local)})), {0.25, 0.5, 2});
}

TEST_F(CVelocities, ThatAreNotKnownAsAWholeAreNoNumbersAndCounted) {
  const auto read = read_recording(
      {folder_.file("flight.csv",
                    "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,2,3\na,1,0,0,0,,2,3\na,2,0,0,0,1,2,nan\n"
                    "a,3,0,0,0,,,\n")});
  const std::vector<double> found = velocities_of(read);
  ASSERT_EQ(found.size(), 12U);
  EXPECT_EQ(std::vector<double>(found.begin(), found.begin() + 3), (std::vector<double>{1, 2, 3}));
  for (std::size_t i = 3; i < 12; ++i) EXPECT_TRUE(std::isnan(found[i])) << i;
  EXPECT_TRUE(has_note(read, "no velocity is known of 3 of 4 fixes"));
}

TEST_F(CVelocities, OfSeveralFilesAreThoseOfTheFilesThatHaveSome) {
  const auto read = read_recording(
      {folder_.file("one.csv", "id,time_s,x,y,z\na,0,1,2,3\na,1,1,2,3\n"),
       folder_.file("two.csv", "id,time_s,x,y,z,vx,vy,vz\na,2,1,2,3,4,5,6\nb,0,7,8,9,1,1,1\n")});
  const std::vector<double> found = velocities_of(read);
  ASSERT_EQ(found.size(), 12U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(std::isnan(found[i])) << i;
  EXPECT_EQ(std::vector<double>(found.begin() + 6, found.end()),
            (std::vector<double>{4, 5, 6, 1, 1, 1}));
  EXPECT_TRUE(has_note(read, "no velocity is known of 2 of 4 fixes"));
}

TEST_F(CVelocities, AreNullWhereNoFixHasOne) {
  for (const char* const table :
       {"id,time_s,x,y,z\na,0,1,2,3\n", "id,time_s,x,y,z,vx,vy,vz\na,0,1,2,3,,,\n",
        // How fast it climbs is not known.
        "id,time_s,x,y,z,vx,vy\na,0,1,2,3,4,5\n"}) {
    const auto read = read_recording({folder_.file("flight.csv", table)});
    ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    EXPECT_EQ(beespace_io_recording_velocities(read.recording.get()), nullptr) << table;
  }
  EXPECT_EQ(beespace_io_recording_velocities(nullptr), nullptr);
}

TEST_F(CVelocities, OfPointsAreLeftOutAndThatIsSaid) {
  const auto last_note = [](const ReadPoints& read) {
    EXPECT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    return notes_of(beespace_io_points_facts(read.points.get())).back();
  };
  const std::string path =
      folder_.file("st.csv", "id,x,y,z,vx,vy,vz\na,0,0,0,1,0,0\nb,50,0,0,-1,0,0\n");
  EXPECT_EQ(last_note(read_points(path)),
            "velocities, in columns 5 'vx', 6 'vy', 7 'vz', are left out: points have none; read "
            "the file as a recording for them");
  const std::string traffic =
      folder_.file("traffic.csv", "icao24,lon,lat,height_m,groundspeed,track\na,8,47,500,360,60\n");
  EXPECT_NE(last_note(read_points(traffic)).find("columns 5 'groundspeed', 6 'track', are left"),
            std::string::npos);
  // Neither of a part of it, nor of what is read as a position.
  const std::string part = folder_.file("part.csv", "id,x,y,z,speed\na,0,0,0,1\n");
  EXPECT_EQ(last_note(read_points(part)).find("velocities"), std::string::npos);
  auto options = io_options();
  options.columns = "x=5,y=6,z=7";
  options.frame = "metres";
  EXPECT_EQ(last_note(read_points(path, &options)).find("left out"), std::string::npos);
}

}  // namespace
}  // namespace beespace::test
