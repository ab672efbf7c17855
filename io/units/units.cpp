#include "io/units/units.hpp"

#include "io/bytes/characters.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::io {
namespace {

struct UnitFacts {
  Unit unit;
  Quantity quantity;
  std::string_view symbol;
  // Of ours: value * numerator / denominator, exactly.
  double numerator;
  double denominator;
  std::string_view words;  // blanks between them
};

constexpr std::array kUnits = {
    UnitFacts{Unit::kMetre, Quantity::kLength, "m", 1, 1,
              "m meter meters metre metres metro metros mts"},
    UnitFacts{Unit::kKilometre, Quantity::kLength, "km", 1000, 1,
              "km kms kilometer kilometers kilometre kilometres kilometros"},
    UnitFacts{Unit::kCentimetre, Quantity::kLength, "cm", 1, 100,
              "cm centimeter centimeters centimetre centimetres"},
    UnitFacts{Unit::kMillimetre, Quantity::kLength, "mm", 1, 1000,
              "mm millimeter millimeters millimetre millimetres"},
    // The micro sign and the Greek letter.
    UnitFacts{Unit::kMicrometre, Quantity::kLength, "\u00B5m", 1, 1'000'000,
              "um micron microns micrometer micrometers micrometre micrometres \u00B5m \u03BCm"},
    UnitFacts{Unit::kFoot, Quantity::kLength, "ft", 381, 1250, "ft feet foot pies"},
    UnitFacts{Unit::kFlightLevel, Quantity::kLength, "FL", 762, 25, "fl"},
    UnitFacts{Unit::kYard, Quantity::kLength, "yd", 1143, 1250, "yd yard yards"},
    UnitFacts{Unit::kInch, Quantity::kLength, "inch", 127, 5000, "inch inches"},
    UnitFacts{Unit::kMile, Quantity::kLength, "mi", 201168, 125, "mi mile miles"},
    UnitFacts{Unit::kNauticalMile, Quantity::kLength, "NM", 1852, 1, "nm nmi"},
    UnitFacts{Unit::kPixel, Quantity::kLength, "px", 1, 1, ""},  // no word: it has no length alone
    UnitFacts{Unit::kMetrePerSecond, Quantity::kSpeed, "m/s", 1, 1, "m/s mps ms"},
    UnitFacts{Unit::kKilometrePerHour, Quantity::kSpeed, "km/h", 5, 18, "km/h kmh kph kmph"},
    UnitFacts{Unit::kMetrePerMinute, Quantity::kSpeed, "m/min", 1, 60, "m/min"},
    UnitFacts{Unit::kCentimetrePerSecond, Quantity::kSpeed, "cm/s", 1, 100, "cm/s cms"},
    UnitFacts{Unit::kMillimetrePerSecond, Quantity::kSpeed, "mm/s", 1, 1000, "mm/s mms"},
    UnitFacts{Unit::kKnot, Quantity::kSpeed, "kt", 463, 900, "kt kts kn knot knots nm/h nmi/h"},
    UnitFacts{Unit::kMilePerHour, Quantity::kSpeed, "mph", 1397, 3125, "mph mi/h"},
    UnitFacts{Unit::kFootPerSecond, Quantity::kSpeed, "ft/s", 381, 1250, "ft/s fps"},
    UnitFacts{Unit::kFootPerMinute, Quantity::kSpeed, "ft/min", 127, 25000, "ft/min fpm"},
    UnitFacts{Unit::kSecond, Quantity::kTime, "seconds", 1, 1,
              "s sec secs second seconds segundos sekunden secondes secondi"},
    UnitFacts{Unit::kMillisecond, Quantity::kTime, "milliseconds", 1, 1000,
              "ms msec msecs millis millisec millisecond milliseconds milisegundos millisekunden "
              "millisecondes millisecondi"},
    // The micro sign and the Greek letter.
    UnitFacts{Unit::kMicrosecond, Quantity::kTime, "microseconds", 1, 1'000'000,
              "us usec usecs micros microsec microsecond microseconds \u00B5s \u03BCs"},
    UnitFacts{Unit::kNanosecond, Quantity::kTime, "nanoseconds", 1, 1'000'000'000,
              "ns nsec nsecs nanos nanosec nanosecond nanoseconds"},
};

constexpr bool in_order_of_units() {
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    if (static_cast<std::size_t>(kUnits[i].unit) != i + 1) return false;
  }
  return true;
}
static_assert(in_order_of_units());

