#include "io/table/column_names.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::io {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words, char between) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

Role as_geographic(Role role) {
  const auto axis = part_within(Role::kX, role);
  return axis ? part_of(Role::kLongitude, *axis) : role;
}

// The words of one name, taken in one after the other.
class NameReading {
 public:
  explicit NameReading(const NamePattern& pattern) : pattern_(pattern) {}

  // Nothing when the name is not understood to its last word.
  std::optional<ColumnMeaning> read(Words words) {
    if (pattern_.unit == UnitPlace::kLast) {
      found_.unit = take_unit(words, pattern_.quantity).value_or(Unit::kUnstated);
    }
    if (pattern_.whole) words = {joined(words, '-')};
    for (const std::string& word : words) {
      if (!take(word, words.size() == 1)) return std::nullopt;
    }
    return finish();
  }

 private:
  bool take(const std::string& word, bool alone) {
    const auto says =
        std::find_if(pattern_.words.begin(), pattern_.words.end(),
                     [&word](const NameWords& of) { return is_one_of(of.words, word); });
    if (says != pattern_.words.end()) return take(*says, word);
    if (pattern_.unit == UnitPlace::kAnywhere) {
      if (const auto unit = unit_in(word, alone)) {
        if (found_.unit != Unit::kUnstated && found_.unit != *unit) {
          // It is a time all the same: one without a unit, so that the unit is asked for.
          if (pattern_.quantity != Quantity::kTime) return false;
          units_disagree_ = true;
        }
        found_.unit = *unit;
        found_.says_length = found_.says_length || pattern_.quantity == Quantity::kLength;
        return true;
      }
    }
    if (pattern_.quantity == Quantity::kSpeed && pattern_.unit != UnitPlace::kNowhere &&
        !pattern_.whole && unit_of_word(word, Quantity::kLength)) {
      found_.foreign_unit = word;
      return true;
    }
    if (pattern_.anything) return true;
    // Behind the coordinate a word may say anything: "lat_error".
    if (!pattern_.prefix || has(Says::kPart)) return false;
    found_.prefix += (found_.prefix.empty() ? "" : "_") + word;
    return true;
  }

  bool take(const NameWords& of, const std::string& word) {
    const auto says = [&of](unsigned what) { return (of.says & what) != 0; };
    if (says(Says::kOther)) return false;
    if (says(Says::kBeforeUnit) && found_.unit != Unit::kUnstated) return false;
    if (says(Says::kPart) && has(Says::kPart)) return false;
    if (says(Says::kConfirms)) {
      confirmed_.push_back(of.role);
    } else if (of.role != Role::kNone) {
      if (found_.role != Role::kNone && found_.role != of.role) return false;
      found_.role = of.role;
    }
    if (says(Says::kForeign)) found_.foreign_unit = word;
    found_.says_length = found_.says_length || says(Says::kLength);
    found_.since_1970 = found_.since_1970 || says(Says::kSince1970);
    if (of.datum != HeightDatum::kUnstated) found_.datum = of.datum;
    said_ |= of.says;
    return true;
  }

  // A unit by itself, or joined to a noun as lower case makes "timems" of "timeMs".
  std::optional<Unit> unit_in(std::string_view word, bool alone) {
    auto unit = unit_of_word(word, pattern_.quantity);
    if (unit && alone && pattern_.unit_alone && word.size() > 2) said_ |= Says::kNoun;
    for (std::size_t size = 1; size + 1 < word.size() && !unit; ++size) {
      for (const NameWords& of : pattern_.words) {
        if ((of.says & Says::kJoined) == 0 || !is_one_of(of.words, word.substr(0, size))) continue;
        unit = unit_of_word(word.substr(size), pattern_.quantity);
        if (unit) said_ |= of.says;
      }
    }
    return unit;
  }

  [[nodiscard]] bool has(unsigned what) const { return (said_ & what) == what; }

