// Units: the words that name them, and conversions that round once.
#include "io/units/units.hpp"
#include "io/units/unit_overrides.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Definition {
  Unit unit;
  int numerator;
  int denominator;
};

// By international definitions: 1 ft = 0.3048 m, 1 mi = 5280 ft, 1 NM = 1852 m, 1 h = 3600 s.
constexpr Definition kDefinitions[] = {
    {Unit::kMetre, 1, 1},
    {Unit::kKilometre, 1000, 1},
    {Unit::kCentimetre, 1, 100},
    {Unit::kMillimetre, 1, 1000},
    {Unit::kMicrometre, 1, 1'000'000},
    {Unit::kFoot, 3048, 10000},
    {Unit::kFlightLevel, 3048, 100},
    {Unit::kYard, 9144, 10000},
    {Unit::kInch, 254, 10000},
    {Unit::kMile, 1609344, 1000},
    {Unit::kNauticalMile, 1852, 1},
    {Unit::kMetrePerSecond, 1, 1},
    {Unit::kKilometrePerHour, 1000, 3600},
    {Unit::kMetrePerMinute, 1, 60},
    {Unit::kCentimetrePerSecond, 1, 100},
    {Unit::kMillimetrePerSecond, 1, 1000},
    {Unit::kKnot, 1852, 3600},
    {Unit::kMilePerHour, 1609344, 3600000},
    {Unit::kFootPerSecond, 3048, 10000},
    {Unit::kFootPerMinute, 3048, 600000},
};

// Whether no double is nearer to the exact product.
void expect_nearest(double converted, const Rational& exact) {
  const auto away = [&exact](double value) -> Rational { return abs(Rational(value) - exact); };
  EXPECT_LE(away(converted), away(std::nextafter(converted, HUGE_VAL)));
  EXPECT_LE(away(converted), away(std::nextafter(converted, -HUGE_VAL)));
}

TEST(Units, AreConvertedByTheirDefinitionAndRoundedOnce) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-60'000.0, 60'000.0);
  for (const auto& [unit, numerator, denominator] : kDefinitions) {
    const Rational factor(numerator, denominator);
    for (int i = 0; i < 2'000; ++i) {
      const double value = i < 1'000 ? 25.0 * i : any(random);
      expect_nearest(in_metric(value, unit), Rational(value) * factor);
      expect_nearest(from_metric(value, unit), Rational(value) / factor);
    }
  }
  EXPECT_EQ(in_metric(1000.0, Unit::kFoot), 304.8);
  EXPECT_EQ(in_metric(5.0, Unit::kNauticalMile), 9260.0);
  EXPECT_EQ(in_metric(-0.0, Unit::kFoot), 0.0);
  EXPECT_TRUE(std::isnan(in_metric(std::nan(""), Unit::kFoot)));
  EXPECT_EQ(in_metric(HUGE_VAL, Unit::kFoot), HUGE_VAL);
}

TEST(Units, AreKnownByTheirWords) {
  const auto length = [](std::string_view text) { return unit_of_text(text, Quantity::kLength); };
  const auto speed = [](std::string_view text) { return unit_of_text(text, Quantity::kSpeed); };
  EXPECT_EQ(length("ft"), Unit::kFoot);
  EXPECT_EQ(length("NM"), Unit::kNauticalMile);
  EXPECT_EQ(length("km"), Unit::kKilometre);
  EXPECT_EQ(length("m"), Unit::kMetre);
  EXPECT_EQ(length("FL"), Unit::kFlightLevel);
  EXPECT_EQ(length("M"), std::nullopt) << "miles, for some";
  EXPECT_EQ(length("kt"), std::nullopt);
  EXPECT_EQ(length(""), std::nullopt);
  EXPECT_EQ(speed("kt"), Unit::kKnot);
  EXPECT_EQ(speed("ft/min"), Unit::kFootPerMinute);
  EXPECT_EQ(speed("fpm"), Unit::kFootPerMinute);
  EXPECT_EQ(speed("km/h"), Unit::kKilometrePerHour);
  EXPECT_EQ(speed("ft"), std::nullopt);
}

TEST(Units, AreTakenFromTheEndOfAName) {
  const auto taken = [](std::vector<std::string> words) {
    return take_unit(words, Quantity::kSpeed);
  };
  EXPECT_EQ(taken({"vx", "kt"}), Unit::kKnot);
  EXPECT_EQ(taken({"vertical", "rate", "ft", "min"}), Unit::kFootPerMinute);
  EXPECT_EQ(taken({"climb", "feet", "per", "minute"}), Unit::kFootPerMinute);
  EXPECT_EQ(taken({"vel", "n", "m", "s"}), Unit::kMetrePerSecond);
  EXPECT_EQ(taken({"gs", "km", "h"}), Unit::kKilometrePerHour);
  EXPECT_EQ(taken({"gs", "nm", "h"}), Unit::kKnot);
  EXPECT_EQ(taken({"kt"}), std::nullopt) << "nothing else would be left";
  EXPECT_EQ(taken({"v", "x"}), std::nullopt);
}

TEST(Units, MayBeGivenByRole) {
  const auto wishes = read_unit_overrides("height=ft, speed=kt,climb=ft/min,position=km");
  ASSERT_TRUE(wishes.has_value());
  EXPECT_EQ(wishes->height, Unit::kFoot);
  EXPECT_EQ(wishes->speed, Unit::kKnot);
  EXPECT_EQ(wishes->climb, Unit::kFootPerMinute);
  EXPECT_EQ(wishes->position, Unit::kKilometre);
  EXPECT_FALSE(read_unit_overrides("").value().any());
  EXPECT_EQ(read_unit_overrides("aviation").value().convention, UnitConvention::kAviation);
  EXPECT_EQ(read_unit_overrides("metric, height=ft").value().convention, UnitConvention::kMetric);
  EXPECT_EQ(read_unit_overrides("metric, height=ft").value().height, Unit::kFoot);
  EXPECT_FALSE(read_unit_overrides("aviation").value().any());
  for (const auto& [text, part] : {std::pair{"height", "'height' is not understood"},
                                   {"hight=ft", "'hight=ft' is not understood"},
                                   {"height=", "'height=' is not understood"},
                                   {"height=kt", "'kt' is no unit of a height; it is one of m, km"},
                                   {"speed=ft", "'ft' is no unit of a speed; it is one of m/s"},
                                   {"height=ft,height=m", "height is given twice"},
                                   {"metric,aviation", "metric and aviation are given"},
                                   {"aviation,aviation", "or one of them twice"},
                                   {"metric,", "a comma at the end"},
                                   {"imperial", "'imperial' is not understood"},
                                   {"height=ft,", "a comma at the end"}}) {
    const auto refused = read_unit_overrides(text);
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(refused.error().message.find(part), std::string::npos) << refused.error().message;
  }
}

}  // namespace
}  // namespace beespace::io
