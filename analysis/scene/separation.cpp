#include "analysis/scene/separation.hpp"

#include "analysis/recorded/jump_spans.hpp"
#include "io/recording/recording.hpp"

#include <beespace/engine.hpp>
#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr double kMoments = 600.0;

double every_s(const TimeSpan& time) {
  const double lasts_s = time.ends_s - time.begins_s;
  return lasts_s > 0.0 ? lasts_s / kMoments : 1.0;
}

// Into its place in time; of one moment the closer one is kept.
void insert(const report::Separation& at, std::vector<report::Separation>& separation) {
  const auto place = std::lower_bound(
      separation.begin(), separation.end(), at.time_s,
      [](const report::Separation& other, double time_s) { return other.time_s < time_s; });
  if (place == separation.end() || place->time_s != at.time_s) {
    separation.insert(place, at);
  } else if (at.closest.distance_m < place->closest.distance_m) {
    *place = at;
  }
}

// Not known at this moment, nor since the one before, nor until the next one.
void open_at(double time_s, double step_s, const TimeSpan& whole, std::vector<TimeSpan>& open) {
  const double begins_s = std::max(whole.begins_s, time_s - step_s);
  const double ends_s = std::min(whole.ends_s, time_s + step_s);
  if (!open.empty() && begins_s <= open.back().ends_s) {
    open.back().ends_s = ends_s;
  } else {
    open.push_back({begins_s, ends_s});
  }
}

// Those who are there at a moment; after these, who is in a gap, on a straight line across it.
struct There {
  std::size_t known = 0;
  std::vector<PointId> bees;
  std::vector<Point> ground;
  std::vector<double> heights_m;
};

There there_at(const Uprights& uprights, const Findings& findings, const std::vector<Gap>& jumps,
               double time_s) {
  There now;
  const auto add = [&now](PointId bee, const Upright& at) {
    now.bees.push_back(bee);
    now.ground.push_back(at.ground);
    now.heights_m.push_back(at.height_m);
  };
  std::vector<std::pair<PointId, Upright>> in_gaps;
  for (PointId bee = 0; bee < findings.tracks.size(); ++bee) {
    if (const auto at = uprights.at(bee, time_s); at && !is_within(jumps, bee, time_s)) {
      add(bee, *at);
    } else if (const auto across = uprights.across_gaps_at(bee, time_s)) {
      in_gaps.emplace_back(bee, *across);
    }
  }
  now.known = now.bees.size();
  for (const auto& [bee, at] : in_gaps) add(bee, at);
  return now;
}

// Who is nearest to a conflict: a pair by the greater of its shares of both thresholds, and of
// equal ones the first. `share` is where to begin, and becomes what was found.
class NearestToConflict {
 public:
  explicit NearestToConflict(const report::SwarmFacts& swarm) : swarm_(swarm) {}

  std::optional<Pair> find(const There& now, double& share) {
    constexpr int kMostTries = 60;
    constexpr double kLeastShare = 1e-6;
    double within = std::max(kLeastShare, 1.25 * share);
    for (int k = 0; k < kMostTries; ++k, within *= 2.0) {
      SearchOptions options;
      options.threshold_m = within * swarm_.threshold_m;
      options.vertical_m = within * *swarm_.vertical_m;
      options.inclusive = true;
      const auto found =
          engine_.find_pairs(PointsView(now.ground).with_heights(now.heights_m), options, pairs_);
      if (!found) return std::nullopt;
      if (!pairs_.empty()) return least(now, share);
    }
    return std::nullopt;
  }

 private:
  std::optional<Pair> least(const There& now, double& share) const {
    const auto share_of = [&](const Pair& pair) {
      const double across = distance(now.ground[pair.first], now.ground[pair.second]);
      const double up = std::abs(now.heights_m[pair.first] - now.heights_m[pair.second]);
      return std::max(across / swarm_.threshold_m, up / *swarm_.vertical_m);
    };
    const auto nearest =
        std::min_element(pairs_.begin(), pairs_.end(), [&](const Pair& a, const Pair& b) {
          return std::tuple(share_of(a), a) < std::tuple(share_of(b), b);
        });
    share = share_of(*nearest);
    return *nearest;
  }

  const report::SwarmFacts& swarm_;
  Engine engine_;
  std::vector<Pair> pairs_;
};

