#include "report/figure/snapshot_view.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/density.hpp"
#include "report/figure/picture_names.hpp"
#include "report/figure/style.hpp"
#include "report/figure/text_boxes.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace beespace::report {
namespace {

// Of more, single marks would hide each other, and fill the file.
constexpr std::size_t kFewBees = 4'000;
constexpr std::size_t kFewAtRisk = 1'500;
constexpr std::size_t kFewPairs = 2'000;

bool are_few(const SnapshotFacts& facts) {
  return facts.positions.size() <= kFewBees;
}

// Whether each of those at risk has a mark.
bool have_marks(const SnapshotFacts& facts) {
  return are_few(facts) || facts.at_risk.size() <= kFewAtRisk;
}

bool have_lines(const SnapshotFacts& facts) {
  return are_few(facts) && facts.pair_count <= kFewPairs && facts.pairs.size() == facts.pair_count;
}

double radius_of_a_bee(const SnapshotFacts& facts) {
  if (facts.positions.size() <= 200) return 3.2;
  return facts.positions.size() <= 1'000 ? 2.4 : 1.7;
}

Density all_bees(const SnapshotFacts& facts, const View& view) {
  Density density = density_over(view, kDensityCell);
  for (const Point& position : facts.positions) density.add(view.spot_of(position));
  return density;
}

Density those_at_risk(const SnapshotFacts& facts, const View& view) {
  Density density = density_over(view, kRiskCell);
  for (const PointId bee : facts.at_risk) density.add(view.spot_of(facts.positions[bee]));
  return density;
}

// Those who are not at risk.
Dots dots_of(const SnapshotFacts& facts, const View& view) {
  Dots dots{{}, radius_of_a_bee(facts), kBee};
  auto next = facts.at_risk.begin();
  for (PointId bee = 0; bee < facts.positions.size(); ++bee) {
    if (next != facts.at_risk.end() && *next == bee) {
      ++next;
    } else {
      dots.centres.push_back(view.spot_of(facts.positions[bee]));
    }
  }
  return dots;
}

Diamonds marks_of(const SnapshotFacts& facts, const View& view) {
  const double radius = radius_of_a_bee(facts) + 2.4;
  Diamonds diamonds{{}, kRisk};
  for (const PointId bee : facts.at_risk) {
    diamonds.marks.push_back(
        {view.spot_of(facts.positions[bee]), radius, picture_name(facts.swarm.names, bee)});
  }
  return diamonds;
}

Lines lines_of(const SnapshotFacts& facts, const View& view) {
  Lines lines{{}, kRisk, 1.2};
  for (const Pair& pair : facts.pairs) {
    lines.runs.push_back(
        {view.spot_of(facts.positions[pair.first]), view.spot_of(facts.positions[pair.second])});
  }
  return lines;
}

// The ways of those that come too close later, from where they are to where they are closest then.
void draw_ahead(const SnapshotFacts& facts, const View& view, Drawing& drawing) {
  if (!facts.ahead || facts.ahead->conflicts.empty()) return;
  Lines ways{{}, kRisk, 1.4, true};
  Dots there{{}, radius_of_a_bee(facts) + 2.0, kRisk, 1.4};
  for (const ConflictAhead& each : facts.ahead->conflicts) {
    ways.runs.push_back(
        {view.spot_of(facts.positions[each.first]), view.spot_of(each.first_there)});
    ways.runs.push_back(
        {view.spot_of(facts.positions[each.second]), view.spot_of(each.second_there)});
    there.centres.push_back(view.spot_of(each.first_there));
    there.centres.push_back(view.spot_of(each.second_there));
  }
  drawing.shapes.emplace_back(std::move(ways));
  drawing.shapes.emplace_back(std::move(there));
}

// The name of one of them, where it is now: on the side to which it does not fly, or on another one
// that has room and covers least. Where it would cover another name it is left to the list.
void name_one_ahead(const std::string& name, Spot at, Spot there, const Box& box,
                    Drawing& drawing) {
  constexpr double kBeside = 8.0;
  const double width = text_width(name, kLabelSize);
  const double left = at.x - kBeside - width;
  const double right = at.x + kBeside;
  const bool flies_right = there.x > at.x + 1.0;
  const double middle =
      std::clamp(at.x - 0.5 * width, box.left, std::max(box.left, box.right() - width));
  std::vector<Spot> places;
  for (const Spot place :
       {Spot{flies_right ? left : right, at.y + 4.0}, Spot{flies_right ? right : left, at.y + 4.0},
        Spot{middle, at.y - kBeside - 2.0}, Spot{middle, at.y + kBeside + kLabelSize}}) {
    const bool fits = place.x >= box.left && place.x + width <= box.right() &&
                      place.y - kLabelSize >= box.top && place.y + 4.0 <= box.bottom();
    if (fits) places.push_back(place);
  }
  if (places.empty()) places.push_back({middle, at.y + 4.0});
  const auto written = [&name](const Spot& place) {
    return Text{place, name, kLabelSize, Anchor::kStart, false, false, true, kText};
  };
  const std::vector<Box> texts = boxes_of_texts(drawing);
  std::erase_if(places, [&](const Spot& place) {
    const Box own = box_of_text(written(place));
    return std::any_of(texts.begin(), texts.end(),
                       [&own](const Box& text) { return covers_part_of(own, text); });
  });
  if (places.empty()) return;
  std::vector<std::ptrdiff_t> covered(places.size());
  std::transform(places.begin(), places.end(), covered.begin(),
                 [&](const Spot& place) { return in_the_way(drawing, place, width); });
  const auto best = std::min_element(covered.begin(), covered.end()) - covered.begin();
  drawing.shapes.emplace_back(written(places[static_cast<std::size_t>(best)]));
}

// Over all else, each once.
void name_those_ahead(const SnapshotFacts& facts, const View& view, Drawing& drawing) {
  if (!facts.ahead || view.from != View::From::kAbove) return;
  std::vector<PointId> named;
  const auto name = [&](PointId bee, const Point& there) {
    if (std::find(named.begin(), named.end(), bee) != named.end()) return;
    named.push_back(bee);
    name_one_ahead(one_line(picture_name(facts.swarm.names, bee)),
                   view.spot_of(facts.positions[bee]), view.spot_of(there), view.panel.box,
                   drawing);
  };
  for (const ConflictAhead& each : facts.ahead->conflicts) {
    name(each.first, each.first_there);
    name(each.second, each.second_there);
  }
}

void draw_closest(const SnapshotFacts& facts, const View& view, Drawing& drawing) {
  if (!facts.closest || !are_few(facts)) return;
  // Who is not too close now is of no account beside those who will be.
  if (facts.at_risk.empty() && facts.ahead && facts.ahead->count > 0) return;
  const Spot a = view.spot_of(facts.positions[facts.closest->first]);
  const Spot b = view.spot_of(facts.positions[facts.closest->second]);
  draw_ring(view.panel.box, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)},
            view.from == View::From::kAbove
                ? (!facts.at_risk.empty()  ? "closest: "
                   : facts.unknown.empty() ? "closest, not too close: "
                                           : "closest of those known: ") +
                      apart_words(facts.swarm, facts.closest->distance_m, facts.closest_apart,
                                  facts.at_risk.empty())
                : std::string(),
            drawing);
}

}  // namespace

