#include "analysis/scene/snapshot_facts.hpp"

#include "analysis/geometry/ground_places.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/last_snapshot.hpp"
#include "analysis/scene/conflicts_ahead.hpp"
#include "analysis/scene/height_words.hpp"
#include "analysis/scene/uprights.hpp"
#include "analysis/snapshot/closest_in_conflict.hpp"
#include "analysis/snapshot/shown_ids.hpp"
#include "analysis/snapshot/worst_pairs.hpp"
#include "analysis/text/bee_name.hpp"
#include "analysis/text/unit_notes.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"
#include "report/earth_frame.hpp"
#include "report/local_axes.hpp"

#include <beespace/engine.hpp>
#include <beespace/geodesy.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

// Of more bees only those have their own ids whose pairs are shown.
constexpr std::size_t kMostNames = 200'000;

report::Names names_of(const io::LoadedPoints& loaded, const std::vector<Pair>& pairs) {
  report::Names names;
  std::vector<PointId> bees(loaded.points.size());
  std::iota(bees.begin(), bees.end(), PointId{0});
  const bool all = bees.size() <= kMostNames;
  if (!all) {
    bees.clear();
    for (const Pair& pair : pairs) bees.insert(bees.end(), {pair.first, pair.second});
    std::sort(bees.begin(), bees.end());
    bees.erase(std::unique(bees.begin(), bees.end()), bees.end());
  }
  const ShownIds ids(loaded, bees);
  if (ids.are_point_numbers()) return names;
  for (const PointId bee : bees) names.texts.push_back(ids.text(bee));
  if (!all) names.bees = std::move(bees);
  return names;
}

// Of what is read from either kind of input, and what it is called.
report::SnapshotFacts begun(const std::string& title, const SceneRequest& request) {
  report::SnapshotFacts facts;
  facts.swarm.title = title;
  facts.swarm.origin = request.origin;
  facts.swarm.threshold_m = request.threshold_m.value_or(kDefaultThreshold_m);
  facts.swarm.vertical_m = request.vertical_m();
  facts.swarm.inclusive = request.inclusive;
  return facts;
}

// In a sphere the bee nearest to one at risk is in conflict with it.
Status find_closest_in_conflict(Engine& engine, const PointsView& places,
                                const std::vector<Point>& points, const SearchOptions& options,
                                report::SnapshotFacts& facts) {
  if (!options.vertical_m) {
    for (const PointId bee : facts.at_risk) {
      facts.closest_in_conflict.push_back(facts.nearest[bee]);
    }
    return std::monostate{};
  }
  auto closest = closest_in_conflict(engine, places, points, options, facts.at_risk);
  if (!closest) return std::move(closest).error();
  facts.closest_in_conflict = *std::move(closest);
  return std::monostate{};
}

Status find_closest_pair(Engine& engine, const std::vector<Point>& points, const RunOptions& run,
                         report::SnapshotFacts& facts) {
  if (facts.swarm.vertical_m && !facts.pairs.empty()) {
    const Pair& pair = facts.pairs.front();
    facts.closest = ClosestPair{pair.first, pair.second, facts.distances_m.front()};
    return std::monostate{};
  }
  auto closest = engine.find_closest_pair(points, run);
  if (!closest) return std::move(closest).error();
  facts.closest = *closest;
  return std::monostate{};
}

// Asks the engine.
Status search(const std::vector<Point>& points, const GroundPlaces& apart, const RunOptions& run,
              report::SnapshotFacts& facts) {
  SearchOptions options;
  options.threshold_m = facts.swarm.threshold_m;
  options.vertical_m = apart.vertical_m;
  options.inclusive = facts.swarm.inclusive;
  options.threads = run.threads;
  options.stop = run.stop;
  const PointsView places = apart.view(points);
  Engine engine;
  Status found = engine.find_at_risk(places, options, facts.at_risk);
  IdRows groups;
  if (found) found = engine.find_conflict_groups(places, options, groups);
  if (found) found = engine.find_nearest(points, facts.nearest, run);
  if (found) found = find_closest_in_conflict(engine, places, points, options, facts);
  if (!found) return found;
  facts.group_count = groups.size();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    facts.largest_group = std::max<std::uint64_t>(facts.largest_group, groups[i].size());
  }
  auto worst = worst_pairs(engine, places, points, options);
  if (!worst) return std::move(worst).error();
  facts.pair_count = worst->count;
  facts.pairs = std::move(worst->pairs);
  facts.distances_m = std::move(worst->distances_m);
  if (facts.pairs.size() < facts.pair_count) {
    facts.swarm.notes.push_back("of " + io::grouped(facts.pair_count) + " pairs, the closest " +
                                io::grouped(facts.pairs.size()) + " are kept");
  }
  return find_closest_pair(engine, points, run, facts);
}

