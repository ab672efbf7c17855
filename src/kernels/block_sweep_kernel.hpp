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
//
// Comparing does not branch on whether a pair is near.
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
  std::uint32_t size = 0;
};

// The same sides as seen from the row beyond them.
constexpr unsigned opposite(unsigned sides) {
  return (sides & (kLowY | kLowZ)) << 1 | (sides & (kHighY | kHighZ)) >> 1;
}

// What becomes of near pairs is up to a Task. A block of its lanes asks from start to finish, which
// name the sorted places of the block: those from `i` on, or a list of `count`.
//   kForItself                    whether all points of a row ask it, each for itself
//   kMeasures                     whether it asks for distances, not for what is near
//   start(i), start(places, count)
//   beside(seen, i, j)            unless for itself: point i + lane has met point j + lane
//   around(seen, j)               if for itself: every lane has met point j of its own row
//   across(seen, j)               every lane has met point j across a seam
//   finish(i, count), finish(places, count)
// Those that take `seen` return whether to go on. One that measures is for itself, and has instead
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

  // asked(lane) and met(lane) give the two points.
  template <class Asked, class Met>
  [[gnu::noinline]] void decide_unsure(typename Lanes::Seen& seen, const Asked& asked,
                                       const Met& met) const {
    for (unsigned open = seen.within & ~seen.near; open != 0; open &= open - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(open));
      if (sweep_.unsure.decide(sweep_.unsure.context, asked(lane), met(lane))) {
        Lanes::add_near(seen, lane);
      }
    }
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
    for (std::uint32_t j = points.begin; j < points.end && at.x[j] < end_x; ++j) {
      const std::uint32_t lane_of_j = j - block.begin;
      const unsigned itself = lane_of_j < Lanes::kLanes ? 1U << lane_of_j : 0U;
      auto seen = lanes.meet(at.x[j], at.y[j], at.z[j], asking & ~itself);
      if (seen.within != seen.near) [[unlikely]] {
        decide_unsure(
            seen, [block](unsigned lane) { return block.begin + lane; },
            [j](unsigned) { return j; });
      }
      if (!task_.around(seen, j)) return false;
    }
    return true;
  }

  // The same for distances. Lanes behind the block are measured, too: nobody reads what they find.
  void measure_around(const Lanes& lanes, Range points, Range block, std::int32_t end_x) {
    const Positions at = sweep_.asked;
    const auto squared = [&](std::uint32_t j) { return lanes.squared(at.x[j], at.y[j], at.z[j]); };
    std::uint32_t j = points.begin;
    for (; j < block.begin; ++j) task_.measured(squared(j), j);
    for (; j < block.end; ++j) task_.measured(Lanes::without(squared(j), j - block.begin), j);
    for (; j < points.end && at.x[j] < end_x; ++j) task_.measured(squared(j), j);
  }

  bool meet_those_behind(Range part) {
    const Positions at = sweep_.asked;
    const std::uint32_t end = sweep_.own.end;
    Lanes lanes = lanes_;
    for (std::uint32_t i = part.begin; i < part.end; i += Lanes::kLanes) {
      const std::uint32_t count = least(part.end - i, Lanes::kLanes);
      lanes.select_block(at.x + i, at.y + i, at.z + i, reach_.units, reach_.slice);
      task_.start(i);
      for (std::uint32_t j = i + 1; j < end; ++j) {
        auto seen = lanes.look(at.x + j, at.y + j, at.z + j, least(count, end - j));
        if (seen.before == 0) break;  // no lane reaches so far
        if (seen.within != seen.near) [[unlikely]] {
          decide_unsure(
              seen, [i](unsigned lane) { return i + lane; },
              [j](unsigned lane) { return j + lane; });
        }
        if (!task_.beside(seen, i, j)) return false;
      }
      task_.finish(i, count);
    }
    return true;
  }

  void pack(const Positions& from, Range points, unsigned sides, Beside& to) const {
    std::uint32_t size = to.size;
    for (std::uint32_t i = points.begin; i < points.end; i += Lanes::kLanes) {
      const unsigned chosen =
          Lanes::at_sides(from.y + i, from.z + i, sides, reach_.units, row_width_, points.end - i);
      Lanes::pack(from.x + i, chosen, to.x + size);
      Lanes::pack(from.y + i, chosen, to.y + size);
      Lanes::pack(from.z + i, chosen, to.z + size);
      Lanes::pack_numbers(i, chosen, to.place + size);
      size += static_cast<std::uint32_t>(__builtin_popcount(chosen));
    }
    to.size = size;
  }

  bool meet_across(Range part, unsigned k) {
    const Target& target = sweep_.targets[k];
    mine_.size = 0;
    pack(sweep_.asked, part, target.sides, mine_);
    if (mine_.size == 0) return true;
    Lanes::clear(mine_.x + mine_.size);  // the last block reads so far
    Lanes::clear(mine_.y + mine_.size);
    Lanes::clear(mine_.z + mine_.size);
    const std::int32_t* const x = sweep_.others.x;
    const std::int32_t end = reach_.end_x(mine_.x[mine_.size - 1]);
    next_[k] = first_not_before(x, {next_[k], target.points.end}, reach_.first_x(mine_.x[0]));
    std::uint32_t j = next_[k];
    while (j < target.points.end && x[j] < end) {
      theirs_.size = 0;
      while (j < target.points.end && x[j] < end && theirs_.size < Beside::kMost) {
        const Range block{j, least(j + Lanes::kLanes, target.points.end)};
        pack(sweep_.others, block, opposite(target.sides), theirs_);
        j = block.end;
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
      task_.start(mine_.place + i, count);
      if constexpr (Task::kMeasures) {
        measure_beside(lanes, first, end);
      } else {
        if (!meet_beside(lanes, first, {i, i + count}, end)) return false;
      }
      task_.finish(mine_.place + i, count);
    }
    return true;
  }

  // The selected block meets the packed points beyond the seam from `first` on.
  bool meet_beside(const Lanes& lanes, std::uint32_t first, Range block, std::int32_t end_x) {
    for (std::uint32_t j = first; j < theirs_.size && theirs_.x[j] < end_x; ++j) {
      auto seen =
          lanes.meet(theirs_.x[j], theirs_.y[j], theirs_.z[j], all_of(block.end - block.begin));
      if (seen.within != seen.near) [[unlikely]] {
        decide_unsure(
            seen, [this, block](unsigned lane) { return mine_.place[block.begin + lane]; },
            [this, j](unsigned) { return theirs_.place[j]; });
      }
      if (!task_.across(seen, theirs_.place[j])) return false;
    }
    return true;
  }
  void measure_beside(const Lanes& lanes, std::uint32_t first, std::int32_t end_x) {
    for (std::uint32_t j = first; j < theirs_.size && theirs_.x[j] < end_x; ++j) {
      task_.measured(lanes.squared(theirs_.x[j], theirs_.y[j], theirs_.z[j]), theirs_.place[j]);
    }
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

template <class Lanes>
class MarkBoth {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  explicit MarkBoth(const Marks& marks) : marks_(marks) {}

  void start(std::uint32_t i) {
    near_ = 0;
    ahead_ = 0;
    first_ahead_ = i;
  }
  void start(const std::uint32_t*, std::uint32_t) { near_ = 0; }
  bool beside(const Seen& seen, std::uint32_t, std::uint32_t j) {
    if (j - first_ahead_ > kMostAhead) [[unlikely]] {
      mark_ahead();
      first_ahead_ = j;
    }
    ahead_ |= std::uint64_t{seen.near} << (j - first_ahead_);
    near_ |= seen.near;
    return true;
  }
  bool across(const Seen& seen, std::uint32_t j) {
    std::uint8_t& mark = marks_.others[j - marks_.first_other];
    mark = static_cast<std::uint8_t>(mark | (seen.near != 0 ? 1U : 0U));
    near_ |= seen.near;
    return true;
  }
  void finish(std::uint32_t i, std::uint32_t) {
    Lanes::mark(marks_.asked + (i - marks_.first_asked), near_);
    mark_ahead();
  }
  void finish(const std::uint32_t* places, std::uint32_t) {
    for (; near_ != 0; near_ &= near_ - 1) {
      marks_.asked[places[__builtin_ctz(near_)] - marks_.first_asked] = 1;
    }
  }

 private:
  static constexpr std::uint32_t kMostAhead = 64 - Lanes::kLanes;

  void mark_ahead() {
    std::uint8_t* marks = marks_.others + (first_ahead_ - marks_.first_other);
    for (; ahead_ != 0; ahead_ >>= Lanes::kLanes, marks += Lanes::kLanes) {
      Lanes::mark(marks, static_cast<unsigned>(ahead_ & ((1U << Lanes::kLanes) - 1)));
    }
  }

  Marks marks_;
  unsigned near_ = 0;
  // Points from the first of the block on that have met a near one, a bit each. To mark them at
  // every step would be to wait for the marks of the last step, which are a place beside.
  std::uint64_t ahead_ = 0;
  std::uint32_t first_ahead_ = 0;
};

template <class Lanes>
class CountBoth {
 public:
  // Adding to counts lane by lane would have to wait for what was just added a lane beside.
  static constexpr bool kForItself = true;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  explicit CountBoth(const Counts& counts) : counts_(counts) {}

  void start(std::uint32_t) { tally_.clear(); }
  void start(const std::uint32_t*, std::uint32_t) { tally_.clear(); }
  bool around(const Seen& seen, std::uint32_t) {
    tally_.add(seen);
    return true;
  }
  bool across(const Seen& seen, std::uint32_t j) {
    tally_.add(seen);
    counts_.others[j - counts_.first_other] +=
        static_cast<std::uint32_t>(__builtin_popcount(seen.near));
    return true;
  }
  void finish(std::uint32_t i, std::uint32_t count) {
    std::uint32_t sums[Lanes::kLanes];
    tally_.write(sums);
    std::uint32_t* const counts = counts_.asked + (i - counts_.first_asked);
    for (std::uint32_t lane = 0; lane < count; ++lane) counts[lane] += sums[lane];
  }
  void finish(const std::uint32_t* places, std::uint32_t count) {
    std::uint32_t sums[Lanes::kLanes];
    tally_.write(sums);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      counts_.asked[places[lane] - counts_.first_asked] += sums[lane];
    }
  }

 private:
  Counts counts_;
  typename Lanes::Tally tally_;
};

template <class Lanes>
class CollectOnce {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  CollectOnce(const Sweep& sweep, PairSink& pairs) : id_(sweep.asked.id), pairs_(pairs) {}

  void start(std::uint32_t) {}
  void start(const std::uint32_t* places, std::uint32_t count) {
    for (std::uint32_t lane = 0; lane < count; ++lane) asked_[lane] = id_[places[lane]];
  }
  bool beside(const Seen& seen, std::uint32_t i, std::uint32_t j) {
    Lanes::store(id_ + i, seen.near, pairs_.first + pairs_.size);
    Lanes::store(id_ + j, seen.near, pairs_.second + pairs_.size);
    return go_on_after(seen);
  }
  bool across(const Seen& seen, std::uint32_t j) {
    Lanes::store(asked_, seen.near, pairs_.first + pairs_.size);
    Lanes::fill(pairs_.second + pairs_.size, id_[j]);
    return go_on_after(seen);
  }
  void finish(std::uint32_t, std::uint32_t) {}
  void finish(const std::uint32_t*, std::uint32_t) {}

 private:
  bool go_on_after(const Seen& seen) {
    pairs_.size += static_cast<std::uint32_t>(__builtin_popcount(seen.near));
    if (pairs_.capacity - pairs_.size >= PairSink::kMostAtOnce) [[likely]] {
      return true;
    }
    return pairs_.make_room(pairs_.context);
  }

  const PointId* id_;
  PairSink& pairs_;
  PointId asked_[Lanes::kLanes];
};

// Of balls, each with a radius of its own.
template <class Lanes>
class CollectMeeting {
 public:
  static constexpr bool kForItself = false;
  static constexpr bool kMeasures = false;
  using Seen = typename Lanes::Seen;

  explicit CollectMeeting(const MeetingSink& meeting)
      : radius_(meeting.radius), pairs_(meeting.places) {}

  void start(std::uint32_t) {}
  void start(const std::uint32_t* places, std::uint32_t count) {
    asked_ = places;
    for (std::uint32_t lane = 0; lane < count; ++lane) asked_radius_[lane] = radius_[places[lane]];
  }
  bool beside(const Seen& seen, std::uint32_t i, std::uint32_t j) {
    const unsigned meeting = Lanes::meeting(seen, radius_ + i, radius_ + j);
    Lanes::pack_numbers(i, meeting, pairs_.first + pairs_.size);
    Lanes::pack_numbers(j, meeting, pairs_.second + pairs_.size);
    return go_on_after(meeting);
  }
  bool across(const Seen& seen, std::uint32_t j) {
    const unsigned meeting = Lanes::meeting(seen, asked_radius_, radius_[j]);
    Lanes::store(asked_, meeting, pairs_.first + pairs_.size);
    Lanes::fill(pairs_.second + pairs_.size, j);
    return go_on_after(meeting);
  }
  void finish(std::uint32_t, std::uint32_t) {}
  void finish(const std::uint32_t*, std::uint32_t) {}

 private:
  bool go_on_after(unsigned meeting) {
    pairs_.size += static_cast<std::uint32_t>(__builtin_popcount(meeting));
    if (pairs_.capacity - pairs_.size >= PairSink::kMostAtOnce) [[likely]] {
      return true;
    }
    return pairs_.make_room(pairs_.context);
  }

  const float* radius_;
  PairSink& pairs_;
  const std::uint32_t* asked_ = nullptr;
  float asked_radius_[Lanes::kLanes] = {};
};

template <class Lanes>
class KeepNearestOfAll {
 public:
  static constexpr bool kForItself = true;
  static constexpr bool kMeasures = true;

  explicit KeepNearestOfAll(const NearestTable& table) : table_(table) {}

  void start(std::uint32_t) { nearest_.clear(); }
  void start(const std::uint32_t* places, std::uint32_t count) {
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const std::uint32_t place = places[lane] - table_.first_asked;
      best_[lane] = table_.best[place];
      second_[lane] = table_.second[place];
      who_[lane] = table_.who[place];
    }
    nearest_.read(best_, second_, who_);
  }
  void measured(const typename Lanes::Squared& squared, std::uint32_t j) {
    nearest_.add_one(squared, j);
  }
  void finish(std::uint32_t i, std::uint32_t count) {
    nearest_.write_lanes(best_, second_, who_);
    const std::uint32_t first = i - table_.first_asked;
    for (std::uint32_t lane = 0; lane < count; ++lane) set(first + lane, lane);
  }
  void finish(const std::uint32_t* places, std::uint32_t count) {
    nearest_.write_lanes(best_, second_, who_);
    for (std::uint32_t lane = 0; lane < count; ++lane) set(places[lane] - table_.first_asked, lane);
  }

 private:
  void set(std::uint32_t place, std::uint32_t lane) {
    table_.best[place] = best_[lane];
    table_.second[place] = second_[lane];
    table_.who[place] = who_[lane];
  }

  typename Lanes::Nearest nearest_;
  NearestTable table_;
  float best_[Lanes::kLanes];
  float second_[Lanes::kLanes];
  std::uint32_t who_[Lanes::kLanes];
};

template <class Lanes, class Task>
[[gnu::always_inline]] inline bool sweep_blocks(const Sweep& sweep, Task task) {
  return BlockSweep<Lanes, Task>(sweep, task).run();
}

}  // namespace
}  // namespace beespace::cpu