  std::optional<ColumnMeaning> finish() {
    if (!has(pattern_.needed)) return std::nullopt;
    if (units_disagree_) found_.unit = Unit::kUnstated;
    if (found_.role == Role::kNone) found_.role = pattern_.role;
    for (const Role role : confirmed_) {
      if (role != found_.role) return std::nullopt;
    }
    if (has(Says::kNoUnit) && found_.unit != Unit::kUnstated) {
      if (in_metric(1.0, found_.unit) != 1.0) found_.foreign_unit = symbol_of(found_.unit);
      found_.unit = Unit::kUnstated;
    }
    return finish_position() ? std::optional(std::move(found_)) : std::nullopt;
  }

  // What else a coordinate says.
  bool finish_position() {
    if (has(Says::kDegrees)) found_.role = as_geographic(found_.role);
    found_.course_format = pattern_.course;
    if (found_.role == Role::kLongitude || found_.role == Role::kLatitude) {
      const bool above_sea =
          found_.datum == HeightDatum::kPressure || found_.datum == HeightDatum::kMeanSeaLevel;
      if (above_sea) return false;
      found_.datum = HeightDatum::kUnstated;
      found_.frame = Frame::kWgs84;
    } else if (part_within(Role::kX, found_.role)) {
      const bool plain = !has(Says::kBeside) && found_.datum == HeightDatum::kUnstated;
      if (found_.says_length || (plain && found_.prefix.empty())) found_.frame = Frame::kMetres;
    }
    return true;
  }

  const NamePattern& pattern_;
  ColumnMeaning found_;
  unsigned said_ = 0;
  bool units_disagree_ = false;
  std::vector<Role> confirmed_;
};

// Takes the word that says what is intended out of the name, once; of "goalx", as lower case makes
// it of "goalX", it leaves the "x".
const Intent* take_intent(const ColumnSchema& schema, Words& words) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    const bool axis = word->size() > 1 && word->find_last_of("xyz") + 1 == word->size();
    for (const Intent& intent : schema.intents) {
      if (is_one_of(intent.words, *word)) {
        words.erase(word);
        return &intent;
      }
      if (!axis || !is_one_of(intent.words, word->substr(0, word->size() - 1))) continue;
      word->erase(0, word->size() - 1);
      return &intent;
    }
  }
  return nullptr;
}

// kX as the intent has it; kNone where that has no meaning.
Role intended(Role role, const Intent* intent) {
  if (intent == nullptr) return role;
  for (const auto& [first, becomes] :
       {std::pair{Role::kX, intent->place}, std::pair{Role::kVelocityX, intent->velocity}}) {
    const auto axis = part_within(first, role);
    if (axis) return becomes == Role::kNone ? Role::kNone : part_of(becomes, *axis);
  }
  return role;
}

// Whether any of the words may speak of a coordinate, in whatever way.
bool may_say_position(const ColumnSchema& schema, const Words& words) {
  return std::any_of(words.begin(), words.end(), [&schema](const std::string& word) {
    if (is_one_of(schema.hints, word)) return true;
    return std::any_of(schema.names.begin(), schema.names.end(), [&word](const NamePattern& of) {
      return std::any_of(of.words.begin(), of.words.end(), [&word](const NameWords& words_of) {
        return (words_of.says & Says::kPart) != 0 && is_one_of(words_of.words, word);
      });
    });
  });
}

}  // namespace

std::vector<std::string> split_words(std::string_view name) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : lower_case(name)) {
    const bool part =
        (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (part && !inside) words.emplace_back();
    if (part) words.back() += c;
    inside = part;
  }
  return words;
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const std::string& word : split_words(name)) plain.append(plain.empty() ? "" : "_") += word;
  return plain;
}

ColumnMeaning read_column_name(const ColumnSchema& schema, std::string_view name) {
  const Words words = split_words(name);
  Words rest = words;
  const Intent* const intent = take_intent(schema, rest);
  for (const NamePattern& pattern : schema.names) {
    auto found = NameReading(pattern).read(pattern.intended ? rest : words);
    if (!found) continue;
    if (schema.strict && !found->prefix.empty()) return {};
    if (pattern.intended) found->role = intended(found->role, intent);
    if (found->role != Role::kNone) return *std::move(found);
  }
  ColumnMeaning other;
  other.says_position = may_say_position(schema, words);
  return other;
}

}  // namespace beespace::io
