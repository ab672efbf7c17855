// Positions whose unit nothing names, and that would be faster in metres than anything like that;
// and units of columns whose names are not known.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

// Twelve rows, one `step_s` after the other, each so far from the one before.
std::string path_of(const std::string& header, double step_s, int along,
                    const std::string& behind = "") {
  std::string text = header + "\n";
  for (int k = 0; k < 12; ++k) {
    text += std::to_string(k * step_s) + "," + std::to_string(k * along) + ",0,500" + behind + "\n";
  }
  return text;
}

void expect_asked(const std::string& text, const RecordingOptions& options = {}) {
  expect_error(record(text, options),
               {ErrorCode::kInvalidArgument, "bees.csv", "are x, y, z in metres?"});
  for (const Unit unit : {Unit::kCentimetre, Unit::kMillimetre, Unit::kMetre}) {
    RecordingOptions said = options;
    said.units.position = unit;
    EXPECT_TRUE(record(text, said));
  }
}

TEST(DoubtfulMetres, OfShowsAreAskedAbout) {
  expect_asked(path_of("Time,X,Y,Z,R,G,B", 0.5, 100, ",255,0,0"), columns_are(""));
  expect_asked(path_of("Time,X,Y,Z,Color", 0.5, 100, ",#ff0000"), columns_are(""));
  EXPECT_TRUE(record(path_of("Time,X,Y,Z,R,G,B", 0.5, 5, ",255,0,0"), columns_are("")));
  EXPECT_TRUE(record(path_of("Time,x_m,y_m,z_m,R,G,B", 0.5, 100, ",255,0,0"), columns_are("")));
}

TEST(DoubtfulMetres, OfCamerasAndOthersAreAskedAbout) {
  RecordingOptions options;
  options.frames_per_second = 20.0;
  std::string text = "Frame,X,Y,Z\n";
  for (int k = 0; k < 12; ++k) text += std::to_string(k) + "," + std::to_string(k * 10) + ",0,1\n";
  expect_asked(text, options);
  expect_asked(path_of("time_s,x,y,z", 0.5, 500));
  EXPECT_TRUE(record(path_of("time_s,x,y,z", 0.5, 100)));  // an aircraft
}

TEST(UnitsOfNames, ThatAreNotKnownAreHeeded) {
  const auto place = [](const Result<Recording>& loaded) {
    const Recording recording = recording_of(loaded);
    return recording.bees.empty() ? Point() : recording.bees[0].fixes[0].position;
  };
  RecordingOptions options = columns_are("x=3,y=4,z=5", Unit::kUnstated);
  const std::string row = "a,0,100,200,300\n";
  EXPECT_EQ(place(record("id,time_s,posx(cm),posy(cm),posz(cm)\n" + row, options)),
            (Point{1, 2, 3}));
  EXPECT_FALSE(record("id,time_s,posx(px),posy(px),posz(px)\n" + row, options));
  options.columns = "lon=3,lat=4,height=5";
  const std::string in_feet = "id,time_s,lon,lat,altitude_above_seaLevel(feet)\na,0,19,47,1000\n";
  EXPECT_DOUBLE_EQ(place(record(in_feet, options)).z, 304.8);
  EXPECT_DOUBLE_EQ(place(record(in_feet)).z, 304.8);
  EXPECT_EQ(recording_of(record(in_feet)).heights, HeightDatum::kMeanSeaLevel);
  options.columns = "x=3,y=4,z=5,vx=6,vy=7";
  const Recording moving = recording_of(
      record("id,time_s,posx(m),posy(m),posz(m),dx(cm/s),dy(cm/s)\na,0,1,2,3,100,200\n", options));
  EXPECT_EQ(moving.bees[0].velocities[0].y, 2.0);
}

}  // namespace
}  // namespace beespace::io
