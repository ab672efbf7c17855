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
            {{analysis::name_of(closest.first, recording),
              analysis::name_of(closest.second, recording), closest.closest_s, closest.closest_m}},
            analysis::has_labels(recording)};
  add_apart_columns(rows.columns, distances);
  add_apart(rows.rows.front(), distances.of(closest), distances);
  set_labels_apart(rows);
  return rows;
}

}  // namespace

Rows rows_of(const ReplayRequest& request, const analysis::Findings& findings,
             const Distances& distances) {
  if (request.report == "bees") return bee_rows(findings, distances);
  if (request.report == "separation") {
    return separation_rows(analysis::separation_over_time(findings, request.every_s), findings,
                           distances);
  }
  const bool curved = std::any_of(findings.tracks.begin(), findings.tracks.end(),
                                  [](const Track& track) { return track.tolerance_m > 0.0; });
  return conflict_rows(findings.recorded.conflicts, findings.recording, curved, distances);
}

void write_findings(io::JsonWriter& json, const analysis::Findings& findings,
                    const ReplayRequest& request, double threshold_m, const Distances& distances) {
  const auto& conflicts = findings.recorded.conflicts;
  write_head(json, findings.recording, request.moving, threshold_m);
  json.member("conflict_count", conflicts.size());
  json.member("pair_count", analysis::pairs_in_conflict(conflicts).size());
  json.member("gap_count", findings.recorded.gaps.size());
  write_coverage(json.key("known"), findings.coverage, findings.recording);
  json.key("closest");
  if (findings.closest) {
    const Rows closest = closest_row(*findings.closest, findings.recording, distances);
    write_row(json, closest.columns, closest.rows.front());
  } else {
    json.null();
  }
}

}  // namespace beespace::cli
