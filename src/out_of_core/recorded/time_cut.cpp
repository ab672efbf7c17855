#include "out_of_core/recorded/time_cut.hpp"

#include "base/stopping.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace beespace::out_of_core {

namespace {

// Each time borders are looked for where cells are too large there are thousands of them.
constexpr int kMostRounds = 4;
constexpr std::size_t kMostBorders = std::size_t{1} << 15U;

// Of so many times as many as there may be borders, evenly spread.
std::vector<double> thinned(const std::vector<double>& times) {
  if (times.size() <= kMostBorders) return times;
  std::vector<double> some;
  some.reserve(kMostBorders);
  for (std::size_t at = 0; at < kMostBorders; ++at) {
    some.push_back(times[at * times.size() / kMostBorders]);
  }
  return some;
}

struct Passage {
  const StoredFixes& fixes;
  const CutRules& rules;
  RepeatedFixes& repeated;
  const FixWatcher& watch;
};

Result<TimeCells> count(const Passage& in, const TimeBorders& borders) {
  TimeCells cells(borders.cells());
  std::optional<StoredFix> last;
  std::size_t cell = 0;
  bool stopped = false;
  auto status = in.fixes.for_each(in.repeated, [&](const StoredFix& fix) {
    const double time_s = fix.fix.time_s;
    const bool same = last && last->agent == fix.agent;
    const std::size_t from = same ? cell : 0;
    cell = borders.cell_of(time_s, from);
    if (same && time_s - last->fix.time_s <= in.rules.max_gap_s) {
      cells.go_on(from, cell);
    } else {
      cells.begin(cell);
    }
    last = fix;
    stopped = !in.watch();
    return !stopped;
  });
  if (!status) return std::move(status).error();
  if (stopped) return core::stopped_error();
  cells.finish();
  return cells;
}

// What cells that are too large by themselves can be cut at: of each the least of its times, so
// that it gets smaller in any case, and some others.
Result<std::vector<double>> more_borders(const Passage& in, const TimeBorders& borders,
                                         const std::vector<bool>& too_large) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, double>> spans(borders.cells(), {kNone, -kNone});
  TimeSample sample;
  bool stopped = false;
  auto status = in.fixes.for_each(in.repeated, [&](const StoredFix& fix) {
    const double time_s = fix.fix.time_s;
    const std::size_t cell = borders.cell_of(time_s);
    if (too_large[cell]) {
      auto& [least, most] = spans[cell];
      least = std::min(least, time_s);
      most = std::max(most, time_s);
      sample.add(time_s);
    }
    stopped = !in.watch();
    return !stopped;
  });
  if (!status) return std::move(status).error();
  if (stopped) return core::stopped_error();
  std::vector<double> all;
  for (const double time_s : thinned(sample.sorted())) {
    // The last of a cell cuts nothing off.
    if (time_s < spans[borders.cell_of(time_s)].second) all.push_back(time_s);
  }
  for (const auto& [least, most] : spans) {
    if (least < most) all.push_back(least);
  }
  return all;
}

std::vector<bool> too_large_cells(const TimeCells& cells, const CutRules& rules, bool& any) {
  std::vector<bool> too_large(cells.count());
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    too_large[cell] = rules.cost.of(cells.size_of(cell, cell)) > rules.limit;
    any = any || too_large[cell];
  }
  return too_large;
}

TimeCut cut_of(const TimeCells& cells, const TimeBorders& borders, const CutRules& rules) {
  TimeCut cut;
  std::vector<double> between;
  std::size_t first = 0;
  for (const std::size_t last : cells.cut(rules.cost, rules.limit)) {
    cut.sizes.push_back(cells.size_of(first, last));
    if (last + 1 < cells.count()) between.push_back(borders.all()[last]);
    first = last + 1;
  }
  cut.borders = TimeBorders(std::move(between));
  return cut;
}

}  // namespace

WindowSize TimeCut::largest(const WindowCost& cost) const {
  WindowSize largest;
  for (const WindowSize& size : sizes) {
    if (cost.of(size) > cost.of(largest)) largest = size;
  }
  return largest;
}

Result<TimeCut> find_cut(const StoredFixes& fixes, const CutRules& rules, RepeatedFixes& repeated,
                         const FixWatcher& watch) {
  const Passage in{fixes, rules, repeated, watch};
  TimeBorders borders(thinned(fixes.times().sorted()));
  for (int round = 0;; ++round) {
    auto cells = count(in, borders);
    if (!cells) return std::move(cells).error();
    bool any = false;
    const std::vector<bool> too_large = too_large_cells(*cells, rules, any);
    if (any && round < kMostRounds) {
      auto more = more_borders(in, borders, too_large);
      if (!more) return std::move(more).error();
      if (!more->empty()) {
        std::vector<double> all = borders.all();
        all.insert(all.end(), more->begin(), more->end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        borders = TimeBorders(std::move(all));
        continue;
      }
    }
    return cut_of(*cells, borders, rules);
  }
}

}  // namespace beespace::out_of_core
