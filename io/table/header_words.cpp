#include "io/table/header_words.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view kLongitudeWords[] = {
    "lon",    "longitude",   "longitud",   "lng",         "long",    "laenge", "länge",
    "lengte", "longitudine", "längengrad", "laengengrad", "долгота", "boylam", "lengtegraad"};
constexpr std::string_view kLatitudeWords[] = {
    "lat",   "latitude", "latitud",    "breite",      "breedte",
    "enlem", "широта",   "latitudine", "breitengrad", "breedtegraad"};
constexpr std::string_view kHeightWords[] = {
    "height",  "altitude",  "alt",        "elevation",   "elev",      "h",
    "altura",  "altitud",   "höhe",       "hoehe",       "hauteur",   "hoogte",
    "quota",   "elevación", "высота",     "elevacion",   "élévation", "geoaltitude",
    "altezza", "yükseklik", "altitudine", "baroaltitude"};
constexpr std::string_view kIdWords[] = {"id",     "name",     "icao",       "icao24",
                                         "hex",    "callsign", "identifier", "uuid",
                                         "nombre", "label",    "nom",        "hexid"};
constexpr std::string_view kMetreFrames[] = {"ecef", "enu", "ned", "local"};
constexpr std::string_view kDegreeUnits[] = {"deg",    "degree", "degrees", "grad",
                                             "grados", "°",      "dd"};
// What a column may be called that tells bees apart, where it is called nothing else.
constexpr std::string_view kMoverWords[] = {"bee",     "drone", "uav",      "agent",
                                            "vehicle", "robot", "aircraft", "boid",
                                            "object",  "abeja", "biene",    "abeille"};
constexpr std::string_view kForeignUnits[] = {"rad", "radian", "radians"};
// What a height is counted from.
constexpr std::string_view kPressureWords[] = {"baro", "barometric", "pressure"};
constexpr std::string_view kEllipsoidWords[] = {"geo",      "geom",        "geometric",
                                                "geodetic", "ellipsoidal", "ellipsoid"};
constexpr std::string_view kSeaLevelWords[] = {"msl", "amsl"};
// Words that may stand beside a coordinate's name without changing what it is.
constexpr std::string_view kFillers[] = {"gps", "wgs84", "degrees", "decimal", "drone", "aircraft"};
constexpr std::string_view kArticles[] = {
    "the", "of", "in", "de", "la", "el",  "der", "die", "das", "du", "des", "dell", "della", "di",
    "l",   "d",  "le", "da", "do", "del", "las", "los", "les", "a",  "von", "each", "cada"};
// Words that make another quantity of a coordinate, or a coordinate of something else.
constexpr std::string_view kOtherQuantities[] = {
    "std",      "sigma", "err",  "error",  "acc",   "accuracy", "var",  "cov",
    "delta",    "diff",  "rel",  "vel",    "speed", "velocity", "rate", "relative",
    "min",      "max",   "ref",  "home",   "start", "last",     "prev", "base",
    "target",   "next",  "goal", "origin", "accel", "gyro",     "mag",  "force",
    "previous", "size",  "old",  "end",    "first", "v"};

bool is_among(std::string_view word, Words words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return is_among(word, Words(words.begin(), words.size()));
}

bool starts_with_any(std::string_view word, std::initializer_list<std::string_view> stems) {
  return std::any_of(stems.begin(), stems.end(),
                     [word](std::string_view stem) { return word.substr(0, stem.size()) == stem; });
}

// What a word says of the height beside it; nothing for other words.
HeightDatum datum_of(std::string_view word) {
  if (word == "baroaltitude" || is_among(word, kPressureWords)) return HeightDatum::kPressure;
  if (word == "geoaltitude" || is_among(word, kEllipsoidWords)) return HeightDatum::kEllipsoid;
  if (is_among(word, kSeaLevelWords)) return HeightDatum::kMeanSeaLevel;
  return HeightDatum::kUnstated;
}

Role axis_role(std::string_view word) {
  if (word == "x") return Role::kX;
  if (word == "y") return Role::kY;
  if (word == "z") return Role::kZ;
  return Role::kNone;
}

Role word_role(std::string_view word) {
  if (is_among(word, kLongitudeWords)) return Role::kLongitude;
  if (is_among(word, kLatitudeWords)) return Role::kLatitude;
  if (is_among(word, kHeightWords)) return Role::kHeight;
  if (is_among(word, {"east", "easting"})) return Role::kX;
  if (is_among(word, {"north", "northing"})) return Role::kY;
  if (word == "up") return Role::kZ;
  return axis_role(word);
}

Role as_geographic(Role role) {
  switch (role) {
    case Role::kX:
      return Role::kLongitude;
    case Role::kY:
      return Role::kLatitude;
    case Role::kZ:
      return Role::kHeight;
    default:
      return role;
  }
}

bool speaks_of_a_bee(std::string_view word) {
  return starts_with_any(word, {"abeja", "bee", "biene", "abeille", "abelha"}) ||
         is_among(word, {"ape", "api"});
}

bool speaks_of_a_coordinate(std::string_view word) {
  return starts_with_any(word, {"coord", "koord"});
}

