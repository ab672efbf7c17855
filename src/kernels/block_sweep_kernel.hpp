// The sweep of a swarm by itself: a lane for every query point.
//
// Included by the sweep_<instruction set>.cpp files only, through sweep_kernel.hpp; the rules of
// sweep_lanes.hpp hold. Where all points are queries, neighbours in the order are compared with
// nearly the same others. So a block of points queries together, and the others pass by:
//
//   in their own row    lane by lane: the points one place further on, then two, and so on, until
//                       these are beyond the reach of every lane. Or, where every point searches
//                       for itself, one by one.
//   across a seam       one by one: the points of the row beyond that lie beside the seam, past
//                       those that lie beside it on this side. Both are packed together first, so
//                       that no lane idles for the many in the middle of a wide row.
#pragma once

#include "kernels/sweep_lanes.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

// Points beside a seam, packed together.
struct Beside {
  static constexpr std::uint32_t kMost = 512;
  static constexpr std::uint32_t kRoom = kMost + 32;  // packing and reading go a block beyond

  std::int32_t x[kRoom];
  std::int32_t y[kRoom];
  std::int32_t z[kRoom];
  std::uint32_t place[kRoom];  // in the sorted order
  std::uint32_t word[kRoom];   // what the task knows of each, if anything
  std::uint32_t size = 0;
};

// The same sides as seen from the row beyond them.
constexpr unsigned opposite(unsigned sides) {
  return (sides & (kLowY | kLowZ)) << 1 | (sides & (kHighY | kHighZ)) >> 1;
}

// What becomes of near pairs is up to a Task (block_tasks.hpp), which is copied into each inner
// loop, so that what it knows stays in registers there. A block of its lanes asks from start to
// finish, which name the block: the sorted places from `i` on, or the packed points from `i` on.
//   kForItself                    whether all points of a row ask it, each for itself
//   kMeasures                     whether it asks for squared distances, not for what is near
//   words()                       a word for each sorted place, to be packed with it, or null
//   start(i), start(mine, i, count)
//   beside(seen, i, j)            unless for itself: point i + lane has met point j + lane
//   around(seen, j)               if for itself: every lane has met point j of its own row
//   across(seen, theirs, j)       every lane has met the packed point j across a seam
//   finish(i, count), finish(mine, i, count)
// Those that take `seen` return whether to go on. One that measures takes instead of `seen`
//   beside(squared, lanes, i, j), across(squared, lanes, theirs, j)   and those lanes that count;
//                                 or, if for itself,
//   measured(squared, j)          the squared distances of every lane to point j
template <class Lanes, class Task>
class BlockSweep {
 public:
  BlockSweep(const Sweep& given, Task& task)
      : sweep_(given),
        task_(task),
        lanes_(given.limits),
        reach_(given),
        row_width_(1 << (given.fraction_bits + given.row_shift)) {
    for (unsigned k = 0; k < sweep_.target_count; ++k) next_[k] = sweep_.targets[k].points.begin;
  }

  bool run() {
    std::uint32_t i = sweep_.points.begin;
    while (i < sweep_.points.end) {
      const Range part{i, least(i + Beside::kMost, sweep_.points.end)};
      if (!meet_own_row(part)) return false;
      for (unsigned k = 0; k < sweep_.target_count; ++k) {
        if (!meet_across(part, k)) return false;
      }
      i = part.end;
    }
    return true;
  }

 private:
  static std::uint32_t least(std::uint32_t a, std::uint32_t b) { return a < b ? a : b; }

  static unsigned all_of(std::uint32_t count) { return (1U << count) - 1U; }

  struct Places {
    std::uint32_t at[Lanes::kLanes];
  };
  static Places copy_of(const std::uint32_t* places) {
    Places copy;
    for (unsigned lane = 0; lane < Lanes::kLanes; ++lane) copy.at[lane] = places[lane];
    return copy;
  }

  bool meet_own_row(Range part) {
    if constexpr (Task::kForItself) {
      return ask_own_row(part);
    } else {
      return meet_those_behind(part);
    }
  }

  bool ask_own_row(Range part) {
    const Positions at = sweep_.asked;
    const Range own = sweep_.own;
    Lanes lanes = lanes_;
    std::uint32_t first = first_not_before(at.x, own, reach_.first_x(at.x[part.begin]));
    for (std::uint32_t i = part.begin; i < part.end; i += Lanes::kLanes) {
      const std::uint32_t count = least(part.end - i, Lanes::kLanes);
      const std::int32_t from = reach_.first_x(at.x[i]);
      const std::int32_t end = reach_.end_x(at.x[i + count - 1]);
      while (at.x[first] < from) ++first;
      lanes.select_block(at.x + i, at.y + i, at.z + i, reach_.units, reach_.slice);
      task_.start(i);
      if constexpr (Task::kMeasures) {
        measure_around(lanes, {first, own.end}, {i, i + count}, end);
      } else {
        if (!meet_around(lanes, {first, own.end}, {i, i + count}, end)) return false;
      }
      task_.finish(i, count);
    }
    return true;
  }

