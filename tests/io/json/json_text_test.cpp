#include "io/json/json_text.hpp"

#include <gtest/gtest.h>

namespace beespace::io {
namespace {

std::string json_string(std::string_view text) {
  std::string out;
  append_json_string(out, text);
  return out;
}

TEST(JsonText, QuotesBackslashesAndControlCharactersAreEscaped) {
  EXPECT_EQ(json_string("bee \"7\" \\ x"), R"("bee \"7\" \\ x")");
  EXPECT_EQ(json_string("a\n\t\r\x01\x1f\x7f"), R"("a\n\t\r\u0001\u001f\u007f")");
  EXPECT_EQ(json_string(std::string_view("a\0b", 3)), R"("a\u0000b")");
}

TEST(JsonText, ValidUtf8StaysAsItIs) {
  for (const std::string bee : {"abeja ñ", "蜂", "🐝", "\xF4\x8F\xBF\xBF", "\xEE\x80\x80"}) {
    EXPECT_EQ(json_string(bee), "\"" + bee + "\"");
  }
}

TEST(JsonText, EveryBrokenByteBecomesTheReplacementCharacter) {
  const std::string r = "\xEF\xBF\xBD";
  EXPECT_EQ(json_string("a\xFFz"), "\"a" + r + "z\"");
  EXPECT_EQ(json_string("\xC3"), "\"" + r + "\"");                          // cut off
  EXPECT_EQ(json_string("\xC0\xAF"), "\"" + r + r + "\"");                  // overlong
  EXPECT_EQ(json_string("\xED\xA0\x80"), "\"" + r + r + r + "\"");          // a surrogate
  EXPECT_EQ(json_string("\xF4\x90\x80\x80"), "\"" + r + r + r + r + "\"");  // beyond Unicode
  EXPECT_EQ(json_string("\xF0\x9F\x90"), "\"" + r + r + r + "\"");
}

}  // namespace
}  // namespace beespace::io