void draw_bees(const SnapshotFacts& facts, const View& view, Drawing& drawing) {
  if (facts.positions.empty()) return;
  if (are_few(facts)) {
    drawing.shapes.emplace_back(dots_of(facts, view));
  } else {
    drawing.shapes.emplace_back(all_bees(facts, view).cells(shades()));
  }
  draw_ahead(facts, view, drawing);
  if (have_lines(facts)) drawing.shapes.emplace_back(lines_of(facts, view));
  if (have_marks(facts)) {
    drawing.shapes.emplace_back(marks_of(facts, view));
  } else {
    drawing.shapes.emplace_back(those_at_risk(facts, view).diamonds(kRisk));
  }
  draw_closest(facts, view, drawing);
  name_those_ahead(facts, view, drawing);
}

std::vector<KeyEntry> key_of_bees(const SnapshotFacts& facts, const View& from_above) {
  using Sample = KeyEntry::Sample;
  std::vector<KeyEntry> key;
  if (are_few(facts)) {
    key.push_back({Sample::kBee, facts.swarm.noun.one});
  } else {
    key.push_back({Sample::kShades, facts.swarm.noun.several + " in a cell: 1 to " +
                                        count_label(all_bees(facts, from_above).most()) +
                                        " from above"});
  }
  if (facts.ahead && facts.ahead->count > 0) {
    key.push_back(
        {Sample::kAhead, "way, flying straight on, to where two are closest and too close"});
  }
  if (facts.at_risk.empty()) return key;
  if (!have_marks(facts)) {
    key.push_back({Sample::kBinned, "at risk: area by their number, up to " +
                                        count_label(those_at_risk(facts, from_above).most()) +
                                        " from above"});
  } else if (have_lines(facts)) {
    key.push_back({Sample::kPair, "at risk, and who is too close to whom"});
  } else {
    key.push_back({Sample::kAtRisk, "at risk"});
  }
  return key;
}

}  // namespace beespace::report
