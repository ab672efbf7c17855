#include "report/figure/separation_chart.hpp"

#include "report/figure/sheet.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace beespace::report {
namespace {

constexpr double kDay_s = 86'400.0;
// Separations over more powers of ten than lines can show are drawn by them.
constexpr double kWideSpreadOverTime = 100.0;

TimeSpan time_of(const RecordingFacts& facts) {
  TimeSpan time{HUGE_VAL, -HUGE_VAL};
  for (const Track& track : facts.tracks) {
    if (track.fixes.empty()) continue;
    time.begins_s = std::min(time.begins_s, track.fixes.front().time_s);
    time.ends_s = std::max(time.ends_s, track.fixes.back().time_s);
  }
  if (!(time.begins_s <= time.ends_s)) return {0.0, 1.0};
  const double least_s = std::max(1e-9, 1e-9 * std::abs(time.begins_s));
  return {time.begins_s, std::max(time.ends_s, time.begins_s + least_s)};
}

Axis time_axis(const RecordingFacts& facts, const Box& box) {
  constexpr double kFewSeconds = 1'800.0;
  constexpr double kManySeconds = 360'000.0;  // 100 hours
  const TimeSpan time = time_of(facts);
  const Range range{time.begins_s, time.ends_s};
  const Scale scale(range, box.left, box.right());
  const auto clock_from = [&](double zero) {
    return as_many_as_fit(box.width,
                          [&](std::size_t most) { return clock_ticks(range, most, zero); });
  };
  if (facts.since_1970 && !date_label(time.begins_s).empty()) {
    return {scale, clock_from(std::floor(time.begins_s / kDay_s) * kDay_s),
            "Time (UTC, from " + date_label(time.begins_s) + ")"};
  }
  if (range.size() > kFewSeconds && range.low >= 0.0 && range.high < kManySeconds) {
    return {scale, clock_from(0.0), "Time (hours:minutes)"};
  }
  return {scale,
          as_many_as_fit(box.width, [&](std::size_t most) { return nice_ticks(range, most); }),
          "Time (s)"};
}

Axis distance_axis(const RecordingFacts& facts, const Box& box) {
  const double threshold_m = facts.swarm.threshold_m;
  double least_m = threshold_m;
  double most_m = threshold_m;
  for (const Separation& at : facts.separation) {
    if (at.closest.distance_m > 0.0) least_m = std::min(least_m, at.closest.distance_m);
    most_m = std::max(most_m, at.closest.distance_m);
  }
  if (most_m > kWideSpreadOverTime * threshold_m) {
    const Range range{0.8 * std::max(least_m, 1e-9 * most_m), 1.25 * most_m};
    return {Scale(range, box.bottom(), box.top, Scale::Kind::kLogarithmic),
            logarithmic_ticks(range, 7), "Distance (m), by powers of ten"};
  }
  const Range range{0.0, 1.1 * most_m};
  return {Scale(range, box.bottom(), box.top), nice_ticks(range, 5), "Distance (m)"};
}

void draw_bands(const RecordingFacts& facts, const Panel& panel, Drawing& drawing) {
  constexpr double kNarrowest = 1.0;
  const Box& box = panel.box;
  double drawn_to = box.left - 1.0;
  for (const TimeSpan& span : times_in_conflict(facts.at_risk)) {
    const double left = std::max(drawn_to, panel.across.scale(span.begins_s));
    const double right = std::max(left + kNarrowest, panel.across.scale(span.ends_s));
    if (right <= drawn_to) continue;
    drawn_to = right;
    drawing.shapes.emplace_back(
        Area{{{left, box.top}, {right, box.top}, {right, box.bottom()}, {left, box.bottom()}},
             kRiskBand});
  }
}

// Broken where there are no two bees for longer than from one moment to the next.
Lines line_of(const RecordingFacts& facts, const Panel& panel) {
  const auto& all = facts.separation;
  double usual_s = 0.0;
  if (all.size() > 2) {
    std::vector<double> steps_s(all.size() - 1);
    for (std::size_t i = 0; i < steps_s.size(); ++i) steps_s[i] = all[i + 1].time_s - all[i].time_s;
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    usual_s = *middle;
  }
  Lines lines{{{}}, kText, 1.3};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && usual_s > 0.0 && all[i].time_s - all[i - 1].time_s > 1.5 * usual_s) {
      lines.runs.emplace_back();
    }
    lines.runs.back().push_back(
        {panel.across.scale(all[i].time_s), panel.upwards.scale(all[i].closest.distance_m)});
  }
  return lines;
}

}  // namespace

std::vector<TimeSpan> times_in_conflict(const std::vector<AtRisk>& at_risk) {
  std::vector<TimeSpan> all;
  all.reserve(at_risk.size());
  for (const AtRisk& of : at_risk) all.push_back(of.span);
  std::sort(all.begin(), all.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
  std::vector<TimeSpan> merged;
  for (const TimeSpan& next : all) {
    if (merged.empty() || next.begins_s > merged.back().ends_s) {
      merged.push_back(next);
    } else {
      merged.back().ends_s = std::max(merged.back().ends_s, next.ends_s);
    }
  }
  return merged;
}

void draw_separation(const RecordingFacts& facts, const Box& box, Drawing& drawing) {
  constexpr std::size_t kRingSpots = 80;
  const Panel panel{box, "Distance of the closest two", time_axis(facts, box),
                    distance_axis(facts, box)};
  draw_bands(facts, panel, drawing);
  draw_panel(panel, drawing);
  Lines line = line_of(facts, panel);
  drawing.shapes.emplace_back(line);
  // Where heights are compared apart, the closest two in conflict need not be on the line.
  if (facts.closest && (!facts.swarm.vertical_m || facts.conflicts.empty())) {
    const Conflict& closest = *facts.closest;
    const Spot at = {panel.across.scale(closest.closest_s), panel.upwards.scale(closest.closest_m)};
    const double baseline =
        draw_ring(box, at, length_label_below(facts.swarm.threshold_m, closest.closest_m), drawing,
                  panel.upwards.scale(facts.swarm.threshold_m));
    // The label of the threshold keeps off this one.
    line.runs.emplace_back(kRingSpots);
    for (std::size_t i = 0; i < kRingSpots; ++i) {
      line.runs.back()[i] = {at.x - 80.0 + 2.0 * static_cast<double>(i), baseline - 4.0};
    }
  }
  draw_line_across(panel, facts.swarm.threshold_m, threshold_name(facts.swarm), line, drawing);
}

std::string moment_label(double time_s, bool since_1970) {
  if (!since_1970 || date_label(time_s).empty()) return decimal_label(time_s, 1) + " s";
  const double midnight = std::floor(time_s / kDay_s) * kDay_s;
  return clock_label(std::floor(time_s - midnight), 1.0);
}

}  // namespace beespace::report