SeparationOverTime nearest_to_conflict(const Findings& findings, const Uprights& uprights,
                                       const report::SwarmFacts& swarm, const TimeSpan& time) {
  SeparationOverTime over_time;
  NearestToConflict search(swarm);
  const std::vector<Gap> jumps = doubtful_spans(findings.recording, findings.coverage.max_gap);
  double share = 1.0;
  const double step_s = every_s(time);
  for (std::uint64_t i = 0; static_cast<double>(i) * step_s <= time.ends_s - time.begins_s; ++i) {
    const double now_s = time.begins_s + static_cast<double>(i) * step_s;
    const There now = there_at(uprights, findings, jumps, now_s);
    if (now.bees.size() < 2) continue;
    const auto pair = search.find(now, share);
    if (!pair) continue;
    if (std::max(pair->first, pair->second) >= now.known) {
      open_at(now_s, step_s, time, over_time.open);
      continue;
    }
    const PointId first = now.bees[pair->first];
    const PointId second = now.bees[pair->second];
    const report::Apart of = apart({now.ground[pair->first], now.heights_m[pair->first]},
                                   {now.ground[pair->second], now.heights_m[pair->second]});
    // Where heights are apart from positions, that is the straight line.
    over_time.known.push_back(
        {now_s, {first, second, std::hypot(of.horizontal_m, of.height_m)}, of});
  }
  return over_time;
}

// Of conflicts that begin and end between two moments none would be seen: of each moment the
// closest that is nearer in time to it than to others, where it is closest.
std::vector<Conflict> conflicts_between(const Findings& findings, const TimeSpan& time) {
  const double step_s = every_s(time);
  std::map<std::int64_t, const Conflict*> closest;
  for (const Conflict& conflict : findings.recorded.conflicts) {
    const auto moment = std::llround((conflict.closest_s - time.begins_s) / step_s);
    const auto [at, is_new] = closest.emplace(moment, &conflict);
    if (!is_new && conflict.closest_m < at->second->closest_m) at->second = &conflict;
  }
  std::vector<Conflict> all;
  all.reserve(closest.size() + 1);
  for (const auto& [moment, conflict] : closest) all.push_back(*conflict);
  if (findings.closest) all.push_back(*findings.closest);
  return all;
}

// Others may be closer just then, as far as the curve goes: a pair that is closest for a while is
// not where another one passes at a greater distance.
void insert_conflicts(const Findings& findings, const TimeSpan& time,
                      std::vector<report::Separation>& known) {
  const std::vector<Conflict> conflicts = conflicts_between(findings, time);
  std::vector<double> times_s;
  times_s.reserve(conflicts.size());
  for (const Conflict& conflict : conflicts) times_s.push_back(conflict.closest_s);
  const std::vector<Moment> then = separation_at(findings, times_s);
  for (std::size_t i = 0; i < conflicts.size(); ++i) {
    const Conflict& conflict = conflicts[i];
    ClosestPair closest{conflict.first, conflict.second, conflict.closest_m};
    if (then[i].distance_m < closest.distance_m) {
      const auto [first, second] = std::minmax(then[i].first, then[i].second);
      closest = {first, second, then[i].distance_m};
    }
    insert({conflict.closest_s, closest}, known);
  }
}

// Where the closest two become others, or cease to approach, between two moments: a straight line
// from one to the next may be above how close they are there by more than its width.
std::vector<double> times_of_turns(const std::vector<report::Separation>& known, double step_s) {
  const auto falls_to = [&known](std::size_t i) {
    return known[i].closest.distance_m < known[i - 1].closest.distance_m;
  };
  std::vector<double> times_s;
  for (std::size_t i = 1; i < known.size(); ++i) {
    const ClosestPair& before = known[i - 1].closest;
    const ClosestPair& after = known[i].closest;
    const double lasts_s = known[i].time_s - known[i - 1].time_s;
    if (lasts_s > 1.5 * step_s) continue;  // something between is not known
    const bool others =
        std::pair(before.first, before.second) != std::pair(after.first, after.second);
    const bool turns_before = i > 1 && falls_to(i - 1) && !falls_to(i);
    const bool turns_behind = i + 1 < known.size() && falls_to(i) && !falls_to(i + 1);
    if (others || turns_before || turns_behind) {
      times_s.push_back(known[i - 1].time_s + 0.5 * lasts_s);
    }
  }
  return times_s;
}

