#include "io/table/csv_field.hpp"

#include <gtest/gtest.h>

namespace beespace::io {
namespace {

std::string field(std::string_view text, char delimiter) {
  std::string out;
  append_csv_field(out, text, delimiter);
  return out;
}

TEST(CsvField, PlainTextStaysAsItIs) {
  EXPECT_EQ(field("maya", ','), "maya");
  EXPECT_EQ(field("1;2", ','), "1;2");
  EXPECT_EQ(field("", ','), "");
}

TEST(CsvField, WhatWouldBeReadAsSomethingElseIsQuoted) {
  EXPECT_EQ(field("a,b", ','), "\"a,b\"");
  EXPECT_EQ(field("wil\"li", ','), "\"wil\"\"li\"");
  EXPECT_EQ(field("a b", ' '), "\"a b\"");
  EXPECT_EQ(field("a\tb", '\t'), "\"a\tb\"");
  EXPECT_EQ(field(" a", ','), "\" a\"");
  EXPECT_EQ(field("a\nb", ','), "\"a\nb\"");
}

TEST(CsvField, NothingBetweenBlanksIsStillAField) {
  EXPECT_EQ(field("", ' '), "\"\"");
}

}  // namespace
}  // namespace beespace::io
