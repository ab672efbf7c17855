#include "report/figure/nearest_histogram.hpp"

#include "report/figure/sheet.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

constexpr double kBins = 44.0;
// Wider spreads than this, from the lowest percent to the highest, are shown by powers of ten.
constexpr double kWideSpreadOfNearest = 60.0;
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

std::size_t bin_of(double distance_m, const std::vector<double>& edges_m) {
  const auto above = std::upper_bound(edges_m.begin(), edges_m.end(), distance_m);
  const auto bin = std::max<std::ptrdiff_t>(0, above - edges_m.begin() - 1);
  return std::min(static_cast<std::size_t>(bin), edges_m.size() - 2);
}

// How high so many stand: one bee among a million can be seen too.
double top_of(std::uint64_t count, const Scale& upwards, const Box& box) {
  return std::min(box.bottom() - 1.5, upwards(static_cast<double>(count)));
}

void draw_bar(double left, double right, double bottom, double top, Ink ink, Drawing& drawing) {
  drawing.shapes.emplace_back(
      Area{{{left, bottom}, {left, top}, {right, top}, {right, bottom}}, ink});
}

std::string capitalised(std::string word) {
  if (!word.empty()) word.front() = static_cast<char>(word.front() - 'a' + 'A');
  return word;
}

// Distances are in a straight line: with a limit in height, too, who is nearer than the horizontal
// one need not be at risk.
std::string apart_in_height(const Histogram& histogram, const SwarmFacts& swarm) {
  if (!swarm.vertical_m) return {};
  std::uint64_t apart = 0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.edges_m[i + 1] > swarm.threshold_m) break;
    apart += histogram.counts[i] - histogram.at_risk[i];
  }
  if (apart == 0) return {};
  return "; " + count_label(apart) + " left of the line " + (apart == 1 ? "is" : "are") +
         " apart in height";
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
  histogram.logarithmic = high_m > kWideSpreadOfNearest * low_m;
  const double least_m = histogram.logarithmic ? least_above_zero(distances_m) : 0.0;
  const double begin_m = std::min(threshold_m, std::max(least_m, kLeastShare * most_m));
  histogram.edges_m = edges_of(histogram.logarithmic ? 0.8 * begin_m : 0.0, most_m, threshold_m,
                               histogram.logarithmic);
  histogram.counts.resize(histogram.edges_m.size() - 1);
  for (const double d : distances_m) {
    ++histogram.counts[bin_of(d, histogram.edges_m)];
    if (d < histogram.edges_m.front()) ++histogram.below;
  }
  histogram.at_risk.resize(histogram.counts.size());
  for (const PointId bee : facts.at_risk) {
    const double distance_m = facts.nearest[bee].distance_m;
    if (std::isfinite(distance_m)) ++histogram.at_risk[bin_of(distance_m, histogram.edges_m)];
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
  // As the axes beside it.
  const AxisUnit unit = swarm.aviation ? axis_unit(swarm, distances.high) : AxisUnit{};
  const Scale upwards({0.0, 1.12 * most}, box.bottom(), box.top);
  std::vector<Tick> counts = nice_ticks(upwards.values(), 5);
  for (Tick& tick : counts) tick.label = decimal_label(tick.value, 0);
  counts.erase(
      std::remove_if(counts.begin(), counts.end(),
                     [](const Tick& tick) { return tick.value != std::floor(tick.value); }),
      counts.end());
  const Panel panel{box,
                    "Distance to the nearest other " + swarm.noun.one,
                    {across,
                     as_many_as_fit(box.width,
                                    [&](std::size_t at_most) {
                                      return histogram.logarithmic
                                                 ? logarithmic_ticks(distances, at_most)
                                                 : nice_ticks(distances, at_most, unit.metres);
                                    }),
                     (histogram.logarithmic ? "Distance (m), by powers of ten"
                                            : std::string("Distance (") + unit.name + ")") +
                         apart_in_height(histogram, swarm)},
                    {upwards, counts, capitalised(swarm.noun.several)}};
  draw_panel(panel, drawing);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    const double left = across(edges_m[i]) + 0.5;
    const double right = std::max(left + 1.0, across(edges_m[i + 1]) - 0.5);
    const std::uint64_t at_risk = histogram.at_risk[i];
    const double foot = at_risk > 0 ? top_of(at_risk, upwards, box) : box.bottom();
    if (at_risk > 0) draw_bar(left, right, box.bottom(), foot, kRisk, drawing);
    if (at_risk == histogram.counts[i]) continue;
    draw_bar(left, right, foot, top_of(histogram.counts[i], upwards, box), kBee, drawing);
  }
  draw_line_upwards(panel, swarm.threshold_m, threshold_name(swarm), drawing);
}

}  // namespace beespace::report
