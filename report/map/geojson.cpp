#include "report/map/geojson.hpp"

#include "io/json/geojson_geometry.hpp"
#include "io/json/json_writer.hpp"
#include "io/units/units.hpp"
#include "report/calendar_words.hpp"
#include "report/map/map_obstacles.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"

#include <cmath>
#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

class Features {
 public:
  // What is not in the file is said in a member of its own, which readers may pass over.
  Features(std::string words, const std::vector<std::string>& notes, io::AtomicOutput& output)
      : output_(output), json_(text_) {
    for (const std::string& note : notes) words += (words.empty() ? "" : "; ") + note;
    json_.begin_object().member("type", "FeatureCollection");
    if (!words.empty()) json_.member("note", words);
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

void write_apart(io::JsonWriter& json, const SwarmFacts& swarm, const std::vector<Apart>& apart,
                 std::size_t number) {
  if (!swarm.vertical_m || number >= apart.size()) return;
  const Apart& of = apart[number];
  json.member("horizontal_m", of.horizontal_m).member("vertical_m", of.height_m);
  if (!swarm.aviation) return;
  json.member("horizontal_NM", io::from_metric(of.horizontal_m, io::Unit::kNauticalMile));
  json.member("vertical_ft", io::from_metric(of.height_m, io::Unit::kFoot));
}

void write_conflict(io::JsonWriter& json, const RecordingFacts& facts, std::size_t number) {
  const Conflict& conflict = facts.conflicts[number];
  json.member("first", facts.swarm.names.at(conflict.closest_s, conflict.first));
  json.member("second", facts.swarm.names.at(conflict.closest_s, conflict.second));
  json.member("closest_m", conflict.closest_m);
  write_apart(json, facts.swarm, facts.conflicts_apart, number);
  json.member("begins_s", conflict.begins_s);
  json.member("closest_s", conflict.closest_s).member("ends_s", conflict.ends_s);
  json.member("certain", conflict.certain);
  if (!facts.calendar.tells()) return;
  json.member("begins", date_time_label(conflict.begins_s, facts.calendar));
  json.member("closest", date_time_label(conflict.closest_s, facts.calendar));
  json.member("ends", date_time_label(conflict.ends_s, facts.calendar));
}

void add_conflicts(const RecordingFacts& facts, const MapPlaces& places, Features& features) {
  const auto add_each = [&](const char* kind, const auto& write_geometry) {
    for (std::size_t i = 0; i < facts.conflicts.size(); ++i) {
      const Conflict& conflict = facts.conflicts[i];
      const auto a = position_at(facts.tracks[conflict.first], conflict.closest_s);
      const auto b = position_at(facts.tracks[conflict.second], conflict.closest_s);
      if (!a || !b) continue;
      features.add([&](io::JsonWriter& json) { write_geometry(json, *a, *b); },
                   [&](io::JsonWriter& json) {
                     json.member("kind", kind);
                     write_conflict(json, facts, i);
                   });
    }
  };
  add_each("conflict", [&](io::JsonWriter& json, const Point& a, const Point& b) {
    io::write_geojson_point(json, places.of(middle_of(a, b)));
  });
  add_each("pair", [&](io::JsonWriter& json, const Point& a, const Point& b) {
    io::write_geojson_line(json, places.of(a), places.of(b));
  });
}

// A line from one gap to the next; a place where only one fix is known.
void add_paths(const MapTracks& map, const RecordingFacts& facts, const MapPlaces& places,
               Features& features) {
  for (const MapTrack& track : map.tracks) {
    for (const std::vector<Fix>& run : track.runs) {
      std::vector<GeographicPosition> line;
      line.reserve(run.size());
      for (const Fix& fix : run) line.push_back(places.of(fix.position));
      features.add(
          [&](io::JsonWriter& json) {
            line.size() == 1 ? io::write_geojson_point(json, line.front())
                             : io::write_geojson_path(json, line);
          },
          [&](io::JsonWriter& json) {
            json.member("kind", "path").member("id", facts.swarm.names.of(track.bee));
            json.member("begins_s", run.front().time_s).member("ends_s", run.back().time_s);
            if (!facts.calendar.tells()) return;
            json.member("begins", date_time_label(run.front().time_s, facts.calendar));
            json.member("ends", date_time_label(run.back().time_s, facts.calendar));
          });
    }
  }
}

// Heights without an end have no member, as in files of obstacles.
void add_obstacles(const MapObstacles& map, Features& features) {
  for (const MapObstacle& obstacle : map.obstacles) {
    features.add([&](io::JsonWriter& json) { io::write_geojson_polygon(json, obstacle.outline); },
                 [&](io::JsonWriter& json) {
                   json.member("kind", "obstacle").member("name", obstacle.name);
                   json.member("shape", obstacle.shape);
                   if (obstacle.round) json.member("radius_m", obstacle.round->radius_m);
                   const Heights& heights = obstacle.heights;
                   if (std::isfinite(heights.low_m)) json.member("low_m", heights.low_m);
                   if (std::isfinite(heights.high_m)) json.member("high_m", heights.high_m);
                 });
  }
}

}  // namespace

std::vector<std::string> write_geojson(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  const Names& names = facts.swarm.names;
  const MapObstacles obstacles = map_obstacles(facts);
  const auto place = [&](PointId bee) { return places.of(facts.positions[bee]); };
  Features features(kept_words(facts), obstacles.notes, output);
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
          write_apart(json, facts.swarm, facts.apart, i);
        });
  }
  add_obstacles(obstacles, features);
  features.finish();
  return obstacles.notes;
}

std::vector<std::string> write_geojson(const RecordingFacts& facts, io::AtomicOutput& output) {
  const MapPlaces places(facts.swarm);
  const MapTracks map = map_tracks(facts, kMostTracks, kMostTrackFixes);
  const MapObstacles obstacles = map_obstacles(facts);
  std::vector<std::string> notes = map.notes;
  notes.insert(notes.end(), obstacles.notes.begin(), obstacles.notes.end());
  Features features(kept_words(facts), notes, output);
  add_conflicts(facts, places, features);
  add_paths(map, facts, places, features);
  add_obstacles(obstacles, features);
  features.finish();
  return notes;
}

}  // namespace beespace::report
