#include "cli/recorded/path_findings.hpp"

#include "analysis/text/bee_name.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/coverage_output.hpp"
#include "cli/recorded/holding_words.hpp"
#include "cli/recorded/limit_hints.hpp"
#include "io/obstacle_name.hpp"
#include "io/recording/moment_text.hpp"

#include <cmath>
#include <cstddef>

namespace beespace::cli {
namespace {

void write_pair(io::JsonWriter& json, const char* key, const std::optional<Conflict>& pair,
                const io::Recording& recording) {
  json.key(key);
  if (!pair) return json.null();
  Rows row{{{"first", "first_label"}, {"second", "second_label"}, {"at_s"}, {"distance_m"}},
           {{analysis::name_at(pair->closest_s, pair->first, recording),
             analysis::name_at(pair->closest_s, pair->second, recording), pair->closest_s,
             pair->closest_m}},
           analysis::has_labels(recording)};
  set_labels_apart(row);
  write_row(json, row.columns, row.rows.front());
}

}  // namespace

Rows finding_rows(const PathFindings& findings) {
  const io::Recording& recording = findings.recording;
  Rows rows{{{"finding"},
             {"first", "first_label"},
             {"second", "second_label"},
             {"begins_s", nullptr, "begins"},
             {"ends_s", nullptr, "ends"},
             {"value"},
             {"limit"},
             {"at_s", nullptr, "at"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  for (const Conflict& loss : findings.verdict.losses) {
    rows.rows.push_back(
        {std::string("loss"), analysis::name_at(loss.closest_s, loss.first, recording),
         analysis::name_at(loss.closest_s, loss.second, recording), loss.begins_s, loss.ends_s,
         loss.closest_m, findings.question.threshold_m, loss.closest_s});
  }
  for (const auto& [bee, loss] : findings.verdict.clearance_losses) {
    const Obstacle& obstacle = findings.question.obstacles->obstacles()[loss.obstacle];
    rows.rows.push_back({std::string("clearance"), analysis::name_of(bee, recording),
                         io::obstacle_name(loss.obstacle, obstacle), loss.begins_s, loss.ends_s,
                         loss.closest_m, findings.question.clearance_m, std::monostate{}});
  }
  for (const auto& [bee, excess, beside] : findings.verdict.breaches) {
    const double most = beside ? findings.verdict.accelerations[*beside].declared.most_mps2
                               : findings.limits.limits[excess.limit];
    rows.rows.push_back({std::string(words_of(excess.limit).finding),
                         analysis::name_of(bee, recording), std::monostate{}, excess.begins_s,
                         excess.ends_s, excess.peak.value, most, excess.peak.at_s});
  }
  return rows;
}

void write_verdict(io::JsonWriter& json, const PathFindings& findings,
                   const MovingRequest& request) {
  const analysis::PathVerdict& verdict = findings.verdict;
  const io::Recording& recording = findings.recording;
  write_head(json, recording, request, findings.question.threshold_m);
  json.member("motion", findings.motion).member("holds", findings.holds());
  write_coverage(json.key("known"), findings.coverage, recording);
  json.begin_object("limits", io::JsonLayout::kLines);
  for (const PathLimitWords& words : kPathLimitWords) {
    const auto which = static_cast<std::size_t>(words.limit);
    const double most = findings.limits.limits[words.limit];
    if (!std::isfinite(most)) continue;
    json.begin_object(words.finding).member("most", most).member("unit", words.unit);
    json.member("declared", findings.limits.declared[which]).end();
  }
  json.end();
  write_navigation(json, verdict, recording);
  if (const auto names = looked_at(verdict.not_looked_at, verdict, false); !names.empty()) {
    json.member("limits_not_looked_at", names);
  }
  json.begin_object("greatest", io::JsonLayout::kLines);
  for (const PathLimitWords& words : kPathLimitWords) {
    const auto& peak = verdict.peaks[static_cast<std::size_t>(words.limit)];
    if (!peak) continue;
    json.begin_object(words.finding).member("value", shown_value(peak->peak, words.limit));
    json.member("unit", words.unit);
    json.member("id", analysis::name_of(peak->bee, recording).id);
    json.member("at_s", peak->peak.at_s);
    if (words.limit == PathLimit::kAcceleration) {
      json.member("at_corner", peak->peak.at_corner);
      if (peak->peak.at_corner) json.member("corner_deviation_m", kCornerDeviation_m);
    }
    json.end();
  }
  json.end();
  json.member("loss_count", verdict.losses.size());
  write_low(json, verdict.low, request);
  if (findings.question.obstacles != nullptr) {
    json.member("obstacles", findings.question.obstacles->obstacles().size());
    json.member("clearance_m", findings.question.clearance_m);
    json.member("clearance_loss_count", verdict.clearance_losses.size());
  }
  json.member("breach_count", verdict.breaches.size());
  write_pair(json, "closest", verdict.closest, recording);
  if (verdict.with_standing.empty() && verdict.closest == verdict.closest_in_the_air) return;
  json.member("with_standing_count", verdict.with_standing.size());
  write_pair(json, "closest_in_the_air", verdict.closest_in_the_air, recording);
}

}  // namespace beespace::cli
