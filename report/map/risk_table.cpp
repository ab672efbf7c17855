#include "report/map/risk_table.hpp"

#include "io/bytes/number_text.hpp"
#include "io/table/csv_field.hpp"
#include "report/map/map_places.hpp"
#include "report/number_label.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <system_error>

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

  [[nodiscard]] std::string names() const {
    if (places_) {
      return "first_longitude,first_latitude,first_height_m,"
             "second_longitude,second_latitude,second_height_m";
    }
    return "first_x,first_y,first_z,second_x,second_y,second_z";
  }

  [[nodiscard]] std::string of(const std::optional<Point>& place) const {
    if (!place) return ",,";
    if (places_) return place_text(places_->of(*place), ',');
    return io::exact(place->x) + ',' + io::exact(place->y) + ',' + io::exact(place->z);
  }

 private:
  std::optional<MapPlaces> places_;
};

// Spreadsheets of many countries split tables at semicolons, some at tabs: what holds one is quoted
// as if this one did.
void append_id(std::string& out, const Names& names, PointId bee) {
  const std::string id = harmless_in_spreadsheets(names.of(bee));
  const std::size_t elsewhere = id.find_first_of(";\t");
  io::append_csv_field(out, id, elsewhere == std::string::npos ? ',' : id[elsewhere]);
  out += ',';
}

}  // namespace

std::string harmless_in_spreadsheets(std::string_view text) {
  std::string harmless(begins_formula(text) && !is_number(text) ? "'" : "");
  return harmless += text;
}

void write_risk_table(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const PlaceColumns places(facts.swarm);
  output.write("first,second,distance_m," + places.names() + '\n');
  for (std::size_t i = 0; i < facts.pairs.size(); ++i) {
    const auto& [first, second] = facts.pairs[i];
    std::string row;
    append_id(row, facts.swarm.names, first);
    append_id(row, facts.swarm.names, second);
    row += io::exact(facts.distances_m[i]) + ',' + places.of(facts.positions[first]) + ',' +
           places.of(facts.positions[second]) + '\n';
    output.write(row);
  }
}

void write_risk_table(const RecordingFacts& facts, io::AtomicOutput& output) {
  const PlaceColumns places(facts.swarm);
  output.write("first,second,begins_s,closest_s,ends_s,closest_m,certain," + places.names() +
               (facts.since_1970 ? ",begins,closest,ends\n" : "\n"));
  for (const Conflict& c : facts.conflicts) {
    std::string row;
    append_id(row, facts.swarm.names, c.first);
    append_id(row, facts.swarm.names, c.second);
    for (const double number : {c.begins_s, c.closest_s, c.ends_s, c.closest_m}) {
      row += io::exact(number) + ',';
    }
    row += c.certain ? "yes," : "no,";
    row += places.of(position_at(facts.tracks[c.first], c.closest_s)) + ',' +
           places.of(position_at(facts.tracks[c.second], c.closest_s));
    if (facts.since_1970) {
      for (const double time_s : {c.begins_s, c.closest_s, c.ends_s}) {
        row += ',' + instant_label(time_s);
      }
    }
    output.write(row + '\n');
  }
}

}  // namespace beespace::report
