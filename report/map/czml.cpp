#include "report/map/czml.hpp"

#include "io/json/json_object.hpp"
#include "io/json/json_text.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_time.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"
#include "report/number_label.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace beespace::report {
namespace {

constexpr const char* kRiskColour = R"({"rgba":[200,80,10,255]})";
constexpr const char* kBeeColour = R"({"rgba":[111,136,163,255]})";
constexpr const char* kPathMaterial = R"({"solidColor":{"color":{"rgba":[111,136,163,120]}}})";
constexpr const char* kLineStyle =
    R"("arcType":"NONE","width":3,"material":{"solidColor":{"color":{"rgba":[200,80,10,255]}}})";

class Packets {
 public:
  Packets(const SwarmFacts& swarm, const std::string& kept, const std::vector<std::string>& notes,
          const std::string& clock, io::AtomicOutput& output)
      : output_(output) {
    io::JsonObject document;
    document.add_text("id", "document");
    document.add_text("version", "1.0");
    document.add_text("name", swarm.title);
    document.add_text("description", document_words(kept, notes));
    if (!clock.empty()) document.add_json("clock", clock);
    output_.write("[\n" + document.text());
  }

  void add(const io::JsonObject& packet) { output_.write(",\n" + packet.text()); }
  void finish() { output_.write("\n]\n"); }

 private:
  io::AtomicOutput& output_;
};

std::string id_of(PointId bee) {
  return "bee/" + std::to_string(bee);
}

std::string interval(double begins_s, double ends_s) {
  return map_instant(begins_s) + '/' + map_instant(ends_s);
}

std::string dot(double size, const std::string& colour) {
  return R"({"pixelSize":)" + io::json_number(size) + R"(,"color":)" + colour +
         R"(,"outlineColor":{"rgba":[255,255,255,255]},"outlineWidth":1})";
}

std::string line(const std::string& positions) {
  return "{\"positions\":" + positions + ',' + kLineStyle + '}';
}

std::string line(const GeographicPosition& from, const GeographicPosition& to) {
  return line(R"({"cartographicDegrees":[)" + place_text(from, ',') + ',' + place_text(to, ',') +
              "]}");
}

io::JsonObject packet(const std::string& id, const std::string& name,
                      const std::string& description) {
  io::JsonObject begun;
  begun.add_text("id", id);
  begun.add_text("name", name);
  if (!description.empty()) begun.add_text("description", description);
  return begun;
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

std::string clock_of(const TimeSpan& time) {
  io::JsonObject clock;
  clock.add_text("interval", interval(time.begins_s, time.ends_s));
  clock.add_text("currentTime", map_instant(time.begins_s));
  clock.add_number("multiplier", 1.0);
  return clock.text();
}

// One interval, or a list of them where the bee is absent in between.
std::string availability_of(const MapTrack& track) {
  std::string list;
  for (const auto& run : track.runs) {
    if (!list.empty()) list += ',';
    list += io::json_string(interval(run.front().time_s, run.back().time_s));
  }
  return track.runs.size() == 1 ? list : '[' + list + ']';
}

std::string samples_of(const MapTrack& track, double epoch_s, const MapPlaces& places) {
  std::string list;
  for (const auto& run : track.runs) {
    for (const Fix& fix : run) {
      if (!list.empty()) list += ',';
      list +=
          io::json_number(fix.time_s - epoch_s) + ',' + place_text(places.of(fix.position), ',');
    }
  }
  return R"({"epoch":")" + map_instant(epoch_s) + R"(","cartographicDegrees":[)" + list + "]}";
}

// What comes later in the list counts.
std::string colours_of(const MapTrack& track, const std::vector<AtRisk>& at_risk) {
  std::string list = R"([{"interval":")" +
                     interval(track.runs.front().front().time_s, track.runs.back().back().time_s) +
                     R"(",)" + std::string(kBeeColour).substr(1);
  auto next = std::lower_bound(at_risk.begin(), at_risk.end(), track.bee,
                               [](const AtRisk& of, PointId bee) { return of.bee < bee; });
  for (; next != at_risk.end() && next->bee == track.bee; ++next) {
    list += R"(,{"interval":")" + interval(next->span.begins_s, next->span.ends_s) + R"(",)" +
            std::string(kRiskColour).substr(1);
  }
  return list + ']';
}

