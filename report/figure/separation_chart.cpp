#include "report/figure/separation_chart.hpp"

#include "report/calendar_words.hpp"
#include "report/figure/calendar_axis.hpp"
#include "report/figure/sheet.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kDay_s = 86'400.0;
// Separations over more powers of ten than lines can show are drawn by them.
constexpr double kWideSpreadOverTime = 12.0;

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
  const io::Calendar& calendar = facts.calendar;
  if (!date_time_label(time.begins_s, calendar).empty()) {
    return {scale,
            as_many_as_fit(box.width,
                           [&](std::size_t most) { return calendar_ticks(range, most, calendar); }),
            calendar_title(range, calendar)};
  }
  if (range.size() > kFewSeconds && range.low >= 0.0 && range.high < kManySeconds) {
    return {scale, clock_from(0.0), "Time (hours:minutes)"};
  }
  return {scale,
          as_many_as_fit(box.width, [&](std::size_t most) { return nice_ticks(range, most); }),
          "Time (s)"};
}

// A distance of the closest two, its limit, and what it is called.
struct Measure {
  std::string heading;
  std::string title;
  std::string limit_name;
  double limit_m;
  AxisUnit unit;
  double (*of)(const Separation&);
};

// The greatest distance that is drawn. When few are known, as at the beginning and the end of a
// recording, the closest two may be far apart for a little time: what that is, and no more, does
// not press all else against the axis, but leaves the panel at its top.
double greatest_drawn_m(const RecordingFacts& facts, const Measure& measure) {
  constexpr double kNearlyAll = 0.9;
  constexpr double kRoom = 1.25;
  constexpr double kFarBeyond = 2.0;
  std::vector<double> all_m;
  all_m.reserve(facts.separation.size());
  for (const Separation& at : facts.separation) all_m.push_back(measure.of(at));
  if (all_m.empty()) return measure.limit_m;
  std::sort(all_m.begin(), all_m.end());
  const double most_m = std::max(all_m.back(), measure.limit_m);
  const auto last = static_cast<double>(all_m.size() - 1);
  const double nearly_all_m = all_m[static_cast<std::size_t>(kNearlyAll * last)];
  const double cut_m = kRoom * std::max(nearly_all_m, 2.0 * measure.limit_m);
  return most_m > kFarBeyond * cut_m ? cut_m : most_m;
}

struct DistanceAxis {
  Axis axis;
  std::string note;  // what its title does not say
};

// With a tick at the limit, which others give way to.
std::vector<Tick> powers_beside_limit(const Range& range, const Measure& measure, const Box& box,
                                      const Scale& scale) {
  constexpr double kBetween = 1.3 * kLabelSize;
  const auto most = static_cast<std::size_t>(box.height / (2.0 * kLabelSize));
  const double unit_m = measure.unit.metres;
  auto ticks = logarithmic_ticks({range.low / unit_m, range.high / unit_m}, most + 1);
  for (Tick& tick : ticks) tick.value *= unit_m;
  const double limit_at = scale(measure.limit_m);
  std::erase_if(
      ticks, [&](const Tick& tick) { return std::abs(scale(tick.value) - limit_at) < kBetween; });
  ticks.push_back({measure.limit_m, short_label(measure.limit_m / unit_m)});
  std::sort(ticks.begin(), ticks.end(),
            [](const Tick& one, const Tick& other) { return one.value < other.value; });
  return ticks;
}

DistanceAxis distance_axis(const RecordingFacts& facts, const Measure& measure, const Box& box) {
  constexpr double kNameHeight = 24.0;
  const std::string title = measure.title + " (" + measure.unit.name + ")";
  double least_m = measure.limit_m;
  double farthest_m = measure.limit_m;
  for (const Separation& at : facts.separation) {
    if (measure.of(at) > 0.0) least_m = std::min(least_m, measure.of(at));
    farthest_m = std::max(farthest_m, measure.of(at));
  }
  const double most_m = greatest_drawn_m(facts, measure);
  const std::string cut = most_m < farthest_m ? "cut off at the top" : "";
  constexpr std::size_t kFewest = 3;  // of a low panel, so that more than the 0 has one
  const auto ticks = std::max(kFewest, static_cast<std::size_t>(box.height / (3.2 * kLabelSize)));
  if (most_m > kWideSpreadOverTime * measure.limit_m) {
    const double lowest_m = std::max(least_m, 1e-3 * measure.limit_m);
    const Range range{0.8 * lowest_m, 1.25 * farthest_m};
    const Scale scale(range, box.bottom(), box.top, Scale::Kind::kLogarithmic);
    return {{scale, powers_beside_limit(range, measure, box, scale), title}, "by powers of ten"};
  }
  // The name of the limit has room above its line.
  const double room = box.height / (box.height - kNameHeight);
  const double top_m = cut.empty() ? 1.1 * most_m : most_m;
  const Range range{0.0, std::max(top_m, room * measure.limit_m)};
  return {
      {Scale(range, box.bottom(), box.top), nice_ticks(range, ticks, measure.unit.metres), title},
      cut};
}