  // The selected block meets the points of its own row, up to those beyond the reach along x.
  bool meet_around(const Lanes& lanes, Range points, Range block, std::int32_t end_x) {
    const Positions at = sweep_.asked;
    const unsigned asking = all_of(block.end - block.begin);
    Task task = task_;
    bool go_on = true;
    for (std::uint32_t j = points.begin; go_on && j < points.end && at.x[j] < end_x; ++j) {
      const std::uint32_t lane_of_j = j - block.begin;
      const unsigned itself = lane_of_j < Lanes::kLanes ? 1U << lane_of_j : 0U;
      auto seen = lanes.meet(at.x[j], at.y[j], at.z[j], asking & ~itself);
      if (seen.within != seen.near) [[unlikely]] {
        Lanes::add_near(seen, decided_near(
                                  sweep_.unsure, seen.within & ~seen.near,
                                  [block](unsigned lane) { return block.begin + lane; },
                                  [j](unsigned) { return j; }));
      }
      go_on = task.around(seen, j);
    }
    task_ = task;
    return go_on;
  }

  // The same for distances. Lanes behind the block are measured, too: nobody reads what they find.
  void measure_around(const Lanes& lanes, Range points, Range block, std::int32_t end_x) {
    const Positions at = sweep_.asked;
    const auto squared = [&](std::uint32_t j) { return lanes.squared(at.x[j], at.y[j], at.z[j]); };
    Task task = task_;
    std::uint32_t j = points.begin;
    for (; j < block.begin; ++j) task.measured(squared(j), j);
    for (; j < block.end; ++j) task.measured(Lanes::without(squared(j), j - block.begin), j);
    for (; j < points.end && at.x[j] < end_x; ++j) task.measured(squared(j), j);
    task_ = task;
  }

  bool meet_those_behind(Range part) {
    const Positions at = sweep_.asked;
    Lanes lanes = lanes_;
    for (std::uint32_t i = part.begin; i < part.end; i += Lanes::kLanes) {
      const std::uint32_t count = least(part.end - i, Lanes::kLanes);
      lanes.select_block(at.x + i, at.y + i, at.z + i, reach_.units, reach_.slice);
      task_.start(i);
      if constexpr (Task::kMeasures) {
        if (!measure_behind(lanes, {i, i + count})) return false;
      } else {
        if (!meet_behind(lanes, {i, i + count})) return false;
      }
      task_.finish(i, count);
    }
    return true;
  }

  // Every lane of the selected block meets the points behind it, until no lane reaches so far.
  bool meet_behind(const Lanes& lanes, Range block) {
    const Positions at = sweep_.asked;
    const std::uint32_t i = block.begin;
    const std::uint32_t end = sweep_.own.end;
    Task task = task_;
    bool go_on = true;
    for (std::uint32_t j = i + 1; go_on && j < end; ++j) {
      auto seen = lanes.look(at.x + j, at.y + j, at.z + j, least(block.end - i, end - j));
      if (seen.before == 0) break;
      if (seen.within != seen.near) [[unlikely]] {
        Lanes::add_near(seen, decided_near(
                                  sweep_.unsure, seen.within & ~seen.near,
                                  [i](unsigned lane) { return i + lane; },
                                  [j](unsigned lane) { return j + lane; }));
      }
      go_on = task.beside(seen, i, j);
    }
    task_ = task;
    return go_on;
  }
  bool measure_behind(const Lanes& lanes, Range block) {
    const Positions at = sweep_.asked;
    const std::uint32_t i = block.begin;
    const std::uint32_t end = sweep_.own.end;
    Task task = task_;
    bool go_on = true;
    for (std::uint32_t j = i + 1; go_on && j < end; ++j) {
      const unsigned asking = all_of(least(block.end - i, end - j));
      if ((lanes.reaching(at.x + j) & asking) == 0) break;
      go_on = task.beside(lanes.squared(at.x + j, at.y + j, at.z + j), asking, i, j);
    }
    task_ = task;
    return go_on;
  }

  // Adds the points of a range at these sides of their row.
  void pack(Positions from, Range points, const typename Lanes::AtSides& at_sides,
            Beside& to) const {
    const auto* const words = task_.words();
    std::uint32_t size = to.size;
    for (std::uint32_t i = points.begin; i < points.end; i += Lanes::kLanes) {
      const unsigned chosen =
          at_sides(from.y + i, from.z + i) & all_of(least(points.end - i, Lanes::kLanes));
      Lanes::pack(from.x + i, chosen, to.x + size);
      Lanes::pack(from.y + i, chosen, to.y + size);
      Lanes::pack(from.z + i, chosen, to.z + size);
      Lanes::pack_numbers(i, chosen, to.place + size);
      if (words != nullptr) Lanes::pack(words + i, chosen, to.word + size);
      size += static_cast<std::uint32_t>(__builtin_popcount(chosen));
    }
    to.size = size;
  }

