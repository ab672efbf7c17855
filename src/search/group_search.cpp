#include "search/group_search.hpp"

#include "base/disjoint_sets.hpp"
#include "grid/coincident_points.hpp"
#include "search/candidates.hpp"
#include "search/crowded.hpp"
#include "search/query_grids.hpp"
#include "sweep/box_questions.hpp"
#include "sweep/join_groups.hpp"
#include "tree/box_tree.hpp"
#include "tree/crowd_groups.hpp"
#include "tree/crowd_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace beespace::search {

namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFFU;

// Measured: from about this many others in a cube of the threshold on, boxes are joined faster than
// pairs.
constexpr double kCrowdedForGroups = 25.0;

using Roots = core::Buffer<std::uint32_t>;  // by id

void find_roots_in_grid(const SearchDomain& domain, const PairOptions& options,
                        const core::Resources& with, const TuningOverrides& tuning,
                        Roots& root_of) {
  const QueryGrids grids(domain, options, with, tuning);
  const cpu::SweepQuery question = grids.question();
  const core::SortedGrid& grid = question.asked.grid;
  core::DisjointSets sets(with.memory, static_cast<std::uint32_t>(grid.size));
  cpu::join_near(question, with, sets);
  with.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      root_of[grid.id[i]] = sets.root(static_cast<std::uint32_t>(i));
    }
  });
}

template <class Tree>
void write_roots(const Tree& tree, const core::Resources& with, core::DisjointSets& sets,
                 Roots& root_of) {
  with.crew.split(tree.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      root_of[tree.index(slot)] = sets.root(static_cast<std::uint32_t>(slot));
    }
  });
}

// For every one of `points` the slot that is the root of its set.
void find_roots_in_tree(const PointsView& points, const SearchDomain& domain,
                        const PairOptions& options, const core::Resources& with,
                        const TuningOverrides& tuning, Roots& root_of) {
  const core::Lattice lattice(domain.sets(), domain.bounds(), options.threshold_m, with.memory,
                              tuning.fold_beyond_cells);
  const core::CrowdTree tree(points, domain.bounds(), lattice, with);
  const core::ProximityTest closer(options.threshold_m, options.inclusive);
  core::DisjointSets sets(with.memory, static_cast<std::uint32_t>(tree.size()));
  if (core::join_crowds(tree, options.threshold_m, lattice.units_per_m(), closer,
                        tuning.crowd_decisions, with, sets)) {
    return write_roots(tree, with, sets, root_of);
  }
  const core::BoxTree boxes(points, with);
  core::DisjointSets of_boxes(with.memory, static_cast<std::uint32_t>(boxes.size()));
  cpu::join_in_boxes(boxes, {options.threshold_m, closer, tuning.instruction_set}, with, of_boxes);
  write_roots(boxes, with, of_boxes, root_of);
}

void find_roots(const SearchDomain& domain, const PairOptions& options, const core::Resources& with,
                const TuningOverrides& tuning, Roots& root_of) {
  if (!is_crowded(domain, options.threshold_m, kCrowdedForGroups, tuning)) {
    return find_roots_in_grid(domain, options, with, tuning, root_of);
  }
  if (!has_duplicates(domain, options.threshold_m)) {
    return find_roots_in_tree(domain.points(), domain, options, with, tuning, root_of);
  }
  const core::CoincidentPoints places(domain.points(), with.memory);
  Roots root_of_place(with.memory, places.size());
  find_roots_in_tree(places.places(), domain, options, with, tuning, root_of_place);
  for (PointId id = 0; id < domain.points().size(); ++id) {
    root_of[id] = root_of_place[places.place_of(id)];
  }
}

// What is no candidate is a set of its own.
void find_roots_among(const Candidates& candidates, std::size_t size, const PairOptions& options,
                      const core::Resources& with, const TuningOverrides& tuning, Roots& root_of) {
  Roots found(with.memory, candidates.size());
  if (candidates.size() > 0) {
    find_roots(candidates.domain(with), options, with, tuning, found);
  }
  auto alone = static_cast<std::uint32_t>(candidates.size());
  std::size_t next = 0;
  for (PointId id = 0; id < size; ++id) {
    const bool is_candidate = next < candidates.size() && candidates.id(next) == id;
    root_of[id] = is_candidate ? found[next++] : alone++;
  }
}

}  // namespace

void write_groups(const Roots& root_of, std::size_t size, const core::Resources& with,
                  IdRows& groups) {
  core::Buffer<std::uint32_t> members(with.memory, size);  // by root
  std::fill_n(members.data(), size, 0U);
  for (PointId id = 0; id < size; ++id) ++members[root_of[id]];
  core::Buffer<std::uint32_t> group_of(with.memory, size);  // by root
  std::fill_n(group_of.data(), size, kNone);
  groups.offsets.assign(1, 0);
  for (PointId id = 0; id < size; ++id) {
    const std::uint32_t root = root_of[id];
    if (members[root] < 2 || group_of[root] != kNone) continue;
    group_of[root] = static_cast<std::uint32_t>(groups.offsets.size() - 1);
    groups.offsets.push_back(groups.offsets.back() + members[root]);
  }
  groups.ids.resize(groups.offsets.back());
  if (groups.offsets.size() == 1) return groups.offsets.clear();  // no rows
  core::Vector<std::uint64_t> next(groups.offsets.begin(), groups.offsets.end(), &with.memory);
  for (PointId id = 0; id < size; ++id) {
    const std::uint32_t group = group_of[root_of[id]];
    if (group != kNone) groups.ids[next[group]++] = id;
  }
}

void find_conflict_groups(const SearchDomain& domain, const PairOptions& options,
                          const core::Resources& with, const TuningOverrides& tuning,
                          IdRows& groups) {
  const std::size_t size = domain.points().size();
  Roots root_of(with.memory, size);
  if (const auto candidates = Candidates::of(domain, options.threshold_m, with, tuning)) {
    find_roots_among(*candidates, size, options, with, tuning, root_of);
  } else {
    find_roots(domain, options, with, tuning, root_of);
  }
  write_groups(root_of, size, with, groups);
}

}  // namespace beespace::search
