// The sweep kernels: the algorithm, written once over lanes of points.
//
// Included by the sweep_<instruction set>.cpp files only; each brings its own Lanes. Those files
// are compiled for processors that the rest of the library must not require, so nothing here may
// be shared with other files: all is in an unnamed namespace, and no inline function of a library
// header is called.
//
// Lanes gives
//   kLanes                         how many points it looks at together
//   Lanes(limits)
//   select(x, y, z, first_x)       the point to compare with, and where its window along x starts
//   Seen look(x, y, z, count)      compares it with the next kLanes points, of which `count` count
//   mark(marks, seen)              marks[lane] = nonzero for every near lane
//   count(counts, seen)            counts[lane] += 1 for every near lane
//   store(ids, seen, to)           writes the ids of the near lanes one after the other; kLanes
//                                  places may be written
//   fill(to, id)                   writes an id kLanes times
//   leave_out(seen, ids, id)       the lane whose id is this one no longer counts
// where Seen has one bit a lane: near (surely), within (near or unsure), before (left of the
// window); and what else the Lanes remember. Nearest keeps, lane by lane, the nearest two:
//   add(seen, from)                takes the lanes that count, which are others from `from` on
//   write(best, second, who)       the nearest two of all lanes
#pragma once

#include "cpu/sweep.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

constexpr float kInfinity = __builtin_inff();  // NOLINT(misc-definitions-in-headers)

// What becomes of near pairs is up to a sink: start(sweep, i) says whether point i is still worth
// comparing, take(seen, from) whether to go on with a row, finish(i) whether to go on at all.

template <class Lanes>
class MarkBoth {
 public:
  explicit MarkBoth(const Marks& marks) : marks_(marks) {}

  bool start(const Sweep&, std::uint32_t) {
    any_ = 0;
    return true;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t from) {
    Lanes::mark(marks_.others + (from - marks_.first_other), seen);
    any_ |= seen.near;
    return true;
  }
  bool finish(std::uint32_t i) {
    std::uint8_t& mark = marks_.asked[i - marks_.first_asked];
    mark = static_cast<std::uint8_t>(mark | (any_ != 0 ? 1U : 0U));
    return true;
  }

 private:
  Marks marks_;
  unsigned any_ = 0;
};

template <class Lanes>
class MarkAsked {
 public:
  explicit MarkAsked(const Marks& marks) : marks_(marks) {}

  bool start(const Sweep&, std::uint32_t i) {
    asked_ = i;
    return marks_.asked[i - marks_.first_asked] == 0;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t) {
    if (seen.near != 0) marks_.asked[asked_ - marks_.first_asked] = 1;
    return marks_.asked[asked_ - marks_.first_asked] == 0;  // an unsure pair may have marked it too
  }
  bool finish(std::uint32_t) { return true; }

 private:
  Marks marks_;
  std::uint32_t asked_ = 0;
};

template <class Lanes, bool Both>
class Count {
 public:
  explicit Count(const Counts& counts) : counts_(counts) {}

