#include "report/map/geojson.hpp"

#include "io/json/geojson_geometry.hpp"
#include "io/json/json_object.hpp"
#include "io/json/json_text.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_words.hpp"
#include "report/number_label.hpp"

#include <cmath>
#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

class Features {
 public:
  // What is not in the file is said in a member of its own, which readers may pass over.
  Features(const std::string& kept, io::AtomicOutput& output) : output_(output) {
    output_.write(R"({"type": "FeatureCollection", )" +
                  (kept.empty() ? "" : R"("note": )" + io::json_string(kept) + ", ") +
                  R"("features": [)");
  }

  void add(const std::string& geometry, const io::JsonObject& properties) {
    output_.write(first_ ? "\n" : ",\n");
    first_ = false;
    output_.write(R"({"type": "Feature", "geometry": )" + geometry + R"(, "properties": )" +
                  properties.text() + '}');
  }

  void finish() { output_.write("\n]}\n"); }

 private:
  io::AtomicOutput& output_;
  bool first_ = true;
};

std::string point(const GeographicPosition& at) {
  std::string text;
  io::JsonWriter json(text);
  io::write_geojson_point(json, at);
  return text;
}

std::string line(const GeographicPosition& from, const GeographicPosition& to) {
  std::string text;
  io::JsonWriter json(text);
  io::write_geojson_line(json, from, to);
  return text;
}

io::JsonObject properties_of(const Conflict& conflict, const RecordingFacts& facts,
                             const char* kind) {
  io::JsonObject properties;
  properties.add_text("kind", kind);
  properties.add_text("first", facts.swarm.names.of(conflict.first));
  properties.add_text("second", facts.swarm.names.of(conflict.second));
  properties.add_number("closest_m", conflict.closest_m);
  properties.add_number("begins_s", conflict.begins_s);
  properties.add_number("closest_s", conflict.closest_s);
  properties.add_number("ends_s", conflict.ends_s);
  properties.add_flag("certain", conflict.certain);
  if (!facts.since_1970) return properties;
  properties.add_text("begins", instant_label(conflict.begins_s));
  properties.add_text("closest", instant_label(conflict.closest_s));
  properties.add_text("ends", instant_label(conflict.ends_s));
  return properties;
}

}  // namespace

void write_geojson(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  const Names& names = facts.swarm.names;
  Features features(kept_words(facts), output);
  for (std::size_t i = 0; i < facts.at_risk.size(); ++i) {
    const PointId bee = facts.at_risk[i];
    io::JsonObject properties;
    properties.add_text("kind", "at risk");
    properties.add_text("id", names.of(bee));
    const Nearest& nearest = facts.closest_in_conflict[i];
    properties.add_text("nearest", names.of(nearest.id));
    properties.add_number("nearest_m", nearest.distance_m);
    features.add(point(places.of(facts.positions[bee])), properties);
  }
  for (std::size_t i = 0; i < facts.pairs.size(); ++i) {
    const auto& [first, second] = facts.pairs[i];
    io::JsonObject properties;
    properties.add_text("kind", "pair");
    properties.add_text("first", names.of(first));
    properties.add_text("second", names.of(second));
    properties.add_number("distance_m", facts.distances_m[i]);
    features.add(line(places.of(facts.positions[first]), places.of(facts.positions[second])),
                 properties);
  }
  features.finish();
}

void write_geojson(const RecordingFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  Features features(kept_words(facts), output);
  const auto add_each = [&](const char* kind, const auto& geometry) {
    for (const Conflict& conflict : facts.conflicts) {
      const auto a = position_at(facts.tracks[conflict.first], conflict.closest_s);
      const auto b = position_at(facts.tracks[conflict.second], conflict.closest_s);
      if (a && b) features.add(geometry(*a, *b), properties_of(conflict, facts, kind));
    }
  };
  add_each("conflict",
           [&](const Point& a, const Point& b) { return point(places.of(middle_of(a, b))); });
  add_each("pair",
           [&](const Point& a, const Point& b) { return line(places.of(a), places.of(b)); });
  features.finish();
}

}  // namespace beespace::report
