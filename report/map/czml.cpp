#include "report/map/czml.hpp"

#include "io/json/json_writer.hpp"
#include "report/map/map_obstacles.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_time.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace beespace::report {
namespace {

using Colour = std::array<unsigned, 4>;

constexpr Colour kRiskColour = {200, 80, 10, 255};
constexpr Colour kBeeColour = {111, 136, 163, 255};
constexpr Colour kPathColour = {111, 136, 163, 120};
constexpr Colour kOutlineColour = {255, 255, 255, 255};
constexpr Colour kObstacleColour = {210, 150, 60, 80};
constexpr Colour kObstacleOutline = {210, 150, 60, 192};
constexpr Colour kLabelOutline = {0, 0, 0, 255};

struct LineStyle {
  Colour colour;
  unsigned width = 1;
};
constexpr LineStyle kRiskLine = {kRiskColour, 3};
constexpr LineStyle kPathLine = {kPathColour, 1};

constexpr double kLabelsFrom_m = 500'000.0;

// A list of packets, the first of which is about the document.
class Packets {
 public:
  explicit Packets(io::AtomicOutput& output) : output_(output), json_(text_) {
    json_.begin_array(io::JsonLayout::kFlush);
  }

  // `write` writes the members.
  void add(const auto& write) {
    json_.begin_object(io::JsonLayout::kTight);
    write(json_);
    json_.end();
    output_.write(text_);
    text_.clear();
  }

  void finish() {
    json_.end();
    output_.write(text_ + '\n');
  }

 private:
  io::AtomicOutput& output_;
  std::string text_;
  io::JsonWriter json_;
};

std::string id_of(PointId bee) {
  return "bee/" + std::to_string(bee);
}

std::string interval(double begins_s, double ends_s) {
  return map_instant(begins_s) + '/' + map_instant(ends_s);
}

void write_document(io::JsonWriter& json, const SwarmFacts& swarm, const std::string& description) {
  json.member("id", "document").member("version", "1.0").member("name", swarm.title);
  json.member("description", description);
}

void write_colour(io::JsonWriter& json, const char* key, const Colour& colour) {
  json.begin_object(key).member("rgba", colour).end();
}

void write_material(io::JsonWriter& json, const Colour& colour) {
  json.begin_object("material").begin_object("solidColor");
  write_colour(json, "color", colour);
  json.end().end();
}

// `write_colours` writes the member "color".
void write_dot(io::JsonWriter& json, double size, const auto& write_colours) {
  json.begin_object("point").member("pixelSize", size);
  write_colours();
  write_colour(json, "outlineColor", kOutlineColour);
  json.member("outlineWidth", 1u);
  json.end();
}

void write_place(io::JsonWriter& json, const GeographicPosition& place) {
  json.value(place.longitude_deg).value(place.latitude_deg).value(place.height_m);
}

// `write_positions` writes the members that say where it is.
void write_line(io::JsonWriter& json, const LineStyle& style, const auto& write_positions) {
  json.begin_object("polyline").begin_object("positions");
  write_positions();
  json.end();
  json.member("arcType", "NONE").member("width", style.width);
  write_material(json, style.colour);
  json.end();
}

void write_places(io::JsonWriter& json, std::span<const GeographicPosition> places) {
  json.begin_array("cartographicDegrees");
  for (const GeographicPosition& place : places) write_place(json, place);
  json.end();
}

TimeSpan time_of(const MapTracks& map) {
  TimeSpan time{0.0, 0.0};
  bool first = true;
  for (const MapTrack& track : map.tracks) {
    const double begins_s = track.runs.front().front().time_s;
    const double ends_s = track.runs.back().back().time_s;
    time.begins_s = first ? begins_s : std::min(time.begins_s, begins_s);
    time.ends_s = first ? ends_s : std::max(time.ends_s, ends_s);
    first = false;
  }
  return time;
}

// So that all of it is seen in a minute or two: 1, 2, 5, 10, 20, ... times as fast as it was.
double multiplier_for(const TimeSpan& time) {
  constexpr double kShown_s = 120.0;
  const double wanted = (time.ends_s - time.begins_s) / kShown_s;
  double multiplier = 1.0;
  for (double power = 1.0; power < wanted && power < 1e9; power *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (power * step <= wanted) multiplier = power * step;
    }
  }
  return multiplier;
}

void write_clock(io::JsonWriter& json, const TimeSpan& time) {
  json.begin_object("clock").member("interval", interval(time.begins_s, time.ends_s));
  json.member("currentTime", map_instant(time.begins_s));
  json.member("multiplier", multiplier_for(time));
  json.member("range", "LOOP_STOP").member("step", "SYSTEM_CLOCK_MULTIPLIER");
  json.end();
}

// Between instants to the microsecond, as they are written: so that positions are there at the
// beginning and at the end of what is written of a bee.
double seconds_after(double epoch_s, double time_s) {
  constexpr double kPerSecond = 1e6;
  return (std::round(time_s * kPerSecond) - std::round(epoch_s * kPerSecond)) / kPerSecond;
}

