#include "io/tracks/utm_zone.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/header_words.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/first_fields.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

bool has_word(const std::vector<std::string>& words, std::string_view any_of) {
  return std::any_of(words.begin(), words.end(),
                     [any_of](const std::string& word) { return is_one_of(any_of, word); });
}

// As eastings and northings in metres are.
bool is_first_between(std::string_view text, const TableLayout& table, std::size_t column,
                      double least, double most) {
  const FirstFields fields = first_fields(text, table, column);
  double number = 0.0;
  return !fields.empty() &&
         parse_number(without_padding(fields.front()), number) == NumberKind::kNumber &&
         number >= least && number < most;
}

}  // namespace

std::optional<std::size_t> find_utm_zone(std::string_view text, const TableLayout& table) {
  const std::size_t x = table.choice.axes[0];
  if (x >= table.names.size()) return std::nullopt;
  const bool easting = has_word(split_words(table.names[x]), "easting east utm e rechtswert") ||
                       (is_first_between(text, table, x, 100'000.0, 1e6) &&
                        is_first_between(text, table, table.choice.axes[1], 100'000.0, 1e7));
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto words = split_words(table.names[i]);
    const bool zone = has_word(words, "zone utmzone");
    if (zone && ((easting && names_zone(table.names[i])) || words[0] == "utmzone" ||
                 has_word(words, "utm grid"))) {
      return i;
    }
  }
  return std::nullopt;
}

std::string utm_zone_of(std::string_view text) {
  std::string zone;
  for (const char c : lower_case(text)) {
    if (c != ' ' && (c != '0' || !zone.empty())) zone += c;
  }
  if (zone.empty()) return zone;
  const std::string hemisphere =
      zone.substr(std::min(zone.find_first_not_of("0123456789"), zone.size()));
  const std::string number = zone.substr(0, zone.size() - hemisphere.size());
  // Bands of latitude: C to M south, N to X north of the equator, of which S reads as "south", too.
  if (hemisphere.size() != 1 || hemisphere == "s") return zone;
  const char band = hemisphere.front();
  if (band >= 'n' && band <= 'x') return number + "n";
  return band >= 'c' && band <= 'm' ? number + "south" : zone;
}

std::optional<Error> other_zone(std::string_view text, const TableLayout& table, std::size_t column,
                                std::optional<std::string>& zone) {
  RecordWalk walk(text, 0, table);
  while (walk.next()) {
    const Field field = field_at(walk.record(), table.delimiter, column);
    const std::string here = utm_zone_of(without_padding(field.text));
    if (!zone) zone = here;
    if (*zone == here) continue;
    Error error{ErrorCode::kUnknownFrame,
                "this easting and northing are of UTM zone " + excerpt(field.text) +
                    ", but those before are of " + excerpt(*zone) +
                    ": they cannot be compared; take longitude and latitude, as with --columns "
                    "lon=...,lat=..., or bring all into one zone",
                {}};
    error.location.line = walk.line() + 1;
    error.location.record = walk.row();
    error.location.column = column + 1;
    return error;
  }
  return std::nullopt;
}

}  // namespace beespace::io
