#include "report/figure/panel.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/style.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kTickLength = 4.0;
constexpr double kBold = 1.1;  // how much wider bold text is

void draw_across(const Panel& panel, Drawing& drawing) {
  const Box& box = panel.box;
  const bool labelled = !panel.across.title.empty();
  Lines grid{{}, kGrid};
  Lines ticks{{}, kAxis};
  for (const Tick& tick : panel.across.ticks) {
    const double x = panel.across.scale(tick.value);
    grid.runs.push_back({{x, box.top}, {x, box.bottom()}});
    ticks.runs.push_back({{x, box.bottom()}, {x, box.bottom() + kTickLength}});
  }
  drawing.shapes.emplace_back(grid);
  drawing.shapes.emplace_back(ticks);
  if (!labelled) return;
  for (const Tick& tick : panel.across.ticks) {
    drawing.shapes.emplace_back(Text{{panel.across.scale(tick.value), box.bottom() + 18.0},
                                     tick.label,
                                     kLabelSize,
                                     Anchor::kMiddle,
                                     false,
                                     false,
                                     false,
                                     kQuietText});
  }
  drawing.shapes.emplace_back(Text{{box.left + box.width / 2.0, box.bottom() + 38.0},
                                   panel.across.title,
                                   kLabelSize,
                                   Anchor::kMiddle,
                                   false,
                                   false,
                                   false,
                                   kText});
}

void draw_upwards(const Panel& panel, Drawing& drawing) {
  const Box& box = panel.box;
  Lines grid{{}, kGrid};
  double widest = 0.0;
  for (const Tick& tick : panel.upwards.ticks) {
    const double y = panel.upwards.scale(tick.value);
    grid.runs.push_back({{box.left, y}, {box.right(), y}});
    widest = std::max(widest, text_width(tick.label, kLabelSize));
  }
  drawing.shapes.emplace_back(grid);
  for (const Tick& tick : panel.upwards.ticks) {
    drawing.shapes.emplace_back(
        Text{{box.left - 8.0, panel.upwards.scale(tick.value) + kLabelSize * 0.35},
             tick.label,
             kLabelSize,
             Anchor::kEnd,
             false,
             false,
             false,
             kQuietText});
  }
  drawing.shapes.emplace_back(
      Text{{std::max(kLabelSize, box.left - widest - 18.0), box.top + box.height / 2.0},
           panel.upwards.title,
           kLabelSize,
           Anchor::kMiddle,
           false,
           true,
           false,
           kText});
}