const UnitFacts* facts_of(Unit unit) {
  return unit == Unit::kUnstated ? nullptr : &kUnits[static_cast<std::size_t>(unit) - 1];
}

// value * factor / divisor, both whole and small: the nearest double, unless it is subnormal.
//
// The product is high + low exactly. A quotient q of `high` leaves a remainder that is exact; what
// is to be added to q is below its last place, and its own rounding 2^53 times smaller than that.
// No tie between two doubles can be missed: a tie makes the rest a half of the last place of q, of
// which nothing is rounded, and all else is at least 1 / (4 * factor * divisor) places away.
double times_ratio(double value, double factor, double divisor) {
  const double high = value * factor;
  const double low = std::fma(value, factor, -high);
  const double quotient = high / divisor;
  if (!std::isfinite(quotient) || divisor == 1.0) return quotient;
  return quotient + (std::fma(-quotient, divisor, high) + low) / divisor;
}

// "sec" as "s", and so on; empty for what is no time to divide by.
std::string_view per_time(std::string_view word) {
  if (is_one_of("s sec second seconds", word)) return "s";
  if (is_one_of("min minute minutes", word)) return "min";
  if (is_one_of("h hr hour hours", word)) return "h";
  return {};
}

}  // namespace

std::string_view symbol_of(Unit unit) {
  const UnitFacts* const facts = facts_of(unit);
  return facts == nullptr ? "an unknown unit" : facts->symbol;
}

std::string_view time_unit_option(Unit unit) {
  if (unit == Unit::kMillisecond) return "ms";
  if (unit == Unit::kMicrosecond) return "us";
  return unit == Unit::kNanosecond ? "ns" : "s";
}

Unit if_unit_of(Unit unit, Quantity quantity) {
  const UnitFacts* const facts = facts_of(unit);
  return facts != nullptr && facts->quantity == quantity ? unit : Unit::kUnstated;
}

double in_metric(double value, Unit unit) {
  const UnitFacts* const facts = facts_of(unit);
  if (facts == nullptr || facts->numerator == facts->denominator) return value;
  return times_ratio(value, facts->numerator, facts->denominator);
}

double from_metric(double value, Unit unit) {
  const UnitFacts* const facts = facts_of(unit);
  if (facts == nullptr || facts->numerator == facts->denominator) return value;
  return times_ratio(value, facts->denominator, facts->numerator);
}

std::optional<Unit> unit_of_word(std::string_view word, Quantity quantity) {
  for (const UnitFacts& facts : kUnits) {
    if (facts.quantity == quantity && is_one_of(facts.words, word)) return facts.unit;
  }
  return std::nullopt;
}

std::optional<Unit> unit_of_text(std::string_view text, Quantity quantity) {
  if (text == "M" || text.empty() || text.find(' ') != std::string_view::npos) return std::nullopt;
  return unit_of_word(lower_case(text), quantity);
}

std::optional<Unit> take_unit(std::vector<std::string>& words, Quantity quantity) {
  const std::size_t count = words.size();
  if (quantity == Quantity::kSpeed && count >= 3) {
    const std::string_view time = per_time(words.back());
    const bool per = words[count - 2] == "per";
    const std::size_t length = count - (per ? 3 : 2);
    const auto of = unit_of_word(words[length], Quantity::kLength);
    if (!time.empty() && of && length > 0) {
      std::string ratio(symbol_of(*of));
      ratio.append("/").append(time);
      if (const auto unit = unit_of_word(lower_case(ratio), quantity)) {
        words.resize(length);
        return unit;
      }
    }
  }
  if (count < 2) return std::nullopt;
  const auto unit = unit_of_word(words.back(), quantity);
  if (unit) words.pop_back();
  return unit;
}

std::string list_units(Quantity quantity) {
  std::string list;
  for (const UnitFacts& facts : kUnits) {
    if (facts.quantity != quantity || facts.words.empty()) continue;
    list.append(list.empty() ? "" : ", ").append(facts.symbol);
  }
  return list;
}

}  // namespace beespace::io
