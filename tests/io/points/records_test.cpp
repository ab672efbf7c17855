#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

struct Seen {
  PointId point;
  std::uint64_t row;
  std::string id;
  std::string text;

  friend bool operator==(const Seen&, const Seen&) = default;
};

std::vector<Seen> visited(const Result<LoadedPoints>& loaded, const std::vector<PointId>& ids) {
  std::vector<Seen> seen;
  if (!loaded) return seen;
  for_each_record(loaded.value(), ids, [&seen](const Record& record) {
    seen.push_back({record.point, record.row, std::string(record.id), std::string(record.text)});
  });
  return seen;
}

TEST(Records, ComeAsTheyStandInTheInput) {
  const auto loaded = load_text("x;y;z\r\n\r\n1; 2 ;3\r\n\"4\";5;6\r\n7;8;9");
  ASSERT_EQ(points_of(loaded).size(), 3u);
  EXPECT_EQ(
      visited(loaded, {0, 1, 2}),
      (std::vector<Seen>{{0, 0, "", "1; 2 ;3"}, {1, 1, "", "\"4\";5;6"}, {2, 2, "", "7;8;9"}}));
  EXPECT_EQ(visited(loaded, {2}), (std::vector<Seen>{{2, 2, "", "7;8;9"}}));
  EXPECT_EQ(visited(loaded, {}), std::vector<Seen>());
  EXPECT_EQ(header_line(loaded.value()), "x;y;z");
  EXPECT_EQ(delimiter(loaded.value()), ';');
  EXPECT_FALSE(has_id_column(loaded.value()));
}

TEST(Records, CarryTheirIdColumnUnquoted) {
  const auto loaded = load_text("hex,x_m,y_m,z_m\nabc,1,2,3\n\"d\"\"e\",4,5,6\n \"f,g\" ,7,8,9\n");
  ASSERT_EQ(points_of(loaded).size(), 3u);
  EXPECT_TRUE(has_id_column(loaded.value()));
  const auto seen = visited(loaded, {0, 1, 2});
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_EQ(seen[0].id, "abc");
  EXPECT_EQ(seen[1].id, "d\"e");
  EXPECT_EQ(seen[2].id, "f,g");
}

TEST(Records, CarryTheGeographicPositionAsItWasGiven) {
  std::string text = "lat,lon,alt\n";
  for (int i = 0; i < 100; ++i) text += "6.25,-75.5,1500.125\n";
  const auto loaded = load_text(text);
  ASSERT_EQ(points_of(loaded).size(), 100u);
  int count = 0;
  for_each_record(loaded.value(), {0, 50, 99}, [&count](const Record& record) {
    EXPECT_EQ(record.geographic.longitude_deg, -75.5);
    EXPECT_EQ(record.geographic.latitude_deg, 6.25);
    EXPECT_EQ(record.geographic.height_m, 1500.125);
    ++count;
  });
  EXPECT_EQ(count, 3);
}

TEST(Records, OutliveTheFileTheyCameFrom) {
  const TemporaryFolder folder;
  const std::string path = folder.write("bees.csv", "x,y,z\n1,2,3\n");
  const auto loaded = load_points(path);
  ASSERT_EQ(points_of(loaded).size(), 1u);
  std::filesystem::remove(path);
  EXPECT_EQ(visited(loaded, {0}), (std::vector<Seen>{{0, 0, "", "1,2,3"}}));
}

}  // namespace
}  // namespace beespace::io
