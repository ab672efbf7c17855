#include "analysis/scene/recording_facts.hpp"
#include "analysis/recorded/coarse_places.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/above_fl410.hpp"
#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/chords.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/jump_spans.hpp"
#include "analysis/recorded/kept_by_height.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/show_conflicts.hpp"
#include "analysis/recorded/still_times.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/recorded/turn_arcs.hpp"
#include "analysis/recorded/velocity_curves.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "analysis/scene/coverage_notes.hpp"
#include "analysis/scene/height_words.hpp"
#include "analysis/scene/pair_ways.hpp"
#include "analysis/scene/placed_tracks.hpp"
#include "analysis/scene/separation.hpp"
#include "analysis/scene/show_limits.hpp"
#include "analysis/scene/uprights.hpp"
#include "analysis/snapshot/worst_pairs.hpp"
#include "analysis/text/bee_name.hpp"
#include "analysis/text/unit_notes.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"
#include "report/earth_frame.hpp"

#include <beespace/find_conflicts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

report::Names names_of(const io::Recording& recording) {
  report::Names names;
  names.texts.reserve(recording.bees.size());
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const io::RecordedBee& of = recording.bees[bee];
    names.texts.push_back(text_of({of.id, of.label}));
    for (const auto& [since_s, label] : of.called) {
      names.called.push_back({bee, since_s, text_of({of.id, label})});
    }
  }
  return names;
}

// When each bee is in conflict with another, stretches that touch put together.
std::vector<report::AtRisk> at_risk_in(const std::vector<Conflict>& conflicts) {
  std::vector<report::AtRisk> all;
  for (const Conflict& conflict : conflicts) {
    for (const PointId bee : {conflict.first, conflict.second}) {
      all.push_back({bee, {conflict.begins_s, conflict.ends_s}});
    }
  }
  std::sort(all.begin(), all.end(), [](const report::AtRisk& a, const report::AtRisk& b) {
    return a.bee != b.bee ? a.bee < b.bee : a.span.begins_s < b.span.begins_s;
  });
  std::vector<report::AtRisk> merged;
  for (const report::AtRisk& next : all) {
    if (!merged.empty() && merged.back().bee == next.bee &&
        next.span.begins_s <= merged.back().span.ends_s) {
      double& ends_s = merged.back().span.ends_s;
      ends_s = std::max(ends_s, next.span.ends_s);
    } else {
      merged.push_back(next);
    }
  }
  return merged;
}

// Whether each bee has one fix, at a time of its own.
bool are_all_there_for_a_moment(const std::vector<Track>& tracks) {
  const auto time = time_of(tracks);
  return time && time->begins_s < time->ends_s &&
         std::all_of(tracks.begin(), tracks.end(),
                     [](const Track& track) { return track.fixes.size() <= 1; });
}

// With a vertical threshold two are told of as they are when they are worst in conflict.
void tell_worst(const WorstOf& worst, std::vector<Conflict>& conflicts) {
  if (!worst) return;
  for (Conflict& conflict : conflicts) {
    const auto moment = worst(conflict);
    if (!moment) continue;
    conflict.closest_s = moment->time_s;
    conflict.closest_m = std::hypot(moment->apart.horizontal_m, moment->apart.vertical_m);
  }
}

