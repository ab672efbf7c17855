#include "search/group_search.hpp"

#include "core/disjoint_sets.hpp"
#include "cpu/join_groups.hpp"
#include "search/question_grids.hpp"

#include <algorithm>
#include <cstdint>

namespace beespace::search {

namespace {

constexpr std::uint32_t kNone = 0xFFFF'FFFFU;

// Writes groups of two or more in the order of their lowest member, members ascending: ids are
// gone through in order, and each goes to the end of its group.
void write_groups(core::DisjointSets& sets, const core::SortedGrid& grid,
                  const core::Resources& with, IdRows& groups) {
  const auto size = static_cast<std::uint32_t>(grid.size);
  core::Buffer<std::uint32_t> root_of(with.memory, size);  // by id
  core::Buffer<std::uint32_t> members(with.memory, size);  // by root
  std::fill_n(members.data(), size, 0U);
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t root = sets.root(i);
    root_of[grid.id[i]] = root;
    ++members[root];
  }
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
  core::Vector<std::uint64_t> next(groups.offsets.begin(), groups.offsets.end(), &with.memory);
  for (PointId id = 0; id < size; ++id) {
    const std::uint32_t group = group_of[root_of[id]];
    if (group != kNone) groups.ids[next[group]++] = id;
  }
}

}  // namespace

void find_conflict_groups(const Frame& frame, const SearchOptions& options,
                          const core::Resources& with, const Choices& choices, IdRows& groups) {
  const QuestionGrids grids(frame, options, with, choices);
  const cpu::Question question = grids.question();
  const core::SortedGrid& grid = question.asked.grid;
  core::DisjointSets sets(with.memory, static_cast<std::uint32_t>(grid.size));
  cpu::join_near(question, with, sets);
  write_groups(sets, grid, with, groups);
}

}  // namespace beespace::search
