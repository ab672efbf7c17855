#include "report/figure/nearest_histogram.hpp"

#include "report/figure/number_label.hpp"
#include "report/figure/style.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

constexpr double kBins = 44.0;
// Wider spreads than this, from the lowest percent to the highest, are shown by powers of ten.
constexpr double kWideSpread = 60.0;
// Of the greatest distance; what is closer still is in the first bin.
constexpr double kLeastShare = 1e-9;

std::vector<double> distances_of(const SnapshotFacts& facts) {
  std::vector<double> distances_m;
  distances_m.reserve(facts.nearest.size());
  for (const Nearest& nearest : facts.nearest) {
    if (std::isfinite(nearest.distance_m)) distances_m.push_back(nearest.distance_m);
  }
  return distances_m;
}

double quantile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

double least_above_zero(const std::vector<double>& distances_m) {
  double least_m = HUGE_VAL;
  for (const double d : distances_m) {
    if (d > 0.0) least_m = std::min(least_m, d);
  }
  return least_m;
}

// Equal steps of value, or of its logarithm, with the threshold at an edge.
std::vector<double> edges_of(double low, double high, double threshold, bool logarithmic) {
  const auto to = [logarithmic](double value) { return logarithmic ? std::log10(value) : value; };
  const auto from = [logarithmic](double value) {
    return logarithmic ? std::pow(10.0, value) : value;
  };
  const double step = (to(high) - to(low)) / kBins;
  const int first = static_cast<int>(std::floor((to(low) - to(threshold)) / step));
  const int last = static_cast<int>(std::floor((to(high) - to(threshold)) / step)) + 1;
  std::vector<double> edges_m;
  for (int k = first; k <= last; ++k) {
    edges_m.push_back(k == 0 ? threshold : from(to(threshold) + k * step));
  }
  if (!logarithmic) edges_m.front() = std::max(0.0, edges_m.front());
  return edges_m;
}

}  // namespace

std::optional<Histogram> nearest_histogram(const SnapshotFacts& facts) {
  std::vector<double> distances_m = distances_of(facts);
  if (distances_m.empty()) return std::nullopt;
  const double threshold_m = facts.swarm.threshold_m;
  const double most_m =
      std::max(threshold_m, *std::max_element(distances_m.begin(), distances_m.end()));
  const double low_m =
      std::min(threshold_m, std::max(quantile(distances_m, 0.01), least_above_zero(distances_m)));
  const double high_m = std::max(threshold_m, quantile(distances_m, 0.99));
  Histogram histogram;
  histogram.logarithmic = high_m > kWideSpread * low_m;
  const double least_m = histogram.logarithmic ? least_above_zero(distances_m) : 0.0;
  const double begin_m = std::min(threshold_m, std::max(least_m, kLeastShare * most_m));
  histogram.edges_m = edges_of(histogram.logarithmic ? 0.8 * begin_m : 0.0, most_m, threshold_m,
                               histogram.logarithmic);
  histogram.counts.resize(histogram.edges_m.size() - 1);
  for (const double d : distances_m) {
    const auto above = std::upper_bound(histogram.edges_m.begin(), histogram.edges_m.end(), d);
    const auto bin = std::max<std::ptrdiff_t>(0, above - histogram.edges_m.begin() - 1);
    const auto last = static_cast<std::ptrdiff_t>(histogram.counts.size()) - 1;
    ++histogram.counts[static_cast<std::size_t>(std::min(bin, last))];
    if (above == histogram.edges_m.begin()) ++histogram.below;
  }
  return histogram;
}

void draw_histogram(const Histogram& histogram, const SwarmFacts& swarm, const Box& box,
                    Drawing& drawing) {
  const auto& edges_m = histogram.edges_m;
  const Range distances{edges_m.front(), edges_m.back()};
  const auto kind = histogram.logarithmic ? Scale::Kind::kLogarithmic : Scale::Kind::kLinear;
  const double most =
      static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  const Scale across(distances, box.left, box.right(), kind);
  const Scale upwards({0.0, 1.12 * most}, box.bottom(), box.top);
  std::vector<Tick> counts = nice_ticks(upwards.values(), 5);
  for (Tick& tick : counts) tick.label = decimal_label(tick.value, 0);
  counts.erase(
      std::remove_if(counts.begin(), counts.end(),
                     [](const Tick& tick) { return tick.value != std::floor(tick.value); }),
      counts.end());
  const Panel panel{box,
                    "Distance to the nearest other bee",
                    {across,
                     as_many_as_fit(box.width,
                                    [&](std::size_t at_most) {
                                      return histogram.logarithmic
                                                 ? logarithmic_ticks(distances, at_most)
                                                 : nice_ticks(distances, at_most);
                                    }),
                     histogram.logarithmic ? "Distance (m), by powers of ten" : "Distance (m)"},
                    {upwards, counts, "Bees"}};
  draw_panel(panel, drawing);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    const double left = across(edges_m[i]) + 0.5;
    const double right = std::max(left + 1.0, across(edges_m[i + 1]) - 0.5);
    // One bee among a million can be seen too.
    const double top =
        std::min(box.bottom() - 1.5, upwards(static_cast<double>(histogram.counts[i])));
    const bool too_close = !swarm.vertical_m && edges_m[i + 1] <= swarm.threshold_m;
    drawing.shapes.emplace_back(
        Area{{{left, box.bottom()}, {left, top}, {right, top}, {right, box.bottom()}},
             too_close ? kRisk : kBee});
  }
  draw_line_upwards(panel, swarm.threshold_m, "threshold " + length_label(swarm.threshold_m),
                    drawing);
}

}  // namespace beespace::report