void take_conflicts(std::vector<Conflict> conflicts, const WorstOf& worst,
                    report::RecordingFacts& facts) {
  facts.conflict_count = conflicts.size();
  facts.possible_count = static_cast<std::uint64_t>(
      std::count_if(conflicts.begin(), conflicts.end(),
                    [](const Conflict& conflict) { return !conflict.certain; }));
  for (const PairInConflict& pair : pairs_in_conflict(conflicts)) {
    facts.pairs.push_back({pair.closest.first, pair.closest.second, pair.conflicts, pair.time_s});
  }
  std::sort(facts.pairs.begin(), facts.pairs.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  facts.pair_count = facts.pairs.size();
  facts.at_risk = at_risk_in(conflicts);
  sort_worst_first(worst, conflicts);
  if (conflicts.size() > kAllPairs) {
    conflicts.resize(kWorstPairs);
    facts.swarm.notes.push_back(
        "of " + io::grouped(facts.conflict_count) + " conflicts, the closest " +
        io::grouped(conflicts.size()) +
        " are kept; how many there are, and who is at risk when, is of all");
  }
  facts.conflicts = std::move(conflicts);
}

// The worst of the conflicts; the closest of all encounters where there is none.
Result<std::optional<Conflict>> closest_of(const std::vector<Conflict>& conflicts,
                                           const WorstOf& worst, const std::vector<Track>& in_space,
                                           double max_gap_s, const SceneRequest& request) {
  if (conflicts.empty()) {
    return find_closest_encounter(in_space, max_gap_s, {request.threads, request.stop});
  }
  return std::optional(pairs_in_conflict(conflicts, worst).front().worst);
}

// How far apart they are, and the ways between them.
void take_pairs(const Uprights& uprights, report::RecordingFacts& facts) {
  for (const Conflict& conflict : facts.conflicts) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    facts.conflicts_apart.push_back(
        apart_in(conflict, uprights).value_or(report::Apart{kUnknown, kUnknown}));
  }
  if (!facts.closest) return;
  facts.closest_apart = apart_in(*facts.closest, uprights);
  if (facts.closest_in_the_air) {
    facts.closest_in_the_air_apart = apart_in(*facts.closest_in_the_air, uprights);
  }
  facts.pair_ways = facts.conflicts.empty() ? pair_ways({*facts.closest}, uprights)
                                            : pair_ways(facts.conflicts, uprights);
}

// Who is in one of these conflicts, or for a time one of the closest two.
std::vector<PointId> bees_named(const std::vector<Conflict>& conflicts,
                                const report::RecordingFacts& facts) {
  std::vector<PointId> bees;
  for (const Conflict& conflict : conflicts) {
    bees.insert(bees.end(), {conflict.first, conflict.second});
  }
  for (const report::Separation& at : facts.separation) {
    bees.insert(bees.end(), {at.closest.first, at.closest.second});
  }
  return bees;
}

// Where straight lines may be off from what gliders flew that circle.
void note_turns(const Chords& chords, const TurnArcs& arcs, report::SwarmFacts& swarm) {
  for (std::string text : {turn_arcs_text(arcs), chords_text(chords)}) {
    if (!text.empty()) swarm.notes.push_back(std::move(text));
  }
}

// Those that are left out as both are low: how many, and how close the closest come.
void take_low(const LowConflicts& low, const io::Recording& recording,
              report::RecordingFacts& facts) {
  facts.low_count = low.left_out.size();
  facts.low_text = low_text(low);
  std::string note = facts.low_text + ", left out (--ignore-below)";
  if (const auto closest = low.closest()) {
    const auto name = [&](PointId bee) {
      return text_of(name_at(closest->closest_s, bee, recording));
    };
    note += ", the closest " + name(closest->first) + " and " + name(closest->second) + ", " +
            io::length_below(facts.swarm.threshold_m, closest->closest_m) + " apart at " +
            io::moment_text(closest->closest_s, recording);
  }
  facts.swarm.notes.push_back(std::move(note));
  std::string unknown = takeoff_unknown_text(low, facts.swarm.noun);
  if (!unknown.empty()) facts.swarm.notes.push_back(std::move(unknown));
}

// What given velocities say beside straight lines.
void note_curves(const VelocityCurves& curves, report::RecordingFacts& facts) {
  if (!curves.followed) {
    facts.unknown += std::string(facts.unknown.empty() ? "" : ", ") +
                     "velocities lead too far away from straight lines to be followed";
  }
  if (curves.conflicts.empty()) return;
  facts.swarm.notes.push_back(
      io::counted(curves.conflicts.size(), "conflict is", "conflicts are") +
      " possible, along curves that have the given velocities; straight lines from fix to fix, "
      "which are drawn, keep apart there");
}

