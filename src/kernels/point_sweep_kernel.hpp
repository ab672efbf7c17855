// The sweep between two sets: one query point in all lanes, past the others around it.
//
// Included by the sweep_<instruction set>.cpp files only, through sweep_kernel.hpp; the rules of
// sweep_lanes.hpp hold. Right where few query points meet many others, and where a query that has
// its answer ends early.
#pragma once

#include "kernels/sweep_lanes.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

// A sink takes the near pairs: start(sweep, i) says whether point i is still worth comparing,
// take(seen, from) whether to go on with a row, finish(i) whether to go on at all.

template <class Lanes>
class MarkAsked {
 public:
  explicit MarkAsked(const Marks& marks) : marks_(marks) {}

  bool start(const Sweep&, std::uint32_t i) {
    asked_ = i;
    return marks_.asked[i - marks_.first_asked] == 0;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t) {
    if (seen.near == 0) return true;
    marks_.asked[asked_ - marks_.first_asked] = 1;
    return false;
  }
  bool finish(std::uint32_t) { return true; }

 private:
  Marks marks_;
  std::uint32_t asked_ = 0;
};

template <class Lanes>
class CountAsked {
 public:
  explicit CountAsked(const Counts& counts) : counts_(counts) {}

  bool start(const Sweep&, std::uint32_t) {
    count_ = 0;
    return true;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t) {
    count_ += static_cast<std::uint32_t>(__builtin_popcount(seen.near));
    return true;
  }
  bool finish(std::uint32_t i) {
    counts_.asked[i - counts_.first_asked] += count_;
    return true;
  }

 private:
  Counts counts_;
  std::uint32_t count_ = 0;
};

template <class Lanes>
class CollectAsked {
 public:
  explicit CollectAsked(PairSink& pairs) : pairs_(pairs) {}

  bool start(const Sweep& sweep, std::uint32_t i) {
    asked_ = sweep.asked.id[i];
    others_ = sweep.others.id;
    return true;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t from) {
    if (seen.near == 0 || !go_on_) return go_on_;
    Lanes::fill(pairs_.first + pairs_.size, asked_);
    Lanes::store(others_ + from, seen.near, pairs_.second + pairs_.size);
    pairs_.size += static_cast<std::uint32_t>(__builtin_popcount(seen.near));
    if (pairs_.capacity - pairs_.size >= PairSink::kMostAtOnce) [[likely]] {
      return true;
    }
    go_on_ = pairs_.make_room(pairs_.context);
    return go_on_;
  }
  bool finish(std::uint32_t) { return go_on_; }

 private:
  PairSink& pairs_;
  const PointId* others_ = nullptr;
  PointId asked_ = 0;
  bool go_on_ = true;
};

template <class Lanes>
class KeepNearestOfAsked {
 public:
  explicit KeepNearestOfAsked(const NearestTable& table) : table_(table) {}

  bool start(const Sweep& sweep, std::uint32_t i) {
    nearest_.clear();
    others_ = sweep.others.id;
    self_ = sweep.same_set ? sweep.asked.id[i] : kNone;
    return true;
  }
  bool take(typename Lanes::Seen seen, std::uint32_t from) {
    Lanes::leave_out(seen, others_ + from, self_);
    nearest_.add(seen, from);
    return true;
  }
  bool finish(std::uint32_t i) {
    const std::uint32_t place = i - table_.first_asked;
    nearest_.write(table_.best[place], table_.second[place], table_.who[place]);
    return true;
  }

 private:
  static constexpr PointId kNone = 0xFFFF'FFFFU;

  typename Lanes::Nearest nearest_;
  NearestTable table_;
  const PointId* others_ = nullptr;
  PointId self_ = kNone;
};

// Compares the selected point i with the points [from, end) that lie within its reach along x.
// Returns how many of those it has seen lie before that.
template <class Lanes, class Sink>
[[gnu::always_inline]] inline std::uint32_t scan(const Lanes& lanes, const Positions& at,
                                                 std::uint32_t i, std::uint32_t from,
                                                 std::uint32_t end, std::int32_t end_x, Sink& sink,
                                                 const Unsure& unsure) {
  std::uint32_t before = 0;
  while (from < end) {
    const std::uint32_t left = end - from;
    auto seen = lanes.look(at.x + from, at.y + from, at.z + from, left);
    before += static_cast<std::uint32_t>(__builtin_popcount(seen.before));
    if (seen.within != seen.near) [[unlikely]] {
      Lanes::add_near(seen, decided_near(
                                unsure, seen.within & ~seen.near, [i](unsigned) { return i; },
                                [from](unsigned lane) { return from + lane; }));
    }
    if (!sink.take(seen, from)) break;
    if (left <= Lanes::kLanes || at.x[from + Lanes::kLanes - 1] >= end_x) break;
    from += Lanes::kLanes;
  }
  return before;
}

// The sides of its row that a point lies beside.
inline unsigned sides_of(std::int32_t y, std::int32_t z, std::int32_t reach, std::int32_t row) {
  const std::int32_t in_y = y & (row - 1);
  const std::int32_t in_z = z & (row - 1);
  return (in_y < reach ? kLowY : 0U) | (in_y >= row - reach ? kHighY : 0U) |
         (in_z < reach ? kLowZ : 0U) | (in_z >= row - reach ? kHighZ : 0U);
}

// A sweep under way: where in each target the window of the next point starts, which only moves
// forward.
template <class Lanes>
struct Walk {
  // A copy of the sweep, so that no store can be suspected of changing it.
  explicit Walk(const Sweep& given) : lanes(given.limits), sweep(given), reach(given) {
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      window[k] = window_start(sweep.others.x, sweep.targets[k].points,
                               reach.first_x(sweep.asked.x[sweep.points.begin]));
    }
  }

  [[gnu::always_inline]] void select(std::uint32_t i) {
    const std::int32_t x = sweep.asked.x[i];
    lanes.select(x, sweep.asked.y[i], sweep.asked.z[i], reach.first_x(x));
  }
  template <class Sink>
  [[gnu::always_inline]] void look_into(unsigned k, std::uint32_t i, Sink& sink) {
    window[k] += scan(lanes, sweep.others, i, window[k], sweep.targets[k].points.end,
                      reach.end_x(sweep.asked.x[i]), sink, sweep.unsure);
  }

  Lanes lanes;
  const Sweep sweep;
  const Reach reach;
  std::uint32_t window[9];
};

template <class Lanes, class Sink>
[[gnu::always_inline]] inline bool sweep_points(const Sweep& given, Sink sink) {
  Walk<Lanes> walk(given);
  const Sweep& sweep = walk.sweep;
  const std::int32_t row_width = 1 << (sweep.fraction_bits + sweep.row_shift);
  for (std::uint32_t i = sweep.points.begin; i < sweep.points.end; ++i) {
    walk.select(i);
    if (!sink.start(sweep, i)) continue;
    const unsigned sides =
        sides_of(sweep.asked.y[i], sweep.asked.z[i], walk.reach.units, row_width);
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      if ((sweep.targets[k].sides & ~sides) == 0) walk.look_into(k, i, sink);
    }
    if (!sink.finish(i)) return false;
  }
  return true;
}

}  // namespace
}  // namespace beespace::cpu
