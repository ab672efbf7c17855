// Units of lengths, speeds and times: the words that name them, and how many of ours they are.
//
// Everything about a unit stands in one table (units.cpp). Ours are metres, metres per second and
// seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

enum class Quantity : std::uint8_t { kLength, kSpeed, kTime };

enum class Unit : std::uint8_t {
  kUnstated,
  kMetre,
  kKilometre,
  kCentimetre,
  kMillimetre,
  kMicrometre,
  kFoot,
  kFlightLevel,  // a hundred feet
  kYard,
  kInch,
  kMile,
  kNauticalMile,
  kPixel,  // of an image: how long it is is for the caller to say
  kMetrePerSecond,
  kKilometrePerHour,
  kMetrePerMinute,
  kCentimetrePerSecond,
  kMillimetrePerSecond,
  kKnot,
  kMilePerHour,
  kFootPerSecond,
  kFootPerMinute,
  kSecond,
  kMillisecond,
  kMicrosecond,
  kNanosecond,
};

// "ft", "km/h", "seconds", ...
std::string_view symbol_of(Unit unit);

// Of a time as the values of --time-unit are: "s", "ms", "us", "ns".
std::string_view time_unit_option(Unit unit);

// The same unit if it is one of that quantity; otherwise kUnstated.
Unit if_unit_of(Unit unit, Quantity quantity);

// The same in metres, metres per second or seconds: the nearest double to the product with the
// exact factor by which the unit is defined (1 ft = 381/1250 m), so rounded once. Unstated units
// are ours.
double in_metric(double value, Unit unit);
// The other way round, in general rounded once as well.
double from_metric(double value, Unit unit);

// The unit that a word names, in lower case and in several languages: "ft", "feet", "pies", "kts".
std::optional<Unit> unit_of_word(std::string_view word, Quantity quantity);

// The unit that all of `text` names, as an option's value has it: "ft", "NM", "km/h", "ft/min".
// Capitals count nowhere but in "M", which never means metres.
std::optional<Unit> unit_of_text(std::string_view text, Quantity quantity);

// The unit that the last words of a name spell, which are taken away: "m", "s" or "ft", "per",
// "min" too, not only "fpm". Nothing where they spell none, or where nothing else would be left.
std::optional<Unit> take_unit(std::vector<std::string>& words, Quantity quantity);

// "m, km, cm, mm, ft, ...": what unit_of_text() takes.
std::string list_units(Quantity quantity);

}  // namespace beespace::io