// Heights of what drives or swims say little.
void note_kept_by_height(const KeptByHeight& kept, const io::Recording& recording,
                         report::RecordingFacts& facts) {
  std::string note = kept_by_height_text(kept, recording, facts.swarm.threshold_m);
  if (!note.empty()) facts.swarm.notes.push_back(std::move(note));
  const std::string open = unsure_heights_text(kept);
  if (open.empty()) return;
  facts.unknown += (facts.unknown.empty() ? "" : ", ") + open;
  facts.hidden = true;
}

// `gaps` are in ascending order of (track, begins_s).
bool is_gap_after(const std::vector<Gap>& gaps, std::size_t track, double time_s) {
  const auto at =
      std::lower_bound(gaps.begin(), gaps.end(), std::pair(track, time_s),
                       [](const Gap& gap, const std::pair<std::size_t, double>& from) {
                         return std::pair<std::size_t, double>(gap.track, gap.begins_s) < from;
                       });
  return at != gaps.end() && at->track == track && at->begins_s == time_s;
}

// In the places in which they are looked at.
void take_tracks(std::vector<Track> tracks, io::Frame frame, report::RecordingFacts& facts) {
  report::SwarmFacts& swarm = facts.swarm;
  if (frame != io::Frame::kWgs84) {
    swarm.origin.reset();
    facts.tracks = std::move(tracks);
    return;
  }
  std::vector<Point> places;
  for (const Track& track : tracks) {
    for (const Fix& fix : track.fixes) places.push_back(fix.position);
  }
  const report::LocalPlaces local = report::around_middle(places, swarm.origin);
  swarm.origin = local.origin;
  const report::EarthFrame earth(local.origin);
  auto next = local.places.begin();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    std::vector<Fix>& fixes = tracks[i].fixes;
    for (std::size_t k = 1; k < fixes.size(); ++k) {
      if (is_gap_after(facts.gaps, i, fixes[k - 1].time_s)) continue;
      facts.bend_m =
          std::max(facts.bend_m, report::bend_m(earth, fixes[k - 1].position, fixes[k].position));
    }
    for (Fix& fix : fixes) fix.position = *next++;
  }
  facts.tracks = std::move(tracks);
}

}  // namespace

