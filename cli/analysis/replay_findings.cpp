#include "cli/analysis/replay_findings.hpp"

#include "cli/input/moving_output.hpp"

#include <beespace/engine.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace beespace::cli {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How long some of the stretches last together, where they overlap counted once.
double length_of_union(std::vector<TimeSpan>& spans) {
  std::sort(spans.begin(), spans.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
  double total = 0.0;
  double covered_until = -kInfinity;
  for (const TimeSpan& span : spans) {
    const double from = std::max(span.begins_s, covered_until);
    if (span.ends_s > from) total += span.ends_s - from;
    covered_until = std::max(covered_until, span.ends_s);
  }
  return total;
}

}  // namespace

std::optional<TimeSpan> time_of(const std::vector<Track>& tracks) {
  TimeSpan time{kInfinity, -kInfinity};
  for (const Track& track : tracks) {
    if (track.fixes.empty()) continue;
    time.begins_s = std::min(time.begins_s, track.fixes.front().time_s);
    time.ends_s = std::max(time.ends_s, track.fixes.back().time_s);
  }
  if (time.begins_s > time.ends_s) return std::nullopt;
  return time;
}

std::vector<PairInConflict> pairs_in_conflict(const std::vector<Conflict>& conflicts) {
  std::vector<PairInConflict> pairs;
  for (const Conflict& conflict : conflicts) {  // those of a pair stand together
    const bool same = !pairs.empty() && pairs.back().closest.first == conflict.first &&
                      pairs.back().closest.second == conflict.second;
    if (!same) pairs.push_back({conflict, 0, 0.0});
    PairInConflict& pair = pairs.back();
    if (conflict.closest_m < pair.closest.closest_m) pair.closest = conflict;
    ++pair.conflicts;
    pair.time_s += conflict.ends_s - conflict.begins_s;
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a.closest.closest_m < b.closest.closest_m;
  });
  return pairs;
}

Rows bee_rows(const Findings& findings) {
  struct OfBee {
    std::vector<TimeSpan> spans;
    const Conflict* closest = nullptr;
  };
  std::vector<OfBee> bees(findings.tracks.size());
  for (const Conflict& conflict : findings.recorded.conflicts) {
    for (const PointId bee : {conflict.first, conflict.second}) {
      bees[bee].spans.push_back({conflict.begins_s, conflict.ends_s});
      const Conflict*& closest = bees[bee].closest;
      if (closest == nullptr || conflict.closest_m < closest->closest_m) closest = &conflict;
    }
  }
  Rows rows{{{"id", "label"},
             {"conflicts"},
             {"in_conflict_s"},
             {"closest_m"},
             {"closest_s"},
             {"closest_id", "closest_label"},
             {"unknown_s"}},
            {},
            has_labels(findings.recording)};
  const auto unknown_s = unknown_times_s(findings.recording, findings.recorded.gaps);
  for (PointId bee = 0; bee < bees.size(); ++bee) {
    OfBee& of = bees[bee];
    std::vector<Value> row{name_of(bee, findings.recording), std::uint64_t{of.spans.size()},
                           length_of_union(of.spans)};
    if (of.closest != nullptr) {
      const PointId other = of.closest->first == bee ? of.closest->second : of.closest->first;
      row.insert(row.end(), {of.closest->closest_m, of.closest->closest_s,
                             name_of(other, findings.recording)});
    } else {
      row.resize(rows.columns.size() - 1);
    }
    row.emplace_back(unknown_s[bee]);
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Moment> separation_over_time(const Findings& findings, double every_s) {
  std::vector<Moment> moments;
  const auto time = time_of(findings.tracks);
  if (!time) return moments;
  Engine engine;
  std::vector<Point> places;
  std::vector<PointId> bees;
  const double lasts = time->ends_s - time->begins_s;
  for (std::uint64_t i = 0; static_cast<double>(i) * every_s <= lasts; ++i) {
    const double now = time->begins_s + static_cast<double>(i) * every_s;
    places.clear();
    bees.clear();
    std::uint64_t unknown = 0;
    for (PointId bee = 0; bee < findings.tracks.size(); ++bee) {
      const auto place =
          position_at(findings.in_space[bee], now, findings.coverage.max_gap.seconds);
      // A drone of a show that does not fly stands.
      if (!place && !findings.recording.bees[bee].path) ++unknown;
      if (!place) continue;
      places.push_back(*place);
      bees.push_back(bee);
    }
    moments.push_back({now, kInfinity, 0, 0, unknown});
    const auto pair = engine.find_closest_pair(places);
    if (!pair || !*pair) continue;
    moments.back() = {now, (*pair)->distance_m, bees[(*pair)->first], bees[(*pair)->second],
                      unknown};
  }
  return moments;
}

Rows separation_rows(const std::vector<Moment>& moments, const io::Recording& recording) {
  Rows rows{{{"time_s"},
             {"distance_m"},
             {"first", "first_label"},
             {"second", "second_label"},
             {"unknown"}},
            {},
            has_labels(recording)};
  for (const Moment& moment : moments) {
    std::vector<Value> row{moment.time_s};
    if (std::isfinite(moment.distance_m)) {
      row.insert(row.end(), {moment.distance_m, name_of(moment.first, recording),
                             name_of(moment.second, recording)});
    } else {
      row.resize(rows.columns.size() - 1);
    }
    row.emplace_back(moment.unknown);
    rows.rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace beespace::cli
