#include "search/nearest_in_tree.hpp"

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/dynamic_schedule.hpp"
#include "base/stopping.hpp"
#include "exact/exact_distance.hpp"
#include "grid/coincident_points.hpp"
#include "kernels/tree_walk.hpp"
#include "search/crowded.hpp"
#include "search/k_nearest_search.hpp"
#include "search/shell_walk.hpp"
#include "tree/middle_of_shell.hpp"
#include "tree/nearest_list.hpp"
#include "tree/point_tree.hpp"
#include "tree/point_tree_order.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace beespace::search {

namespace {

constexpr std::size_t kAtOnce = 512;  // queries that one worker looks up

// The queries of one search, in the order of a tree of their own: each stands behind one of its
// neighbours, whose answer is a good guess.
class Queries {
 public:
  Queries(const PointsView& points, std::span<const PointId> asked, const core::Resources& with)
      : ids_(asked),
        size_(asked.empty() ? points.size() : asked.size()),
        places_(with.memory, size_) {
    for (std::size_t i = 0; i < size_; ++i) places_[i] = points[id_of(i)];
    const PointsView places(std::span<const Point>(places_.data(), size_));
    core::Buffer<core::TreeLeaf> leaves(with.memory, (size_ + core::kFanOut - 1) / core::kFanOut);
    core::Buffer<Point> slots(with.memory, size_);
    const core::Bounds bounds = *core::measure(places, with);
    order_ = core::point_tree_order(places, bounds, with, leaves, slots);
    const auto middle = [&](std::size_t axis) {
      return bounds.low[axis] + (bounds.high[axis] - bounds.low[axis]) / 2;
    };
    middle_ = {middle(0), middle(1), middle(2)};
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  // Of the box around all.
  [[nodiscard]] const Point& middle() const { return middle_; }
  [[nodiscard]] PointId id(std::size_t slot) const { return id_of(order_[slot]); }
  [[nodiscard]] const Point& place(std::size_t slot) const { return places_[order_[slot]]; }

 private:
  [[nodiscard]] PointId id_of(std::size_t i) const {
    return ids_.empty() ? static_cast<PointId>(i) : ids_[i];
  }

  std::span<const PointId> ids_;
  std::size_t size_;
  core::Buffer<Point> places_;
  core::Buffer<std::uint32_t> order_;
  Point middle_;
};

// Of each place, the lowest id of the points there. Places are numbered in the order of these.
core::Buffer<PointId> lowest_ids(const core::CoincidentPoints& places, std::size_t points,
                                 core::Memory& memory) {
  core::Buffer<PointId> lowest(memory, places.size());
  for (std::size_t id = points; id-- > 0;) {
    lowest[places.place_of(static_cast<PointId>(id))] = static_cast<PointId>(id);
  }
  return lowest;
}

// Between two sets.
class TreeSearch {
 public:
  TreeSearch(const PointsView& others, const std::optional<PairOptions>& within,
             const core::Resources& with, const TuningOverrides& tuning)
      : others_(others),
        farthest_(within ? within->threshold_m * kMore : std::numeric_limits<double>::infinity()),
        tree_(others_, *core::measure(others_, with), with),
        set_(tuning.instruction_set),
        walks_(cpu::tree_walks(set_)) {}

  // Looks which way to find the others is the shorter one, in the middle of a shell or not, unless
  // it is chosen.
  void prepare(const Queries& queries, const core::Resources& with,
               TuningOverrides::Nearest chosen) {
    const bool forced = chosen == TuningOverrides::Nearest::kShells;
    const std::size_t boxes = forced ? 0 : leaves_looked_at(queries, with);
    if (!forced && boxes <= kManyLeaves * kDrawn) return;
    const Point middle =
        core::middle_of_shell(others_, queries.middle()).value_or(queries.middle());
    shells_.emplace(others_, middle, set_, with);
    if (!forced && 2 * leaves_looked_at(queries, with) > boxes) shells_.reset();
  }

  void answer(const Queries& queries, std::size_t begin, std::size_t end, core::Memory& memory,
              std::vector<Nearest>& nearest) const {
    core::NearestList list(&memory);
    Nearest found;  // of the query before
    for (std::size_t slot = begin; slot < end && !core::is_stopping(); ++slot) {
      find(queries.place(slot), list, found);
      nearest[queries.id(slot)] = found;
    }
  }

