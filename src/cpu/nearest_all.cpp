#include "cpu/nearest_all.hpp"

#include "core/neighbour_rows.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::cpu {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// The nearest two that one worker has met, for its own points and for those that these reach.
struct Table {
  Table(Range noted_points, core::Memory& memory)
      : noted(noted_points),
        best(memory, noted.end - noted.begin + core::kPadding),
        second(memory, noted.end - noted.begin + core::kPadding),
        who(memory, noted.end - noted.begin + core::kPadding) {
    const std::size_t size = noted.end - noted.begin + core::kPadding;
    std::fill_n(best.data(), size, kFar);
    std::fill_n(second.data(), size, kFar);
    std::fill_n(who.data(), size, 0U);
  }

  void add(std::uint32_t place, float other_best, float other_second, std::uint32_t other_who) {
    if (other_best < best[place]) {
      second[place] = std::min(best[place], other_second);
      best[place] = other_best;
      who[place] = other_who;
    } else {
      second[place] = std::min(second[place], other_best);
    }
  }

  Range noted;
  core::Buffer<float> best;
  core::Buffer<float> second;
  core::Buffer<std::uint32_t> who;
};

using Tables = core::Vector<std::optional<Table>>;

// Distances in units are wrong by less than 2 (see SquaredLimits): beyond this squared distance
// nobody can be nearer than somebody at `squared`.
float not_surely_farther(float squared) {
  const float units = std::sqrt(squared) + 4.0F;
  return units * units * (1.0F + 0x1p-18F);
}

class NearestAll {
 public:
  NearestAll(const Question& question, const core::Resources& with)
      : question_(question), with_(with), tables_(with.crew.size(), &with.memory) {}

  void sweep() {
    const core::SortedGrid& grid = question_.asked.grid;
    with_.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      if (begin == end) return;
      const Range points{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
      RowSweeps rows(everything(), {nullptr, nullptr});
      const bool both = question_.by_itself();
      Table& table = tables_[worker].emplace(both ? rows.reach(points.begin, points.end) : points,
                                             with_.memory);
      const NearestTable into{table.best.data(), table.second.data(), table.who.data(),
                              table.noted.begin};
      const auto kernel = both ? question_.kernels.nearest : question_.kernels.nearest_asked;
      rows.for_each(points.begin, points.end, [&](const Sweep& sweep) {
        kernel(sweep, into);
        return true;
      });
    });
  }

  // A worker's points come with what the workers before it noted about them.
  void join() {
    for (std::size_t worker = 1; worker < tables_.size(); ++worker) {
      if (!tables_[worker]) continue;
      Table& mine = *tables_[worker];
      for (std::size_t before = 0; before < worker; ++before) {
        if (!tables_[before]) continue;
        const Table& earlier = *tables_[before];
        const std::uint32_t end = std::min(mine.noted.end, earlier.noted.end);
        for (std::uint32_t i = mine.noted.begin; i < end; ++i) {
          const std::uint32_t there = i - earlier.noted.begin;
          mine.add(i - mine.noted.begin, earlier.best[there], earlier.second[there],
                   earlier.who[there]);
        }
      }
    }
  }

  void write(PointId* nearest) {
    const core::SortedGrid& grid = question_.asked.grid;
    with_.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      if (begin == end) return;
      const Table& table = *tables_[worker];
      core::NeighbourRows around(grid, question_.others.grid);
      auto row = static_cast<std::size_t>(
          std::upper_bound(grid.row_begin.begin(), grid.row_begin.end(), begin) -
          grid.row_begin.begin() - 1);
      std::size_t selected = grid.rows();
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        const std::uint32_t place = i - table.noted.begin;
        PointId& result = nearest[grid.id[i]];
        if (table.best[place] == kFar) {
          result = Nearest::kNobody;
        } else if (table.second[place] > not_surely_farther(table.best[place])) [[likely]] {
          result = question_.others.grid.id[table.who[place]];
        } else {
          while (grid.row_begin[row + 1] <= i) ++row;
          if (row != selected) around.select(row);
          selected = row;
          result = exactly(around, i, not_surely_farther(table.best[place]));
        }
      }
    });
  }

 private:
  // The kernels for nearest ones have no limits: everybody they see counts, and surely so.
  [[nodiscard]] Question everything() const {
    return {question_.asked, question_.others,  question_.closer,
            {kFar, kFar},    question_.kernels, question_.same_set};
  }

  [[nodiscard]] PointId exactly(core::NeighbourRows& around, std::uint32_t i,
                                float farthest) const {
    const PointId asking = question_.asked.grid.id[i];
    const Point place = question_.asked.point(i);
    PointId best = Nearest::kNobody;
    around.any_near(i, farthest, [&](std::uint32_t j, float) {
      const PointId id = question_.others.grid.id[j];
      if (question_.same_set && id == asking) return false;
      if (best != Nearest::kNobody) {
        const int sign = core::compare_distances(place, question_.others.points[id], place,
                                                 question_.others.points[best]);
        if (sign > 0 || (sign == 0 && id > best)) return false;
      }
      best = id;
      return false;
    });
    return best;
  }

  const Question& question_;
  const core::Resources& with_;
  Tables tables_;
};

}  // namespace

void nearest_all(const Question& question, const core::Resources& with, PointId* nearest) {
  NearestAll all(question, with);
  all.sweep();
  if (question.by_itself()) all.join();
  all.write(nearest);
}

}  // namespace beespace::cpu
