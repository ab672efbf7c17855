#include "report/swarm_json.hpp"

#include "report/obstacles_json.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace beespace::report {
namespace {

constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
constexpr std::array<const char*, 3> kLocalAxes = {"east", "north", "height"};

void write_origin(io::JsonWriter& json, const GeographicPosition& origin) {
  json.begin_object("origin");
  json.member("longitude_deg", origin.longitude_deg).member("latitude_deg", origin.latitude_deg);
  json.member("height_m", origin.height_m);
  json.end();
}

void write_heights(io::JsonWriter& json, const HeightWords& heights) {
  json.begin_object("heights").member("in_feet", heights.in_feet);
  json.member("by_pressure", heights.by_pressure);
  json.end();
}

void write_noun(io::JsonWriter& json, const io::RecordedNoun& noun) {
  json.begin_object("noun").member("one", noun.one).member("several", noun.several);
  json.end();
}

void write_names(io::JsonWriter& json, const Names& names, Columns& columns) {
  json.begin_object("names");
  columns.add(json, "texts", names.texts);
  if (!names.bees.empty()) columns.add(json, "bees", names.bees, Differences::kFirst);
  if (!names.called.empty()) {
    std::vector<PointId> bees;
    std::vector<double> since_s;
    std::vector<std::string> texts;
    for (const Names::Called& one : names.called) {
      bees.push_back(one.bee);
      since_s.push_back(one.since_s);
      texts.push_back(one.text);
    }
    json.begin_object("called");
    columns.add(json, "bees", bees, Differences::kFirst);
    columns.add(json, "since_s", since_s);
    columns.add(json, "texts", texts);
    json.end();
  }
  json.end();
}

}  // namespace

std::string Names::of(PointId bee) const {
  if (bees.empty()) return bee < texts.size() ? texts[bee] : std::to_string(bee);
  const auto at = std::lower_bound(bees.begin(), bees.end(), bee);
  if (at == bees.end() || *at != bee) return std::to_string(bee);
  return texts[static_cast<std::size_t>(at - bees.begin())];
}

std::string Names::at(double time_s, PointId bee) const {
  const auto first = std::lower_bound(called.begin(), called.end(), bee,
                                      [](const Called& one, PointId of) { return one.bee < of; });
  if (first == called.end() || first->bee != bee) return of(bee);
  const std::string* text = &first->text;
  for (auto one = first; one != called.end() && one->bee == bee; ++one) {
    if (one->since_s <= time_s) text = &one->text;
  }
  return *text;
}

void write_facts(io::JsonWriter& json, const SwarmFacts& swarm, std::size_t count,
                 Columns& columns) {
  json.member("title", swarm.title).member("source", swarm.source);
  json.member("count", count).member("axes", swarm.origin ? kLocalAxes : kAxes);
  if (swarm.origin) write_origin(json, *swarm.origin);
  if (swarm.heights.in_feet || swarm.heights.by_pressure) write_heights(json, swarm.heights);
  if (swarm.aviation) json.member("aviation", true);
  if (swarm.flat) json.member("flat", true);
  if (swarm.y_is_down) json.member("y_down", true);
  if (swarm.noun.one != io::RecordedNoun().one) write_noun(json, swarm.noun);
  json.member("threshold_m", swarm.threshold_m);
  if (swarm.vertical_m) json.member("vertical_m", swarm.vertical_m);
  json.member("inclusive", swarm.inclusive);
  if (!swarm.names.texts.empty()) write_names(json, swarm.names, columns);
  json.member("notes", swarm.notes);
  write_obstacles(json, swarm.obstacles);
}

void write_positions(io::JsonWriter& json, const Quantised& positions, Differences differences,
                     Columns& columns) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns.add(json, kAxes[axis], positions.codes[axis], differences,
                {positions.step_m[axis], positions.low_m[axis]});
  }
}

void write_apart(io::JsonWriter& json, const std::vector<Apart>& apart, Columns& columns) {
  if (apart.empty()) return;
  std::vector<double> horizontal_m;
  std::vector<double> height_m;
  for (const Apart& of : apart) {
    horizontal_m.push_back(of.horizontal_m);
    height_m.push_back(of.height_m);
  }
  columns.add(json, "horizontal_m", horizontal_m);
  columns.add(json, "height_m", height_m);
}

void write_apart(io::JsonWriter& json, const Apart& apart) {
  json.member("horizontal_m", apart.horizontal_m).member("height_m", apart.height_m);
}

}  // namespace beespace::report
