#include "report/map/kml.hpp"

#include "report/map/map_obstacles.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_time.hpp"
#include "report/map/map_tracks.hpp"
#include "report/map/map_words.hpp"
#include "report/xml_text.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace beespace::report {
namespace {

// Colours are alpha, blue, green, red.
constexpr std::string_view kStyles =
    "<Style id=\"risk\"><IconStyle><color>ff0a50c8</color><scale>0.8</scale></IconStyle>"
    "<LabelStyle><scale>0.7</scale></LabelStyle>"
    "<LineStyle><color>ff0a50c8</color><width>3</width></LineStyle></Style>\n"
    "<Style id=\"path\"><IconStyle><color>ffa3886f</color><scale>0.6</scale></IconStyle>"
    "<LabelStyle><scale>0.7</scale></LabelStyle>"
    "<LineStyle><color>b0a3886f</color><width>1.5</width></LineStyle></Style>\n"
    "<Style id=\"obstacle\"><LineStyle><color>c03c96d2</color><width>1</width></LineStyle>"
    "<PolyStyle><color>503c96d2</color></PolyStyle></Style>\n";

std::string element(std::string_view name, std::string_view text) {
  std::string out = "<";
  (out += name) += '>';
  append_xml_text(out, text);
  return ((out += "</") += name) += '>';
}

// Where it is not known how high the place is, heights are those above the ground.
std::string_view altitude_mode(const SwarmFacts& swarm) {
  return counts_from_unknown_ground(swarm) ? "<altitudeMode>relativeToGround</altitudeMode>"
                                           : "<altitudeMode>absolute</altitudeMode>";
}

class Document {
 public:
  Document(const SwarmFacts& swarm, const std::string& kept, const std::vector<std::string>& notes,
           io::AtomicOutput& output)
      : output_(output), mode_(altitude_mode(swarm)) {
    output_.write(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
        "xmlns:gx=\"http://www.google.com/kml/ext/2.2\">\n<Document>\n");
    output_.write(element("name", swarm.title) +
                  element("description", document_words(swarm, kept, notes)) + '\n');
    output_.write(kStyles);
  }

  void begin_folder(std::string_view name) {
    output_.write("<Folder>" + element("name", name) + '\n');
  }
  void end_folder() { output_.write("</Folder>\n"); }

  // `time` and `geometry` are XML.
  void add(const std::string& name, const std::string& description, const std::string& time,
           const char* style, const std::string& geometry) {
    output_.write("<Placemark>" + element("name", name) +
                  (description.empty() ? "" : element("description", description)) + time +
                  "<styleUrl>#" + style + "</styleUrl>" + geometry + "</Placemark>\n");
  }

  void finish() { output_.write("</Document>\n</kml>\n"); }

  // What heights are counted from, an element of each geometry.
  [[nodiscard]] std::string_view mode() const { return mode_; }

 private:
  io::AtomicOutput& output_;
  std::string_view mode_;
};

std::string point(std::string_view mode, const GeographicPosition& at) {
  return "<Point>" + std::string(mode) + element("coordinates", place_text(at, ',')) + "</Point>";
}

std::string line(std::string_view mode, const GeographicPosition& from,
                 const GeographicPosition& to) {
  return "<LineString>" + std::string(mode) +
         element("coordinates", place_text(from, ',') + ' ' + place_text(to, ',')) +
         "</LineString>";
}

std::string track(std::string_view mode, const std::vector<Fix>& run, const MapPlaces& places) {
  std::string out = "<gx:Track>" + std::string(mode) + '\n';
  for (const Fix& fix : run) out += element("when", map_instant(fix.time_s)) + '\n';
  for (const Fix& fix : run) {
    out += element("gx:coord", place_text(places.of(fix.position), ' ')) + '\n';
  }
  return out + "</gx:Track>";
}

std::string tracks(std::string_view mode, const MapTrack& of, const MapPlaces& places) {
  if (of.runs.size() == 1) return track(mode, of.runs.front(), places);
  std::string out = "<gx:MultiTrack>\n";
  for (const auto& run : of.runs) out += track(mode, run, places) + '\n';
  return out + "</gx:MultiTrack>";
}

std::string polygon(std::string_view mode, const std::vector<GeographicPosition>& corners,
                    bool to_the_ground) {
  std::string places;
  for (const GeographicPosition& corner : corners) places += place_text(corner, ',') + ' ';
  places += place_text(corners.front(), ',');
  return "<Polygon>" + std::string(to_the_ground ? "<extrude>1</extrude>" : "") +
         std::string(mode) + "<outerBoundaryIs><LinearRing>" + element("coordinates", places) +
         "</LinearRing></outerBoundaryIs></Polygon>";
}

std::vector<GeographicPosition> at_height(std::vector<GeographicPosition> corners,
                                          double height_m) {
  for (GeographicPosition& corner : corners) corner.height_m = height_m;
  return corners;
}

// Its roof, down to the ground where it has no lower end; otherwise its floor and its walls too.
std::string solid(std::string_view mode, const MapObstacle& obstacle) {
  const auto roof = at_height(obstacle.outline, obstacle.high_m);
  if (!std::isfinite(obstacle.heights.low_m)) return polygon(mode, roof, true);
  if (obstacle.low_m == obstacle.high_m) return polygon(mode, roof, false);
  const auto& floor = obstacle.outline;
  std::string faces =
      polygon(mode, roof, false) + polygon(mode, {floor.rbegin(), floor.rend()}, false);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const std::size_t next = (i + 1) % floor.size();
    faces += polygon(mode, {floor[i], floor[next], roof[next], roof[i]}, false);
  }
  return "<MultiGeometry>" + faces + "</MultiGeometry>";
}