// Of lines with many spots: how many of them a label covers that begins there.
std::ptrdiff_t spots_within(const Lines& lines, Spot at, double width) {
  const auto covered = [&](const Spot& spot) {
    return spot.x > at.x - 4.0 && spot.x < at.x + width + 4.0 && spot.y > at.y - kLabelSize &&
           spot.y < at.y + 4.0;
  };
  std::ptrdiff_t count = 0;
  // Between spots that are far apart the line is in the way too.
  constexpr double kStep = 3.0;
  for (const auto& run : lines.runs) {
    for (std::size_t i = 0; i < run.size(); ++i) {
      const Spot from = run[i];
      const Spot to = run[std::min(i + 1, run.size() - 1)];
      const double size = std::hypot(to.x - from.x, to.y - from.y);
      const auto steps = static_cast<int>(std::clamp(size / kStep, 1.0, 1'000.0));
      for (int k = 0; k < steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        count +=
            covered({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}) ? 1 : 0;
      }
    }
  }
  return count;
}

// The baseline, or one so far above or below it that the line does not strike the text through.
double clear_of(double line_y, double baseline, const Box& box) {
  constexpr double kAscent = 11.0;
  constexpr double kDescent = 5.0;
  if (line_y > baseline + kDescent || line_y < baseline - kAscent) return baseline;
  const double above = line_y - kDescent;
  const double below = line_y + kAscent;
  const bool fits_below = below + kDescent <= box.bottom();
  return fits_below && below - baseline < baseline - above ? below : above;
}

// At the right end of the heading, behind a dash as the line has them; false where there is no
// room.
bool name_beside_heading(const Panel& panel, const std::string& name, Drawing& drawing) {
  constexpr double kDash = 18.0;
  constexpr double kBetween = 6.0;
  const Box& box = panel.box;
  const double left = box.right() - text_width(name, kLabelSize);
  const double heading = box.left + kBold * text_width(panel.heading, kTextSize);
  const double dash_ends = left - kBetween;
  if (dash_ends - kDash < heading + 2.0 * kBetween) return false;
  const double baseline = box.top - 10.0;
  const double y = baseline - 0.35 * kLabelSize;
  drawing.shapes.emplace_back(
      Lines{{{{dash_ends - kDash, y}, {dash_ends, y}}}, kThreshold, 1.2, true});
  drawing.shapes.emplace_back(
      Text{{left, baseline}, name, kLabelSize, Anchor::kStart, false, false, false, kText});
  return true;
}

}  // namespace

Lines hatching(const Box& box) {
  constexpr double kApart = 6.0;
  Lines lines{{}, kAxis, 1.0};
  const double first = std::floor((box.left + box.top) / kApart) * kApart;
  const auto count = static_cast<int>(std::ceil((box.right() + box.bottom() - first) / kApart));
  for (int i = 0; i < count; ++i) {
    const double slant = first + i * kApart;
    // The part in the box of x + y = slant.
    const double left = std::max(box.left, slant - box.bottom());
    const double right = std::min(box.right(), slant - box.top);
    if (left < right) lines.runs.push_back({{left, slant - left}, {right, slant - right}});
  }
  return lines;
}

std::vector<Tick> as_many_as_fit(double length, const TickMaker& make) {
  constexpr std::size_t kMost = 9;
  constexpr double kBetween = 14.0;
  std::vector<Tick> ticks;
  for (std::size_t most = kMost; most > 0; --most) {
    ticks = make(most);
    double widest = 0.0;
    for (const Tick& tick : ticks) {
      widest = std::max(widest, text_width(tick.label, kLabelSize));
    }
    if (static_cast<double>(ticks.size()) * (widest + kBetween) <= length) break;
  }
  return ticks;
}

void draw_panel(const Panel& panel, Drawing& drawing) {
  const Box& box = panel.box;
  drawing.shapes.emplace_back(Text{{box.left, box.top - 10.0},
                                   panel.heading,
                                   kTextSize,
                                   Anchor::kStart,
                                   true,
                                   false,
                                   false,
                                   kText});
  draw_across(panel, drawing);
  draw_upwards(panel, drawing);
  drawing.shapes.emplace_back(
      Lines{{{{box.left, box.top}, {box.left, box.bottom()}, {box.right(), box.bottom()}}}, kAxis});
}

void draw_line_across(const Panel& panel, double value, const std::string& name,
                      const Lines& around, Drawing& drawing) {
  const Box& box = panel.box;
  const double y = panel.upwards.scale(value);
  drawing.shapes.emplace_back(Lines{{{{box.left, y}, {box.right(), y}}}, kThreshold, 1.2, true});
  if (name_beside_heading(panel, name, drawing)) return;
  const double width = text_width(name, kLabelSize);
  const double left = box.left + 6.0;
  const double right = box.right() - width;
  const double above = y - 6.0;
  const double below = y + kLabelSize + 4.0;
  constexpr int kSteps = 8;
  std::vector<Spot> places;
  for (int k = 0; k <= kSteps; ++k) {
    const double x = right + static_cast<double>(k) / kSteps * (left - right);
    for (const double at : {above, below}) {
      if (at - kLabelSize < box.top || at + 4.0 > box.bottom()) continue;
      places.push_back({x, at});
    }
  }
  const auto in_the_way = [&](Spot at) { return spots_within(around, at, width); };
  const auto best =
      std::min_element(places.begin(), places.end(),
                       [&](const Spot& a, const Spot& b) { return in_the_way(a) < in_the_way(b); });
  const Spot at = best == places.end() ? Spot{right, above} : *best;
  drawing.shapes.emplace_back(
      Text{at, name, kLabelSize, Anchor::kStart, false, false, true, kText});
}

void draw_line_upwards(const Panel& panel, double value, const std::string& name,
                       Drawing& drawing) {
  const Box& box = panel.box;
  const double x = panel.across.scale(value);
  drawing.shapes.emplace_back(Lines{{{{x, box.top}, {x, box.bottom()}}}, kThreshold, 1.2, true});
  const bool to_the_left = x - box.left > box.width / 2.0;
  drawing.shapes.emplace_back(Text{{to_the_left ? x - 6.0 : x + 6.0, box.top + kLabelSize},
                                   name,
                                   kLabelSize,
                                   to_the_left ? Anchor::kEnd : Anchor::kStart,
                                   false,
                                   false,
                                   true,
                                   kText});
}

std::ptrdiff_t in_the_way(const Drawing& drawing, Spot at, double width) {
  const auto is_data = [](const Ink& ink) {
    return ink.rgb != kGrid.rgb && ink.rgb != kAxis.rgb && ink.rgb != kThreshold.rgb;
  };
  std::ptrdiff_t count = 0;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* lines = std::get_if<Lines>(&shape)) {
      const bool curve = !lines->dashed && lines->ink.rgb == kText.rgb && !lines->runs.empty() &&
                         lines->runs.front().size() > 2;
      if (curve || is_data(lines->ink)) count += spots_within(*lines, at, width);
    }
    Lines marks{{{}}, kText};
    if (const auto* dots = std::get_if<Dots>(&shape)) marks.runs.front() = dots->centres;
    if (const auto* diamonds = std::get_if<Diamonds>(&shape)) {
      for (const Diamond& mark : diamonds->marks) marks.runs.front().push_back(mark.centre);
    }
    constexpr std::ptrdiff_t kMark = 4;  // a mark hides more than a spot of a line
    for (const Spot& mark : marks.runs.front()) {
      count += kMark * spots_within(Lines{{{mark}}, kText}, at, width);
    }
  }
  return count;
}