void add_bees(const MapTracks& map, const RecordingFacts& facts, double epoch_s,
              const MapPlaces& places, Packets& packets) {
  for (const MapTrack& track : map.tracks) {
    io::JsonObject bee = packet(id_of(track.bee), facts.swarm.names.of(track.bee), {});
    bee.add_json("availability", availability_of(track));
    bee.add_json("position", samples_of(track, epoch_s, places));
    bee.add_json("point", dot(7.0, colours_of(track, facts.at_risk)));
    bee.add_json("path", R"({"width":1,"material":)" + std::string(kPathMaterial) + '}');
    packets.add(bee);
  }
}

// The line moves with the two, where both are in the file.
std::string line_of(const Conflict& c, const MapTracks& map, const RecordingFacts& facts,
                    const MapPlaces& places) {
  const auto is_shown = [&map](PointId bee) {
    const auto at = std::lower_bound(map.tracks.begin(), map.tracks.end(), bee,
                                     [](const MapTrack& of, PointId id) { return of.bee < id; });
    return at != map.tracks.end() && at->bee == bee;
  };
  if (is_shown(c.first) && is_shown(c.second)) {
    return line(R"({"references":[")" + id_of(c.first) + R"(#position",")" + id_of(c.second) +
                R"(#position"]})");
  }
  const auto a = position_at(facts.tracks[c.first], c.closest_s);
  const auto b = position_at(facts.tracks[c.second], c.closest_s);
  return a && b ? line(places.of(*a), places.of(*b)) : std::string();
}

}  // namespace

std::vector<std::string> write_czml(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const Names& names = facts.swarm.names;
  std::vector<std::string> notes;
  const std::size_t bees = marks_shown(facts.at_risk.size(), "bees at risk", notes);
  const std::size_t pairs = marks_shown(facts.pairs.size(), "pairs", notes);
  const MapPlaces places(facts.swarm);
  Packets packets(facts.swarm, kept_words(facts), notes, {}, output);
  for (std::size_t i = 0; i < bees; ++i) {
    const PointId bee = facts.at_risk[i];
    io::JsonObject mark =
        packet(id_of(bee), names.of(bee), nearest_words(facts.closest_in_conflict[i], facts.swarm));
    mark.add_json("position", R"({"cartographicDegrees":[)" +
                                  place_text(places.of(facts.positions[bee]), ',') + "]}");
    mark.add_json("point", dot(8.0, kRiskColour));
    packets.add(mark);
  }
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto& [first, second] = facts.pairs[i];
    io::JsonObject joined =
        packet("pair/" + std::to_string(i), pair_name(names, first, second),
               length_label_below(facts.swarm.threshold_m, facts.distances_m[i]) + " apart");
    joined.add_json("polyline",
                    line(places.of(facts.positions[first]), places.of(facts.positions[second])));
    packets.add(joined);
  }
  packets.finish();
  return notes;
}

std::vector<std::string> write_czml(const RecordingFacts& facts, io::AtomicOutput& output) {
  MapTracks map = map_tracks(facts, kMostTracks, kMostTrackFixes);
  std::vector<std::string> notes = std::move(map.notes);
  if (!facts.since_1970) notes.emplace_back(kTimeNote);
  const std::size_t conflicts = marks_shown(facts.conflicts.size(), "conflicts", notes);
  const MapPlaces places(facts.swarm);
  const TimeSpan time = time_of(map);
  Packets packets(facts.swarm, kept_words(facts), notes, clock_of(time), output);
  add_bees(map, facts, time.begins_s, places, packets);
  for (std::size_t i = 0; i < conflicts; ++i) {
    const Conflict& c = facts.conflicts[i];
    const std::string joined = line_of(c, map, facts, places);
    if (joined.empty()) continue;
    io::JsonObject conflict =
        packet("conflict/" + std::to_string(i), pair_name(facts.swarm.names, c.first, c.second),
               conflict_words(c, facts.swarm));
    conflict.add_text("availability", interval(c.begins_s, c.ends_s));
    conflict.add_json("polyline", joined);
    packets.add(conflict);
  }
  packets.finish();
  return notes;
}

}  // namespace beespace::report
