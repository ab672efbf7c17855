#include "cli/recorded/replay_answer.hpp"

#include "analysis/text/bee_name.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/recorded/replay_rows.hpp"

#include <algorithm>

namespace beespace::cli {

namespace {

Rows closest_row(const Conflict& closest, const io::Recording& recording,
                 const Distances& distances) {
  Rows rows{{{"first", "first_label"}, {"second", "second_label"}, {"time_s"}, {"distance_m"}},
            {{analysis::name_at(closest.closest_s, closest.first, recording),
              analysis::name_at(closest.closest_s, closest.second, recording), closest.closest_s,
              closest.closest_m}},
            analysis::has_labels(recording)};
  add_apart_columns(rows.columns, distances);
  add_apart(rows.rows.front(), distances.of(closest), distances);
  set_labels_apart(rows);
  return rows;
}

// What the curves with the given velocities say; null where there are none.
void write_velocities(io::JsonWriter& json, const analysis::Findings& findings) {
  json.key("velocities");
  const analysis::VelocityCurves* const curves = findings.curves;
  if (findings.velocities_passed_over) {
    json.begin_object().member("followed", false).end();
    return;
  }
  if (curves == nullptr || !curves->given) {
    json.null();
    return;
  }
  json.begin_object().member("followed", curves->followed);
  json.member("conflict_count", curves->conflicts.size());
  json.member("most_off_m", curves->most_off_m);
  json.member("id", findings.recording.bees[curves->bee].id);
  json.member("begins_s", curves->span.begins_s).member("ends_s", curves->span.ends_s);
  json.end();
}

}  // namespace

Rows rows_of(const ReplayRequest& request, const analysis::Findings& findings,
             const Distances& distances) {
  if (request.report == "bees") return bee_rows(findings, distances);
  if (request.report == "pairs") return pair_rows(findings, distances);
  if (request.report == "separation") {
    return separation_rows(analysis::separation_over_time(findings, request.every_s), findings,
                           distances);
  }
  const bool curved = std::any_of(findings.tracks.begin(), findings.tracks.end(),
                                  [](const Track& track) { return track.tolerance_m > 0.0; });
  const auto& conflicts = findings.recorded.conflicts;
  const bool possible = std::any_of(conflicts.begin(), conflicts.end(),
                                    [](const Conflict& conflict) { return !conflict.certain; });
  Rows rows = conflict_rows(conflicts, findings.recording, curved || possible, distances);
  add_unknown_around(findings, rows);
  return rows;
}

void write_findings(io::JsonWriter& json, const analysis::Findings& findings,
                    const ReplayRequest& request, double threshold_m, const Distances& distances) {
  const auto& conflicts = findings.recorded.conflicts;
  write_head(json, findings.recording, request.moving, threshold_m);
  json.member("conflict_count", conflicts.size());
  json.member("pair_count", analysis::pairs_in_conflict(conflicts).size());
  write_low(json, findings.low, request.moving);
  json.member("gap_count", findings.coverage.gaps);
  write_coverage(json.key("known"), findings.coverage, findings.recording);
  write_velocities(json, findings);
  json.key("kept_by_height");
  if (findings.kept_by_height) {
    const analysis::KeptByHeight& kept = *findings.kept_by_height;
    json.begin_object().member("pair_count", kept.pairs).member("more", kept.more);
    json.member("unsure_pair_count", kept.unsure)
        .member("longer_pair_count", kept.longer)
        .member("vertical_m", kept.vertical_m);
    json.end();
  } else {
    json.null();
  }
  const auto write = [&](const char* key, const std::optional<Conflict>& conflict) {
    json.key(key);
    if (!conflict) return json.null();
    const Rows row = closest_row(*conflict, findings.recording, distances);
    write_row(json, row.columns, row.rows.front());
  };
  write("closest", findings.closest);
  if (distances.worst) {
    json.key("worst");
    const auto worst = worst_row(conflicts, findings.recording, distances);
    if (worst) {
      write_row(json, worst->columns, worst->rows.front());
    } else {
      json.null();
    }
  }
  if (!findings.above_fl410.empty()) {
    json.member("closer_above_fl410_count", findings.above_fl410.size());
  }
  const auto& in_the_air = findings.closest_in_the_air;
  if (findings.with_standing.empty() && !in_the_air) return;
  json.member("with_standing_count", findings.with_standing.size());
  write("closest_in_the_air", in_the_air ? in_the_air : findings.closest);
}

}  // namespace beespace::cli
