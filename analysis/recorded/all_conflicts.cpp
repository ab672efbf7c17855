#include "analysis/recorded/all_conflicts.hpp"

#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/jump_spans.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/show_conflicts.hpp"
#include "analysis/recorded/still_times.hpp"

#include <beespace/search_options.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

Result<std::optional<Conflict>> closest_or_encounter(const std::vector<Conflict>& conflicts,
                                                     const std::vector<Track>& tracks,
                                                     const ConflictOptions& options) {
  if (conflicts.empty()) {
    if (options.vertical_m) return std::optional<Conflict>();
    return find_closest_encounter(tracks, options.max_gap_s, {options.threads, options.stop});
  }
  return std::optional<Conflict>(*std::min_element(
      conflicts.begin(), conflicts.end(),
      [](const Conflict& a, const Conflict& b) { return a.closest_m < b.closest_m; }));
}

}  // namespace

Result<AllConflicts> all_conflicts(const io::Recording& recording, const std::vector<Track>& tracks,
                                   Geometry geometry, const ConflictOptions& options,
                                   bool straight) {
  AllConflicts found;
  auto along_lines = find_conflicts(tracks, options);
  if (!along_lines) return std::move(along_lines).error();
  found.recorded = *std::move(along_lines);
  std::vector<Conflict>& conflicts = found.recorded.conflicts;
  auto of_show = conflicts_of_show(recording, tracks, options, std::move(conflicts));
  if (!of_show) return std::move(of_show).error();
  conflicts = std::move(of_show->conflicts);
  found.with_standing = std::move(of_show->with_standing);
  if (!straight) {
    auto curves = follow_velocities(recording, geometry, options, conflicts);
    if (!curves) return std::move(curves).error();
    found.curves = *std::move(curves);
    conflicts = merged(std::move(conflicts), found.curves.conflicts);
  }
  leave_out_jumps(recording, conflicts);
  found.chords = doubt_chords(recording, tracks, options, conflicts);
  auto arcs = follow_turns(recording, tracks, geometry, options, !straight, conflicts);
  if (!arcs) return std::move(arcs).error();
  found.arcs = *std::move(arcs);
  conflicts = merged(std::move(conflicts), found.arcs.conflicts);
  doubt_shared_ids(recording, conflicts);
  const auto left_out = leave_out_standing(recording, tracks, options, conflicts);
  if (!left_out) return left_out.error();
  found.standing_count = *left_out;
  if (recording.of_aircraft) {
    found.with_standing = beside_still(recording, conflicts);
  } else if (!recording.show) {
    found.with_standing = beside_landed(recording, conflicts);
  }
  auto closest = closest_or_encounter(conflicts, tracks, options);
  if (!closest) return std::move(closest).error();
  found.closest = *closest;
  // It was decided that the two are not closer than that, whatever rounding makes of it.
  if (recording.show && conflicts.empty() && found.closest && !options.inclusive &&
      !options.vertical_m) {
    found.closest->closest_m = std::max(found.closest->closest_m, options.threshold_m);
  }
  if (conflicts.empty() && found.closest && both_stand(recording, *found.closest)) {
    auto flying =
        closest_of_flying(recording, tracks, options.max_gap_s, {options.threads, options.stop});
    if (!flying) return std::move(flying).error();
    found.closest_in_the_air = *flying;
    return found;
  }
  const auto& standing = found.with_standing;
  if (std::find(standing.begin(), standing.end(), found.closest) == standing.end()) return found;
  const std::vector<Conflict> of_flying = without(conflicts, standing);
  if (recording.of_aircraft && of_flying.empty()) return found;
  auto in_the_air = recording.show || !of_flying.empty()
                        ? closest_or_encounter(of_flying, tracks, options)
                        : closest_of_flying(recording, tracks, options.max_gap_s,
                                            {options.threads, options.stop});
  if (!in_the_air) return std::move(in_the_air).error();
  found.closest_in_the_air = *in_the_air;
  return found;
}

bool has_encounters(const AllConflicts& found, const io::Recording& recording,
                    const std::vector<Track>& in_space, const ConflictOptions& options) {
  // Drones of a show that fly one after the other stand meanwhile.
  if (found.closest || (recording.show && in_space.size() > 1)) return true;
  if (!options.vertical_m) return false;
  const auto any =
      find_closest_encounter(in_space, options.max_gap_s, {options.threads, options.stop});
  return any && any->has_value();
}

namespace {

// Whether it was found along these curves, or arcs, and not along straight lines.
auto is_among(const std::vector<Conflict>& conflicts) {
  return [&conflicts](const Conflict& conflict) {
    const auto by_pair = [](const Conflict& a, const Conflict& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    };
    const auto [from, to] = std::equal_range(conflicts.begin(), conflicts.end(), conflict, by_pair);
    return std::any_of(from, to, [&conflict](const Conflict& each) {
      return each.begins_s <= conflict.ends_s && conflict.begins_s <= each.ends_s;
    });
  };
}

}  // namespace

ApartOf apart_along(const std::vector<Track>& lines, const VelocityCurves& curves,
                    const TurnArcs& arcs, double height_unit_m) {
  if (curves.tracks.empty() && arcs.tracks.empty()) return apart_of(lines, height_unit_m);
  return [of_lines = apart_of(lines, height_unit_m),
          of_curves = apart_of(curves.tracks, height_unit_m),
          of_arcs = apart_of(arcs.tracks, height_unit_m), is_curved = is_among(curves.conflicts),
          is_turned = is_among(arcs.conflicts)](const Conflict& conflict) {
    if (is_curved(conflict)) return of_curves(conflict);
    return is_turned(conflict) ? of_arcs(conflict) : of_lines(conflict);
  };
}

WorstOf worst_along(const std::vector<Track>& lines, const VelocityCurves& curves,
                    const TurnArcs& arcs, double height_unit_m, const Minima& minima) {
  if (curves.tracks.empty() && arcs.tracks.empty()) return worst_of(lines, height_unit_m, minima);
  return [of_lines = worst_of(lines, height_unit_m, minima),
          of_curves = worst_of(curves.tracks, height_unit_m, minima),
          of_arcs = worst_of(arcs.tracks, height_unit_m, minima),
          is_curved = is_among(curves.conflicts),
          is_turned = is_among(arcs.conflicts)](const Conflict& conflict) {
    if (is_curved(conflict)) return of_curves(conflict);
    return is_turned(conflict) ? of_arcs(conflict) : of_lines(conflict);
  };
}

}  // namespace beespace::analysis
