#include "report/map/risk_table.hpp"

#include "io/table/table_writer.hpp"
#include "io/units/units.hpp"
#include "report/calendar_words.hpp"
#include "report/map/map_places.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

namespace beespace::report {
namespace {

// Digits behind a sign or none: from_chars takes "inf" and "nan(...)" as well.
bool is_number(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  if (text.empty() || text.front() < '0' || text.front() > '9') return false;
  double value = 0.0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc{} && stop == text.data() + text.size();
}

// Spreadsheets of some languages take the wide forms of these signs for them.
bool begins_formula(std::string_view text) {
  constexpr std::array<std::string_view, 10> kSigns = {
      "=", "+", "-", "@", "\t", "\r", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
  return std::any_of(kSigns.begin(), kSigns.end(),
                     [text](std::string_view sign) { return text.starts_with(sign); });
}

// Where bees are, in the columns of the table.
class PlaceColumns {
 public:
  explicit PlaceColumns(const SwarmFacts& swarm) {
    if (swarm.origin) places_.emplace(swarm);
  }

  void write_names(io::TableWriter& table) const {
    table.header(places_ ? "first_longitude,first_latitude,first_height_m,"
                           "second_longitude,second_latitude,second_height_m"
                         : "first_x,first_y,first_z,second_x,second_y,second_z");
  }

  void write(io::TableWriter& table, const std::optional<Point>& place) const {
    if (!place) {
      table.empty_field().empty_field().empty_field();
    } else if (places_) {
      table.next() += place_text(places_->of(*place), table.delimiter());
    } else {
      table.field(place->x).field(place->y).field(place->z);
    }
  }

 private:
  std::optional<MapPlaces> places_;
};

// How far apart two are horizontally and in height, where each has its limit; in the units of
// aviation too where the input speaks so.
class ApartColumns {
 public:
  ApartColumns(const SwarmFacts& swarm, const std::vector<Apart>& apart)
      : apart_(apart), there_(swarm.vertical_m.has_value()), aviation_(swarm.aviation) {}

  void write_names(io::TableWriter& table) const {
    if (there_) table.header("horizontal_m,vertical_m");
    if (there_ && aviation_) table.header("horizontal_NM,vertical_ft");
  }

  void write(io::TableWriter& table, std::size_t row) const {
    if (!there_) return;
    const Apart apart = row < apart_.size() ? apart_[row] : kUnknown;
    table.field(apart.horizontal_m).field(apart.height_m);  // empty where not known
    if (!aviation_) return;
    table.field(io::from_metric(apart.horizontal_m, io::Unit::kNauticalMile));
    table.field(io::from_metric(apart.height_m, io::Unit::kFoot));
  }

 private:
  static constexpr Apart kUnknown = {std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::quiet_NaN()};

  const std::vector<Apart>& apart_;
  bool there_;
  bool aviation_;
};

// Spreadsheets of many countries split tables at semicolons, some at tabs: what holds one is quoted
// as if this one did.
void write_id(io::TableWriter& table, const Names& names, PointId bee) {
  const std::string id = harmless_in_spreadsheets(names.of(bee));
  const std::size_t elsewhere = id.find_first_of(";\t");
  io::append_field(table.next(), id,
                   elsewhere == std::string::npos ? table.delimiter() : id[elsewhere]);
}

}  // namespace

std::string harmless_in_spreadsheets(std::string_view text) {
  std::string harmless(begins_formula(text) && !is_number(text) ? "'" : "");
  return harmless += text;
}

void write_risk_table(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const PlaceColumns places(facts.swarm);
  std::string text;
  io::TableWriter table(text, ',');
  places.write_names(table.header("first,second,distance_m"));
  const ApartColumns apart(facts.swarm, facts.apart);
  apart.write_names(table);
  table.end_row();
  for (std::size_t i = 0; i < facts.pairs.size(); ++i) {
    const auto& [first, second] = facts.pairs[i];
    write_id(table, facts.swarm.names, first);
    write_id(table, facts.swarm.names, second);
    table.field(facts.distances_m[i]);
    places.write(table, facts.positions[first]);
    places.write(table, facts.positions[second]);
    apart.write(table, i);
    table.end_row();
    output.write(text);
    text.clear();
  }
  output.write(text);
}

void write_risk_table(const RecordingFacts& facts, io::AtomicOutput& output) {
  const PlaceColumns places(facts.swarm);
  std::string text;
  io::TableWriter table(text, ',');
  places.write_names(table.header("first,second,begins_s,closest_s,ends_s,closest_m,certain"));
  if (facts.calendar.tells()) table.header("begins,closest,ends");
  table.header("lasts_s");
  const ApartColumns apart(facts.swarm, facts.conflicts_apart);
  apart.write_names(table);
  table.end_row();
  for (std::size_t i = 0; i < facts.conflicts.size(); ++i) {
    const Conflict& c = facts.conflicts[i];
    write_id(table, facts.swarm.names, c.first);
    write_id(table, facts.swarm.names, c.second);
    table.field(c.begins_s).field(c.closest_s).field(c.ends_s).field(c.closest_m).field(c.certain);
    places.write(table, position_at(facts.tracks[c.first], c.closest_s));
    places.write(table, position_at(facts.tracks[c.second], c.closest_s));
    if (facts.calendar.tells()) {
      for (const double time_s : {c.begins_s, c.closest_s, c.ends_s}) {
        table.field(date_time_label(time_s, facts.calendar));
      }
    }
    table.field(c.ends_s - c.begins_s);
    apart.write(table, i);
    table.end_row();
    output.write(text);
    text.clear();
  }
  output.write(text);
}

}  // namespace beespace::report