// Above a high panel the title of the axis has room for it, and above a low one the heading.
Panel separation_panel(const Box& box, const Measure& measure, Axis time, DistanceAxis distance) {
  constexpr double kHigh = 200.0;
  std::string heading = measure.heading;
  if (!distance.note.empty()) {
    if (box.height < kHigh) {
      heading += ", " + distance.note;
    } else {
      distance.axis.title += ", " + distance.note;
    }
  }
  return {box, heading, std::move(time), std::move(distance.axis)};
}

// Where spans of time lie, from left to right: none is narrower than that, and what would overlap
// is joined.
std::vector<std::pair<double, double>> places_of(const std::vector<TimeSpan>& spans,
                                                 const Panel& panel, double narrowest) {
  const Box& box = panel.box;
  std::vector<std::pair<double, double>> places;
  for (const TimeSpan& span : spans) {
    const double left =
        std::clamp(panel.across.scale(span.begins_s), box.left, box.right() - narrowest);
    const double right =
        std::min(std::max(panel.across.scale(span.ends_s), left + narrowest), box.right());
    if (!places.empty() && left <= places.back().second) {
      places.back().second = std::max(places.back().second, right);
    } else {
      places.emplace_back(left, right);
    }
  }
  return places;
}

void draw_bands(const RecordingFacts& facts, const Panel& panel, Drawing& drawing) {
  constexpr double kNarrowest = 1.0;
  const Box& box = panel.box;
  for (const auto& [left, right] : places_of(times_in_conflict(facts.at_risk), panel, kNarrowest)) {
    drawing.shapes.emplace_back(
        Area{{{left, box.top}, {right, box.top}, {right, box.bottom()}, {left, box.bottom()}},
             kRiskBand});
  }
}

// Over all its height when it is not known how close the closest two are, and at its foot when it
// is not known where a bee is that is there.
void draw_unknown(const RecordingFacts& facts, const Panel& panel, Drawing& drawing) {
  constexpr double kNarrowest = 2.0;
  constexpr double kFoot = 7.0;
  const Box& box = panel.box;
  const auto hatch = [&](const std::vector<TimeSpan>& spans, double height) {
    for (const auto& [left, right] : places_of(spans, panel, kNarrowest)) {
      drawing.shapes.emplace_back(hatching({left, box.bottom() - height, right - left, height}));
    }
  };
  hatch(facts.separation_open, box.height);
  std::vector<AtRisk> unknown;
  for (const Gap& gap : facts.unknown_spans)
    unknown.push_back({gap.track, {gap.begins_s, gap.ends_s}});
  hatch(times_in_conflict(unknown), kFoot);
}

// Whether it is not known, for most of the time from one moment to the next, who is closest.
bool is_open_between(const RecordingFacts& facts, double begins_s, double ends_s) {
  double open_s = 0.0;
  for (const TimeSpan& span : facts.separation_open) {
    open_s += std::max(0.0, std::min(span.ends_s, ends_s) - std::max(span.begins_s, begins_s));
  }
  return open_s > 0.5 * (ends_s - begins_s);
}