Result<report::RecordingFacts> recording_facts(const io::Recording& recording,
                                               const std::string& title,
                                               const SceneRequest& request) {
  if (auto doubt = doubt_of_scale(recording, request.load.frame, typed_threshold(request))) {
    return *std::move(doubt);
  }
  const Geometry geometry = geometry_for(recording, request.vertical);
  const MaxGap max_gap = max_gap_of(recording, request.max_gap_s);
  auto in_space = tracks_of(recording, Geometry::kSpace, request.tolerance_m);
  if (!in_space) return std::move(in_space).error();
  keep_paths_whole(recording, max_gap.seconds, *in_space);
  std::vector<Track> on_ground;
  if (heights_apart(geometry)) {
    auto found = tracks_of(recording, geometry, request.tolerance_m);
    if (!found) return std::move(found).error();
    on_ground = *std::move(found);
  }
  const std::vector<Track>& tracks = heights_apart(geometry) ? on_ground : *in_space;

  report::RecordingFacts facts;
  report::SwarmFacts& swarm = facts.swarm;
  swarm.title = title;
  swarm.origin = request.origin;
  swarm.source = recording.format_description;
  swarm.flat = recording.flat;
  swarm.noun = io::noun_of(recording);
  swarm.y_is_down = recording.y_is_down;
  swarm.heights = height_words(recording.height_unit, recording.heights);
  swarm.aviation = speaks_of_feet(swarm.heights, request.threshold_unit, request.vertical);
  const DefaultThreshold otherwise = default_threshold(recording, kDefaultThreshold_m);
  swarm.threshold_m = request.threshold_m.value_or(otherwise.metres);
  if (!request.threshold_m) swarm.threshold_words = otherwise.words;
  swarm.vertical_m = request.vertical_m();
  swarm.inclusive = request.inclusive;
  if (recording.show && recording.show->place) {
    swarm.own_place = placement_of(*recording.show->place);
  }
  swarm.names = names_of(recording);
  note_units(recording.units, request.vertical, recording.height_unit, swarm.notes);
  if (std::string note = metres_note(recording.units, recording.frame, typed_threshold(request));
      !note.empty()) {
    swarm.notes.push_back(std::move(note));
  }
  swarm.notes.insert(swarm.notes.end(), recording.notes.begin(), recording.notes.end());
  if (recording.skipped_count > 0) {
    swarm.notes.push_back("bad records left out: " + io::grouped(recording.skipped_count));
  }
  facts.calendar = io::calendar_of(recording);
  if (recording.clock) swarm.notes.push_back("times are " + io::clock_text(recording));
  if (recording.show) {
    facts.limits = recording.show->limits;
    facts.cues = recording.show->cues;
    if (Status good = take_show_limits(recording, facts); !good) return good.error();
  }
  if (are_all_there_for_a_moment(*in_space)) {
    swarm.notes.push_back(
        "each " + swarm.noun.one +
        " is there for a moment only, as it has one fix; to compare them as if they were "
        "there at once, leave the time out");
  }

  const ConflictOptions options{
      .threshold_m = swarm.threshold_m,
      .vertical_m = vertical_in(geometry, request.vertical, recording.height_unit),
      .inclusive = request.inclusive,
      .max_gap_s = max_gap.seconds,
      .threads = request.threads,
      .height_unit_m = height_unit_m(geometry, recording.height_unit),
      .stop = request.stop};
  auto recorded = find_conflicts(tracks, options);
  if (!recorded) return std::move(recorded).error();
  auto settled = settled_conflicts(recording, options, std::move(recorded->conflicts));
  if (!settled) return std::move(settled).error();
  recorded->conflicts = *std::move(settled);
  auto standing = conflicts_with_standing(recording, tracks, options);
  if (!standing) return standing.error();
  const auto curves = follow_velocities(recording, geometry, options, recorded->conflicts);
  if (!curves) return curves.error();
  recorded->conflicts = merged(std::move(recorded->conflicts), curves->conflicts);
  leave_out_jumps(recording, recorded->conflicts);
  const Chords chords = doubt_chords(recording, tracks, options, recorded->conflicts);
  const auto arcs = follow_turns(recording, tracks, geometry, options, true, recorded->conflicts);
  if (!arcs) return arcs.error();
  recorded->conflicts = merged(std::move(recorded->conflicts), arcs->conflicts);
  note_turns(chords, *arcs, swarm);
  recorded->conflicts = merged(std::move(recorded->conflicts), *standing);
  const auto left_out = leave_out_standing(recording, tracks, options, recorded->conflicts);
  if (!left_out) return left_out.error();
  facts.standing_count = *left_out;
  if (recording.of_aircraft) {
    *standing = beside_still(recording, recorded->conflicts);
  } else if (!recording.show) {
    *standing = beside_landed(recording, recorded->conflicts);
  }
  if (facts.standing_count > 0) {
    facts.swarm.notes.push_back("conflicts of two that both stand on the ground, left out: " +
                                io::grouped(facts.standing_count));
  }
  LowConflicts low;
  if (request.ignore_below_m) {
    low = leave_out_low(recording, *request.ignore_below_m, recorded->conflicts);
    leave_out_too(low, *standing);
    take_low(low, recording, facts);
  } else if (const auto count =
                 would_leave_out_low(recording, swarm.threshold_m, recorded->conflicts);
             count > 0) {
    swarm.notes.push_back("--ignore-below " + io::exact(swarm.threshold_m) + " leaves out " +
                          io::counted(count, "conflict", "conflicts") +
                          " of two that are both lower than that above where they took off");
  }
  WorstOf worst;
  if (swarm.vertical_m) {
    worst = worst_along(tracks, *curves, *arcs, options.height_unit_m,
                        {swarm.threshold_m, *swarm.vertical_m});
    tell_worst(worst, recorded->conflicts);
    tell_worst(worst, *standing);
  }
  const auto closest = closest_of(recorded->conflicts, worst, *in_space, max_gap.seconds, request);
  if (!closest) return closest.error();
  facts.closest = *closest;
  facts.closest_left_out = recorded->conflicts.empty() && facts.low_count > 0 && facts.closest &&
                           !options.vertical_m && facts.closest->closest_m < options.threshold_m;
  facts.closest_stands = facts.closest && std::find(standing->begin(), standing->end(),
                                                    *facts.closest) != standing->end();
  if (facts.closest_stands) {
    const std::vector<Conflict> of_flying = without(recorded->conflicts, *standing);
    if (!recording.of_aircraft || !of_flying.empty()) {
      const auto in_the_air =
          recording.show || !of_flying.empty()
              ? closest_of(of_flying, worst, *in_space, max_gap.seconds, request)
              : closest_of_flying(recording, *in_space, max_gap.seconds,
                                  {request.threads, request.stop});
      if (!in_the_air) return in_the_air.error();
      facts.closest_in_the_air = *in_the_air;
    }
  } else if (recorded->conflicts.empty() && facts.closest &&
             both_stand(recording, *facts.closest)) {
    const auto flying =
        closest_of_flying(recording, *in_space, max_gap.seconds, {request.threads, request.stop});
    if (!flying) return flying.error();
    facts.closest_in_the_air = *flying;
  }
  // It was decided that they are not closer than that, whatever rounding makes of it.
  if (recording.show && recorded->conflicts.empty() && facts.closest && !options.inclusive &&
      !options.vertical_m && !facts.closest_left_out) {
    facts.closest->closest_m = std::max(facts.closest->closest_m, options.threshold_m);
  }
  facts.gaps = recorded->gaps;
  Coverage coverage = coverage_of(recording, facts.gaps, max_gap);
  judge_places(recording, coarse_question(options, recorded->conflicts, facts.closest), coverage);
  const auto uprights = Uprights::of(recording, *in_space, max_gap.seconds);
  if (!uprights) return uprights.error();
  facts.unknown_spans = unknown_spans(recording, facts.gaps, max_gap);
  facts.gaps = joined_gaps(std::move(facts.gaps), doubtful_spans(recording, max_gap));
  SeparationOverTime over_time = separation_of(
      {recording, tracks, *in_space, *recorded, *closest, coverage, closest->has_value()},
      *uprights, facts.unknown_spans, swarm);
  facts.separation = std::move(over_time.known);
  facts.separation_open = std::move(over_time.open);
  stand_in_tracks(recording, *in_space);
  facts.unknown = unknown_text(coverage, &recording, swarm.noun);
  facts.nowhere_count = recording.missing.nowhere;
  // Drones of a show that fly one after the other stand meanwhile; see has_encounters().
  const bool several_drones = recording.show && in_space->size() > 1;
  facts.nothing_compared = !closest->has_value() && !several_drones && facts.low_count == 0;
  facts.never_known = recording.missing.shared > 0 || recording.missing.nowhere > 0;
  const auto kept =
      kept_by_height(recording, options, request.tolerance_m, recorded->conflicts, low.left_out);
  if (!kept) return kept.error();
  if (*kept) note_kept_by_height(**kept, recording, facts);
  facts.hidden = facts.hidden || coverage.may_hide_conflicts() || !curves->followed;
  note_curves(*curves, facts);
  note_coverage(coverage, recording, facts.unknown, swarm);
  if (std::string above = above_fl410_text(recording, swarm.threshold_m, request.vertical);
      !above.empty()) {
    swarm.notes.push_back(std::move(above));
  }
  doubt_shared_ids(recording, *standing);
  doubt_shared_ids(recording, recorded->conflicts);
  facts.with_standing = *standing;
  take_conflicts(std::move(recorded->conflicts), worst, facts);
  if (!standing->empty()) {
    swarm.notes.push_back(
        io::counted(standing->size(), "conflict is", "conflicts are") +
        (recording.of_aircraft
             ? " with an aircraft that stands still for a minute or longer by its "
               "own reports (0 kt, one place), and come last"
             : " with a drone that stands on the ground, where it is drawn"));
  }
  if (recording.show) {
    *in_space = with_standing(*in_space, recording, bees_named(*standing, facts));
  }
  take_pairs(*uprights, facts);
  take_tracks(*std::move(in_space), recording.frame, facts);
  return facts;
}

}  // namespace beespace::analysis
