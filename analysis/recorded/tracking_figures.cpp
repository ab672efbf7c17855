#include "analysis/recorded/tracking_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace beespace::analysis {

namespace {

constexpr double kLagStep_s = 0.01;
// A lag counts where the mean square of deviations is less than this share of that without it.
constexpr double kClearlyLess = 0.9;

struct Deviation {
  double time_s = 0.0;
  Point by;
};

Point difference(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double length_of(const Point& p) {
  return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
}

// The greatest, and that which only one of so many exceeds.
Extreme extreme_of(std::vector<double>& values, std::size_t one_of = 1000) {
  if (values.empty()) return {};
  const std::size_t last = values.size() - 1;
  const std::size_t usual = last - last / one_of;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(usual);
  std::nth_element(values.begin(), at, values.end());
  return {*std::max_element(at, values.end()), *at};
}

std::vector<Deviation> deviations_of(const SetAndFlown& bee, double lag_s, double max_gap_s) {
  std::vector<Deviation> deviations;
  for (const Fix& flown : bee.flown.fixes) {
    const auto set = position_at(bee.set, flown.time_s - lag_s, max_gap_s);
    if (set) deviations.push_back({flown.time_s, difference(flown.position, *set)});
  }
  return deviations;
}

// Of each two neighbours, in the middle between them.
std::vector<Deviation> change_of(const std::vector<Deviation>& values, double max_gap_s) {
  std::vector<Deviation> changes;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double lasts_s = values[i].time_s - values[i - 1].time_s;
    if (!(lasts_s > 0.0) || lasts_s > max_gap_s) continue;
    const Point by = difference(values[i].by, values[i - 1].by);
    changes.push_back({0.5 * (values[i].time_s + values[i - 1].time_s),
                       {by.x / lasts_s, by.y / lasts_s, by.z / lasts_s}});
  }
  return changes;
}

void add_lengths(const std::vector<Deviation>& values, std::vector<double>& lengths) {
  for (const Deviation& one : values) lengths.push_back(length_of(one.by));
}

std::vector<double> all_lengths(const std::vector<SetAndFlown>& bees, double lag_s,
                                double max_gap_s) {
  std::vector<double> lengths;
  for (const SetAndFlown& bee : bees) add_lengths(deviations_of(bee, lag_s, max_gap_s), lengths);
  return lengths;
}

double mean_square(const std::vector<double>& lengths) {
  double sum = 0.0;
  for (const double one : lengths) sum += one * one;
  return lengths.empty() ? 0.0 : sum / static_cast<double>(lengths.size());
}

std::optional<BeeDeviation> summed_up(const std::vector<Deviation>& deviations) {
  if (deviations.empty()) return std::nullopt;
  constexpr std::size_t kOneOf = 20;
  std::vector<double> lengths;
  lengths.reserve(deviations.size());
  add_lengths(deviations, lengths);
  const auto farthest = std::max_element(lengths.begin(), lengths.end());
  BeeDeviation bee;
  bee.fixes = lengths.size();
  bee.farthest_m = *farthest;
  bee.farthest_s = deviations[static_cast<std::size_t>(farthest - lengths.begin())].time_s;
  bee.mean_m =
      std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
  bee.p95_m = extreme_of(lengths, kOneOf).usual;
  return bee;
}

// What was flown so late that all lags can be compared on the same fixes.
std::vector<SetAndFlown> comparable(const std::vector<SetAndFlown>& bees, double longest_lag_s) {
  std::vector<SetAndFlown> later = bees;
  for (SetAndFlown& bee : later) {
    if (bee.set.fixes.empty()) continue;
    const double from_s = bee.set.fixes.front().time_s + longest_lag_s;
    std::erase_if(bee.flown.fixes, [&](const Fix& fix) { return fix.time_s < from_s; });
  }
  return later;
}

std::optional<double> best_lag(const std::vector<SetAndFlown>& all, double max_gap_s,
                               double longest_lag_s) {
  const std::vector<SetAndFlown> bees = comparable(all, longest_lag_s);
  const double without = mean_square(all_lengths(bees, 0.0, max_gap_s));
  double least = without;
  double best_s = 0.0;
  for (int step = 1; step * kLagStep_s <= longest_lag_s; ++step) {
    const double square = mean_square(all_lengths(bees, step * kLagStep_s, max_gap_s));
    if (square >= least) continue;
    least = square;
    best_s = step * kLagStep_s;
  }
  if (!(least < kClearlyLess * without)) return std::nullopt;
  return best_s;
}

}  // namespace

TrackingFigures tracking_figures(const std::vector<SetAndFlown>& bees, double max_gap_s,
                                 double longest_lag_s) {
  TrackingFigures figures;
  std::vector<double> distances;
  std::vector<double> rates;
  std::vector<double> accelerations;
  std::uint64_t flown = 0;
  figures.each.reserve(bees.size());
  for (const SetAndFlown& bee : bees) {
    const std::vector<Deviation> deviations = deviations_of(bee, 0.0, max_gap_s);
    const std::vector<Deviation> changes = change_of(deviations, max_gap_s);
    add_lengths(deviations, distances);
    figures.each.push_back(summed_up(deviations));
    add_lengths(changes, rates);
    add_lengths(change_of(changes, max_gap_s), accelerations);
    flown += bee.flown.fixes.size();
  }
  figures.fixes = distances.size();
  figures.not_set = flown - figures.fixes;
  figures.deviation_m = extreme_of(distances);
  figures.rate_mps = extreme_of(rates);
  figures.acceleration_mps2 = extreme_of(accelerations);
  figures.lag_s = best_lag(bees, max_gap_s, longest_lag_s);
  std::vector<double> lagging = all_lengths(bees, figures.lag_s.value_or(0.0), max_gap_s);
  figures.without_lag_m = extreme_of(lagging);
  return figures;
}

}  // namespace beespace::analysis
