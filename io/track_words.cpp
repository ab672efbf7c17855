#include "io/track_words.hpp"

#include "io/header_words.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Words = std::vector<std::string>;

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TimeUnit unit_of(std::string_view word) {
  if (is_among(word, {"s", "sec", "secs", "second", "seconds", "segundos", "sekunden", "secondes",
                      "secondi"})) {
    return TimeUnit::kSeconds;
  }
  if (is_among(word, {"ms", "msec", "msecs", "millis", "millisec", "millisecond", "milliseconds",
                      "milisegundos", "millisekunden", "millisecondes", "millisecondi"})) {
    return TimeUnit::kMilliseconds;
  }
  // The micro sign and the Greek letter.
  if (is_among(word, {"us", "usec", "usecs", "micros", "microsec", "microsecond", "microseconds",
                      "\xC2\xB5s", "\xCE\xBCs"})) {
    return TimeUnit::kMicroseconds;
  }
  if (is_among(word, {"ns", "nsec", "nsecs", "nanos", "nanosec", "nanosecond", "nanoseconds"})) {
    return TimeUnit::kNanoseconds;
  }
  return TimeUnit::kAuto;
}

bool is_foreign_time_unit(std::string_view word) {
  return is_among(word, {"min", "mins", "minute", "minutes", "h", "hr", "hour", "hours", "d", "day",
                         "days", "tow", "ticks", "frames", "jd", "mjd"});
}

bool says_time(std::string_view word) {
  return is_among(word, {"time", "t", "timestamp", "timestamps", "ts", "datetime", "zeit", "tiempo",
                         "temps", "tempo", "stamp"});
}

// "timems", as lower case makes it of "timeMs".
TimeUnit unit_behind_time(std::string_view word) {
  for (const std::string_view noun : {"timestamp", "time"}) {
    if (word.substr(0, noun.size()) != noun) continue;
    const std::string_view unit = word.substr(noun.size());
    return unit == "s" ? TimeUnit::kAuto : unit_of(unit);
  }
  return TimeUnit::kAuto;
}

std::optional<TrackWord> read_time_word(const Words& words) {
  TrackWord found;
  found.role = TrackRole::kTime;
  bool time =
      words.size() == 1 && words.front().size() > 2 && unit_of(words.front()) != TimeUnit::kAuto;
  for (const std::string& word : words) {
    const TimeUnit joined = unit_behind_time(word);
    const TimeUnit unit = joined != TimeUnit::kAuto ? joined : unit_of(word);
    if (joined != TimeUnit::kAuto || says_time(word)) time = true;
    if (unit != TimeUnit::kAuto) {
      found.unit = unit;
    } else if (is_foreign_time_unit(word)) {
      found.foreign_unit = word;
    } else if (is_among(word, {"unix", "posix", "epoch", "1970"})) {
      found.since_1970 = true;
    } else if (!says_time(word) &&
               !is_among(word, {"since", "start", "elapsed", "utc", "iso", "iso8601", "8601",
                                "rfc3339", "boot", "begin", "sim", "simulation", "in", "of", "the",
                                "from", "flight", "mission", "sample"})) {
      return std::nullopt;
    }
  }
  if (!time) return std::nullopt;
  return found;
}

std::optional<VelocityAxis> axis_of(std::string_view word) {
  if (word == "x") return VelocityAxis::kX;
  if (word == "y") return VelocityAxis::kY;
  if (word == "z") return VelocityAxis::kZ;
  if (is_among(word, {"e", "east"})) return VelocityAxis::kEast;
  if (is_among(word, {"n", "north"})) return VelocityAxis::kNorth;
  if (is_among(word, {"u", "up"})) return VelocityAxis::kUp;
  if (is_among(word, {"d", "down"})) return VelocityAxis::kDown;
  return std::nullopt;
}

std::optional<TrackWord> read_velocity_word(const Words& words) {
  TrackWord found;
  found.role = TrackRole::kVelocity;
  bool velocity = false;
  std::optional<VelocityAxis> axis;
  for (const std::string& word : words) {
    auto named = axis_of(word);
    if (!named && word.size() == 2 && word.front() == 'v') {
      named = axis_of(std::string_view(word).substr(1));
      velocity = velocity || named.has_value();
    }
    if (named) {
      if (axis) return std::nullopt;
      axis = named;
    } else if (is_among(word, {"v", "vel", "velocity", "speed", "velocidad", "vitesse",
                               "geschwindigkeit", "velocita"})) {
      velocity = true;
    } else if (is_among(word, {"kt",   "kts", "kn",  "knot", "knots", "km", "kmh", "kph",
                               "mph",  "ft",  "fps", "fpm",  "min",   "h",  "hr",  "hour",
                               "mile", "cm",  "cms", "mm",   "feet",  "mi"})) {
      found.foreign_unit = word;
    } else if (!is_among(word, {"m", "s", "mps", "ms", "meter", "meters", "metre", "metres", "per",
                                "sec", "second"})) {
      return std::nullopt;
    }
  }
  if (!velocity || !axis) return std::nullopt;
  found.axis = *axis;
  return found;
}

bool names_a_mover(const Words& words) {
  return words.size() == 1 &&
         is_among(words.front(), {"bee", "drone", "uav", "agent", "vehicle", "robot", "aircraft",
                                  "boid", "object", "abeja", "biene", "abeille"});
}

}  // namespace

TrackWord read_track_word(std::string_view name) {
  const Words words = split_words(name);
  if (words.empty()) return {};
  if (auto time = read_time_word(words)) return *std::move(time);
  if (auto velocity = read_velocity_word(words)) return *std::move(velocity);
  TrackWord other;
  if (names_a_mover(words) || read_header_word(name).role == Role::kId) {
    other.role = TrackRole::kId;
  }
  return other;
}

std::string_view unit_name(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::kSeconds:
      return "seconds";
    case TimeUnit::kMilliseconds:
      return "milliseconds";
    case TimeUnit::kMicroseconds:
      return "microseconds";
    case TimeUnit::kNanoseconds:
      return "nanoseconds";
    case TimeUnit::kAuto:
      break;
  }
  return "an unknown unit";
}

double units_per_second(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::kMilliseconds:
      return 1e3;
    case TimeUnit::kMicroseconds:
      return 1e6;
    case TimeUnit::kNanoseconds:
      return 1e9;
    default:
      return 1.0;
  }
}

}  // namespace beespace::io
