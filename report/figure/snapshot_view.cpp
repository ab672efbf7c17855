#include "report/figure/snapshot_view.hpp"

#include "report/figure/density.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

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
        {view.spot_of(facts.positions[bee]), radius, facts.swarm.names.of(bee)});
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

void draw_closest(const SnapshotFacts& facts, const View& view, Drawing& drawing) {
  if (!facts.closest || !are_few(facts)) return;
  const Spot a = view.spot_of(facts.positions[facts.closest->first]);
  const Spot b = view.spot_of(facts.positions[facts.closest->second]);
  draw_ring(view.panel.box, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)},
            view.from == View::From::kAbove
                ? (facts.at_risk.empty() ? "closest, not too close: " : "closest: ") +
                      apart_words(facts.swarm, facts.closest->distance_m, facts.closest_apart)
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
  if (have_lines(facts)) drawing.shapes.emplace_back(lines_of(facts, view));
  if (have_marks(facts)) {
    drawing.shapes.emplace_back(marks_of(facts, view));
  } else {
    drawing.shapes.emplace_back(those_at_risk(facts, view).diamonds(kRisk));
  }
  draw_closest(facts, view, drawing);
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
