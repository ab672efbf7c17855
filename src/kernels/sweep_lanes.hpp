// The common part of the sweep kernels: the lanes that they are written over, and the reach.
//
// Included by the sweep_<instruction set>.cpp files only, through sweep_kernel.hpp. Those files are
// compiled for processors that the rest of the library must not require, so nothing here may be
// shared with other files: all is in an unnamed namespace, and no inline function of a library
// header is called.
//
// Each of them brings its own Lanes, for points that ask and others that they are compared with:
//   kLanes                          how many comparisons are made together
//   Words, Floats                   a word, a float in every lane
//   Lanes(limits)
//   select(x, y, z, bound_x)        one point that asks, in every lane, and a bound along x
//   select_block(x, y, z, reach, slice)  the next kLanes points, a lane each; the bound of each is
//                                   where its reach along x ends (see Reach)
//   look(x, y, z, count)            every lane with its own of the next kLanes points, of which the
//                                   first `count` count
//   meet(x, y, z, lanes)            one point with the lanes whose bits are set
//   squared(x, y, z)                the squared distances, in units, of one point to all lanes, or
//                                   of each lane to its own of the next kLanes points
//   reaching(x)                     the lanes left of whose bound its own of the next points is
//   without(squared, lane)          the same, but infinite in one lane
// look and meet return what was Seen, one bit a lane: near (surely), within (near or unsure),
// before (left of the bound; look only); and what else the Lanes remember. With that:
//   add_near(seen, lanes)           unsure ones that are near
//   meeting(squared, radii, others) the lanes whose distance is at most both radii; the others'
//                                   are a lane each, or one for all
//   leave_out(seen, ids, id)        the lane whose id is this one no longer counts
//   mark(marks, near)               marks[lane] = nonzero for every near lane
//   words(from), floats(from)       the next kLanes words, as such and as floats
//   store(ids, near, to)            writes the ids of the near lanes one after the other; kLanes
//                                   places may be written
//   fill(to, id)                    writes an id kLanes times
//   AtSides(limits)                 which of the next points lie within the reach of some sides of
//                                   their row: (y, z)
//   around(x, y, z, box, far)       which of the next points are at most so far from a box, by the
//                                   same arithmetic as squared, so that none is farther from the
//                                   box than from a point in it
//   pack(from, chosen, to)          writes the chosen ones of kLanes words, as store does
//   pack_numbers(first, chosen, to) the same of the numbers from `first` on
//   clear(words)                    writes kLanes zeros
//   Tally                           counts the near, lane by lane: add(seen), write(to)
//   Nearest                         keeps the nearest two, lane by lane: add(seen, from), whose
//                                   lanes that count met `from` and those behind it; add_one(
//                                   squared, who), of all; read, write_lanes; write, of all lanes
#pragma once

#include "kernels/sweep.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

constexpr float kInfinity = __builtin_inff();  // NOLINT(misc-definitions-in-headers)

// The reach, in units. A point within it is at most so far away along x, give or take a unit of
// rounding; windows begin and end with whole slices, whose points stand in any order.
struct Reach {
  explicit Reach(const Sweep& sweep)
      : units(sweep.reach_cells << sweep.fraction_bits), slice(-(1 << sweep.slice_bits)) {}

  [[nodiscard]] std::int32_t first_x(std::int32_t x) const { return (x - units - 1) & slice; }
  [[nodiscard]] std::int32_t end_x(std::int32_t x) const {
    return ((x + units + 1) & slice) - slice;
  }

  std::int32_t units;
  std::int32_t slice;
};

// Which of the open lanes are near; asked(lane) and met(lane) give the two points. It is told
// nothing else, so that what a sweep knows can stay in registers.
template <class Asked, class Met>
[[gnu::noinline]] unsigned decided_near(Unsure unsure, unsigned open, const Asked& asked,
                                        const Met& met) {
  unsigned near = 0;
  for (; open != 0; open &= open - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(open));
    if (unsure.decide(unsure.context, asked(lane), met(lane))) near |= 1U << lane;
  }
  return near;
}

// Within the reach of sides of a row, on two axes at once: how far a point is from the low side of
// its row is its place in it, and from the high side that place with all bits flipped, as the width
// of a row is a power of 2.
struct SideLimits {
  SideLimits(unsigned sides, std::int32_t reach, std::int32_t row_width)
      : in_row(row_width - 1),
        flip_y((sides & kHighY) != 0 ? in_row : 0),
        flip_z((sides & kHighZ) != 0 ? in_row : 0),
        reach_y((sides & (kLowY | kHighY)) != 0 ? reach : row_width),
        reach_z((sides & (kLowZ | kHighZ)) != 0 ? reach : row_width) {}

  std::int32_t in_row;
  std::int32_t flip_y;
  std::int32_t flip_z;
  std::int32_t reach_y;
  std::int32_t reach_z;
};

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

}  // namespace
}  // namespace beespace::cpu
