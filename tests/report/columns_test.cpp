// Encoded columns are decoded to the same numbers.
#include "report/columns.hpp"

#include "report/base64.hpp"
#include "tests/report/page_reader.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace beespace::report {
namespace {

using report_test::Column;
using report_test::ParsedJson;
using test::rounds;
using test::SceneMaker;

// Of the column, as the only member of an object.
template <class Number, class... More>
std::string json_of(Columns& columns, std::span<const Number> numbers, const More&... more) {
  std::string text;
  io::JsonWriter json(text);
  json.begin_object(io::JsonLayout::kTight);
  columns.add(json, "column", numbers, more...);
  json.end();
  return text;
}

Column read(const Columns& columns, const std::string& json) {
  return report_test::column_of(ParsedJson(json)["column"], columns.elements());
}

template <class Number>
std::vector<std::uint64_t> widened(const std::vector<Number>& numbers) {
  return {numbers.begin(), numbers.end()};
}

const char* name_of(Differences differences) {
  switch (differences) {
    case Differences::kFirst:
      return "delta";
    case Differences::kSecond:
      return "delta2";
    default:
      return "";
  }
}

template <class Number>
void expect_kept(const std::vector<Number>& numbers, const std::string& type) {
  for (const auto differences : {Differences::kNone, Differences::kFirst, Differences::kSecond}) {
    Columns columns;
    const Column column =
        read(columns, json_of(columns, std::span<const Number>(numbers), differences));
    EXPECT_EQ(column.type, type);
    EXPECT_EQ(column.code, name_of(differences));
    EXPECT_EQ(column.numbers, widened(numbers)) << type << " " << column.code;
    EXPECT_FALSE(column.scale.has_value() || column.offset.has_value());
  }
}

template <class Number>
std::vector<std::vector<Number>> nasty() {
  constexpr Number kMost = std::numeric_limits<Number>::max();
  constexpr Number kHalf = kMost / 2;
  constexpr Number kAboveHalf = kHalf + 1;
  return {{},
          {0},
          {1},
          {kMost},
          {kHalf},
          {kAboveHalf},
          {0, 0, 0},
          {kMost, 0, kMost, 0},
          {0, kMost, 1, kMost, 2},
          {0, kHalf, 0, kAboveHalf, 0, kAboveHalf, kMost},
          {kMost, kMost, kMost, kMost},
          {0, 1, 2, 3, 4, 5, 7, 6}};
}

TEST(Columns, NumbersOfEveryKindAreKeptWhateverTheCode) {
  for (const auto& numbers : nasty<std::uint16_t>()) expect_kept(numbers, "u16");
  for (const auto& numbers : nasty<std::uint32_t>()) expect_kept(numbers, "u32");
}

TEST(Columns, RandomNumbersAreKept) {
  SceneMaker make(7);
  for (int round = 0; round < rounds(400); ++round) {
    std::vector<std::uint16_t> narrow(make.below(300));
    std::vector<std::uint32_t> wide(make.below(300));
    for (auto& number : narrow) number = static_cast<std::uint16_t>(make.below(65'536));
    for (auto& number : wide) number = static_cast<std::uint32_t>(make.below(4'294'967'296));
    expect_kept(narrow, "u16");
    expect_kept(wide, "u32");
  }
}

TEST(Columns, BytesAreKept) {
  std::vector<std::uint8_t> bytes;
  for (int round = 0; round < 300; ++round) {
    Columns columns;
    const Column column = read(columns, json_of(columns, std::span<const std::uint8_t>(bytes)));
    EXPECT_EQ(column.type, "u8");
    EXPECT_EQ(column.code, "");
    EXPECT_EQ(column.numbers, widened(bytes));
    bytes.push_back(static_cast<std::uint8_t>(round * 37));
  }
}

TEST(Columns, RealNumbersAreKeptBitForBit) {
  using Limits = std::numeric_limits<double>;
  const std::vector<std::vector<double>> all = {
      {},
      {0.0, -0.0, 1.0, -1.0, 0.1, std::nextafter(0.1, 1.0)},
      {Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min()},
      {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}};
  for (const auto& numbers : all) {
    Columns columns;
    const Column column = read(columns, json_of(columns, std::span<const double>(numbers)));
    EXPECT_EQ(column.type, "f64");
    ASSERT_EQ(column.numbers.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_EQ(column.numbers[i], std::bit_cast<std::uint64_t>(numbers[i]));
    }
  }
}

TEST(Columns, TextsAreKept) {
  const std::vector<std::vector<std::string>> all = {
      {},
      {""},
      {"", ""},
      {"a", "b,c", "\"quoted\"", "back\\slash", "new\nline", std::string("n\0l", 3)},
      {"</script>", "<!--", "é", "\xE2\x80\xA8", "🐝", std::string(100'000, 'x')}};
  for (const auto& texts : all) {
    Columns columns;
    const Column column = read(columns, json_of(columns, std::span<const std::string>(texts)));
    EXPECT_EQ(column.type, "json");
    EXPECT_EQ(column.texts, texts);
  }
}

TEST(Columns, WhatIsNotUtf8BecomesTheReplacementCharacter) {
  const std::vector<std::string> texts = {"\xFF", "a\xC3", "\xED\xA0\x80z", "ok"};
  Columns columns;
  const Column column = read(columns, json_of(columns, std::span<const std::string>(texts)));
  const std::string unknown = "\xEF\xBF\xBD";
  EXPECT_EQ(column.texts, (std::vector<std::string>{unknown, "a" + unknown,
                                                    unknown + unknown + unknown + "z", "ok"}));
}

TEST(Columns, TheMeaningOfNumbersIsExact) {
  const std::vector<std::uint16_t> narrow = {0, 1, 65'535};
  const std::vector<std::uint32_t> wide = {0, 1, 4'294'967'295};
  for (const Meaning meaning : {Meaning{0.1, 0.0}, Meaning{1.0, -1e-300}, Meaning{0.0, 5.0},
                                Meaning{1.0 / 3.0, 1e9 + 0.1}, Meaning{1e300, -2.5}}) {
    Columns columns;
    const auto none = Differences::kNone;
    for (const Column& column :
         {read(columns, json_of(columns, std::span<const std::uint16_t>(narrow), none, meaning)),
          read(columns, json_of(columns, std::span<const std::uint32_t>(wide), none, meaning))}) {
      EXPECT_EQ(column.scale.value_or(1.0), meaning.scale);
      EXPECT_EQ(column.offset.value_or(0.0), meaning.offset);
      EXPECT_EQ(column.scale.has_value(), meaning.scale != 1.0);
      EXPECT_EQ(column.offset.has_value(), meaning.offset != 0.0);
    }
  }
}

TEST(Columns, EachHasAnElementOfItsOwn) {
  Columns columns;
  const std::vector<std::uint8_t> few = {1};
  const std::vector<double> more = {2.0, 3.0};
  EXPECT_EQ(json_of(columns, std::span<const std::uint8_t>(few)),
            R"({"column":{"at":0,"type":"u8","count":1}})");
  EXPECT_EQ(json_of(columns, std::span<const double>(more)),
            R"({"column":{"at":1,"type":"f64","count":2}})");
  EXPECT_EQ(columns.elements().size(), 2u);
}

TEST(Columns, RegularNumbersCostNextToNothing) {
  std::vector<std::uint32_t> regular(100'000);
  for (std::size_t i = 0; i < regular.size(); ++i) regular[i] = static_cast<std::uint32_t>(i * 40);
  Columns columns;
  json_of(columns, std::span<const std::uint32_t>(regular), Differences::kSecond);
  EXPECT_LT(columns.elements().front().size(), 1'000u);
}

// RFC 4648, section 10.
TEST(Base64, AgreesWithTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFB\xFF\xBF"), "+/+/");
}

}  // namespace
}  // namespace beespace::report
