// The sweep kernel, written once in vectors of kLanes lanes and compiled once an instruction set.
//
// Included by the sweep_<instruction set>.cpp files only. Those are compiled for processors that
// the rest of the library must not require, so nothing here may be shared with other files: all
// is in an unnamed namespace, and no inline function of a library header is called.
#pragma once

#include "cpu/sweep.hpp"

#include <cstdint>
#include <cstring>

namespace beespace::cpu {
namespace {

template <int kLanes>
struct Vectors {
  using Ints [[gnu::vector_size(kLanes * 4)]] = std::int32_t;
  using Floats [[gnu::vector_size(kLanes * 4)]] = float;
  using Bytes [[gnu::vector_size(kLanes)]] = std::int8_t;  // a mask: 0 or -1 a lane
};

template <int kLanes>
class Sweep {
  using Ints = typename Vectors<kLanes>::Ints;
  using Floats = typename Vectors<kLanes>::Floats;
  using Bytes = typename Vectors<kLanes>::Bytes;

 public:
  Sweep(const Positions& positions, const Limits& limits, std::uint8_t* near_marks,
        std::uint32_t first_mark, const Unsure& unsure)
      : at_(positions),
        limits_(limits),
        marks_(near_marks),
        first_mark_(first_mark),
        unsure_(unsure) {
    for (int lane = 0; lane < kLanes; ++lane) lane_number_[lane] = lane;
  }

  void run(const Neighbourhood& hood) {
    // Where in each later row the window of the current point starts. Points of a row are in the
    // order of their cells along x, so windows only move forward.
    std::uint32_t window[4];
    for (unsigned k = 0; k < hood.later_count; ++k) window[k] = hood.later[k].begin;

    for (std::uint32_t i = hood.row.begin; i < hood.row.end; ++i) {
      select(i);
      (void)scan(i + 1, hood.row.end);
      for (unsigned k = 0; k < hood.later_count; ++k) {
        window[k] += scan(window[k], hood.later[k].end);
      }
      if (is_near_) marks_[i - first_mark_] = 0xFF;
    }
  }

 private:
  void select(std::uint32_t i) {
    i_ = i;
    is_near_ = false;
    const std::int32_t cell = at_.x[i] >> at_.fraction_bits;
    first_x_ = (cell - 1) * (1 << at_.fraction_bits);
    last_x_ = (cell + 2) * (1 << at_.fraction_bits);
  }

  // Compares point i with the points from `from` on that lie within a cell of it along x. Returns
  // how many points at the start lie before that.
  std::uint32_t scan(std::uint32_t from, std::uint32_t end) {
    std::uint32_t before = 0;
    while (from < end) {
      const Ints x = load(at_.x + from);
      const Ints in_row = lane_number_ < static_cast<std::int32_t>(end - from);
      const Floats dx = __builtin_convertvector(x - at_.x[i_], Floats);
      const Floats dy = __builtin_convertvector(load(at_.y + from) - at_.y[i_], Floats);
      const Floats dz = __builtin_convertvector(load(at_.z + from) - at_.z[i_], Floats);
      const Floats squared = dx * dx + dy * dy + dz * dz;
      mark(from, (squared < limits_.near) & in_row);
      const Ints open = (squared >= limits_.near) & (squared <= limits_.far) & in_row;
      if (any(open)) decide(from, open);
      before += count((x < first_x_) & in_row);
      if (end - from <= kLanes || at_.x[from + kLanes - 1] >= last_x_) break;
      from += kLanes;
    }
    return before;
  }

  void mark(std::uint32_t from, const Ints& near) {
    const Bytes bytes = __builtin_convertvector(near, Bytes);
    std::uint8_t* marks = marks_ + (from - first_mark_);
    Bytes old;
    std::memcpy(&old, marks, sizeof old);
    old |= bytes;
    std::memcpy(marks, &old, sizeof old);
    is_near_ |= any(near);
  }

  void decide(std::uint32_t from, const Ints& open) {
    for (int lane = 0; lane < kLanes; ++lane) {
      if (open[lane] != 0) {
        unsure_.decide(unsure_.context, i_, from + static_cast<std::uint32_t>(lane));
      }
    }
  }

  static Ints load(const std::int32_t* from) {
    Ints loaded;
    std::memcpy(&loaded, from, sizeof loaded);
    return loaded;
  }

  // A mask as bits, 8 a lane.
  struct Bits {
    static constexpr unsigned kWords = (kLanes + 7) / 8;
    std::uint64_t words[kWords];
  };
  static Bits bits(const Ints& mask) {
    const Bytes bytes = __builtin_convertvector(mask, Bytes);
    Bits packed{};
    std::memcpy(packed.words, &bytes, sizeof bytes);
    return packed;
  }
  static bool any(const Ints& mask) {
    const Bits packed = bits(mask);
    std::uint64_t all = 0;
    for (const std::uint64_t word : packed.words) all |= word;
    return all != 0;
  }
  static std::uint32_t count(const Ints& mask) {
    const Bits packed = bits(mask);
    int ones = 0;
    for (const std::uint64_t word : packed.words) ones += __builtin_popcountll(word);
    return static_cast<std::uint32_t>(ones / 8);
  }

  const Positions at_;
  const Limits limits_;
  std::uint8_t* const marks_;
  const std::uint32_t first_mark_;
  const Unsure unsure_;
  Ints lane_number_;
  std::uint32_t i_ = 0;
  bool is_near_ = false;
  std::int32_t first_x_ = 0;
  std::int32_t last_x_ = 0;
};

}  // namespace
}  // namespace beespace::cpu