// What it is called, beside its dot.
void write_label(io::JsonWriter& json, const std::string& name) {
  json.begin_object("label").member("text", name).member("font", "12px sans-serif");
  json.member("style", "FILL_AND_OUTLINE").member("outlineWidth", 2u);
  write_colour(json, "outlineColor", kLabelOutline);
  json.member("horizontalOrigin", "LEFT");
  json.begin_object("pixelOffset").member("cartesian2", std::array{9.0, 0.0}).end();
  // From far away names would hide the bees.
  json.begin_object("distanceDisplayCondition");
  json.member("distanceDisplayCondition", std::array{0.0, kLabelsFrom_m}).end();
  json.end();
}

// One interval, or a list of them where the bee is absent in between.
void write_availability(io::JsonWriter& json, const MapTrack& track) {
  const bool several = track.runs.size() > 1;
  json.key("availability");
  if (several) json.begin_array();
  for (const auto& run : track.runs) json.value(interval(run.front().time_s, run.back().time_s));
  if (several) json.end();
}

void write_samples(io::JsonWriter& json, const MapTrack& track, double epoch_s,
                   const MapPlaces& places) {
  json.begin_object("position").member("epoch", map_instant(epoch_s));
  json.begin_array("cartographicDegrees");
  for (const auto& run : track.runs) {
    for (const Fix& fix : run) {
      json.value(seconds_after(epoch_s, fix.time_s));
      write_place(json, places.of(fix.position));
    }
  }
  json.end().end();
}

// What comes later in the list counts.
void write_colours(io::JsonWriter& json, const MapTrack& track,
                   const std::vector<AtRisk>& at_risk) {
  const auto write = [&json](double begins_s, double ends_s, const Colour& colour) {
    json.begin_object().member("interval", interval(begins_s, ends_s)).member("rgba", colour).end();
  };
  json.begin_array("color");
  write(track.runs.front().front().time_s, track.runs.back().back().time_s, kBeeColour);
  auto next = std::lower_bound(at_risk.begin(), at_risk.end(), track.bee,
                               [](const AtRisk& of, PointId bee) { return of.bee < bee; });
  for (; next != at_risk.end() && next->bee == track.bee; ++next) {
    write(next->span.begins_s, next->span.ends_s, kRiskColour);
  }
  json.end();
}

void write_bee(io::JsonWriter& json, const MapTrack& track, const RecordingFacts& facts,
               double epoch_s, const MapPlaces& places) {
  json.member("id", id_of(track.bee)).member("name", facts.swarm.names.of(track.bee));
  write_availability(json, track);
  write_samples(json, track, epoch_s, places);
  write_dot(json, 7.0, [&] { write_colours(json, track, facts.at_risk); });
  write_label(json, facts.swarm.names.of(track.bee));
  if (track.runs.size() > 1) return;
  json.begin_object("path").member("width", kPathLine.width);
  write_material(json, kPathColour);
  json.end();
}

// A path would be drawn across gaps: where there are any, a line for each part.
void add_parts(const MapTrack& track, const Names& names, const MapPlaces& places,
               Packets& packets) {
  if (track.runs.size() < 2) return;
  for (std::size_t i = 0; i < track.runs.size(); ++i) {
    std::vector<GeographicPosition> line;
    for (const Fix& fix : track.runs[i]) line.push_back(places.of(fix.position));
    if (line.size() < 2) continue;
    packets.add([&](io::JsonWriter& json) {
      json.member("id", "path/" + std::to_string(track.bee) + '/' + std::to_string(i));
      json.member("name", names.of(track.bee));
      write_line(json, kPathLine, [&] { write_places(json, line); });
    });
  }
}

// Ends it.
void write_solid_style(io::JsonWriter& json) {
  write_material(json, kObstacleColour);
  json.member("outline", true);
  write_colour(json, "outlineColor", kObstacleOutline);
  json.end();
}

void write_round(io::JsonWriter& json, const MapObstacle& obstacle) {
  const RoundShape& round = *obstacle.round;
  json.begin_object("position");
  write_places(json, std::array{round.middle});
  json.end();
  if (round.is_sphere) {
    json.begin_object("ellipsoid").begin_object("radii");
    json.member("cartesian", std::array{round.radius_m, round.radius_m, round.radius_m}).end();
  } else {
    json.begin_object("cylinder").member("length", obstacle.high_m - obstacle.low_m);
    json.member("topRadius", round.radius_m).member("bottomRadius", round.radius_m);
  }
}

