#include "io/json/json_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace beespace::io {
namespace {

std::string written(const std::function<void(JsonWriter&)>& write) {
  std::string out;
  JsonWriter json(out);
  write(json);
  return out;
}

template <class Value>
std::string text_of(const Value& value) {
  return written([&](JsonWriter& json) { json.value(value); });
}

// An object with an empty one, an empty array, and one of two objects.
std::string nested(JsonLayout layout) {
  return written([layout](JsonWriter& json) {
    json.begin_object(layout);
    json.begin_object("none", layout);
    json.end();
    json.begin_array("no rows", layout);
    json.end();
    json.begin_array("rows", layout);
    for (const unsigned number : {1u, 2u}) {
      json.begin_object();
      json.member("a", number);
      json.member("b", true);
      json.end();
    }
    json.end();
    json.end();
  });
}

TEST(JsonWriter, LayoutsSayWhereValuesStand) {
  EXPECT_EQ(nested(JsonLayout::kTight),
            R"({"none":{},"no rows":[],"rows":[{"a":1,"b":true},{"a":2,"b":true}]})");
  EXPECT_EQ(nested(JsonLayout::kLine),
            R"({"none": {}, "no rows": [], "rows": [{"a": 1, "b": true}, {"a": 2, "b": true}]})");
  EXPECT_EQ(nested(JsonLayout::kWrapped), nested(JsonLayout::kLine));
  EXPECT_EQ(nested(JsonLayout::kRows), R"({
  "none": {},
  "no rows": [],
  "rows": [
    {"a": 1, "b": true},
    {"a": 2, "b": true}]})");
  EXPECT_EQ(nested(JsonLayout::kLines), R"({
  "none": {},
  "no rows": [],
  "rows": [
    {"a": 1, "b": true},
    {"a": 2, "b": true}
  ]
})");
  EXPECT_EQ(nested(JsonLayout::kFlush), R"({
"none": {
},
"no rows": [
],
"rows": [
{"a": 1, "b": true},
{"a": 2, "b": true}
]
})");
}

TEST(JsonWriter, WhatStandsOnOneLineDoesNotIndent) {
  EXPECT_EQ(written([](JsonWriter& json) {
              json.begin_array(JsonLayout::kLines);
              json.begin_object();
              json.begin_array("rows", JsonLayout::kRows);
              json.value(1u);
              json.end();
              json.end();
              json.end();
            }),
            "[\n  {\"rows\": [\n    1]}\n]");
}

TEST(JsonWriter, TheCallerMayBeginALine) {
  EXPECT_EQ(written([](JsonWriter& json) {
              json.begin_object(JsonLayout::kWrapped);
              json.member("a", 1u);
              json.member("b", 2u);
              json.new_line();
              json.member("c", 3u);
              json.member("d", 4u);
              json.new_line();
              json.end();
            }),
            "{\"a\": 1, \"b\": 2,\n  \"c\": 3, \"d\": 4\n  }");
}

TEST(JsonWriter, WithinWhatIsTightAllIs) {
  EXPECT_EQ(written([](JsonWriter& json) {
              json.begin_object();
              json.begin_object("tight", JsonLayout::kTight);
              json.member("texts", std::vector<std::string>{"a", "b"});
              json.end();
              json.member("texts", std::vector<std::string>{"a", "b"});
              json.end();
            }),
            R"({"tight": {"texts":["a","b"]}, "texts": ["a", "b"]})");
}

TEST(JsonWriter, WhatGoesThroughValuesIsAnArray) {
  const std::vector<std::array<double, 2>> places = {{1.5, 2}, {3, 4}};
  EXPECT_EQ(text_of(places), "[[1.5, 2], [3, 4]]");
  EXPECT_EQ(text_of(std::vector<std::string>()), "[]");
  std::string tight;
  JsonWriter(tight, JsonLayout::kTight).begin_object().member("places", places).end();
  EXPECT_EQ(tight, R"({"places":[[1.5,2],[3,4]]})");
}

TEST(JsonWriter, NumbersReadBackAsTheSame) {
  using Double = std::numeric_limits<double>;
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(-0.0), "-0");
  EXPECT_EQ(text_of(1e300), "1e+300");
  EXPECT_EQ(text_of(Double::max()), "1.7976931348623157e+308");
  EXPECT_EQ(text_of(Double::denorm_min()), "5e-324");
  EXPECT_EQ(text_of(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(text_of(std::uint64_t{0}), "0");
  EXPECT_EQ(text_of(std::uint8_t{255}), "255");
}

TEST(JsonWriter, WhatIsNoNumberOrNotThereIsNull) {
  using Double = std::numeric_limits<double>;
  for (const double value : {Double::infinity(), -Double::infinity(), Double::quiet_NaN()}) {
    EXPECT_EQ(text_of(value), "null");
  }
  EXPECT_EQ(text_of(std::optional<double>()), "null");
  EXPECT_EQ(text_of(known_if(false, true)), "null");
  EXPECT_EQ(text_of(known_if(true, false)), "false");
  EXPECT_EQ(written([](JsonWriter& json) { json.null(); }), "null");
}

TEST(JsonWriter, KeysAndTextsAreEscaped) {
  EXPECT_EQ(written([](JsonWriter& json) {
              json.begin_object();
              json.member("a \"key\"", "line\n\ttab \\ \x7F 蜂 \xFF");
              json.member("", std::string());
              json.end();
            }),
            "{\"a \\\"key\\\"\": \"line\\n\\ttab \\\\ \\u007f 蜂 \xEF\xBF\xBD\", \"\": \"\"}");
}

TEST(JsonWriter, TheTextMayBeTakenBetweenValues) {
  std::string out;
  std::string taken;
  JsonWriter json(out);
  json.begin_array(JsonLayout::kRows);
  for (const unsigned number : {1u, 2u, 3u}) {
    json.value(number);
    taken += out;
    out.clear();
  }
  json.end();
  EXPECT_EQ(taken + out, "[\n  1,\n  2,\n  3]");
}

TEST(JsonWriter, DocumentsMayFollowEachOther) {
  std::string out;
  JsonWriter json(out);
  for (const bool yes : {true, false}) {
    json.begin_object();
    json.member("yes", yes);
    json.end();
    out += '\n';
  }
  EXPECT_EQ(out, "{\"yes\": true}\n{\"yes\": false}\n");
}

#ifndef NDEBUG
TEST(JsonWriterDeathTest, MisuseIsAnAssertion) {
  const auto misuse = [](const std::function<void(JsonWriter&)>& write) {
    EXPECT_DEATH(written(write), "Assertion");
  };
  misuse([](JsonWriter& json) { json.end(); });
  misuse([](JsonWriter& json) { json.begin_array(); });
  misuse([](JsonWriter& json) { json.key("a"); });
  misuse([](JsonWriter& json) {
    json.begin_array();
    json.key("a");
  });
  misuse([](JsonWriter& json) {
    json.begin_object();
    json.value(1u);
  });
  misuse([](JsonWriter& json) {
    json.begin_object();
    json.key("a");
    json.end();
  });
}
#endif

}  // namespace
}  // namespace beespace::io