void add_obstacles(const MapObstacles& map, Document& document) {
  if (map.obstacles.empty()) return;
  document.begin_folder("Obstacles");
  for (const MapObstacle& obstacle : map.obstacles) {
    document.add(obstacle.name, obstacle.words, {}, "obstacle", solid(document.mode(), obstacle));
  }
  document.end_folder();
}

void add_conflicts(const RecordingFacts& facts, std::size_t count, const MapPlaces& places,
                   Document& document) {
  document.begin_folder("Conflicts");
  for (std::size_t i = 0; i < count; ++i) {
    const Conflict& c = facts.conflicts[i];
    const auto a = position_at(facts.tracks[c.first], c.closest_s);
    const auto b = position_at(facts.tracks[c.second], c.closest_s);
    if (!a || !b) continue;
    const std::string time = "<TimeSpan>" + element("begin", map_instant(c.begins_s)) +
                             element("end", map_instant(c.ends_s)) + "</TimeSpan>";
    document.add(pair_name(facts.swarm.names, c), conflict_words(facts, i), time, "risk",
                 "<MultiGeometry>" + point(document.mode(), places.of(middle_of(*a, *b))) +
                     line(document.mode(), places.of(*a), places.of(*b)) + "</MultiGeometry>");
  }
  document.end_folder();
}

}  // namespace

std::vector<std::string> write_kml(const SnapshotFacts& facts, io::AtomicOutput& output) {
  const Names& names = facts.swarm.names;
  const MapObstacles obstacles = map_obstacles(facts);
  std::vector<std::string> notes = obstacles.notes;
  const std::size_t bees =
      marks_shown(facts.at_risk.size(), facts.swarm.noun.several + " at risk", notes);
  const std::size_t pairs = marks_shown(facts.pairs.size(), "pairs", notes);
  const MapPlaces places(facts.swarm);
  Document document(facts.swarm, kept_words(facts), notes, output);
  document.begin_folder("At risk");
  for (std::size_t i = 0; i < bees; ++i) {
    const PointId bee = facts.at_risk[i];
    document.add(names.of(bee), nearest_words(facts.closest_in_conflict[i], facts.swarm), {},
                 "risk", point(document.mode(), places.of(facts.positions[bee])));
  }
  document.end_folder();
  document.begin_folder("Pairs too close");
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto& [first, second] = facts.pairs[i];
    document.add(pair_name(names, first, second), pair_words(facts, i), {}, "risk",
                 line(document.mode(), places.of(facts.positions[first]),
                      places.of(facts.positions[second])));
  }
  document.end_folder();
  add_obstacles(obstacles, document);
  document.finish();
  return notes;
}

std::vector<std::string> write_kml(const RecordingFacts& facts, io::AtomicOutput& output) {
  const MapTracks map = map_tracks(facts, kMostTracks, kMostTrackFixes);
  const MapObstacles obstacles = map_obstacles(facts);
  std::vector<std::string> notes = map.notes;
  notes.insert(notes.end(), obstacles.notes.begin(), obstacles.notes.end());
  if (!facts.calendar.since_1970) notes.emplace_back(kTimeNote);
  const std::size_t conflicts = marks_shown(facts.conflicts.size(), "conflicts", notes);
  const MapPlaces places(facts.swarm);
  Document document(facts.swarm, kept_words(facts), notes, output);
  add_conflicts(facts, conflicts, places, document);
  document.begin_folder("Paths");
  for (const MapTrack& of : map.tracks) {
    document.add(facts.swarm.names.of(of.bee), {}, {}, "path", tracks(document.mode(), of, places));
  }
  document.end_folder();
  add_obstacles(obstacles, document);
  document.finish();
  return notes;
}

}  // namespace beespace::report
