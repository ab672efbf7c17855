#include "cli/recorded/replay_rows.hpp"

#include "analysis/recorded/unknown_around.hpp"
#include "analysis/text/bee_name.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// How close that bee comes, when, and to which; empty where it is null.
void add_closest(std::vector<Value>& row, const Conflict* closest, PointId bee,
                 const io::Recording& recording) {
  if (closest == nullptr) return row.resize(row.size() + 3);
  const PointId other = closest->first == bee ? closest->second : closest->first;
  row.insert(row.end(), {closest->closest_m, closest->closest_s,
                         analysis::name_at(closest->closest_s, other, recording)});
}

}  // namespace

Rows bee_rows(const analysis::Findings& findings, const Distances& distances) {
  const auto& recording = findings.recording;
  Rows rows{{{"id", "label"},
             {"conflicts"},
             {"in_conflict_s"},
             {"closest_m"},
             {"closest_s", nullptr, "closest"},
             {"closest_id", "closest_label"},
             {"unknown_s"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  add_apart_columns(rows.columns, distances);
  // Of a show, who is closest in the air; and behind it with a drone on the ground.
  const auto& standing = findings.with_standing;
  if (!standing.empty()) {
    rows.columns.insert(rows.columns.end(),
                        {{"closest_with_ground_m"},
                         {"closest_with_ground_s", nullptr, "closest_with_ground"},
                         {"closest_with_ground_id", "closest_with_ground_label"}});
  }
  const auto& conflicts = findings.recorded.conflicts;
  const auto in_the_air = analysis::without(conflicts, standing);
  const auto bees = analysis::bees_in_conflict(findings.tracks.size(), conflicts);
  const auto of_air = analysis::bees_in_conflict(findings.tracks.size(), in_the_air);
  const auto of_ground = analysis::bees_in_conflict(findings.tracks.size(), standing);
  const auto unknown_s =
      analysis::unknown_times_s(recording, findings.recorded.gaps, findings.coverage.max_gap);
  for (PointId bee = 0; bee < bees.size(); ++bee) {
    const analysis::BeeInConflict& of = bees[bee];
    std::vector<Value> row{analysis::name_of(bee, recording), std::uint64_t{of.conflicts},
                           of.time_s};
    const Conflict* closest = of_air[bee].closest;
    if (closest == nullptr && !findings.closest_of_each.empty() && findings.closest_of_each[bee]) {
      closest = &*findings.closest_of_each[bee];
    }
    add_closest(row, closest, bee, recording);
    row.emplace_back(unknown_s[bee]);
    add_apart(row, closest != nullptr ? distances.of(*closest) : std::nullopt, distances);
    if (!standing.empty()) add_closest(row, of_ground[bee].closest, bee, recording);
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

Rows pair_rows(const analysis::Findings& findings, const Distances& distances) {
  const io::Recording& recording = findings.recording;
  Rows rows{{{"first", "first_label"},
             {"second", "second_label"},
             {"conflicts"},
             {"in_conflict_s"},
             {"closest_s", nullptr, "closest"},
             {"closest_m"},
             {"unknown_s"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  add_apart_columns(rows.columns, distances);
  add_worst_columns(rows.columns, distances);
  const std::vector<Gap> unknown =
      analysis::all_unknown_spans(recording, findings.recorded.gaps, findings.coverage.max_gap);
  for (const analysis::PairInConflict& pair :
       analysis::pairs_in_conflict(findings.recorded.conflicts, distances.worst)) {
    const Conflict& closest = pair.closest;
    std::vector<Value> row{analysis::name_at(closest.closest_s, closest.first, recording),
                           analysis::name_at(closest.closest_s, closest.second, recording),
                           std::uint64_t{pair.conflicts},
                           pair.time_s,
                           closest.closest_s,
                           closest.closest_m,
                           analysis::unknown_of_pair_s(closest.first, closest.second, unknown)};
    add_apart(row, distances.of(closest), distances);
    add_worst(row, pair.worst, distances);
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

void add_unknown_around(const analysis::Findings& findings, Rows& rows) {
  const std::vector<Gap> unknown = analysis::all_unknown_spans(
      findings.recording, findings.recorded.gaps, findings.coverage.max_gap);
  if (unknown.empty()) return;
  rows.columns.insert(rows.columns.end(), {{"unknown_before"}, {"unknown_after"}});
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const auto around = analysis::unknown_around(findings.recorded.conflicts[i], unknown);
    rows.rows[i].insert(rows.rows[i].end(), {around.before, around.after});
  }
}

Rows separation_rows(const std::vector<analysis::Moment>& moments,
                     const analysis::Findings& findings, const Distances& distances) {
  const io::Recording& recording = findings.recording;
  Rows rows{{{"time_s", nullptr, "time"},
             {"distance_m"},
             {"first", "first_label"},
             {"second", "second_label"},
             {"unknown"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  const std::size_t columns = rows.columns.size();
  add_apart_columns(rows.columns, distances);
  for (const analysis::Moment& moment : moments) {
    std::vector<Value> row{moment.time_s};
    if (std::isfinite(moment.distance_m)) {
      row.insert(row.end(),
                 {moment.distance_m, analysis::name_at(moment.time_s, moment.first, recording),
                  analysis::name_at(moment.time_s, moment.second, recording)});
    } else {
      row.resize(columns - 1);
    }
    row.emplace_back(moment.unknown);
    Conflict closest;
    closest.first = moment.first;
    closest.second = moment.second;
    closest.closest_s = moment.time_s;
    const bool known = std::isfinite(moment.distance_m);
    add_apart(row, known ? distances.of(closest) : std::nullopt, distances);
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace beespace::cli
