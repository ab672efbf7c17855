#include "report/swarm_json.hpp"

#include "io/json/json_text.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace beespace::report {
namespace {

std::string list_of(const std::vector<std::string>& texts) {
  std::string json = "[";
  for (const std::string& text : texts) {
    if (json.size() > 1) json += ',';
    io::append_json_string(json, text);
  }
  return json + ']';
}

std::string origin_json(const GeographicPosition& origin) {
  io::JsonObject json;
  json.add_number("longitude_deg", origin.longitude_deg);
  json.add_number("latitude_deg", origin.latitude_deg);
  json.add_number("height_m", origin.height_m);
  return json.text();
}

std::string names_json(const Names& names, Columns& columns) {
  io::JsonObject json;
  json.add_json("texts", columns.add(names.texts));
  if (!names.bees.empty()) {
    json.add_json("bees",
                  columns.add(std::span<const std::uint32_t>(names.bees), Differences::kFirst));
  }
  return json.text();
}

}  // namespace

std::string Names::of(PointId bee) const {
  if (bees.empty()) return bee < texts.size() ? texts[bee] : std::to_string(bee);
  const auto at = std::lower_bound(bees.begin(), bees.end(), bee);
  if (at == bees.end() || *at != bee) return std::to_string(bee);
  return texts[static_cast<std::size_t>(at - bees.begin())];
}

void add_swarm(io::JsonObject& json, const SwarmFacts& swarm, std::size_t count, Columns& columns) {
  json.add_text("title", swarm.title);
  json.add_text("source", swarm.source);
  json.add_count("count", count);
  json.add_json("axes", swarm.origin ? R"(["east","north","up"])" : R"(["x","y","z"])");
  if (swarm.origin) json.add_json("origin", origin_json(*swarm.origin));
  json.add_number("threshold_m", swarm.threshold_m);
  if (swarm.vertical_m) json.add_number("vertical_m", *swarm.vertical_m);
  json.add_flag("inclusive", swarm.inclusive);
  if (!swarm.names.texts.empty()) json.add_json("names", names_json(swarm.names, columns));
  json.add_json("notes", list_of(swarm.notes));
}

void add_positions(io::JsonObject& json, const Quantised& positions, Differences differences,
                   Columns& columns) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    json.add_json(kAxes[axis],
                  columns.add(std::span<const std::uint16_t>(positions.codes[axis]), differences,
                              {positions.step_m[axis], positions.low_m[axis]}));
  }
}

}  // namespace beespace::report
