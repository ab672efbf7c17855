#include "search/cylinder_search.hpp"

#include "base/resize_for.hpp"
#include "cylinders/cylinder_pairs.hpp"
#include "cylinders/cylinder_tasks.hpp"
#include "exact/validate.hpp"
#include "search/group_search.hpp"
#include "search/pair_search.hpp"

#include <algorithm>

namespace beespace::search {

namespace {

constexpr auto kNothing = [] {};

core::CylinderSize size_of(const PairOptions& options) {
  return {options.threshold_m, *options.vertical_m};
}

bool have_heights(const PointsView& points, const PointsView* others) {
  return points.has_heights() || (others != nullptr && others->has_heights());
}

// A task that all workers share.
template <class Task>
struct Shared {
  Task* task;

  bool settled(core::CylinderNode a, core::CylinderNode b) { return task->settled(a, b); }
  void near_itself(core::CylinderNode a) { task->near_itself(a); }
  void near(core::CylinderNode a, core::CylinderNode b) { task->near(a, b); }
  void near(std::size_t i, std::size_t j) { task->near(i, j); }
  void looked_into(core::CylinderNode a) { task->looked_into(a); }
};

}  // namespace

CylinderSearch::CylinderSearch(const PointsView& points, const PointsView* others,
                               const PairOptions& options, const core::Resources& with,
                               const TuningOverrides& tuning)
    : points_(core::upright(points, have_heights(points, others))),
      options_(options),
      tests_{core::CylinderBoxTest(size_of(options)), core::CylinderTest(options)},
      with_(with),
      tuning_(tuning) {
  if (others != nullptr) others_ = core::upright(*others, have_heights(points, others));
}

bool CylinderSearch::is_empty() const {
  return others_ ? points_.size() == 0 || others_->size() == 0 : points_.size() < 2;
}

std::optional<core::CylinderRows> CylinderSearch::rows() const {
  if (others_ || is_empty() || tuning_.crowds == TuningOverrides::Crowds::kAlways) return {};
  const bool wanted = tuning_.crowds == TuningOverrides::Crowds::kNever;
  core::CylinderRows rows(points_, size_of(options_), wanted, with_);
  if (!rows.finished()) return {};
  return rows;
}

std::optional<CylinderSearch::Trees> CylinderSearch::trees() const {
  if (is_empty()) return {};
  const core::CylinderSize size = size_of(options_);
  std::optional<Trees> trees;
  trees.emplace(Trees{core::CylinderTree(points_, size, with_), std::nullopt});
  if (others_) trees->others.emplace(*others_, size, with_);
  return trees;
}

template <class TaskOf, class Between>
void CylinderSearch::join(const Trees& trees, const TaskOf& task_of, const Between& between) const {
  const auto join_axes = [&](auto axes) {
    constexpr std::size_t kAxes = decltype(axes)::value;
    if (trees.others) {
      core::join_both<kAxes>(trees.points, *trees.others, tests_, with_.crew, task_of);
    } else {
      core::join_itself<kAxes>(trees.points, tests_, with_.crew, task_of, between);
    }
  };
  if (points_.apart) return join_axes(std::integral_constant<std::size_t, 4>());
  join_axes(std::integral_constant<std::size_t, 3>());
}

template <class Near>
void CylinderSearch::for_each_near(const core::CylinderRows& rows, const Near& near) const {
  rows.for_each_near(tests_, with_.crew, [&](unsigned) { return EachNear<Near>{near}; });
}

Status CylinderSearch::find_at_risk(std::vector<PointId>& at_risk) const {
  at_risk.clear();
  Flags near(with_.memory, points_.size());  // by id
  if (const auto rows = this->rows()) {
    for_each_near(*rows, [&](std::size_t i, std::size_t j) {
      near.set(rows->index(i));
      near.set(rows->index(j));
    });
  } else if (const auto all = trees()) {
    const core::CylinderTree& tree = all->points;
    Marks marks(tree, others_.has_value(), with_.memory);
    join(
        *all, [&](unsigned) { return Shared<Marks>{&marks}; }, [&] { marks.settle_upward(); });
    for (std::size_t slot = 0; slot < tree.size(); ++slot) {
      if (marks[slot]) near.set(tree.index(slot));
    }
  }
  for (PointId id = 0; id < points_.size(); ++id) {
    if (near[id]) at_risk.push_back(id);
  }
  return std::monostate{};
}

Status CylinderSearch::count_neighbors(std::vector<std::uint32_t>& counts) const {
  counts.assign(points_.size(), 0);
  const bool one_worker = with_.crew.size() == 1;
  if (const auto rows = this->rows()) {
    for_each_near(*rows, [&](std::size_t i, std::size_t j) {
      add_shared(counts[rows->index(i)], 1, one_worker);
      add_shared(counts[rows->index(j)], 1, one_worker);
    });
    return std::monostate{};
  }
  const auto all = trees();
  if (!all) return std::monostate{};
  const core::CylinderTree& tree = all->points;
  Counts near(tree, all->second(), one_worker, with_.memory);
  join(
      *all, [&](unsigned) { return Shared<Counts>{&near}; }, kNothing);
  near.add_up();
  for (std::size_t slot = 0; slot < tree.size(); ++slot) counts[tree.index(slot)] = near[slot];
  return std::monostate{};
}

core::Vector<core::FoundPairs> CylinderSearch::collect(std::uint64_t most) const {
  core::Vector<core::FoundPairs> found(&with_.memory);
  found.reserve(with_.crew.size());
  for (unsigned worker = 0; worker < with_.crew.size(); ++worker) {
    found.emplace_back(with_.memory.of(worker));
  }
  PairsKept kept{most};
  if (const auto rows = this->rows()) {
    rows->for_each_near(tests_, with_.crew, [&](unsigned worker) {
      return RowPairs<KeepPairs>(*rows, kept, found[worker]);
    });
  } else if (const auto all = trees()) {
    join(
        *all,
        [&](unsigned worker) {
          return TreePairs<KeepPairs>(all->points, all->second(), kept, found[worker]);
        },
        kNothing);
  }
  return found;
}

Status CylinderSearch::find_pairs(PairAnswer& answer) const {
  const auto direction = others_ ? core::Direction::kAsFound : core::Direction::kAscending;
  return take_pairs(collect(options_.max_results), direction, points_.size(), options_.max_results,
                    with_, answer);
}

Status CylinderSearch::find_neighbors(PairAnswer& answer) const {
  const auto direction = others_ ? core::Direction::kAsFound : core::Direction::kBothWays;
  return take_pairs(collect(options_.max_results / (others_ ? 1 : 2)), direction, points_.size(),
                    options_.max_results, with_, answer);
}

Result<bool> CylinderSearch::visit_pairs(const PairVisitor& visit) const {
  Audience audience{visit};
  if (const auto rows = this->rows()) {
    rows->for_each_near(tests_, with_.crew,
                        [&](unsigned) { return RowPairs<ShowPairs>(*rows, audience); });
  } else if (const auto all = trees()) {
    join(
        *all, [&](unsigned) { return TreePairs<ShowPairs>(all->points, all->points, audience); },
        kNothing);
  }
  return !audience.gone;
}

Status CylinderSearch::find_groups(IdRows& groups) const {
  core::Buffer<std::uint32_t> root_of(with_.memory, points_.size());
  for (PointId id = 0; id < points_.size(); ++id) root_of[id] = id;
  if (const auto rows = this->rows()) {
    core::DisjointSets sets(with_.memory, static_cast<std::uint32_t>(rows->size()));
    for_each_near(*rows, [&](std::size_t i, std::size_t j) {
      sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    });
    for (std::uint32_t slot = 0; slot < rows->size(); ++slot) {
      root_of[rows->index(slot)] = sets.root(slot);
    }
  } else if (const auto all = trees()) {
    const core::CylinderTree& tree = all->points;
    Groups sets(tree, with_.memory);
    join(
        *all, [&](unsigned) { return Shared<Groups>{&sets}; }, [&] { sets.settle_upward(); });
    for (std::size_t slot = 0; slot < tree.size(); ++slot) {
      root_of[tree.index(slot)] = sets.root(slot);
    }
  }
  write_groups(root_of, points_.size(), with_, groups);
  return std::monostate{};
}

}  // namespace beespace::search
