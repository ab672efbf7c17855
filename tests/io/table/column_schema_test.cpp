// Schemas are data: another community's words, and a schema of its own, are read without new code.
#include "io/points/record_reading.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/position_columns.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

struct Reading {
  TableLayout layout;
  std::vector<Point> points;
};

Result<Reading> read_with(const ColumnSchema& schema, std::string_view text,
                          const ColumnOptions& options = {}) {
  auto table = find_table(text, false);
  if (!table) return table.error();
  auto choice = choose_columns(*table, options, schema);
  if (!choice) return choice.error();
  Reading reading{*table, {}};
  reading.layout.choice = *choice;
  for (std::size_t at = table->data_offset; at < text.size();) {
    const Line line = line_at(text, at, table->line_end);
    Point point;
    if (auto error = read_record(line.text, reading.layout, point)) return *std::move(error);
    reading.points.push_back(point);
    at = line.next;
  }
  return reading;
}

ColumnSchema with_polish_words() {
  NamePattern polish;
  polish.words = {
      {Says::kPart, "długość dlugosc", Role::kLongitude, "Polish"},
      {Says::kPart, "szerokość szerokosc", Role::kLatitude, "Polish"},
      {Says::kPart, "wysokość wysokosc", Role::kHeight, "Polish"},
      {Says::kBeside, "geograficzna", Role::kNone, "Polish"},
  };
  polish.unit = UnitPlace::kAnywhere;
  ColumnSchema schema = position_columns();
  schema.names.push_back(polish);
  return schema;
}

TEST(ColumnSchema, AnotherCommunityIsAFewLines) {
  constexpr std::string_view kTable =
      "id,szerokość geograficzna,długość geograficzna,wysokość [ft]\n7,52.5,21.25,1000\n";
  const auto unknown =
      read_with(position_columns(), "id,szerokość,długość,wysokość\n7,52.5,21.25,9\n");
  ASSERT_TRUE(unknown.has_value()) << unknown.error().message;
  EXPECT_EQ(unknown->layout.choice.naming, Naming::kNone) << "taken in their order";
  EXPECT_FALSE(read_with(position_columns(), kTable)) << "one of them is in feet";
  const auto read = read_with(with_polish_words(), kTable);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->points, (std::vector<Point>{{21.25, 52.5, 1000.0}}));
  const ColumnChoice& choice = read->layout.choice;
  EXPECT_EQ(choice.evidence, Frame::kWgs84);
  EXPECT_EQ(choice.reason, "the header names longitude, latitude and height");
  EXPECT_EQ(choice.height_unit(), Unit::kFoot);
  EXPECT_EQ(choice.id, 0u);
}

// The coordinates of a beekeeper's map.
ColumnSchema apiary() {
  NamePattern place;
  place.words = {{Says::kPart, "row", Role::kX},
                 {Says::kPart, "stand", Role::kY},
                 {Says::kPart, "tier", Role::kZ},
                 {Says::kBeside, "hive"}};
  place.unit = UnitPlace::kAnywhere;
  ColumnSchema schema;
  schema.roles = {{Role::kX, "row", "*lane*"}, {Role::kY, "stand"}, {Role::kZ, "tier"}};
  schema.groups = {{"place", {Role::kX, Role::kY, Role::kZ}, Frame::kMetres}};
  schema.names = {place};
  return schema;
}

TEST(ColumnSchema, MayBeDeclaredAnew) {
  const auto read = read_with(apiary(), "tier,hive stand [m],hive row [m]\n3,2,1\n");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->points, (std::vector<Point>{{1, 2, 3}}));
}

TEST(ColumnSchema, WhatIsSaidOfColumnsFollowsFromIt) {
  const auto error_of = [](std::string_view text, std::string columns) {
    ColumnOptions options;
    options.columns = std::move(columns);
    const auto read = read_with(apiary(), text, options);
    return read ? std::string("none") : read.error().message;
  };
  EXPECT_EQ(error_of("1,2,3\n", "x=1"),
            "--columns: 'x=1' is not understood; write role=column, where the role is row, stand "
            "or tier and the column a number (from 1) or a name");
  EXPECT_EQ(error_of("1,2,3\n", "row=1"), "--columns: row needs stand too");
  EXPECT_EQ(error_of("1,2,3\n", "tier=1"), "--columns: tier needs row and stand too");
  EXPECT_EQ(error_of("1,2,3\n", "row=1,stand=1"),
            "--columns: column 1 cannot be both row and stand");
  EXPECT_EQ(error_of("1,2,3\n", "row=2,stand=1"), "none");
  EXPECT_EQ(error_of("lane no,stand,bees,mites\n1,2,3,4\n", ""),
            "the header names 'stand' but not the columns that belong to it; say which is which, "
            "for example with --columns row=1,stand=2,tier=3 (the columns are 1 'lane no', 2 "
            "'stand', 3 'bees', 4 'mites')");
}

}  // namespace
}  // namespace beespace::io
