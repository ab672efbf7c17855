// Decimal commas are read where they are certain, and nowhere else.
#include "io/table/decimal_comma.hpp"

#include "io/load_points.hpp"
#include "io/load_recording.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

std::string changed(const std::string& text) {
  const auto bytes = with_decimal_points(text);
  return bytes ? std::string(bytes->view) : "as it was";
}

TEST(DecimalComma, IsMadeAPointWhereItIsCertain) {
  EXPECT_EQ(changed("id;x;y;z\nb 1;-7,5; 50,25 ;3\r\nb 2;,5;1,250;-2,5e-3\n"),
            "id;x;y;z\nb 1;-7.5; 50.25 ;3\r\nb 2;.5;1.250;-2.5e-3\n");
  EXPECT_EQ(changed("x\ty\tz\n1,5\t2,25\t3\n"), "x\ty\tz\n1.5\t2.25\t3\n");
}

// No group of thousands begins with a zero.
TEST(DecimalComma, WithThreeDigitsBehindIsCertainBelowOne) {
  EXPECT_EQ(changed("x;y;z\n0,125;2,500;3\n"), "x;y;z\n0.125;2.500;3\n");
}

TEST(DecimalComma, OfNamesAndTimesIsKept) {
  EXPECT_EQ(changed("id;t;x;y\nHans, Ulm;12:00:00,5;1,5;2\n"),
            "id;t;x;y\nHans, Ulm;12:00:00,5;1.5;2\n");
}

TEST(DecimalComma, IsNotGuessed) {
  EXPECT_EQ(changed("x;y;z\n1,250;2;3\n"), "as it was");    // or 1250
  EXPECT_EQ(changed("x;y;z\n1,25;2.5;3\n"), "as it was");   // a point, too
  EXPECT_EQ(changed("x,y,z\n1,25,3\n"), "as it was");       // between fields
  EXPECT_EQ(changed("x y z\n1,5 2,5 3,5\n"), "as it was");  // perhaps both
  EXPECT_EQ(changed("x;y;z\n1.234,5;2;3\n"), "as it was");  // thousands, too
  EXPECT_EQ(changed("x;y;z\n1;2;3\n"), "as it was");
}

TEST(DecimalComma, OfPoints) {
  const auto loaded = load_points_from_memory("x;y;z\n1,5;2,25;-3\n", "bees.csv", {});
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->points.size(), 1u);
  EXPECT_EQ(loaded->points[0].x, 1.5);
  EXPECT_EQ(loaded->points[0].y, 2.25);
  EXPECT_NE(loaded->format_description.find("decimal commas"), std::string::npos);
  EXPECT_FALSE(load_points_from_memory("x;y;z\n1,250;2;3\n", "bees.csv", {}));
}

}  // namespace
}  // namespace beespace::io