  bool meet_across(Range part, unsigned k) {
    using AtSides = typename Lanes::AtSides;
    const Target& target = sweep_.targets[k];
    mine_.size = 0;
    pack(sweep_.asked, part, AtSides({target.sides, reach_.units, row_width_}), mine_);
    if (mine_.size == 0) return true;
    Lanes::clear(mine_.x + mine_.size);  // the last block reads so far
    Lanes::clear(mine_.y + mine_.size);
    Lanes::clear(mine_.z + mine_.size);
    const std::int32_t* const x = sweep_.others.x;
    next_[k] = first_not_before(x, {next_[k], target.points.end}, reach_.first_x(mine_.x[0]));
    Range window{next_[k], target.points.end};
    const std::int32_t end = reach_.end_x(mine_.x[mine_.size - 1]);
    // Most often the rest of the row is within reach.
    if (window.begin < window.end && x[window.end - 1] >= end) {
      window.end = first_not_before(x, window, end);
    }
    const AtSides at_theirs({opposite(target.sides), reach_.units, row_width_});
    std::uint32_t j = window.begin;
    while (j < window.end) {
      theirs_.size = 0;
      while (j < window.end && theirs_.size < Beside::kMost) {
        const Range some{j, least(j + (Beside::kMost - theirs_.size), window.end)};
        pack(sweep_.others, some, at_theirs, theirs_);
        j = some.end;
      }
      if (!meet_packed()) return false;
    }
    return true;
  }

  // The first point of a range that is not before `x`; most likely one of its first.
  static std::uint32_t first_not_before(const std::int32_t* at, Range range, std::int32_t x) {
    for (std::uint32_t step = 4; step < range.end - range.begin; step *= 2) {
      if (at[range.begin + step] >= x) {
        range.end = range.begin + step;
        break;
      }
      range.begin += step;
    }
    return window_start(at, range, x);
  }

  bool meet_packed() {
    std::uint32_t first = 0;
    Lanes lanes = lanes_;
    for (std::uint32_t i = 0; i < mine_.size; i += Lanes::kLanes) {
      const std::uint32_t count = least(mine_.size - i, Lanes::kLanes);
      const std::int32_t from = reach_.first_x(mine_.x[i]);
      const std::int32_t end = reach_.end_x(mine_.x[i + count - 1]);
      while (first < theirs_.size && theirs_.x[first] < from) ++first;
      if (first == theirs_.size) return true;
      lanes.select_block(mine_.x + i, mine_.y + i, mine_.z + i, reach_.units, reach_.slice);
      task_.start(mine_, i, count);
      if constexpr (Task::kMeasures && Task::kForItself) {
        measure_beside(lanes, first, end);
      } else {
        if (!meet_beside(lanes, first, {i, i + count}, end)) return false;
      }
      task_.finish(mine_, i, count);
    }
    return true;
  }

  // The selected block meets the packed points beyond the seam from `first` on.
  bool meet_beside(const Lanes& lanes, std::uint32_t first, Range block, std::int32_t end_x) {
    const unsigned asking = all_of(block.end - block.begin);
    const std::uint32_t size = theirs_.size;
    Task task = task_;
    bool go_on = true;
    for (std::uint32_t j = first; go_on && j < size && theirs_.x[j] < end_x; ++j) {
      if constexpr (Task::kMeasures) {
        const auto squared = lanes.squared(theirs_.x[j], theirs_.y[j], theirs_.z[j]);
        go_on = task.across(squared, asking, theirs_, j);
      } else {
        auto seen = lanes.meet(theirs_.x[j], theirs_.y[j], theirs_.z[j], asking);
        if (seen.within != seen.near) [[unlikely]] {
          Lanes::add_near(seen, decided_near(
                                    sweep_.unsure, seen.within & ~seen.near,
                                    [asked = copy_of(mine_.place + block.begin)](unsigned lane) {
                                      return asked.at[lane];
                                    },
                                    [met = theirs_.place[j]](unsigned) { return met; }));
        }
        go_on = task.across(seen, theirs_, j);
      }
    }
    task_ = task;
    return go_on;
  }
  void measure_beside(const Lanes& lanes, std::uint32_t first, std::int32_t end_x) {
    const std::uint32_t size = theirs_.size;
    Task task = task_;
    for (std::uint32_t j = first; j < size && theirs_.x[j] < end_x; ++j) {
      task.measured(lanes.squared(theirs_.x[j], theirs_.y[j], theirs_.z[j]), theirs_.place[j]);
    }
    task_ = task;
  }

  const Sweep sweep_;
  Task& task_;
  const Lanes lanes_;
  const Reach reach_;
  const std::int32_t row_width_;
  std::uint32_t next_[9];  // where in each target the window of the next part starts
  Beside mine_;
  Beside theirs_;
};

template <class Lanes, class Task>
[[gnu::always_inline]] inline bool sweep_blocks(const Sweep& sweep, Task task) {
  return BlockSweep<Lanes, Task>(sweep, task).run();
}

}  // namespace
}  // namespace beespace::cpu