// Broken where there are no two bees for longer than from one moment to the next, and where who is
// closest is not known.
Lines line_of(const RecordingFacts& facts, const Measure& measure, const Panel& panel) {
  const auto& all = facts.separation;
  double usual_s = 0.0;
  if (all.size() > 2) {
    std::vector<double> steps_s(all.size() - 1);
    for (std::size_t i = 0; i < steps_s.size(); ++i) steps_s[i] = all[i + 1].time_s - all[i].time_s;
    // Some lie between two of the moments, as those of conflicts do.
    const auto longer = steps_s.begin() + static_cast<std::ptrdiff_t>(9 * steps_s.size() / 10);
    std::nth_element(steps_s.begin(), longer, steps_s.end());
    usual_s = *longer;
  }
  Lines lines{{{}}, kText, 1.3};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool later = i > 0 && usual_s > 0.0 && all[i].time_s - all[i - 1].time_s > 1.5 * usual_s;
    if (later || (i > 0 && is_open_between(facts, all[i - 1].time_s, all[i].time_s))) {
      lines.runs.emplace_back();
    }
    lines.runs.back().push_back(
        {panel.across.scale(all[i].time_s), panel.upwards.scale(measure.of(all[i]))});
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

namespace {

// They may be others at each moment.
std::string same_two(const RecordingFacts& facts) {
  constexpr std::size_t kMany = 100;
  std::set<std::pair<PointId, PointId>> pairs;
  for (const Separation& at : facts.separation) {
    pairs.emplace(at.closest.first, at.closest.second);
    if (pairs.size() == kMany) return "The same (many pairs in turn)";
  }
  if (pairs.size() < 2) return "The same two";
  return "The same (" + count_label(pairs.size()) + " pairs in turn)";
}

// Each of those who are nearest to a conflict, against its own limit.
void draw_apart(const RecordingFacts& facts, const Box& box, Drawing& drawing) {
  constexpr double kBetween = 44.0;
  const double height = 0.5 * (box.height - kBetween);
  const Box upper{box.left, box.top, box.width, height};
  const Box lower{box.left, upper.bottom() + kBetween, box.width, height};
  const SwarmFacts& swarm = facts.swarm;
  const Measure across{
      "Nearest to a conflict", "Distance",
      threshold_name(swarm),   swarm.threshold_m,
      distance_unit(swarm),    [](const Separation& at) { return at.apart->horizontal_m; }};
  const Measure up{same_two(facts),
                   "Height",
                   "in height " + height_words(swarm, *swarm.vertical_m),
                   *swarm.vertical_m,
                   height_unit(swarm),
                   [](const Separation& at) { return at.apart->height_m; }};
  for (const auto& [measure, place] : {std::pair(across, upper), std::pair(up, lower)}) {
    Axis time = time_axis(facts, place);
    if (place.top == upper.top) time.title.clear();
    const Panel panel =
        separation_panel(place, measure, std::move(time), distance_axis(facts, measure, place));
    draw_bands(facts, panel, drawing);
    draw_unknown(facts, panel, drawing);
    draw_panel(panel, drawing);
    const Lines line = line_of(facts, measure, panel);
    drawing.shapes.emplace_back(line);
    draw_line_across(panel, measure.limit_m, measure.limit_name, line, drawing);
  }
}

bool are_apart(const RecordingFacts& facts) {
  return facts.swarm.vertical_m && !facts.separation.empty() &&
         std::all_of(facts.separation.begin(), facts.separation.end(),
                     [](const Separation& at) { return at.apart.has_value(); });
}

}  // namespace

void draw_separation(const RecordingFacts& facts, const Box& box, Drawing& drawing) {
  if (are_apart(facts)) return draw_apart(facts, box, drawing);
  constexpr std::size_t kRingSpots = 80;
  const Measure measure{
      "The closest two",           "Distance",
      threshold_name(facts.swarm), facts.swarm.threshold_m,
      distance_unit(facts.swarm),  [](const Separation& at) { return at.closest.distance_m; }};
  const Panel panel =
      separation_panel(box, measure, time_axis(facts, box), distance_axis(facts, measure, box));
  draw_bands(facts, panel, drawing);
  draw_unknown(facts, panel, drawing);
  draw_panel(panel, drawing);
  Lines line = line_of(facts, measure, panel);
  drawing.shapes.emplace_back(line);
  // Where heights are compared apart, the closest two in conflict need not be on the line.
  if (facts.closest && (!facts.swarm.vertical_m || facts.conflicts.empty())) {
    // Two that both stand are not on the line.
    const bool both_stand = facts.closest_in_the_air && !facts.closest_stands;
    const Conflict& closest = both_stand ? *facts.closest_in_the_air : *facts.closest;
    const auto& apart = both_stand ? facts.closest_in_the_air_apart : facts.closest_apart;
    const Spot at = {panel.across.scale(closest.closest_s), panel.upwards.scale(closest.closest_m)};
    const double baseline =
        draw_ring(box, at,
                  apart_words(facts.swarm, closest.closest_m, apart) +
                      (facts.closest_stands ? with_one_standing(facts.swarm) : ""),
                  drawing, panel.upwards.scale(facts.swarm.threshold_m));
    // The label of the threshold keeps off this one.
    line.runs.emplace_back(kRingSpots);
    for (std::size_t i = 0; i < kRingSpots; ++i) {
      line.runs.back()[i] = {at.x - 80.0 + 2.0 * static_cast<double>(i), baseline - 4.0};
    }
  }
  draw_line_across(panel, measure.limit_m, measure.limit_name, line, drawing);
}

std::string moment_label(double time_s, const RecordingFacts& facts) {
  const TimeSpan time = time_of(facts);
  const bool of_days = time.ends_s - time.begins_s > kDay_s;
  const std::string text = short_moment_label(time_s, facts.calendar, of_days);
  return text.empty() ? decimal_label(time_s, 1) + " s" : text;
}

}  // namespace beespace::report
