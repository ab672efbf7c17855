#include "io/json/json_fault.hpp"

#include "io/json/json_document.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace beespace::io {
namespace {

std::string fault_in(std::string_view text) {
  const JsonFault fault = find_json_fault(text);
  if (!fault.found) return "none";
  return std::to_string(fault.line) + ":" + std::to_string(fault.column) + ": " + fault.what +
         (fault.at_end ? " (end)" : "");
}

TEST(JsonFault, ValidJsonHasNone) {
  for (const std::string_view text :
       {"{}", "[]", "1", "-0.5e+3", "\"a\\\"b\"", "true", "null", " [1, [2, {\"a\": {}}], []] \n",
        "{\"a\": [1, 2], \"b\": {\"c\": false}}"}) {
    EXPECT_EQ(fault_in(text), "none") << text;
  }
}

TEST(JsonFault, IsShownWithItsPlace) {
  EXPECT_EQ(fault_in("[1,\n 2,\n  NaN]"), "3:3: a value is expected, not 'NaN'");
  EXPECT_EQ(fault_in("[1 2]"), "1:4: a comma or ] is expected, not '2'");
  EXPECT_EQ(fault_in("{\"a\" 1}"), "1:6: a colon is expected, not '1'");
  EXPECT_EQ(fault_in("{\"a\": 1 \"b\"}"), "1:9: a comma or } is expected, not '\"b\"'");
  EXPECT_EQ(fault_in("{a: 1}"), "1:2: a name in quotes is expected, not 'a'");
  EXPECT_EQ(fault_in("[1,]"), "1:4: a value is expected, not ']'");
  EXPECT_EQ(fault_in("[1.]"), "1:4: a digit is expected, not ']'");
  EXPECT_EQ(fault_in("[01]"), "1:3: a comma or ] is expected, not '1'");
  EXPECT_EQ(fault_in("{} x"), "1:4: nothing more is expected, not 'x'");
  EXPECT_EQ(fault_in("[\"a\nb\"]"), "1:4: a closing quote is expected, not '\\x0a'");
}

TEST(JsonFault, AtTheEndTextIsMissing) {
  EXPECT_EQ(fault_in("[1, 2"), "1:6: a comma or ] is expected (end)");
  EXPECT_EQ(fault_in("{\"a\": [\"b"), "1:10: a closing quote is expected (end)");
  EXPECT_EQ(fault_in("{\"a\":"), "1:6: a value is expected (end)");
  EXPECT_EQ(fault_in("\"\\"), "1:3: a closing quote is expected (end)");
  EXPECT_EQ(fault_in(""), "1:1: a value is expected (end)");
}

TEST(JsonFault, DepthCostsNoStack) {
  EXPECT_EQ(fault_in(std::string(1'000'000, '[')), "1:1000001: a value is expected (end)");
}

TEST(JsonDocument, ReportsTheErrorAndItsPlace) {
  const auto problem = [](std::string_view text) {
    const auto parsed = JsonDocument::parse(text, "a.json");
    return parsed ? "none" : to_string(parsed.error());
  };
  EXPECT_EQ(problem("{\"a\": 1}"), "none");
  EXPECT_EQ(problem("{\"a\":\n NaN}"),
            "a.json:2:2: this is no JSON: a value is expected, not 'NaN'; correct it");
  EXPECT_EQ(problem("{\"a\": [1"),
            "a.json:1:9: the JSON ends too early (a comma or ] is expected); the file is "
            "incomplete, copy or download it again");
  EXPECT_EQ(problem("  "), "a.json: the input is empty");
  EXPECT_NE(problem("[1e999]").find("a.json: this JSON cannot be read"), std::string::npos);
  EXPECT_NE(problem(std::string(3000, '[') + std::string(3000, ']')).find("cannot be read"),
            std::string::npos);
}

}  // namespace
}  // namespace beespace::io
