#include "io/tracks/track_words.hpp"

#include "io/table/header_words.hpp"

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

std::optional<TrackWord> read_velocity_word(Words words) {
  TrackWord found;
  found.role = TrackRole::kVelocity;
  found.speed_unit = take_unit(words, Quantity::kSpeed).value_or(Unit::kUnstated);
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
    } else if (unit_of_word(word, Quantity::kLength) ||
               is_among(word, {"min", "h", "hr", "hour", "minute"})) {
      found.foreign_unit = word;
    } else {
      return std::nullopt;
    }
  }
  if (!velocity || !axis) return std::nullopt;
  found.axis = *axis;
  return found;
}

// "groundspeed", "ground_speed_kt", "gs"; "track", "track [deg]"; "vertical_rate", "climb rate".
std::optional<TrackWord> read_over_ground(Words words) {
  TrackWord found;
  found.speed_unit = take_unit(words, Quantity::kSpeed).value_or(Unit::kUnstated);
  std::string name;
  for (const std::string& word : words) name.append(name.empty() ? "" : " ").append(word);
  if (is_among(name, {"groundspeed", "ground speed", "gs", "speed over ground"})) {
    found.role = TrackRole::kGroundSpeed;
  } else if (is_among(name, {"vertical rate", "verticalrate", "vert rate", "vertrate",
                             "vertical speed", "climb rate", "climb", "rate of climb", "roc",
                             "rocd", "baro rate", "geom rate"})) {
    found.role = TrackRole::kClimb;
  } else if (found.speed_unit == Unit::kUnstated &&
             is_among(name, {"track", "track deg", "track degrees", "true track", "track angle",
                             "course over ground", "cog"})) {
    found.role = TrackRole::kTrack;
  } else {
    return std::nullopt;
  }
  return found;
}

}  // namespace

TrackWord read_track_word(std::string_view name) {
  const Words words = split_words(name);
  if (words.empty()) return {};
  if (auto time = read_time_word(words)) return *std::move(time);
  if (auto velocity = read_velocity_word(words)) return *std::move(velocity);
  if (auto speed = read_over_ground(words)) return *std::move(speed);
  TrackWord other;
  if (read_header_word(name).role == Role::kId) other.role = TrackRole::kId;
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