// A coordinate of a bee and nothing else: units and frames are for the general rules.
std::optional<HeaderWord> read_course_word(const std::vector<std::string>& words) {
  bool coordinate = false;
  bool bee = false;
  bool metres = false;
  Role axis = Role::kNone;
  for (const auto& word : words) {
    if (axis_role(word) != Role::kNone) {
      if (axis != Role::kNone) return std::nullopt;
      axis = axis_role(word);
    } else if (speaks_of_a_coordinate(word)) {
      coordinate = true;
    } else if (speaks_of_a_bee(word)) {
      bee = true;
    } else if (unit_of_word(word, Quantity::kLength) == Unit::kMetre) {
      metres = true;
    } else if (!is_among(word, kArticles)) {
      return std::nullopt;
    }
  }
  const bool height = axis == Role::kZ;
  if (!coordinate || !bee || axis == Role::kNone || (metres && !height)) return std::nullopt;
  HeaderWord found;
  found.course_format = true;
  found.frame = Frame::kWgs84;
  found.role = as_geographic(axis);
  return found;
}

// Whether any of the words may speak of a coordinate, in whatever way.
bool may_say_position(const std::vector<std::string>& words) {
  constexpr std::string_view kStems[] = {"lat",   "lon",   "lng",  "alt",   "breit",  "läng",
                                         "laeng", "шир",   "долг", "enlem", "boylam", "heigh",
                                         "höhe",  "hoehe", "выс",  "elev",  "coord",  "koord"};
  for (const std::string& word : words) {
    if (word_role(word) != Role::kNone) return true;
    for (const std::string_view stem : kStems) {
      if (word.find(stem) != std::string::npos) return true;
    }
    // "px", "x1", "e", "n".
    if (is_among(word, {"e", "n"})) return true;
    if (word.size() == 2 && word.find_first_of("xyz") != std::string::npos) return true;
  }
  return false;
}

// The words of one name, taken in one after the other.
class NameReading {
 public:
  void take(const std::string& word) {
    const Role role = word_role(word);
    const auto unit = unit_of_word(word, Quantity::kLength);
    // "gs_km_h" is no height.
    understood_ = understood_ && !(word == "h" && found_.unit != Unit::kUnstated);
    if (const HeightDatum datum = datum_of(word); datum != HeightDatum::kUnstated) {
      found_.datum = datum;
    }
    if (role != Role::kNone) {
      understood_ = understood_ && found_.role == Role::kNone;
      found_.role = role;
    } else if (is_among(word, {"n", "e"})) {
      compass_ = word.front();
    } else if (is_among(word, kDegreeUnits)) {
      degrees_ = true;
    } else if (is_among(word, kForeignUnits)) {
      found_.foreign_unit = word;
    } else if (unit) {
      understood_ = understood_ && found_.unit == Unit::kUnstated;
      found_.unit = *unit;
      found_.says_length = true;
    } else if (is_among(word, kMetreFrames)) {
      found_.says_length = true;
    } else if (datum_of(word) != HeightDatum::kUnstated) {
      plain_ = false;
    } else if (is_among(word, kFillers) || is_among(word, kArticles) || speaks_of_a_bee(word) ||
               speaks_of_a_coordinate(word)) {
      plain_ = false;
    } else if (!is_among(word, {"pos", "position"})) {
      // Behind the coordinate it may say anything: "lat_error".
      understood_ = understood_ && found_.role == Role::kNone && !is_among(word, kOtherQuantities);
      found_.prefix += (found_.prefix.empty() ? "" : "_") + word;
    }
  }

  // Nothing when it is not understood to its last word.
  std::optional<HeaderWord> finish() {
    if (!understood_ || found_.role == Role::kNone) return std::nullopt;
    if (compass_ == 'n' && found_.role != Role::kLatitude) return std::nullopt;
    if (compass_ == 'e' && found_.role != Role::kLongitude) return std::nullopt;
    if (degrees_) found_.role = as_geographic(found_.role);
    const bool degrees = found_.role == Role::kLongitude || found_.role == Role::kLatitude;
    if (found_.datum == HeightDatum::kPressure || found_.datum == HeightDatum::kMeanSeaLevel) {
      if (degrees) return std::nullopt;
    }
    if (degrees) {
      found_.datum = HeightDatum::kUnstated;
      found_.frame = Frame::kWgs84;
    } else if (found_.role != Role::kHeight &&
               (found_.says_length || (plain_ && found_.prefix.empty()))) {
      found_.frame = Frame::kMetres;
    }
    return std::move(found_);
  }

 private:
  HeaderWord found_;
  bool understood_ = true;
  bool degrees_ = false;
  bool plain_ = true;  // nothing but the coordinate and what names metres
  char compass_ = '\0';
};

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

HeaderWord read_header_word(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  if (auto course = read_course_word(words)) return *std::move(course);
  NameReading reading;
  for (const auto& word : words) reading.take(word);
  if (auto found = reading.finish()) return *std::move(found);
  HeaderWord other;
  const bool id = (words.size() == 1 && is_among(words.front(), kMoverWords)) ||
                  std::any_of(words.begin(), words.end(),
                              [](std::string_view word) { return is_among(word, kIdWords); });
  other.role = id ? Role::kId : Role::kNone;
  other.says_position = !id && may_say_position(words);
  return other;
}

}  // namespace beespace::io
