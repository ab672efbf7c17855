#include "io/table/table_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::io {
namespace {

std::string field(std::string_view text, char delimiter) {
  std::string out;
  TableWriter(out, delimiter).field(text);
  return out;
}

TEST(TableWriter, PlainTextStaysAsItIs) {
  EXPECT_EQ(field("maya", ','), "maya");
  EXPECT_EQ(field("1;2", ','), "1;2");
  EXPECT_EQ(field("", ','), "");
}

TEST(TableWriter, WhatWouldBeReadAsSomethingElseIsQuoted) {
  EXPECT_EQ(field("a,b", ','), "\"a,b\"");
  EXPECT_EQ(field("wil\"li", ','), "\"wil\"\"li\"");
  EXPECT_EQ(field("a b", ' '), "\"a b\"");
  EXPECT_EQ(field("a\tb", '\t'), "\"a\tb\"");
  EXPECT_EQ(field(" a", ','), "\" a\"");
  EXPECT_EQ(field("a\nb", ','), "\"a\nb\"");
}

TEST(TableWriter, NothingBetweenBlanksIsStillAField) {
  EXPECT_EQ(field("", ' '), "\"\"");
  std::string out;
  TableWriter table(out, ' ');
  table.field(std::nan("")).empty_field().field(1U).end_row();
  EXPECT_EQ(out, "\"\" \"\" 1\n");
}

TEST(TableWriter, OnOneLineTabsAndLineEndsBecomeBlanks) {
  std::string out;
  TableWriter table(out, '\t', TableText::kOneLine);
  table.field("a\tb\r\nc").field("\"d\", e").end_row();
  EXPECT_EQ(out, "a b  c\t\"d\", e\n");
}

TEST(TableWriter, RowsAreFieldsWithDelimitersBetween) {
  std::string out;
  TableWriter table(out, ';');
  table.header("id,x,at_risk").field("note").end_row();
  EXPECT_EQ(out, "id;x;at_risk;note\n");
  out.clear();  // what has been handed on
  table.field(std::uint64_t{18446744073709551615U}).field(0.1).field(true).empty_field().end_row();
  table.field(7U).field(-0.0).field(false);
  table.next() += "1;2";  // two fields as they are
  table.end_row();
  EXPECT_EQ(out, "18446744073709551615;0.1;yes;\n7;-0;no;1;2\n");
}

TEST(TableWriter, NumbersThatAreNoneAreEmpty) {
  std::string out;
  TableWriter table(out, ',');
  const double infinity = std::numeric_limits<double>::infinity();
  table.field(infinity).field(-infinity).field(std::nan("")).field(1e300).end_row();
  EXPECT_EQ(out, ",,,1e+300\n");
}

TEST(TableWriter, WholeNumbersHaveNoExponent) {
  std::string text;
  TableWriter table(text, ',');
  table.field(1.75e9).field(100000.0).field(-1e5).field(1e15).field(1750000000.5).end_row();
  EXPECT_EQ(text, "1750000000,100000,-1e+05,1e+15,1750000000.5\n");
}

}  // namespace
}  // namespace beespace::io
