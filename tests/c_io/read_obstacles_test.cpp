// Obstacles that C reads from files, as beespace_obstacles_create() takes them.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

struct FreeObstacles {
  void operator()(beespace_io_obstacles* obstacles) const { beespace_io_obstacles_free(obstacles); }
  void operator()(beespace_obstacles* obstacles) const { beespace_obstacles_free(obstacles); }
};

struct ReadObstacles {
  std::unique_ptr<beespace_io_obstacles, FreeObstacles> obstacles;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
};

ReadObstacles read_obstacles(const std::string& path) {
  ReadObstacles read;
  beespace_io_obstacles* obstacles = nullptr;
  read.code = beespace_io_read_obstacles(path.c_str(), &obstacles, &read.error);
  read.obstacles.reset(obstacles);
  return read;
}

class CReadObstacles : public testing::Test {
 protected:
  TestFolder folder_;
};

constexpr const char* kAll =
    R"({"obstacles": [{"kind": "sphere", "center": [1, 2, 3], "radius_m": 4},)"
    R"({"kind": "box", "low": [0, 1, 2], "high": [3, 4, 5]}, {"kind": "ground", "height_m": -7},)"
    R"({"kind": "cylinder", "center": [5, 6], "radius_m": 1, "high_m": 40},)"
    R"({"kind": "prism", "outline": [[0, 0], [4, 0], [0, 3]], "low_m": -1}]})";

TEST_F(CReadObstacles, OfEachKindAreWhatTheFileSays) {
  for (const std::string& path :
       {folder_.file("all.json", kAll), folder_.gzip_file("all.json.gz", kAll)}) {
    const auto read = read_obstacles(path);
    ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
    ASSERT_EQ(beespace_io_obstacles_count(read.obstacles.get()), 5);
    const beespace_obstacle* const all = beespace_io_obstacles_list(read.obstacles.get());
    EXPECT_EQ(all[0].kind, BEESPACE_SPHERE);
    EXPECT_EQ(numbers_of(all[0].center, 3), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(all[0].radius_m, 4);
    EXPECT_EQ(all[1].kind, BEESPACE_BOX);
    EXPECT_EQ(numbers_of(all[1].low, 3), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(numbers_of(all[1].high, 3), (std::vector<double>{3, 4, 5}));
    EXPECT_EQ(all[2].kind, BEESPACE_GROUND);
    EXPECT_EQ(all[2].high[2], -7);
    EXPECT_EQ(all[3].kind, BEESPACE_CYLINDER);
    EXPECT_EQ(numbers_of(all[3].center, 2), (std::vector<double>{5, 6}));
    EXPECT_EQ(all[3].flags, static_cast<std::uint32_t>(BEESPACE_HIGHEST));
    EXPECT_EQ(all[3].high[2], 40);
    EXPECT_EQ(all[4].kind, BEESPACE_PRISM);
    EXPECT_EQ(all[4].flags, static_cast<std::uint32_t>(BEESPACE_LOWEST));
    EXPECT_EQ(all[4].low[2], -1);
    EXPECT_EQ(numbers_of(all[4].outline, 2 * all[4].corners),
              (std::vector<double>{0, 0, 4, 0, 0, 3}));
    beespace_obstacles* made = nullptr;
    EXPECT_EQ(beespace_obstacles_create(all, 5, &made, nullptr), BEESPACE_OK);
    const std::unique_ptr<beespace_obstacles, FreeObstacles> keep(made);
    EXPECT_EQ(beespace_obstacles_size(made), 5);
  }
}

TEST_F(CReadObstacles, MayBeNone) {
  const auto read = read_obstacles(folder_.file("none.json", R"({"obstacles": []})"));
  ASSERT_EQ(read.code, BEESPACE_OK) << text_of(read.error);
  EXPECT_EQ(beespace_io_obstacles_count(read.obstacles.get()), 0);
  EXPECT_EQ(beespace_io_obstacles_list(read.obstacles.get()), nullptr);
  EXPECT_EQ(beespace_io_obstacles_count(nullptr), 0);
  EXPECT_EQ(beespace_io_obstacles_list(nullptr), nullptr);
}

TEST_F(CReadObstacles, ThatAreNoneAreNamed) {
  const std::string box =
      folder_.file("box.json", R"({"obstacles": [{"kind": "ground", "height_m": 0},)"
                               R"({"kind": "box", "low": [9, 0, 0], "high": [1, 1, 1]}]})");
  const auto upside_down = read_obstacles(box);
  EXPECT_EQ(upside_down.code, BEESPACE_MALFORMED_RECORD);
  EXPECT_EQ(upside_down.error.file, box);
  EXPECT_NE(std::strstr(upside_down.error.message, "obstacles[1]"), nullptr);
  const auto unknown = read_obstacles(
      folder_.file("cone.json", R"({"obstacles": [{"kind": "cone", "radius_m": 1}]})"));
  EXPECT_EQ(unknown.code, BEESPACE_UNSUPPORTED_FORMAT);
  EXPECT_NE(std::strstr(unknown.error.message, "obstacles[0].kind"), nullptr);
  EXPECT_EQ(read_obstacles(folder_.path("none")).code, BEESPACE_CANNOT_OPEN);
  auto error = io_error();
  beespace_io_obstacles* obstacles = nullptr;
  EXPECT_EQ(beespace_io_read_obstacles(nullptr, &obstacles, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_read_obstacles(box.c_str(), nullptr, &error), BEESPACE_INVALID_ARGUMENT);
}

TEST_F(CReadObstacles, AreAskedForByTheNameOfTheFunction) {
  const std::string path = folder_.file("all.json", kAll);
  const auto points = read_points(path);
  EXPECT_NE(std::strstr(points.error.message, "read it as obstacles"), nullptr);
  EXPECT_EQ(std::strstr(points.error.message, "'beespace"), nullptr) << points.error.message;
  const auto recording = read_recording({path});
  EXPECT_NE(std::strstr(recording.error.message, "read it as obstacles"), nullptr);
  EXPECT_EQ(std::strstr(recording.error.message, "'beespace"), nullptr);
}

}  // namespace
}  // namespace beespace::test
