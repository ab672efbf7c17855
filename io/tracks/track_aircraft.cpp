#include "io/tracks/track_aircraft.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/address_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/header_words.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

// The column that says what each is called beside its id.
std::optional<std::size_t> choose_label(const Header& header, std::optional<std::size_t> id) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (names_flight(header.table().names[i]) && i != id) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> choose_on_ground(const Header& header) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto words = split_words(header.table().names[i]);
    const bool joined = words.size() == 1 && words[0] == "onground";
    if (joined || (words.size() == 2 && words[0] == "on" && words[1] == "ground")) return i;
  }
  return std::nullopt;
}

// What is to be said of a record without a height of that kind.
const LeftOutReason* reason_without_height(const Header& header, HeightDatum datum) {
  if (datum == HeightDatum::kPressure) return &kNoPressureHeight;
  for (std::size_t i = 0; i < header.size() && datum == HeightDatum::kEllipsoid; ++i) {
    if (header.meaning(i).datum == HeightDatum::kPressure) return &kNoEllipsoidHeight;
  }
  return &kNoHeight;
}

// The unit of heights that the caller says.
std::optional<Unit> asked_height_unit(const TrackLayout& layout) {
  for (const UnitTaken& taken : layout.units) {
    if (taken.of == "heights" && taken.evidence == UnitEvidence::kAsked) return taken.unit;
  }
  return std::nullopt;
}

// Of a known source, which says the unit of both; and what is said of it.
void settle_other_height(const Header& header, TrackLayout& layout) {
  const ColumnChoice& choice = layout.table.choice;
  if (choice.dimensions != 3) return;
  const bool pressure = choice.datum == HeightDatum::kPressure;
  if (!pressure && choice.datum != HeightDatum::kEllipsoid) return;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const ColumnMeaning& meaning = header.meaning(i);
    const bool other =
        meaning.role == Role::kHeight && i != choice.axes[2] &&
        meaning.datum == (pressure ? HeightDatum::kEllipsoid : HeightDatum::kPressure);
    if (!other) continue;
    layout.notes.push_back(
        "heights are " + std::string(pressure ? "by pressure" : "above the ellipsoid") + ", of " +
        column_text(layout.table, choice.axes[2]) + "; " + column_text(layout.table, i) +
        " is passed over (--heights " + (pressure ? "geometric" : "pressure") + " takes it)");
    if (header.source() == nullptr || layout.other_height) continue;
    const KnownColumn* const known = header.source()->find(layout.table.names[i]);
    if (known == nullptr || known->unit == Unit::kUnstated) continue;
    layout.other_height = i;
    // Who says another unit than the source's means both.
    layout.other_height_unit = asked_height_unit(layout).value_or(known->unit);
  }
}

}  // namespace

bool is_unknown(std::string_view text) {
  // Signs and digits come before letters: nearly all texts are numbers.
  if (!text.empty() && text.front() <= '9') {
    constexpr std::size_t kLongest = 4;
    return text.front() < '0' && text.size() <= kLongest &&
           is_one_of(". - -- #n/a", lower_case(text));
  }
  const std::string lower = lower_case(text);
  return lower.empty() || is_one_of("nan nat none null na n/a <na> n.d. n/d", lower);
}

bool says_yes(std::string_view text) {
  return is_one_of("true t yes y 1 1.0 wahr ja vrai oui vero verdadero verdadeiro",
                   lower_case(without_padding(text)));
}

bool says_no(std::string_view text) {
  return is_one_of("false f no n 0 0.0 falsch nein faux non falso",
                   lower_case(without_padding(text)));
}

bool names_flight(std::string_view column) {
  const auto words = split_words(column);
  return (words.size() == 1 && is_one_of("callsign flight", words[0])) ||
         (words.size() == 2 && words[0] == "call" && words[1] == "sign");
}

bool name_aircraft(const std::vector<std::string>& columns) {
  const auto any_is = [&columns](const auto& is) {
    return std::any_of(columns.begin(), columns.end(), is);
  };
  // Ships have call signs, too.
  const bool ships = any_is([](const std::string& name) {
    return is_one_of("mmsi imo vessel vesselname vesseltype shipname shiptype sog",
                     plain_name(name));
  });
  if (ships || words_of_aviation(columns).empty()) return false;
  // A drone may count its flights.
  return any_is(names_address) || any_is([](const std::string& name) {
           return names_flight(name) && plain_name(name) != "flight";
         });
}

bool tells_of_aircraft(const TrackLayout& layout) {
  if (layout.show) return false;
  const TableSource* const source = source_of(layout.table.names);
  return (source != nullptr && source->of_aircraft) || name_aircraft(layout.table.names) ||
         std::any_of(layout.units.begin(), layout.units.end(),
                     [](const UnitTaken& taken) { return taken.unit == Unit::kNauticalMile; });
}

void settle_aircraft(const Header& header, const RecordingOptions& options, TrackLayout& layout) {
  layout.of_aircraft = !words_of_aviation(layout.table.names).empty();
  if (!layout.of_aircraft) return;
  const ColumnChoice& choice = layout.table.choice;
  layout.ids_are_addresses = choice.id && *choice.id < layout.table.names.size() &&
                             names_address(layout.table.names[*choice.id]);
  layout.no_height = reason_without_height(header, choice.datum);
  layout.label = choose_label(header, choice.id);
  if (layout.label && choice.id) {
    layout.notes.push_back(
        "ids are read from " + column_text(layout.table, *choice.id) +
        ", and how they are called beside from " + column_text(layout.table, *layout.label) +
        "; --columns id=" + std::to_string(*layout.label + 1) +
        " would take that for the id, so that the time between two flights of one is no gap");
  } else {
    layout.label.reset();
  }
  settle_other_height(header, layout);
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (plain_name(layout.table.names[i]) == "seen_pos") layout.age = i;
  }
  layout.keeps_grounded = options.grounded;
  if (!options.grounded) layout.on_ground = choose_on_ground(header);
}

}  // namespace beespace::io
