// Definitions of messages in PX4 logs: where their fields are.
#include "io/px4/ulog_format.hpp"
#include "tests/io/px4/ulog_making.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

TEST(UlogFormat, FieldsFollowEachOtherThroughArraysAndNestedDefinitions) {
  UlogDefinitions definitions;
  definitions.add(
      "outer:uint64_t timestamp;inner[2] both;float[3] three;int16_t last;"
      "uint8_t[2] _padding0;");
  definitions.add("inner:int8_t a;leaf b;bool c;");
  definitions.add("leaf:double d;char[4] e;");
  const auto layout = definitions.layout("outer");
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->fields[1].offset, 8u);
  EXPECT_EQ(layout->fields[2].offset, 8u + 2 * (1 + 12 + 1));
  EXPECT_EQ(layout->number("last")->offset, 8u + 28 + 12);
  EXPECT_EQ(layout->number("three"), nullptr);  // not one number
  EXPECT_EQ(layout->number("both"), nullptr);
  EXPECT_EQ(layout->least_size, 8u + 28 + 12 + 2);
  EXPECT_EQ(layout->size, layout->least_size + 2);
}

TEST(UlogFormat, NumbersOfAllTypes) {
  UlogDefinitions definitions;
  definitions.add(
      "all:int8_t a;uint8_t b;int16_t c;uint16_t d;int32_t e;uint32_t f;int64_t g;"
      "uint64_t h;float i;double j;bool k;char l;");
  const auto layout = definitions.layout("all");
  ASSERT_TRUE(layout);
  UlogBody body;
  body.u8(0xFF).u8(0xFF).u16(0xFFFE).u16(0xFFFE).u32(0xFFFFFFFD).u32(0xFFFFFFFD);
  body.u64(0xFFFFFFFFFFFFFFFC).u64(4'000'000'000'000).f32(-1.5).f64(2.25).u8(1).u8('x');
  ASSERT_EQ(body.bytes().size(), layout->size);
  const std::vector<double> expected = {-1, 255,  -2,   65534, -3, 4294967293.0,
                                        -4, 4e12, -1.5, 2.25,  1,  120};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(ulog_number(body.bytes(), layout->fields[i]), expected[i]) << i;
  }
  EXPECT_EQ(ulog_unsigned(body.bytes(), layout->fields[7]), 4'000'000'000'000u);
  EXPECT_FALSE(ulog_unsigned(body.bytes(), layout->fields[8]));
}

TEST(UlogFormat, WhatCannotBeReadIsNoLayout) {
  UlogDefinitions definitions;
  definitions.add("self:uint8_t a;self b;");
  definitions.add("ping:pong a;");
  definitions.add("pong:ping a;");
  definitions.add("missing:nowhere a;");
  definitions.add("large:uint8_t[65535] a;uint8_t b;");
  definitions.add("none:uint8_t[0] a;");
  definitions.add("open:uint8_t[3 a;");
  definitions.add("nameless:uint8_t;");
  definitions.add("no colon");
  // Each has the one before it a hundred times: 10^10 fields, and no byte.
  definitions.add("bomb0:bomb1 a;");
  std::string wide = ":";
  for (int i = 0; i < 100; ++i) wide += "empty a;";
  definitions.add("empty:");
  std::string of_last = "empty";
  for (const char* const name : {"w1", "w2", "w3", "w4", "w5"}) {
    std::string fields;
    for (int i = 0; i < 100; ++i) fields += of_last + " a;";
    definitions.add(std::string(name) + ":" + fields);
    of_last = name;
  }
  for (const char* const name : {"self", "ping", "missing", "large", "none", "open", "nameless",
                                 "no colon", "bomb0", "w5", ""}) {
    EXPECT_FALSE(definitions.layout(name)) << name;
  }
  EXPECT_TRUE(definitions.layout("w1"));
}

}  // namespace
}  // namespace beespace::io