 private:
  static constexpr double kMore = 1.0 + 0x1p-48;  // distances are off by a few 2^-53
  // Of an even swarm, a query looks at some ten leaves.
  static constexpr std::size_t kDrawn = 32;
  static constexpr std::size_t kManyLeaves = 64;

  // Starts from what is near to a place nearby, and becomes what is near to this one.
  void find(const Point& place, core::NearestList& list, Nearest& found) const {
    double reach_m = farthest_;
    if (found.id != Nearest::kNone) {
      reach_m = std::min(reach_m, distance(place, others_[found.id]) * kMore);
    }
    list.start(place, 1, reach_m);
    if (shells_) {
      shells_->find_nearest(place, list);
    } else {
      walks_.find_nearest(tree_.view(), place, list);
    }
    if (list.write(&found) == 0) found = {};
  }

  // For some of the queries. The first of two is only there for the second to start from.
  [[nodiscard]] std::size_t leaves_looked_at(const Queries& queries,
                                             const core::Resources& with) const {
    if (queries.size() < 4 * kDrawn) return 0;
    core::NearestList list(&with.memory);
    std::size_t leaves = 0;
    for (std::size_t i = 0; i < kDrawn; ++i) {
      const std::size_t slot = queries.size() * i / kDrawn;
      Nearest found;
      find(queries.place(slot), list, found);
      const std::size_t before = list.leaves;
      find(queries.place(slot + 1), list, found);
      leaves += list.leaves - before;
    }
    return leaves;
  }

  const PointsView others_;
  double farthest_;
  core::PointTree tree_;
  cpu::InstructionSet set_;
  cpu::TreeWalks walks_;
  std::optional<ShellWalk> shells_;
};

void answer_all(const Queries& queries, const PointsView& others,
                const std::optional<PairOptions>& within, const core::Resources& with,
                const TuningOverrides& tuning, std::vector<Nearest>& nearest) {
  TreeSearch search(others, within, with, tuning);
  search.prepare(queries, with, tuning.nearest);
  cpu::schedule(with.crew, queries.size(), kAtOnce,
                [&](std::size_t begin, std::size_t end, unsigned worker) {
                  search.answer(queries, begin, end, with.memory.of(worker), nearest);
                });
}

// Where many of the others share their places, each place is looked at once.
void find_in_two_sets(const SearchDomain& domain, std::span<const PointId> asked,
                      const std::optional<PairOptions>& within, const core::Resources& with,
                      const TuningOverrides& tuning, std::vector<Nearest>& nearest) {
  const PointsView others = domain.original_others();
  const Queries queries(domain.original_points(), asked, with);
  if (!has_duplicates(domain, std::numeric_limits<double>::infinity())) {
    return answer_all(queries, others, within, with, tuning, nearest);
  }
  const core::CoincidentPoints places(others, with.memory);
  answer_all(queries, places.places(), within, with, tuning, nearest);
  const core::Buffer<PointId> lowest = lowest_ids(places, others.size(), with.memory);
  for (std::size_t slot = 0; slot < queries.size(); ++slot) {
    Nearest& found = nearest[queries.id(slot)];
    if (found.id != Nearest::kNone) found.id = lowest[found.id];
  }
}

void find_in_one_set(const PointsView& points, const core::Resources& with,
                     const TuningOverrides& tuning, std::vector<Nearest>& nearest) {
  core::Vector<core::NearestList> lists(&with.memory);
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    lists.emplace_back(&with.memory.of(worker));
  }
  NearestRows rows;
  rows.entries = std::move(nearest);
  find_k_nearest(points, *core::measure(points, with), 1, with, tuning, lists, rows);
  nearest = std::move(rows.entries);
}

}  // namespace

void find_nearest_in_tree(const SearchDomain& domain, std::span<const PointId> asked,
                          const std::optional<PairOptions>& within, const core::Resources& with,
                          const TuningOverrides& tuning, std::vector<Nearest>& nearest) {
  const PointsView points = domain.original_points();
  const PointsView others = domain.original_others();
  if (domain.has_others()) {
    find_in_two_sets(domain, asked, within, with, tuning, nearest);
  } else {
    find_in_one_set(points, with, tuning, nearest);
  }
  if (!within) return;
  const core::ProximityTest closer(within->threshold_m, within->inclusive);
  with.crew.split(points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t id = begin; id < end; ++id) {
      Nearest& found = nearest[id];
      if (found.id != Nearest::kNone && !closer(points[id], others[found.id])) found = {};
    }
  });
}

}  // namespace beespace::search