  bool start(const Sweep&, std::uint32_t) {
    count_ = 0;
    return true;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t from) {
    if constexpr (Both) Lanes::count(counts_.others + (from - counts_.first_other), seen);
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
class Collect {
 public:
  explicit Collect(PairSink& pairs) : pairs_(pairs) {}

  bool start(const Sweep& sweep, std::uint32_t i) {
    asked_ = sweep.asked.id[i];
    others_ = sweep.others.id;
    return true;
  }
  bool take(const typename Lanes::Seen& seen, std::uint32_t from) {
    if (seen.near == 0 || !go_on_) return go_on_;
    Lanes::fill(pairs_.first + pairs_.size, asked_);
    Lanes::store(others_ + from, seen, pairs_.second + pairs_.size);
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
class KeepNearest {
 public:
  explicit KeepNearest(const NearestTable& table) : table_(table) {}

  bool start(const Sweep& sweep, std::uint32_t i) {
    nearest_.clear();
    others_ = sweep.others.id;
    self_ = sweep.same_set ? sweep.asked.id[i] : kNobody;
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
  static constexpr PointId kNobody = 0xFFFF'FFFFU;

  typename Lanes::Nearest nearest_;
  NearestTable table_;
  const PointId* others_ = nullptr;
  PointId self_ = kNobody;
};

template <class Lanes>
[[gnu::noinline]] void decide_unsure(const Unsure& unsure, std::uint32_t i, std::uint32_t from,
                                     unsigned open) {
  for (unsigned lane = 0; lane < Lanes::kLanes; ++lane) {
    if ((open >> lane & 1U) != 0) unsure.decide(unsure.context, i, from + lane);
  }
}

// Compares the selected point i with the points [from, end) that lie within a cell of it along x.
// Returns how many of those it has seen lie before that.
template <class Lanes, class Sink>
[[gnu::always_inline]] inline std::uint32_t scan(const Lanes& lanes, const Positions& at,
                                                 std::uint32_t i, std::uint32_t from,
                                                 std::uint32_t end, std::int32_t end_x, Sink& sink,
                                                 const Unsure& unsure) {
  std::uint32_t before = 0;
  while (from < end) {
    const std::uint32_t left = end - from;
    const auto seen = lanes.look(at.x + from, at.y + from, at.z + from, left);
    before += static_cast<std::uint32_t>(__builtin_popcount(seen.before));
    if (seen.within != seen.near) [[unlikely]] {
      decide_unsure<Lanes>(unsure, i, from, seen.within & ~seen.near);
    }
    if (!sink.take(seen, from)) break;
    if (left <= Lanes::kLanes || at.x[from + Lanes::kLanes - 1] >= end_x) break;
    from += Lanes::kLanes;
  }
  return before;
}

// The first point of a range whose slice is not before `first_x`.
inline std::uint32_t window_start(const std::int32_t* x, Range range, std::int32_t first_x) {
  while (range.begin < range.end) {
    const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
    if (x[middle] < first_x) {
      range.begin = middle + 1;
    } else {
      range.end = middle;
    }
  }
  return range.begin;
}

// The sides of its row that the cell of a point lies at.
inline unsigned sides_of(std::int32_t y, std::int32_t z, unsigned fraction_bits,
                         unsigned row_shift) {
  const unsigned last = (1U << row_shift) - 1U;
  const unsigned in_y = static_cast<unsigned>(y) >> fraction_bits & last;
  const unsigned in_z = static_cast<unsigned>(z) >> fraction_bits & last;
  return (in_y == 0 ? kLowY : 0U) | (in_y == last ? kHighY : 0U) | (in_z == 0 ? kLowZ : 0U) |
         (in_z == last ? kHighZ : 0U);
}

// A sweep under way: where in each target the window of the next point starts, which only moves
// forward.
template <class Lanes>
struct Walk {
  // A copy of the sweep, so that no store can be suspected of changing it.
  explicit Walk(const Sweep& given)
      : lanes(given.limits),
        sweep(given),
        cell(1 << sweep.fraction_bits),
        slice(-(1 << sweep.slice_bits)) {
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      window[k] =
          window_start(sweep.others.x, sweep.targets[k].points, first_x_of(sweep.points.begin));
    }
  }

  // Whoever is within the reach is at most a cell away along x, give or take a unit of rounding;
  // windows begin and end with whole slices, whose points stand in any order.
  [[nodiscard]] std::int32_t first_x_of(std::uint32_t i) const {
    return (sweep.asked.x[i] - cell - 1) & slice;
  }
  [[nodiscard]] std::int32_t end_x_of(std::uint32_t i) const {
    return ((sweep.asked.x[i] + cell + 1) & slice) - slice;
  }
  [[gnu::always_inline]] void select(std::uint32_t i) {
    lanes.select(sweep.asked.x[i], sweep.asked.y[i], sweep.asked.z[i], first_x_of(i));
  }
  template <class Sink>
  [[gnu::always_inline]] void look_behind(std::uint32_t i, Sink& sink) {
    (void)scan(lanes, sweep.others, i, i + 1, sweep.own_end, end_x_of(i), sink, sweep.unsure);
  }
  template <class Sink>
  [[gnu::always_inline]] void look_into(unsigned k, std::uint32_t i, Sink& sink) {
    window[k] += scan(lanes, sweep.others, i, window[k], sweep.targets[k].points.end, end_x_of(i),
                      sink, sweep.unsure);
  }

  Lanes lanes;
  const Sweep sweep;
  std::uint32_t window[9];
  const std::int32_t cell;
  const std::int32_t slice;
};

template <class Lanes, class Sink>
[[gnu::always_inline]] inline bool sweep_row(const Sweep& given, Sink sink) {
  Walk<Lanes> walk(given);
  const Sweep& sweep = walk.sweep;
  for (std::uint32_t i = sweep.points.begin; i < sweep.points.end; ++i) {
    walk.select(i);
    if (!sink.start(sweep, i)) continue;
    walk.look_behind(i, sink);
    const unsigned sides =
        sides_of(sweep.asked.y[i], sweep.asked.z[i], sweep.fraction_bits, sweep.row_shift);
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      if ((sweep.targets[k].sides & ~sides) == 0) walk.look_into(k, i, sink);
    }
    if (!sink.finish(i)) return false;
  }
  return true;
}

template <class Lanes>
constexpr Kernels kernels_over() {
  return {
      [](const Sweep& sweep, const Marks& marks) {
        (void)sweep_row<Lanes>(sweep, MarkBoth<Lanes>(marks));
      },
      [](const Sweep& sweep, const Marks& marks) {
        (void)sweep_row<Lanes>(sweep, MarkAsked<Lanes>(marks));
      },
      [](const Sweep& sweep, const Counts& counts) {
        (void)sweep_row<Lanes>(sweep, Count<Lanes, true>(counts));
      },
      [](const Sweep& sweep, const Counts& counts) {
        (void)sweep_row<Lanes>(sweep, Count<Lanes, false>(counts));
      },
      [](const Sweep& sweep, PairSink& pairs) {
        return sweep_row<Lanes>(sweep, Collect<Lanes>(pairs));
      },
      [](const Sweep& sweep, const NearestTable& nearest) {
        (void)sweep_row<Lanes>(sweep, KeepNearest<Lanes>(nearest));
      },
  };
}

}  // namespace
}  // namespace beespace::cpu
