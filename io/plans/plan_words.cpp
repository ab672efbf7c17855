#include "io/plans/plan_words.hpp"

#include "io/table/header_words.hpp"
#include "io/tracks/track_words.hpp"

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

// What a word makes of the coordinate beside it.
enum class Intent : std::uint8_t {
  kNow,    // no such word, or one that says as much
  kGoal,   // of a place only: a velocity at the goal would be something else
  kWanted  // of a place or a velocity
};

std::optional<Intent> intent_of(std::string_view word) {
  if (is_among(word, {"start", "from", "initial", "current", "begin"})) return Intent::kNow;
  if (is_among(word, {"goal", "destination", "dest", "ziel", "destino", "objetivo", "meta"})) {
    return Intent::kGoal;
  }
  if (is_among(word, {"target", "want", "wanted", "wish", "wished", "preferred", "pref", "desired",
                      "intended", "setpoint"})) {
    return Intent::kWanted;
  }
  return std::nullopt;
}

// Takes the word that says so out of the name, once; of "goalx", as lower case makes it of "goalX",
// it leaves the "x".
Intent take_intent(Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (const auto intent = intent_of(words[i])) {
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
      return *intent;
    }
    if (words[i].size() < 2 || words[i].find_last_of("xyz") + 1 != words[i].size()) continue;
    const std::string_view stem = std::string_view(words[i]).substr(0, words[i].size() - 1);
    if (const auto intent = intent_of(stem)) {
      words[i].erase(0, stem.size());
      return *intent;
    }
  }
  return Intent::kNow;
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : "_").append(word);
  return text;
}

// "max_speed", "vmax [m/s]", "acceleration limit".
std::optional<PlanWord> read_limit(Words words) {
  PlanWord found;
  found.unit = take_unit(words, Quantity::kSpeed).value_or(Unit::kUnstated);
  bool greatest = false;
  bool speed = false;
  bool acceleration = false;
  for (const std::string& word : words) {
    if (is_among(word, {"max", "maximum", "greatest", "limit", "top", "vmax", "amax"})) {
      greatest = true;
      speed = speed || word == "vmax";
      acceleration = acceleration || word == "amax";
    } else if (is_among(word, {"speed", "velocity", "vel", "v"})) {
      speed = true;
    } else if (is_among(word, {"acceleration", "accel", "acc", "a"})) {
      acceleration = true;
    } else if (is_among(word, {"kt", "kts", "kn", "knot", "knots", "km", "kmh", "kph", "mph", "ft",
                               "fps", "feet", "h", "g"})) {
      found.foreign_unit = word;
    } else if (!is_among(word,
                         {"m", "s", "mps", "mps2", "ms", "ms2", "s2", "s²", "2", "per", "meter",
                          "meters", "metre", "metres", "sec", "second", "squared"})) {
      return std::nullopt;
    }
  }
  if (!greatest || speed == acceleration) return std::nullopt;
  found.role = speed ? PlanRole::kMaxSpeed : PlanRole::kMaxAcceleration;
  if (acceleration && found.unit != Unit::kUnstated) {
    if (found.unit != Unit::kMetrePerSecond) found.foreign_unit = symbol_of(found.unit);
    found.unit = Unit::kUnstated;
  }
  return found;
}

std::optional<PlanWord> read_velocity(const std::string& name, Intent intent) {
  const TrackWord word = read_track_word(name);
  if (word.role != TrackRole::kVelocity || intent == Intent::kGoal) return std::nullopt;
  PlanWord found;
  found.role = intent == Intent::kWanted ? PlanRole::kWish : PlanRole::kVelocity;
  found.unit = word.speed_unit;
  found.foreign_unit = word.foreign_unit;
  switch (word.axis) {
    case VelocityAxis::kX:
      found.axis = 0;
      return found;
    case VelocityAxis::kY:
      found.axis = 1;
      return found;
    case VelocityAxis::kZ:
      found.axis = 2;
      return found;
    default:  // of the compass: whether x points east is not known here
      return std::nullopt;
  }
}

std::optional<PlanWord> read_place(const std::string& name, Intent intent) {
  const HeaderWord word = read_header_word(name);
  if (!word.prefix.empty()) return std::nullopt;
  PlanWord found;
  found.role = intent == Intent::kNow ? PlanRole::kPosition : PlanRole::kGoal;
  found.unit = word.unit;
  found.foreign_unit = word.foreign_unit;
  switch (word.role) {
    case Role::kX:
      found.axis = 0;
      return found;
    case Role::kY:
      found.axis = 1;
      return found;
    case Role::kZ:
      found.axis = 2;
      return found;
    case Role::kLongitude:
    case Role::kLatitude:
      found.role = PlanRole::kDegrees;
      return found;
    default:
      return std::nullopt;
  }
}

}  // namespace

PlanWord read_plan_word(std::string_view name) {
  Words words = split_words(name);
  if (words.empty()) return {};
  if (auto limit = read_limit(words)) return *std::move(limit);
  PlanWord other;
  if (read_track_word(name).role == TrackRole::kId) other.role = PlanRole::kId;
  const Intent intent = take_intent(words);
  const std::string rest = joined(words);
  if (auto velocity = read_velocity(rest, intent)) return *std::move(velocity);
  if (auto place = read_place(rest, intent)) return *std::move(place);
  return other;
}

}  // namespace beespace::io
