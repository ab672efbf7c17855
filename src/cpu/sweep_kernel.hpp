// The sweep kernel: the algorithm, written once over lanes of points.
//
// Included by the sweep_<instruction set>.cpp files only; each brings its own Lanes. Those files
// are compiled for processors that the rest of the library must not require, so nothing here may
// be shared with other files: all is in an unnamed namespace, and no inline function of a library
// header is called.
//
// Lanes gives
//   kLanes                        how many points it looks at together
//   Lanes(limits)
//   select(x, y, z, first_x)      the point to compare with, and where its window along x starts
//   Found look(x, y, z, count)    compares it with the next kLanes points, of which `count` count
//   mark(marks, near_lanes)       marks[lane] = nonzero for every lane set
// where Found has one bit a lane: surely near, within (near or unsure), and before (left of the
// window).
#pragma once

#include "cpu/sweep.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

struct Marks {
  std::uint8_t* first;
  std::uint32_t first_point;

  [[nodiscard]] std::uint8_t* of(std::uint32_t point) const {
    return first + (point - first_point);
  }
};

// Compares the selected point i with the points [from, end) that lie within a cell of it along x.
// Returns how many of them at the start lie before that; `any_near` collects hits.
template <class Lanes>
[[gnu::always_inline]] inline std::uint32_t scan(const Lanes& lanes, const Positions& at,
                                                 std::uint32_t i, std::uint32_t from,
                                                 std::uint32_t end, std::int32_t end_x,
                                                 const Marks& marks, unsigned& any_near,
                                                 const Unsure& unsure) {
  std::uint32_t before = 0;
  while (from < end) {
    const std::uint32_t left = end - from;
    const auto found = lanes.look(at.x + from, at.y + from, at.z + from, left);
    Lanes::mark(marks.of(from), found.near);
    any_near |= found.near;
    before += static_cast<std::uint32_t>(__builtin_popcount(found.before));
    if (found.within != found.near) [[unlikely]] {
      const unsigned open = found.within & ~found.near;
      for (unsigned lane = 0; lane < Lanes::kLanes; ++lane) {
        if ((open >> lane & 1U) != 0) unsure.decide(unsure.context, i, from + lane);
      }
    }
    if (left <= Lanes::kLanes || at.x[from + Lanes::kLanes - 1] >= end_x) break;
    from += Lanes::kLanes;
  }
  return before;
}

template <class Lanes>
[[gnu::always_inline]] inline void sweep(const Positions& positions, const Neighbourhood& around,
                                         const Limits& limits, std::uint8_t* near_marks,
                                         std::uint32_t first_mark, const Unsure& unsure) {
  const Positions at = positions;
  const Neighbourhood hood = around;
  const Marks marks{near_marks, first_mark};
  const std::int32_t cell = 1 << at.fraction_bits;
  constexpr std::int32_t kEverywhere = 0x7FFF'FFFF;
  const bool own_is_whole = hood.own_end != hood.row.end;
  Lanes lanes(limits);

  // Where in each later row the window of the current point starts. Points of a row are in the
  // order of their cells along x, so windows only move forward.
  std::uint32_t window[4] = {hood.later[0].begin, hood.later[1].begin, hood.later[2].begin,
                             hood.later[3].begin};
  for (std::uint32_t i = hood.row.begin; i < hood.row.end; ++i) {
    const std::int32_t first_x = (at.x[i] & -cell) - cell;
    const std::int32_t end_x = first_x + 3 * cell;
    lanes.select(at.x[i], at.y[i], at.z[i], first_x);
    unsigned any_near = 0;
    (void)scan(lanes, at, i, i + 1, hood.own_end, own_is_whole ? kEverywhere : end_x, marks,
               any_near, unsure);
    (void)scan(lanes, at, i, hood.together.begin, hood.together.end, kEverywhere, marks, any_near,
               unsure);
    if (hood.later_count != 0) {
      for (unsigned k = 0; k < 4; ++k) {
        window[k] +=
            scan(lanes, at, i, window[k], hood.later[k].end, end_x, marks, any_near, unsure);
      }
    }
    Lanes::mark(marks.of(i), any_near != 0 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace beespace::cpu
