#include "io/header_words.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

namespace beespace::io {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view kLongitudeWords[] = {
    "lon", "longitude", "longitud", "lng", "long", "laenge", "länge", "lengte", "longitudine"};
constexpr std::string_view kLatitudeWords[] = {"lat",    "latitude", "latitud",
                                               "breite", "breedte",  "latitudine"};
constexpr std::string_view kHeightWords[] = {
    "height", "altitude", "alt",     "elevation", "elev",  "h",         "altura",    "altitud",
    "höhe",   "hoehe",    "hauteur", "hoogte",    "quota", "elevación", "elevacion", "geoaltitude"};
constexpr std::string_view kIdWords[] = {"id",     "name",     "icao",       "icao24",
                                         "hex",    "callsign", "identifier", "uuid",
                                         "nombre", "label",    "nom",        "hexid"};
constexpr std::string_view kMetreUnits[] = {"m",      "meter", "meters", "metre",
                                            "metres", "metro", "metros", "mts"};
constexpr std::string_view kDegreeUnits[] = {"deg",    "degree", "degrees", "grad",
                                             "grados", "°",      "dd"};
constexpr std::string_view kForeignUnits[] = {
    "ft",    "feet", "foot",   "pies",   "km",      "cm",         "mm",
    "rad",   "nm",   "mi",     "mile",   "miles",   "yd",         "yard",
    "yards", "inch", "inches", "radian", "radians", "kilometers", "kilometres"};
// Words that may stand beside a coordinate's name without changing what it is.
constexpr std::string_view kFillers[] = {
    "gps",        "wgs84",      "pos",        "position",    "coord", "coordinate", "coordinates",
    "coordenada", "koordinate", "coordonnee", "coordonnée",  "the",   "of",         "in",
    "de",         "la",         "el",         "der",         "die",   "du",         "degrees",
    "decimal",    "geo",        "geodetic",   "ellipsoidal", "drone", "bee",        "aircraft"};

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

// Runs of letters and digits, in lower case; bytes beyond ASCII count as letters.
std::vector<std::string> split_words(std::string_view name) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool part = upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                      static_cast<unsigned char>(c) >= 0x80;
    if (part && !inside) words.emplace_back();
    if (part) words.back() += upper ? static_cast<char>(c - 'A' + 'a') : c;
    inside = part;
  }
  return words;
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

std::optional<HeaderWord> read_course_word(const std::vector<std::string>& words) {
  const bool coordinate = std::any_of(words.begin(), words.end(), [](std::string_view word) {
    return starts_with_any(word, {"coord", "koord"});
  });
  if (!coordinate || std::none_of(words.begin(), words.end(), speaks_of_a_bee)) return {};
  HeaderWord found;
  found.course_format = true;
  found.frame = Frame::kWgs84;
  for (const auto& word : words) {
    if (axis_role(word) != Role::kNone) found.role = as_geographic(axis_role(word));
  }
  return found;
}

}  // namespace

HeaderWord read_header_word(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  if (auto course = read_course_word(words)) return *std::move(course);

  HeaderWord found;
  bool degrees = false;
  bool plain = true;  // nothing but the coordinate, its unit and what names metres
  std::size_t unknown = 0;
  for (const auto& word : words) {
    const Role role = word_role(word);
    if (role != Role::kNone) {
      unknown += found.role == Role::kNone ? 0 : 1;
      found.role = role;
    } else if (is_among(word, kDegreeUnits)) {
      degrees = true;
    } else if (is_among(word, kForeignUnits)) {
      found.foreign_unit = word;
    } else if (is_among(word, kFillers)) {
      plain = false;
    } else if (!is_among(word, kMetreUnits) && !is_among(word, {"ecef", "enu", "local"})) {
      ++unknown;
    }
  }
  if (found.role == Role::kNone || unknown > 0) {
    const bool id = std::any_of(words.begin(), words.end(),
                                [](std::string_view word) { return is_among(word, kIdWords); });
    HeaderWord other;
    other.role = id ? Role::kId : Role::kNone;
    return other;
  }
  if (degrees) found.role = as_geographic(found.role);
  if (found.role == Role::kLongitude || found.role == Role::kLatitude) {
    found.frame = Frame::kWgs84;
  } else if (found.role != Role::kHeight && plain) {
    found.frame = Frame::kMetres;
  }
  return found;
}

}  // namespace beespace::io
