#include "analysis/recorded/findings.hpp"

#include "analysis/recorded/jump_spans.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "analysis/recorded/show_conflicts.hpp"

#include <beespace/engine.hpp>
#include <beespace/nearest.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace beespace::analysis {
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

std::vector<Conflict> merged(std::vector<Conflict> some, const std::vector<Conflict>& more) {
  if (more.empty()) return some;
  some.insert(some.end(), more.begin(), more.end());
  std::stable_sort(some.begin(), some.end(), [](const Conflict& a, const Conflict& b) {
    return std::tuple(a.first, a.second, a.begins_s) < std::tuple(b.first, b.second, b.begins_s);
  });
  return some;
}

std::vector<Conflict> without(const std::vector<Conflict>& conflicts,
                              const std::vector<Conflict>& others) {
  const auto before = [](const Conflict& a, const Conflict& b) {
    return std::tuple(a.first, a.second, a.begins_s) < std::tuple(b.first, b.second, b.begins_s);
  };
  std::vector<Conflict> rest;
  for (const Conflict& conflict : conflicts) {
    const auto [from, to] = std::equal_range(others.begin(), others.end(), conflict, before);
    if (std::find(from, to, conflict) == to) rest.push_back(conflict);
  }
  return rest;
}

std::vector<PairInConflict> pairs_in_conflict(const std::vector<Conflict>& conflicts,
                                              const WorstOf& worst) {
  std::vector<PairInConflict> pairs;
  std::vector<double> ranks;
  for (const Conflict& conflict : conflicts) {  // those of a pair stand together
    const bool same = !pairs.empty() && pairs.back().closest.first == conflict.first &&
                      pairs.back().closest.second == conflict.second;
    const double rank = rank_of(conflict, worst);
    if (!same) {
      pairs.push_back({conflict, conflict, 0, 0.0});
      ranks.push_back(rank);
    }
    PairInConflict& pair = pairs.back();
    if (conflict.closest_m < pair.closest.closest_m) pair.closest = conflict;
    if (rank < ranks.back()) {
      pair.worst = conflict;
      ranks.back() = rank;
    }
    ++pair.conflicts;
    pair.time_s += conflict.ends_s - conflict.begins_s;
  }
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&ranks](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
  std::vector<PairInConflict> in_order;
  in_order.reserve(pairs.size());
  for (const std::size_t place : order) in_order.push_back(pairs[place]);
  return in_order;
}

std::vector<BeeInConflict> bees_in_conflict(std::size_t bees,
                                            const std::vector<Conflict>& conflicts) {
  std::vector<BeeInConflict> found(bees);
  std::vector<std::vector<TimeSpan>> spans(bees);
  for (const Conflict& conflict : conflicts) {
    for (const PointId bee : {conflict.first, conflict.second}) {
      spans[bee].push_back({conflict.begins_s, conflict.ends_s});
      const Conflict*& closest = found[bee].closest;
      if (closest == nullptr || conflict.closest_m < closest->closest_m) closest = &conflict;
    }
  }
  for (std::size_t bee = 0; bee < bees; ++bee) {
    found[bee].conflicts = spans[bee].size();
    found[bee].time_s = length_of_union(spans[bee]);
  }
  return found;
}

namespace {

// Places at one moment, and whose they are.
struct Places {
  std::vector<Point> at;
  std::vector<PointId> bees;

  void clear() {
    at.clear();
    bees.clear();
  }
  void add(PointId bee, const Point& place) {
    at.push_back(place);
    bees.push_back(bee);
  }
};

void take_closer(const Result<std::optional<ClosestPair>>& pair, const Places& places,
                 const Places& others, Moment& moment) {
  if (!pair || !*pair || (*pair)->distance_m >= moment.distance_m) return;
  const auto [first, second] =
      std::minmax(places.bees[(*pair)->first], others.bees[(*pair)->second]);
  moment.distance_m = (*pair)->distance_m;
  moment.first = first;
  moment.second = second;
}

// Whether any of `in_gaps`, or `known`, which come first then, is closer to one of `in_gaps` than
// two of `known` are to each other.
bool would_be_closer(Engine& engine, std::vector<Point>& known, const std::vector<Point>& in_gaps) {
  if (in_gaps.empty()) return false;
  const std::size_t count = known.size();
  known.insert(known.end(), in_gaps.begin(), in_gaps.end());
  const auto pair = engine.find_closest_pair(known);
  known.resize(count);
  return pair && *pair && std::max((*pair)->first, (*pair)->second) >= count;
}

}  // namespace

std::vector<Moment> separation_over_time(const Findings& findings, double every_s) {
  std::vector<double> times_s;
  const auto time = time_of(findings.tracks);
  if (!time) return {};
  const double lasts = time->ends_s - time->begins_s;
  for (std::uint64_t i = 0; static_cast<double>(i) * every_s <= lasts; ++i) {
    times_s.push_back(time->begins_s + static_cast<double>(i) * every_s);
  }
  return separation_at(findings, times_s);
}

std::vector<Moment> separation_at(const Findings& findings, const std::vector<double>& times_s) {
  std::vector<Moment> moments;
  moments.reserve(times_s.size());
  Engine engine;
  const std::vector<Standing> standing = standing_in(findings.recording);
  const std::vector<Gap> jumps = doubtful_spans(findings.recording, findings.coverage.max_gap);
  Places flying;
  Places on_ground;
  std::vector<Point> in_gaps;
  for (const double now : times_s) {
    flying.clear();
    on_ground.clear();
    in_gaps.clear();
    Moment& moment = moments.emplace_back(Moment{now, kInfinity, 0, 0, 0});
    for (PointId bee = 0; bee < findings.tracks.size(); ++bee) {
      auto place = position_at(findings.in_space[bee], now, findings.coverage.max_gap.seconds);
      if (is_within(jumps, bee, now)) place.reset();
      // A drone of a show that does not fly stands.
      if (place) {
        (has_landed(findings.recording, bee, now) ? on_ground : flying).add(bee, *place);
        continue;
      }
      if (!findings.recording.show) ++moment.unknown;
      if (const auto across = position_at(findings.in_space[bee], now)) in_gaps.push_back(*across);
    }
    moment.open = would_be_closer(engine, flying.at, in_gaps);
    take_closer(engine.find_closest_pair(flying.at), flying, flying, moment);
    if (standing.empty() && on_ground.bees.empty()) continue;
    for (const Standing& one : standing) {
      // At its first and its last instant it flies, which counts.
      const bool stands = one.span.begins_s <= now && now <= one.span.ends_s &&
                          !std::binary_search(flying.bees.begin(), flying.bees.end(), one.bee);
      if (stands) on_ground.add(one.bee, one.at);
    }
    take_closer(find_closest_pair_between(flying.at, on_ground.at), flying, on_ground, moment);
  }
  return moments;
}

}  // namespace beespace::analysis