void add_obstacles(const MapObstacles& map, Packets& packets) {
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const MapObstacle& obstacle = map.obstacles[i];
    packets.add([&](io::JsonWriter& json) {
      json.member("id", "obstacle/" + std::to_string(i));
      json.member("name", obstacle.name).member("description", obstacle.words);
      if (obstacle.round) {
        write_round(json, obstacle);
      } else {
        json.begin_object("polygon").begin_object("positions");
        write_places(json, obstacle.outline);
        json.end();
        json.member("height", obstacle.low_m).member("extrudedHeight", obstacle.high_m);
      }
      write_solid_style(json);
    });
  }
}

// The line moves with the two, where both are in the file. Nothing is written of a conflict whose
// places are not known.
void add_conflict(std::size_t number, const MapTracks& map, const RecordingFacts& facts,
                  const MapPlaces& places, Packets& packets) {
  const Conflict& c = facts.conflicts[number];
  const auto is_shown = [&map](PointId bee) {
    const auto at = std::lower_bound(map.tracks.begin(), map.tracks.end(), bee,
                                     [](const MapTrack& of, PointId id) { return of.bee < id; });
    return at != map.tracks.end() && at->bee == bee;
  };
  const bool moves = is_shown(c.first) && is_shown(c.second);
  const auto a = position_at(facts.tracks[c.first], c.closest_s);
  const auto b = position_at(facts.tracks[c.second], c.closest_s);
  if (!moves && !(a && b)) return;
  packets.add([&](io::JsonWriter& json) {
    json.member("id", "conflict/" + std::to_string(number));
    json.member("name", pair_name(facts.swarm.names, c));
    json.member("description", conflict_words(facts, number));
    json.member("availability", interval(c.begins_s, c.ends_s));
    write_line(json, kRiskLine, [&] {
      if (!moves) return write_places(json, std::array{places.of(*a), places.of(*b)});
      const std::string end = "#position";
      json.member("references", std::array{id_of(c.first) + end, id_of(c.second) + end});
    });
  });
}

}  // namespace

std::vector<std::string> write_czml(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const Names& names = facts.swarm.names;
  const MapObstacles obstacles = map_obstacles(facts);
  std::vector<std::string> notes = obstacles.notes;
  const std::size_t bees =
      marks_shown(facts.at_risk.size(), facts.swarm.noun.several + " at risk", notes);
  const std::size_t pairs = marks_shown(facts.pairs.size(), "pairs", notes);
  const MapPlaces places(facts.swarm);
  const auto place = [&](PointId bee) { return places.of(facts.positions[bee]); };
  Packets packets(output);
  packets.add([&](io::JsonWriter& json) {
    write_document(json, facts.swarm, document_words(facts.swarm, kept_words(facts), notes));
  });
  for (std::size_t i = 0; i < bees; ++i) {
    const PointId bee = facts.at_risk[i];
    packets.add([&](io::JsonWriter& json) {
      json.member("id", id_of(bee)).member("name", names.of(bee));
      json.member("description", nearest_words(facts.closest_in_conflict[i], facts.swarm));
      json.begin_object("position");
      write_places(json, std::array{place(bee)});
      json.end();
      write_dot(json, 8.0, [&] { write_colour(json, "color", kRiskColour); });
      write_label(json, names.of(bee));
    });
  }
  for (std::size_t i = 0; i < pairs; ++i) {
    const Pair& pair = facts.pairs[i];
    packets.add([&](io::JsonWriter& json) {
      json.member("id", "pair/" + std::to_string(i));
      json.member("name", pair_name(names, pair.first, pair.second));
      json.member("description", pair_words(facts, i));
      write_line(json, kRiskLine, [&] {
        write_places(json, std::array{place(pair.first), place(pair.second)});
      });
    });
  }
  add_obstacles(obstacles, packets);
  packets.finish();
  return notes;
}

std::vector<std::string> write_czml(const RecordingFacts& facts, io::AtomicOutput& output) {
  const MapTracks map = map_tracks(facts, kMostTracks, kMostTrackFixes);
  const MapObstacles obstacles = map_obstacles(facts);
  std::vector<std::string> notes = map.notes;
  notes.insert(notes.end(), obstacles.notes.begin(), obstacles.notes.end());
  if (!facts.calendar.since_1970) notes.emplace_back(kTimeNote);
  const std::size_t conflicts = marks_shown(facts.conflicts.size(), "conflicts", notes);
  const MapPlaces places(facts.swarm);
  const TimeSpan time = time_of(map);
  Packets packets(output);
  packets.add([&](io::JsonWriter& json) {
    write_document(json, facts.swarm, document_words(facts.swarm, kept_words(facts), notes));
    write_clock(json, time);
  });
  for (const MapTrack& track : map.tracks) {
    packets.add(
        [&](io::JsonWriter& json) { write_bee(json, track, facts, time.begins_s, places); });
    add_parts(track, facts.swarm.names, places, packets);
  }
  for (std::size_t i = 0; i < conflicts; ++i) add_conflict(i, map, facts, places, packets);
  add_obstacles(obstacles, packets);
  packets.finish();
  return notes;
}

}  // namespace beespace::report
