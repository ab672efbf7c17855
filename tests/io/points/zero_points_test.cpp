// Points where no place is known, and eastings of several zones: as recordings have them.
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include "io/load_points.hpp"
#include "io/stream_points.hpp"

#include <optional>
#include <string>

namespace beespace::io {
namespace {

const std::string kZeroHeader = "id,lon,lat,height\n";

Result<LoadedPoints> points_in(const std::string& text, bool skip_bad = false) {
  LoadOptions options;
  options.skip_bad = skip_bad;
  return load_points_from_memory(text, "bees.csv", options);
}

TEST(ZeroPoints, AreNoPlacesWhereNothingElseIsNear) {
  for (const std::string zero : {"0,0", "0.0,-0", "-180,-90"}) {
    const std::string text =
        kZeroHeader + "a,8,47,500\nb," + zero + ",0\nc," + zero + ",0\nd,8.1,47,500\n";
    const auto loaded = points_in(text);
    ASSERT_FALSE(loaded) << zero;
    EXPECT_EQ(loaded.error().location.line, 3u);
    EXPECT_EQ(loaded.error().location.column, 2u);
    EXPECT_NE(loaded.error().message.find("are written where no place is known"), std::string::npos)
        << loaded.error().message;
    const auto skipped = points_in(text, true);
    ASSERT_TRUE(skipped) << skipped.error().message;
    EXPECT_EQ(skipped->points.size(), 2u);
    EXPECT_EQ(skipped->skipped_count, 2u);
    std::string ids;
    for_each_record(*skipped, {0, 1}, [&ids](const Record& record) { ids += record.id; });
    EXPECT_EQ(ids, "ad");
  }
}

TEST(ZeroPoints, ArePlacesWhereOthersAreNear) {
  EXPECT_TRUE(points_in(kZeroHeader + "a,0,0,0\nb,0.5,0.5,0\n"));
  EXPECT_TRUE(points_in(kZeroHeader + "a,-180,-90,0\nb,20,-89.5,0\n"));
  EXPECT_FALSE(points_in(kZeroHeader + "a,0,0,0\nb,2,0.5,0\n"));
  EXPECT_FALSE(points_in(kZeroHeader + "a,0,0,0\nb,0,2,0\n"));
  EXPECT_TRUE(points_in("id,x_m,y_m\na,0,0\nb,1000000,5\n"));
}

TEST(ZeroPoints, AreNoneOfALargeFileEither) {
  const TemporaryFolder folder;
  const std::string path = folder.write("bees.csv", kZeroHeader + "a,8,47,500\nb,0,0,0\n");
  for (const bool skip_bad : {false, true}) {
    LoadOptions options;
    options.skip_bad = skip_bad;
    auto stream = PointStream::open(path, options, 1U << 20U);
    ASSERT_TRUE(stream) << stream.error().message;
    ASSERT_TRUE(stream->next());
    const auto end = stream->next();
    ASSERT_FALSE(end);
    EXPECT_EQ(end.error().location.line, 3u);
    EXPECT_NE(end.error().message.find("are written where no place is known"), std::string::npos);
  }
}

TEST(ZonesOfPoints, MustBeOne) {
  const std::string header = "id,easting,northing,utm_zone\n";
  const auto one = points_in(header + "a,500000,5200000,32N\nb,500010,5200000,32T\n");
  ASSERT_TRUE(one) << one.error().message;
  ASSERT_FALSE(one->notes.empty());
  EXPECT_NE(one->notes.front().find("of UTM zone '32n', all of them"), std::string::npos)
      << one->notes.front();
  const std::string text = header + "a,500000,5200000,32N\n\nb,500010,5200000,33N\n";
  const auto two = points_in(text);
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().location.line, 4u);
  EXPECT_EQ(two.error().location.column, 4u);
  EXPECT_NE(two.error().message.find("are of UTM zone '33N', but those before are of '32n'"),
            std::string::npos)
      << two.error().message;
  const TemporaryFolder folder;
  EXPECT_FALSE(PointStream::open(folder.write("bees.csv", text), {}, 1U << 20U));
}

}  // namespace
}  // namespace beespace::io
