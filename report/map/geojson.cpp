#include "report/map/geojson.hpp"

#include "io/json/geojson_geometry.hpp"
#include "io/json/json_writer.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_words.hpp"
#include "report/number_label.hpp"

#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

class Features {
 public:
  // What is not in the file is said in a member of its own, which readers may pass over.
  Features(const std::string& kept, io::AtomicOutput& output) : output_(output), json_(text_) {
    json_.begin_object().member("type", "FeatureCollection");
    if (!kept.empty()) json_.member("note", kept);
    json_.begin_array("features", io::JsonLayout::kFlush);
  }

  void add(const auto& write_geometry, const auto& write_properties) {
    io::write_geojson_feature(
        json_, io::JsonLayout::kTight, [&] { write_geometry(json_); },
        [&] { write_properties(json_); });
    output_.write(text_);
    text_.clear();
  }

  void finish() {
    json_.end().end();
    output_.write(text_ + '\n');
  }

 private:
  io::AtomicOutput& output_;
  std::string text_;
  io::JsonWriter json_;
};

void write_conflict(io::JsonWriter& json, const Conflict& conflict, const RecordingFacts& facts) {
  json.member("first", facts.swarm.names.of(conflict.first));
  json.member("second", facts.swarm.names.of(conflict.second));
  json.member("closest_m", conflict.closest_m).member("begins_s", conflict.begins_s);
  json.member("closest_s", conflict.closest_s).member("ends_s", conflict.ends_s);
  json.member("certain", conflict.certain);
  if (!facts.since_1970) return;
  json.member("begins", instant_label(conflict.begins_s));
  json.member("closest", instant_label(conflict.closest_s));
  json.member("ends", instant_label(conflict.ends_s));
}

}  // namespace

void write_geojson(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  const Names& names = facts.swarm.names;
  const auto place = [&](PointId bee) { return places.of(facts.positions[bee]); };
  Features features(kept_words(facts), output);
  for (std::size_t i = 0; i < facts.at_risk.size(); ++i) {
    const PointId bee = facts.at_risk[i];
    const Nearest& nearest = facts.closest_in_conflict[i];
    features.add([&](io::JsonWriter& json) { io::write_geojson_point(json, place(bee)); },
                 [&](io::JsonWriter& json) {
                   json.member("kind", "at risk").member("id", names.of(bee));
                   json.member("nearest", names.of(nearest.id));
                   json.member("nearest_m", nearest.distance_m);
                 });
  }
  for (std::size_t i = 0; i < facts.pairs.size(); ++i) {
    const Pair& pair = facts.pairs[i];
    features.add(
        [&](io::JsonWriter& json) {
          io::write_geojson_line(json, place(pair.first), place(pair.second));
        },
        [&](io::JsonWriter& json) {
          json.member("kind", "pair");
          json.member("first", names.of(pair.first)).member("second", names.of(pair.second));
          json.member("distance_m", facts.distances_m[i]);
        });
  }
  features.finish();
}

void write_geojson(const RecordingFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  Features features(kept_words(facts), output);
  const auto add_each = [&](const char* kind, const auto& write_geometry) {
    for (const Conflict& conflict : facts.conflicts) {
      const auto a = position_at(facts.tracks[conflict.first], conflict.closest_s);
      const auto b = position_at(facts.tracks[conflict.second], conflict.closest_s);
      if (!a || !b) continue;
      features.add([&](io::JsonWriter& json) { write_geometry(json, *a, *b); },
                   [&](io::JsonWriter& json) {
                     json.member("kind", kind);
                     write_conflict(json, conflict, facts);
                   });
    }
  };
  add_each("conflict", [&](io::JsonWriter& json, const Point& a, const Point& b) {
    io::write_geojson_point(json, places.of(middle_of(a, b)));
  });
  add_each("pair", [&](io::JsonWriter& json, const Point& a, const Point& b) {
    io::write_geojson_line(json, places.of(a), places.of(b));
  });
  features.finish();
}

}  // namespace beespace::report
