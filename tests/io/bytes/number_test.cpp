#include "io/bytes/number.hpp"

#include "io/bytes/digit_mask.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace beespace::io {
namespace {

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

double parsed(std::string_view text) {
  double value = -1.0;
  EXPECT_EQ(parse_number(text, value), NumberKind::kNumber) << text;
  return value;
}

NumberKind kind(std::string_view text) {
  double value = 0.0;
  return parse_number(text, value);
}

TEST(ParseNumber, TakesEveryUsualNotation) {
  EXPECT_EQ(parsed("12"), 12.0);
  EXPECT_EQ(parsed("+1.5"), 1.5);
  EXPECT_EQ(parsed("-1.5"), -1.5);
  EXPECT_EQ(parsed("1e3"), 1000.0);
  EXPECT_EQ(parsed("1E+3"), 1000.0);
  EXPECT_EQ(parsed("25e-1"), 2.5);
  EXPECT_EQ(parsed(".5"), 0.5);
  EXPECT_EQ(parsed("5."), 5.0);
  EXPECT_EQ(parsed("-.5e1"), -5.0);
  EXPECT_EQ(parsed("007"), 7.0);
  EXPECT_EQ(bits(parsed("-0")), bits(-0.0));
  EXPECT_EQ(bits(parsed("-0.000")), bits(-0.0));
}

TEST(ParseNumber, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",     "+",   "-",   ".",  "e5",   "1e",       "1e+",    "1.2.3", "--1",   "+-1", "1 2",
        "0x10", "1,5", "abc", "1a", "1e5x", "infinite", "nan(1)", "-",     "1_000", "1f"}) {
    EXPECT_EQ(kind(text), NumberKind::kNotANumber) << text;
  }
}

TEST(ParseNumber, DistinguishesNotFiniteFromNoNumber) {
  for (const char* text : {"nan", "NaN", "-nan", "inf", "-inf", "+Inf", "Infinity", "-INFINITY"}) {
    EXPECT_EQ(kind(text), NumberKind::kNotFinite) << text;
  }
}

TEST(ParseNumber, ReportsTooLargeAndTooSmall) {
  EXPECT_EQ(kind("1e999"), NumberKind::kTooLarge);
  EXPECT_EQ(kind("-1e309"), NumberKind::kTooLarge);
  EXPECT_EQ(kind("1.7976931348623159e308"), NumberKind::kTooLarge);
  EXPECT_EQ(kind("1e99999999999999999999"), NumberKind::kTooLarge);
  EXPECT_EQ(kind("1" + std::string(400, '0')), NumberKind::kTooLarge);
  EXPECT_EQ(parsed("1.7976931348623157e308"), 1.7976931348623157e308);
  EXPECT_EQ(kind("1e-999"), NumberKind::kTooSmall);
  EXPECT_EQ(kind("-1e-400"), NumberKind::kTooSmall);
  EXPECT_EQ(kind("1e-324"), NumberKind::kTooSmall);
  EXPECT_EQ(kind("1e-99999999999999999999"), NumberKind::kTooSmall);
  EXPECT_EQ(bits(parsed("-0e-999")), bits(-0.0));
  EXPECT_EQ(parsed("5e-324"), 5e-324);
  EXPECT_EQ(parsed("0e999"), 0.0);
  EXPECT_EQ(parsed("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(parsed("0." + std::string(400, '0') + "1e401"), 1.0);
}

TEST(ParseNumber, RoundsHardCasesToTheNearestDouble) {
  for (const char* text :
       {"9007199254740993", "9007199254740992.5", "0.1", "0.3", "2.2250738585072011e-308",
        "1.00000000000000011102230246251565", "1.00000000000000011102230246251566",
        "179769313486231580793728971405301e276", "8.5", "123456789012345678901234567890",
        "4.9406564584124654e-324", "2.4703282292062328e-324"}) {
    EXPECT_EQ(bits(parsed(text)), bits(std::strtod(text, nullptr))) << text;
  }
}

TEST(ParseNumber, AgreesWithStrtodOnRandomDoublesAndDigits) {
  std::mt19937_64 random(1);
  std::array<char, 64> text = {};
  for (int i = 0; i < 50'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (value - value != 0.0) continue;  // infinite or not a number
    const int digits = static_cast<int>(random() % 20);
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    double found = 0.0;
    const NumberKind outcome = parse_number(text.data(), found);
    const double expected = std::strtod(text.data(), nullptr);
    if (expected - expected != 0.0) {  // rounding up the digits went beyond the largest double
      EXPECT_EQ(outcome, NumberKind::kTooLarge) << text.data();
    } else {
      EXPECT_EQ(outcome, NumberKind::kNumber) << text.data();
      EXPECT_EQ(bits(found), bits(expected)) << text.data();
    }
  }
}

TEST(DigitMask, ProcessorVersionEqualsThePlainOneForEveryByteValue) {
  std::array<char, kDigitMaskBytes> text = {};
  std::mt19937_64 random(2);
  for (int round = 0; round < 2'000; ++round) {
    for (char& c : text) c = static_cast<char>(random() % 3 == 0 ? random() : '0' + random() % 10);
    std::uint64_t expected = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] < '0' || text[i] > '9') expected |= std::uint64_t{1} << i;
    }
    EXPECT_EQ(non_digit_mask_portable(text.data()), expected);
    EXPECT_EQ(non_digit_mask(text.data()), expected);
  }
}

TEST(JoinPlainNumber, AgreesWithParseNumberForEveryCountOfDigits) {
  std::mt19937_64 random(3);
  int joined = 0;
  for (std::size_t whole = 0; whole <= 9; ++whole) {
    for (std::size_t decimals = 0; decimals <= 20; ++decimals) {
      for (int round = 0; round < 50; ++round) {
        std::string number = round % 2 == 0 ? "" : "-";
        const std::size_t sign = number.size();
        const char top = round % 5 == 0 ? '9' : '\0';
        for (std::size_t i = 0; i < whole; ++i) {
          number += top != '\0' ? top : static_cast<char>('0' + random() % 10);
        }
        if (decimals > 0) number += '.';
        for (std::size_t i = 0; i < decimals; ++i) {
          number += top != '\0' ? top : static_cast<char>('0' + random() % 10);
        }
        const std::string padded = number + std::string(kPlainNumberOverread, ',');
        double value = 0.0;
        const char* const begin = padded.data();
        if (!join_plain_number(begin, begin + sign, whole, decimals, begin + number.size(),
                               value)) {
          EXPECT_TRUE(whole == 0 || whole > 7) << number;
          continue;
        }
        ++joined;
        EXPECT_EQ(bits(value), bits(parsed(number))) << number;
      }
    }
  }
  EXPECT_EQ(joined, 7 * 21 * 50);
}

}  // namespace
}  // namespace beespace::io
