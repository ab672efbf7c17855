// Local positions of autopilots, whose origin is that of each vehicle.
#include "io/recording/local_topics.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <string>

namespace beespace::io {
namespace {

std::string of_two(const std::string& one, const std::string& other) {
  std::string text = "id,time_ns,x,y,z\n";
  for (int i = 0; i < 10; ++i) {
    const std::string at = std::to_string(1'718'000'000 + i) + "000000000," + std::to_string(i);
    text += one + "," + at + ",0,2\n" + other + "," + at + ",5,2\n";
  }
  return text;
}

TEST(LocalTopics, OfSeveralVehiclesAreAskedAboutWithoutAColumnOfFrames) {
  for (const std::string topic : {"mavros/local_position/pose", "fmu/out/vehicle_local_position"}) {
    const std::string text = of_two("/uav1/" + topic, "/uav2/" + topic);
    expect_error(record(text), {ErrorCode::kUnknownFrame, "bees.csv:3", "--crs metres"});
    RecordingOptions metres;
    metres.frame = Frame::kMetres;
    EXPECT_EQ(recording_of(record(text, metres)).bees.size(), 2u);
    // One of them alone, and others.
    EXPECT_EQ(recording_of(record(of_two("/uav1/" + topic, "/uav2/gps/pose"))).bees.size(), 2u);
  }
  EXPECT_EQ(recording_of(record(of_two("/uav1/pose", "/uav2/pose"))).bees.size(), 2u);
  EXPECT_TRUE(is_local_to_its_vehicle("uav1_mavros_local_position_pose"));
}

}  // namespace
}  // namespace beespace::io
