#include "cli/bench/bench_check.hpp"

#include <beespace/brute_force.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace beespace::cli {
namespace {

constexpr PointId kNoGroup = std::numeric_limits<PointId>::max();

// What brute force says of the bees that are checked.
struct Sample {
  std::vector<PointId> bees;
  std::vector<std::vector<PointId>> neighbors;
};

Sample sample_of(const std::vector<Point>& points, double threshold_m) {
  Sample sample;
  std::vector<Point> places;
  const std::size_t count = std::min(kBeesChecked, points.size());
  for (std::size_t i = 0; i < count; ++i) {
    sample.bees.push_back(static_cast<PointId>(i * points.size() / count));
    places.push_back(points[sample.bees.back()]);
  }
  SearchOptions options;
  options.threshold_m = threshold_m;
  const IdRows rows = *brute_force::find_neighbors_between(places, points, options);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<PointId> others(rows[i].begin(), rows[i].end());
    others.erase(std::remove(others.begin(), others.end(), sample.bees[i]), others.end());
    sample.neighbors.push_back(std::move(others));
  }
  return sample;
}

// Exact ties aside the nearest is who is nearest by rounded distances too, up to their rounding.
bool is_nearest(const std::vector<Point>& points, PointId bee, const Nearest& nearest) {
  constexpr double kRounding = 0x1p-50;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i != bee) least = std::min(least, distance(points[bee], points[i]));
  }
  return nearest.id != bee && nearest.id < points.size() &&
         nearest.distance_m == distance(points[bee], points[nearest.id]) &&
         nearest.distance_m <= least * (1.0 + kRounding);
}

std::vector<std::vector<PointId>> partners_of(const std::vector<PointId>& bees, std::size_t points,
                                              const std::vector<Pair>& pairs) {
  std::vector<std::vector<PointId>> partners(bees.size());
  std::vector<std::uint32_t> place(points, kNoGroup);
  for (std::size_t i = 0; i < bees.size(); ++i) place[bees[i]] = static_cast<std::uint32_t>(i);
  for (const Pair& pair : pairs) {
    if (place[pair.first] != kNoGroup) partners[place[pair.first]].push_back(pair.second);
    if (place[pair.second] != kNoGroup) partners[place[pair.second]].push_back(pair.first);
  }
  for (auto& row : partners) std::sort(row.begin(), row.end());
  return partners;
}

std::vector<PointId> group_of_each(const IdRows& groups, std::size_t points) {
  std::vector<PointId> group(points, kNoGroup);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const PointId bee : groups[i]) group[bee] = static_cast<PointId>(i);
  }
  return group;
}

// The lowest bee that can be reached from each by pairs.
std::vector<PointId> lowest_reached(std::size_t points, const std::vector<Pair>& pairs) {
  std::vector<PointId> lower(points);
  std::iota(lower.begin(), lower.end(), PointId{0});
  const auto lowest = [&lower](PointId bee) {
    while (lower[bee] != bee) bee = lower[bee] = lower[lower[bee]];
    return bee;
  };
  for (const Pair& pair : pairs) {
    const PointId a = lowest(pair.first);
    const PointId b = lowest(pair.second);
    lower[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < points; ++i) lower[i] = lowest(static_cast<PointId>(i));
  return lower;
}

bool groups_follow_from_pairs(const BenchAnswers& answers, std::size_t points) {
  const std::vector<PointId> lowest = lowest_reached(points, answers.pairs);
  std::vector<std::size_t> reached_by(points, 0);
  for (const PointId bee : lowest) ++reached_by[bee];
  for (std::size_t i = 0; i < answers.groups.size(); ++i) {
    const auto members = answers.groups[i];
    const PointId first = members.front();
    const bool together = std::all_of(members.begin(), members.end(),
                                      [&](PointId bee) { return lowest[bee] == lowest[first]; });
    if (!together || reached_by[lowest[first]] != members.size()) return false;
    reached_by[lowest[first]] = 1;
  }
  return std::all_of(reached_by.begin(), reached_by.end(), [](std::size_t n) { return n <= 1; });
}

}  // namespace

std::string disagreement(const std::vector<Point>& points, const BenchScene& scene,
                         const BenchAnswers& answers) {
  const Sample sample = sample_of(points, scene.threshold_m);
  const auto partners = partners_of(sample.bees, points.size(), answers.pairs);
  const std::vector<PointId> group = group_of_each(answers.groups, points.size());
  for (std::size_t i = 0; i < sample.bees.size(); ++i) {
    const PointId bee = sample.bees[i];
    const std::vector<PointId>& neighbors = sample.neighbors[i];
    const std::string of_bee = " of bee " + std::to_string(bee);
    const bool found = std::binary_search(answers.at_risk.begin(), answers.at_risk.end(), bee);
    if (found == neighbors.empty()) return "risk" + of_bee;
    if (answers.counts[bee] != neighbors.size()) return "count" + of_bee;
    if (scene.pairs_fit && partners[i] != neighbors) return "pairs" + of_bee;
    if (!is_nearest(points, bee, answers.nearest[bee])) return "nearest" + of_bee;
    const bool together = std::all_of(neighbors.begin(), neighbors.end(),
                                      [&](PointId other) { return group[other] == group[bee]; });
    if ((group[bee] == kNoGroup) != neighbors.empty() || !together) return "group" + of_bee;
  }
  if (scene.pairs_fit && !groups_follow_from_pairs(answers, points.size())) return "groups";
  return {};
}

}  // namespace beespace::cli