double draw_ring(const Box& box, Spot spot, const std::string& text, Drawing& drawing,
                 std::optional<double> line_y) {
  constexpr double kRadius = 8.0;
  constexpr double kAside = 14.0;  // so far above or below, where it is in a corner
  double y = std::min(spot.y + 4.0, box.bottom() - 6.0);
  if (line_y) y = clear_of(*line_y, y, box);
  const double beside = kRadius + 5.0;
  const double width = kBold * text_width(text, kLabelSize);
  const double right = spot.x + beside;
  const double left = spot.x - beside - width;
  const double middle = std::max(box.left, std::min(spot.x - 0.5 * width, box.right() - width));
  const double above = spot.y - beside;
  const double below = spot.y + beside + kLabelSize;
  // The first of those of which least is in the way; the last two fit across, wherever it is.
  std::vector<Spot> places;
  for (const Spot at :
       {Spot{right, y}, Spot{left, y}, Spot{right, y - kAside}, Spot{right, y + kAside},
        Spot{left, y - kAside}, Spot{left, y + kAside}, Spot{middle, above}, Spot{middle, below}}) {
    const bool struck = line_y && clear_of(*line_y, at.y, box) != at.y;
    const bool fits = at.x >= box.left && at.x + width <= box.right() &&
                      at.y - kLabelSize >= box.top && at.y + 4.0 <= box.bottom();
    if (fits && !struck) places.push_back(at);
  }
  if (places.empty()) places.push_back({middle, above - kLabelSize >= box.top ? above : below});
  std::vector<std::ptrdiff_t> covered(places.size());
  if (!text.empty()) {
    std::transform(places.begin(), places.end(), covered.begin(),
                   [&](const Spot& at) { return in_the_way(drawing, at, width); });
  }
  const Spot at = places[static_cast<std::size_t>(std::min_element(covered.begin(), covered.end()) -
                                                  covered.begin())];
  drawing.shapes.emplace_back(Dots{{spot}, kRadius, kText, 1.6});
  if (text.empty()) return y;
  drawing.shapes.emplace_back(Text{at, text, kLabelSize, Anchor::kStart, true, false, true, kText});
  return at.y;
}

}  // namespace beespace::report
