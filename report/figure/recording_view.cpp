#include "report/figure/recording_view.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/density.hpp"
#include "report/figure/path_labels.hpp"
#include "report/figure/picture_names.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"
#include "report/shown_fixes.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::report {
namespace {

// Of more, single lines would hide each other, and fill the file.
constexpr std::size_t kFewPaths = 1'500;
constexpr std::size_t kFewCorners = 60'000;
constexpr std::size_t kFewConflicts = 300;
constexpr std::size_t kFewStarts = 300;
constexpr std::size_t kMostFixes = 1'000'000;
constexpr double kFinest = 0.7;  // corners closer than this to each other look like one

// A path as a view shows it: not more corners than can be seen.
class ShownPath {
 public:
  void add(Spot spot) {
    last_ = spot;
    ended_ = !run_.empty() && std::hypot(spot.x - run_.back().x, spot.y - run_.back().y) < kFinest;
    if (!ended_) run_.push_back(spot);
  }
  // Also what is no longer than a corner can be seen.
  std::vector<Spot> finish() {
    if (ended_) run_.push_back(last_);
    ended_ = false;
    return std::exchange(run_, {});
  }

 private:
  std::vector<Spot> run_;
  Spot last_;
  bool ended_ = false;
};

// A path from one gap to the next.
struct PathRun {
  std::size_t bee = 0;
  std::vector<Spot> spots;
};

std::vector<PathRun> paths_of(const RecordingFacts& facts, const View& view) {
  const ShownFixes shown = shown_fixes(facts.tracks, facts.gaps, kMostFixes);
  std::vector<PathRun> paths;
  for (const ShownRun& run : runs_of(shown)) {
    ShownPath path;
    for (std::size_t i = run.begin; i < run.end; ++i) path.add(view.spot_of(shown.positions[i]));
    auto spots = path.finish();
    if (spots.size() > 1) paths.push_back({run.bee, std::move(spots)});
  }
  return paths;
}

bool are_few(const std::vector<PathRun>& paths) {
  std::size_t corners = 0;
  for (const PathRun& path : paths) corners += path.spots.size();
  return paths.size() <= kFewPaths && corners <= kFewCorners;
}

Density ways_of(const std::vector<PathRun>& paths, const View& view) {
  Density density = density_over(view, kDensityCell);
  for (const auto& [bee, spots] : paths) {
    for (std::size_t i = 1; i < spots.size(); ++i) density.add_way(spots[i - 1], spots[i]);
  }
  return density;
}

// In one ink, or each bee in its own, one after the other.
void draw_lines(std::vector<PathRun> paths, std::size_t bees, Drawing& drawing) {
  constexpr std::size_t kThinner = 200;
  Lines all{{}, kPath, bees <= kThinner ? 1.0 : 0.7};
  std::size_t drawn = 0;
  const auto draw = [&] {
    if (all.runs.empty()) return;
    if (const auto own = own_ink(drawn, bees)) all.ink = *own;
    drawing.shapes.emplace_back(all);
    all.runs.clear();
  };
  for (PathRun& path : paths) {
    if (path.bee != drawn && own_ink(path.bee, bees)) draw();
    drawn = path.bee;
    all.runs.push_back(std::move(path.spots));
  }
  draw();
}

// Where a bee is while it is in conflict.
std::vector<Spot> part_of(const AtRisk& at_risk, const RecordingFacts& facts, const View& view) {
  const Track& track = facts.tracks[at_risk.bee];
  const auto [begins_s, ends_s] = at_risk.span;
  const auto first = std::upper_bound(track.fixes.begin(), track.fixes.end(), begins_s,
                                      [](double t, const Fix& fix) { return t < fix.time_s; });
  ShownPath path;
  if (const auto begin = position_at(track, begins_s)) path.add(view.spot_of(*begin));
  for (auto fix = first; fix != track.fixes.end() && fix->time_s < ends_s; ++fix) {
    path.add(view.spot_of(fix->position));
  }
  if (const auto end = position_at(track, ends_s)) path.add(view.spot_of(*end));
  return path.finish();
}

// Where bees are while they are in conflict; nothing where these are too many to draw, and the
// marks of the closest points have to do.
std::vector<std::vector<Spot>> parts_in_conflict(const RecordingFacts& facts, const View& view) {
  std::vector<std::vector<Spot>> parts;
  std::size_t corners = 0;
  for (const AtRisk& at_risk : facts.at_risk) {
    parts.push_back(part_of(at_risk, facts, view));
    corners += parts.back().size();
    if (corners > kFewCorners) return {};
  }
  return parts;
}

std::vector<Diamond> closest_points(const RecordingFacts& facts, const View& view) {
  std::vector<Diamond> marks;
  for (const Conflict& conflict : facts.conflicts) {
    for (const PointId bee : {conflict.first, conflict.second}) {
      const auto at = position_at(facts.tracks[bee], conflict.closest_s);
      if (at) marks.push_back({view.spot_of(*at), 5.0, picture_name(facts.swarm.names, bee)});
    }
  }
  return marks;
}

Density conflicts_of(const RecordingFacts& facts, const View& view) {
  Density density = density_over(view, kRiskCell);
  for (const Conflict& conflict : facts.conflicts) {
    const auto at = position_at(facts.tracks[conflict.first], conflict.closest_s);
    if (at) density.add(view.spot_of(*at));
  }
  return density;
}

// What the areas of their marks tell.
std::string areas_of(const RecordingFacts& facts) {
  if (facts.conflicts.size() >= facts.conflict_count) return "conflicts: area by their number";
  return "closest " + count_label(facts.conflicts.size()) + " conflicts: area by number";
}

void draw_conflicts(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  if (facts.conflicts.empty()) return;
  if (facts.conflicts.size() <= kFewConflicts) {
    drawing.shapes.emplace_back(Diamonds{closest_points(facts, view), kRisk});
  } else {
    drawing.shapes.emplace_back(conflicts_of(facts, view).diamonds(kRisk));
  }
}

void draw_starts(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  constexpr double kStart = 2.6;
  Dots starts{{}, kStart, kBee, 1.0};
  for (std::size_t bee = 0; bee < facts.tracks.size(); ++bee) {
    const Track& track = facts.tracks[bee];
    if (track.fixes.empty()) continue;
    const Spot at = view.spot_of(track.fixes.front().position);
    if (const auto own = own_ink(bee, facts.tracks.size())) {
      drawing.shapes.emplace_back(Dots{{at}, kStart, *own, 1.0});
    } else {
      starts.centres.push_back(at);
    }
  }
  if (!starts.centres.empty() && starts.centres.size() <= kFewStarts) {
    drawing.shapes.emplace_back(std::move(starts));
  }
}

// "a drone", "an animal".
std::string one_of(const io::RecordedNoun& noun) {
  const bool vowel = std::string_view("aeiou").find(noun.one.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun.one;
}

// "Drone 3 – Drone 7", as short as there is room for.
std::string names_of(const Conflict& pair, const RecordingFacts& facts) {
  constexpr double kWidest = 130.0;
  const auto name = [&](PointId bee) {
    return fitted(one_line(facts.swarm.names.at(pair.closest_s, bee)), kLabelSize, kWidest);
  };
  return name(pair.first) + " \u2013 " + name(pair.second);
}

void draw_closest(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  if (!facts.closest) return;
  // Of a show with drones on the ground, those that are closest in the air.
  const bool in_the_air = facts.closest_in_the_air.has_value();
  const Conflict& closest = in_the_air ? *facts.closest_in_the_air : *facts.closest;
  const auto& apart = in_the_air ? facts.closest_in_the_air_apart : facts.closest_apart;
  const bool keeps_apart =
      in_the_air ? closest.closest_m >= facts.swarm.threshold_m : facts.at_risk.empty();
  const auto first = position_at(facts.tracks[closest.first], closest.closest_s);
  const auto second = position_at(facts.tracks[closest.second], closest.closest_s);
  if (!first || !second) return;
  const Spot a = view.spot_of(*first);
  const Spot b = view.spot_of(*second);
  std::string words;
  if (view.from == View::From::kAbove) {
    words = in_the_air ? closest_of_moving(facts.swarm) : "closest";
    words += facts.closest_left_out && !in_the_air ? ", left out: "
             : !keeps_apart                        ? ": "
             : facts.unknown.empty()               ? ", not too close: "
                                                   : " in the known time: ";
    // A few paths have their names at their ends.
    if (facts.tracks.size() > kMostNamedPaths) words += names_of(closest, facts) + ", ";
    words += apart_words(facts.swarm, closest.closest_m, apart, keeps_apart);
    if (facts.closest_stands && !in_the_air) words += with_one_standing(facts.swarm);
  }
  draw_ring(view.panel.box, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, words, drawing);
}

}  // namespace

void draw_paths(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  auto paths = paths_of(facts, view);
  if (are_few(paths)) {
    draw_lines(std::move(paths), facts.tracks.size(), drawing);
  } else {
    drawing.shapes.emplace_back(ways_of(paths, view).cells(shades()));
  }
  draw_starts(facts, view, drawing);
  drawing.shapes.emplace_back(Lines{parts_in_conflict(facts, view), kRisk,
                                    facts.conflicts.size() <= kFewConflicts ? 2.2 : 1.0});
  draw_conflicts(facts, view, drawing);
  draw_closest(facts, view, drawing);
  if (view.from == View::From::kAbove) draw_path_labels(facts, view, drawing);
}

std::vector<KeyEntry> key_of_paths(const RecordingFacts& facts, const View& from_above) {
  using Sample = KeyEntry::Sample;
  std::vector<KeyEntry> key;
  const auto paths = paths_of(facts, from_above);
  if (are_few(paths)) {
    const bool own = facts.tracks.size() > 1 && own_ink(0, facts.tracks.size());
    key.push_back({Sample::kPath, own ? "path, each in its colour" : "path"});
  } else {
    key.push_back({Sample::kShades, "paths through a cell: 1 to " +
                                        count_label(ways_of(paths, from_above).most()) +
                                        " from above"});
  }
  if (facts.tracks.size() <= kFewStarts) {
    const std::size_t named = named_paths(facts).size();
    key.push_back({Sample::kStart, named == 0                     ? "start"
                                   : named == facts.tracks.size() ? "start; names are at ends"
                                                                  : "start; names of those in "
                                                                    "conflict are at ends"});
  }
  if (!facts.unknown_spans.empty())
    key.push_back({Sample::kUnknown, one_of(facts.swarm.noun) + " unknown"});
  if (facts.conflicts.empty()) return key;
  const bool parts = !parts_in_conflict(facts, from_above).empty();
  if (facts.conflicts.size() <= kFewConflicts) {
    key.push_back(parts ? KeyEntry{Sample::kInConflict, "in conflict, and where it is closest"}
                        : KeyEntry{Sample::kAtRisk, "in conflict, where it is closest"});
  } else {
    if (parts) key.push_back({Sample::kInConflict, "in conflict"});
    key.push_back({Sample::kBinned, areas_of(facts) + ", up to " +
                                        count_label(conflicts_of(facts, from_above).most()) +
                                        " from above"});
  }
  key.push_back({Sample::kBand, one_of(facts.swarm.noun) + " in conflict"});
  return key;
}

}  // namespace beespace::report