void insert_turns(const Findings& findings, double step_s, std::vector<report::Separation>& known) {
  constexpr int kRounds = 4;
  constexpr double kVisible = 0.005;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<report::Separation> lower;
    std::size_t next = 0;
    for (const Moment& moment : separation_at(findings, times_of_turns(known, step_s))) {
      if (moment.open || !std::isfinite(moment.distance_m)) continue;
      while (known[next].time_s < moment.time_s) ++next;
      const double line_m =
          0.5 * (known[next - 1].closest.distance_m + known[next].closest.distance_m);
      if (moment.distance_m >= (1.0 - kVisible) * line_m) continue;
      const auto [first, second] = std::minmax(moment.first, moment.second);
      lower.push_back({moment.time_s, {first, second, moment.distance_m}});
    }
    if (lower.empty()) return;
    for (const report::Separation& at : lower) insert(at, known);
  }
}

SeparationOverTime closest_two(const Findings& findings, const TimeSpan& time) {
  SeparationOverTime over_time;
  const double step_s = every_s(time);
  for (const Moment& moment : separation_over_time(findings, step_s)) {
    if (moment.open) open_at(moment.time_s, step_s, time, over_time.open);
    if (moment.open || !std::isfinite(moment.distance_m)) continue;
    const auto [first, second] = std::minmax(moment.first, moment.second);
    over_time.known.push_back({moment.time_s, {first, second, moment.distance_m}});
  }
  insert_conflicts(findings, time, over_time.known);
  insert_turns(findings, step_s, over_time.known);
  return over_time;
}

// Ascending, none touch.
std::vector<TimeSpan> united(std::vector<TimeSpan> spans) {
  std::sort(spans.begin(), spans.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
  std::vector<TimeSpan> all;
  for (const TimeSpan& span : spans) {
    if (!(span.begins_s < span.ends_s)) continue;
    if (!all.empty() && span.begins_s <= all.back().ends_s) {
      all.back().ends_s = std::max(all.back().ends_s, span.ends_s);
    } else {
      all.push_back(span);
    }
  }
  return all;
}

// From one known moment to the next that is not the next moment of all.
std::vector<TimeSpan> without_known(const std::vector<report::Separation>& known,
                                    const TimeSpan& time) {
  const double longest_s = 1.5 * every_s(time);
  std::vector<TimeSpan> spans;
  double from_s = time.begins_s;
  for (const report::Separation& at : known) {
    if (at.time_s - from_s > longest_s) spans.push_back({from_s, at.time_s});
    from_s = at.time_s;
  }
  if (time.ends_s - from_s > longest_s) spans.push_back({from_s, time.ends_s});
  return spans;
}

void open_unknown(const std::vector<Gap>& unknown, bool of_show, const TimeSpan& time,
                  SeparationOverTime& over_time) {
  std::vector<TimeSpan> spans = over_time.open;
  std::vector<TimeSpan> there{time};
  if (!of_show) there = without_known(over_time.known, time);
  for (const Gap& gap : unknown) {
    for (const TimeSpan& span : there) {
      spans.push_back({std::max(gap.begins_s, span.begins_s), std::min(gap.ends_s, span.ends_s)});
    }
  }
  over_time.open = united(std::move(spans));
  if (!of_show) return;
  std::erase_if(over_time.known, [&over_time](const report::Separation& at) {
    return std::any_of(over_time.open.begin(), over_time.open.end(), [&at](const TimeSpan& span) {
      return span.begins_s < at.time_s && at.time_s < span.ends_s;
    });
  });
}

}  // namespace

SeparationOverTime separation_of(const Findings& findings, const Uprights& uprights,
                                 const std::vector<Gap>& unknown, const report::SwarmFacts& swarm) {
  const auto time = time_of(findings.tracks);
  if (!time) return {};
  SeparationOverTime over_time = swarm.vertical_m
                                     ? nearest_to_conflict(findings, uprights, swarm, *time)
                                     : closest_two(findings, *time);
  open_unknown(unknown, findings.recording.show.has_value(), *time, over_time);
  return over_time;
}

}  // namespace beespace::analysis