// Where a point is above the ground, and how high.
Upright upright(const Point& point, io::Frame frame) {
  if (frame != io::Frame::kWgs84) return {{point.x, point.y, 0.0}, point.z};
  GeographicPosition place = report::to_geographic(point);
  const double height_m = place.height_m;
  place.height_m = 0.0;
  const auto ground = to_ecef(place);
  return {ground ? *ground : point, height_m};
}

// How far apart pairs are horizontally and in height: of all where heights count by themselves, and
// otherwise of not too many.
void take_apart(const std::vector<Point>& points, io::Frame frame, report::SnapshotFacts& facts) {
  constexpr std::size_t kMany = 10'000;
  const auto of = [&](PointId first, PointId second) {
    return apart(upright(points[first], frame), upright(points[second], frame));
  };
  if (facts.closest) facts.closest_apart = of(facts.closest->first, facts.closest->second);
  if (!facts.swarm.vertical_m && facts.pairs.size() > kMany) return;
  for (const Pair& pair : facts.pairs) facts.apart.push_back(of(pair.first, pair.second));
}

void place(const std::vector<Point>& points, io::Frame frame, report::SnapshotFacts& facts) {
  take_apart(points, frame, facts);
  if (frame != io::Frame::kWgs84) {
    facts.swarm.origin.reset();
    facts.positions = points;
    return;
  }
  report::LocalPlaces local = report::around_middle(points, facts.swarm.origin);
  facts.swarm.origin = local.origin;
  facts.positions = std::move(local.places);
}

void note_skipped(std::uint64_t count, std::vector<std::string>& notes) {
  if (count > 0) notes.push_back("bad records left out: " + io::grouped(count));
}

// What the search did not see.
std::string unknown_text(const Snapshot& snapshot, const io::Recording& recording) {
  const io::RecordedNoun noun = io::noun_of(recording);
  std::string text;
  if (const std::uint64_t count = snapshot.unmoving.size(); count > 0) {
    text = noun.counted(count) + (count == 1 ? " is" : " are") +
           " checked for now only, where last heard of";
  }
  const std::uint64_t stale = snapshot.stale;
  const std::string left_out =
      stale > 0 ? noun.counted(stale) + (stale == 1 ? " is" : " are") + " left out" : "";
  for (const std::string& more :
       {left_out, missing_text(recording.missing, noun), passed_over_text(snapshot, recording)}) {
    if (!text.empty() && !more.empty()) text += ", ";
    text += more;
  }
  return text;
}

void note_unknown(const std::string& unknown, std::vector<std::string>& notes) {
  if (!unknown.empty()) notes.push_back("what is said is of those that are known: " + unknown);
}

// What `predict` says of bees that are not where they were last seen.
void note_ages(const Snapshot& snapshot, std::vector<std::string>& notes) {
  if (snapshot.brought_forward > 0) {
    notes.push_back(io::grouped(snapshot.brought_forward) +
                    " last heard of before the time shown were brought forward, by up to " +
                    io::grouped(snapshot.oldest_s, 2) + " s");
  }
  if (snapshot.stale > 0) {
    notes.push_back(io::grouped(snapshot.stale) + " left out: not heard of for " +
                    io::exact(kMaxAgeShown_s) + " s");
  }
  if (snapshot.unmoving.empty()) return;
  double oldest_s = 0.0;
  for (const Snapshot::Placed& placed : snapshot.unmoving) {
    oldest_s = std::max(oldest_s, placed.age_s);
  }
  notes.push_back(
      io::grouped(snapshot.unmoving.size()) + " shown where last heard of, up to " +
      io::grouped(oldest_s, 2) +
      " s before: neither a velocity (speed, direction and climb) nor two fixes tell how fast "
      "they go" +
      (snapshot.climbless + snapshot.level_only > 0 ? ", or nothing how fast they climb" : ""));
}

}  // namespace

Result<report::SnapshotFacts> snapshot_facts(const io::LoadedPoints& loaded,
                                             const std::string& title,
                                             const SceneRequest& request) {
  report::SnapshotFacts facts = begun(title, request);
  report::SwarmFacts& swarm = facts.swarm;
  swarm.source = loaded.format_description;
  swarm.heights = height_words(loaded.height_unit, loaded.heights);
  swarm.aviation = speaks_of_feet(swarm.heights, request.threshold_unit, request.vertical);
  swarm.y_is_down =
      std::any_of(loaded.units.begin(), loaded.units.end(),
                  [](const io::UnitTaken& taken) { return taken.unit == io::Unit::kPixel; });
  note_units(loaded.units, request.vertical, loaded.height_unit, swarm.notes);
  swarm.notes.insert(swarm.notes.end(), loaded.notes.begin(), loaded.notes.end());
  if (const io::RepeatedIds repeated = io::find_repeated_ids(loaded); repeated.count > 0) {
    swarm.notes.push_back(text_of(repeated));
  }
  note_skipped(loaded.skipped_count, swarm.notes);
  io::MissingRecords missing;
  missing.count = loaded.skipped_count;
  facts.unknown = missing_text(missing);
  note_unknown(facts.unknown, swarm.notes);
  const GroundPlaces apart = ground_places(loaded, request.vertical, loaded.height_unit);
  const Status found = search(loaded.points, apart, {request.threads, request.stop}, facts);
  if (!found) return found.error();
  swarm.names = names_of(loaded, facts.pairs);
  if (!swarm.names.bees.empty()) {
    swarm.notes.emplace_back(
        "only those whose pairs are shown have their own ids; of the others, the number of the "
        "data row is shown");
  }
  place(loaded.points, loaded.frame, facts);
  return facts;
}

Result<report::SnapshotFacts> snapshot_facts(const io::Recording& recording,
                                             const std::string& title,
                                             const SceneRequest& request) {
  report::SnapshotFacts facts = begun(title, request);
  report::SwarmFacts& swarm = facts.swarm;
  swarm.source = recording.format_description;
  swarm.noun = io::noun_of(recording);
  swarm.y_is_down = recording.y_is_down;
  swarm.heights = height_words(recording.height_unit, recording.heights);
  swarm.aviation = speaks_of_feet(swarm.heights, request.threshold_unit, request.vertical);
  note_units(recording.units, request.vertical, recording.height_unit, swarm.notes);
  swarm.notes.insert(swarm.notes.end(), recording.notes.begin(), recording.notes.end());
  note_skipped(recording.skipped_count, swarm.notes);
  const auto snapshot = snapshot_of(recording, Geometry::kSpace, kMaxAgeShown_s, Wanted::kPlaces);
  if (!snapshot) return snapshot.error();
  if (snapshot->passed_over_since_s) {
    swarm.notes.push_back("shown is one moment, " + io::moment_text(snapshot->time_s, recording));
  }
  note_ages(*snapshot, swarm.notes);
  facts.unknown = unknown_text(*snapshot, recording);
  note_unknown(facts.unknown, swarm.notes);
  // Whom a search must not look ahead of is there all the same.
  const Snapshot present = snapshot->present();
  std::vector<Point> points;
  points.reserve(present.movers.size());
  for (const Mover& mover : present.movers) points.push_back(mover.position);
  GroundPlaces apart;
  const Geometry geometry = geometry_for(recording, request.vertical);
  apart.vertical_m = vertical_in(geometry, request.vertical, recording.height_unit);
  if (heights_apart(geometry)) {
    const auto in_cylinders = snapshot_of(recording, geometry, kMaxAgeShown_s, Wanted::kPlaces);
    if (!in_cylinders) return in_cylinders.error();
    Snapshot on_ground = in_cylinders->present();
    for (const Mover& mover : on_ground.movers) apart.ground.push_back(mover.position);
    apart.heights_m = std::move(on_ground.heights_m);
  }
  const Status found = search(points, apart, {request.threads, request.stop}, facts);
  if (!found) return found.error();
  for (const std::uint32_t bee : present.bees) {
    swarm.names.texts.push_back(text_of(name_of(bee, recording)));
  }
  place(points, recording.frame, facts);
  facts.moment = io::moment_text(snapshot->time_s, recording);
  if (Status looked = look_ahead(recording, present.bees, request, facts); !looked) {
    return looked.error();
  }
  return facts;
}

}  // namespace beespace::analysis
