// A closer look at the moves of two balls: do they pass closely within the step?
//
// In floats, and so with a margin: which are surely near, which surely far, and which must be
// decided by others.
#pragma once

#include "motion/passing/passing_search.hpp"

#include "grid/sorted_grid.hpp"

#include <beespace/point.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace beespace::motion {

// A ball in the units of a grid and on its axes: where it is in the middle of the step, and how it
// moves from there to the end. Half a cache line.
struct alignas(32) BallInGrid {
  std::int32_t x, y, z;
  PointId id;
  float move_x, move_y, move_z, radius;
};

// Some pairs of sorted places.
struct PlacePairs {
  const std::uint32_t* first;
  const std::uint32_t* second;
};

class PassCheck {
 public:
  static constexpr std::uint32_t kAtOnce = 4;

  // What is known of each: one bit a pair.
  struct Known {
    unsigned possible;      // not surely far
    unsigned near;          // surely
    unsigned known_before;  // surely near already when the step begins, which a step before knows
  };

  PassCheck(const core::SortedGrid& grid, const BallInGrid* balls, const Step& step)
      : balls_(balls),
        clearance_(static_cast<float>(step.clearance_m * grid.units_per_m + margin_in(grid))),
        near_squared_(squared_or_none(step.surely_m * grid.units_per_m - margin_in(grid))),
        before_squared_(step.follows_another ? near_squared_ : -1.0F) {}

  // Positions are cut to whole units, as in core::SquaredLimits; moves, and what is made of them
  // here, are wrong by some 2^-20 of a cell.
  static double margin_in(const core::SortedGrid& grid) {
    return 3.0 + std::ldexp(1.0, static_cast<int>(grid.fraction_bits) - 17);
  }

  [[nodiscard]] PointId id_of(std::uint32_t place) const { return balls_[place].id; }
  void prefetch(std::uint32_t place) const { __builtin_prefetch(balls_ + place); }

  // Of the next four pairs, whose balls around all of their step meet.
  //
  // Relative to the first, the second is at r + w t for t from -1 to 1, closest at t = -(r w) / (w
  // w) or at an end. The distance is taken of the difference of positions at that time, not by way
  // of a polynomial, so that it is wrong by no more than positions and moves are.
  [[nodiscard]] Known operator()(const PlacePairs& pairs) const {
    std::array<Floats, kAtOnce> r;
    std::array<Floats, kAtOnce> w;
    std::array<Floats, kAtOnce> sum;
    for (std::size_t lane = 0; lane < kAtOnce; ++lane) {
      const BallInGrid& a = balls_[pairs.first[lane]];
      const BallInGrid& b = balls_[pairs.second[lane]];
      r[lane] = __builtin_convertvector(load<Ints>(&b.x) - load<Ints>(&a.x), Floats);
      const Floats move_a = load<Floats>(&a.move_x);
      const Floats move_b = load<Floats>(&b.move_x);
      w[lane] = move_b - move_a;
      sum[lane] = move_b + move_a;
    }
    const auto [rx, ry, rz] = by_axis(r);
    const auto [wx, wy, wz] = by_axis(w);
    const Floats radii = Floats{sum[0][3], sum[1][3], sum[2][3], sum[3][3]};
    constexpr float kHardlyMoving = 1e-20F;  // a time of 0 / 0 is none
    const Floats speed_squared = wx * wx + wy * wy + wz * wz + kHardlyMoving;
    Floats t = -(rx * wx + ry * wy + rz * wz) / speed_squared;
    t = t < -1.0F ? Floats{} - 1.0F : t;
    t = t > 1.0F ? Floats{} + 1.0F : t;
    const Floats squared = squared_length(rx + wx * t, ry + wy * t, rz + wz * t);
    const Floats before = squared_length(rx - wx, ry - wy, rz - wz);
    const Floats clearance = radii + clearance_;
    return {bits(~(squared > clearance * clearance)), bits(squared < near_squared_),
            bits(before < before_squared_)};
  }

 private:
  using Floats [[gnu::vector_size(16)]] = float;
  using Ints [[gnu::vector_size(16)]] = std::int32_t;

  template <class Vector, class From>
  static Vector load(const From* from) {
    Vector loaded;
    std::memcpy(&loaded, from, sizeof loaded);
    return loaded;
  }

  // x, y and z of four vectors.
  static std::array<Floats, 3> by_axis(const std::array<Floats, kAtOnce>& v) {
    const Floats xy01 = __builtin_shufflevector(v[0], v[1], 0, 4, 1, 5);
    const Floats xy23 = __builtin_shufflevector(v[2], v[3], 0, 4, 1, 5);
    const Floats zr01 = __builtin_shufflevector(v[0], v[1], 2, 6, 3, 7);
    const Floats zr23 = __builtin_shufflevector(v[2], v[3], 2, 6, 3, 7);
    return {__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5),
            __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7),
            __builtin_shufflevector(zr01, zr23, 0, 1, 4, 5)};
  }

  static Floats squared_length(const Floats& x, const Floats& y, const Floats& z) {
    return x * x + y * y + z * z;
  }
  static unsigned bits(const Ints& mask) {
    return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
  }
  static float squared_or_none(double units) {
    return units > 0.0 ? static_cast<float>(units * units) : -1.0F;
  }

  const BallInGrid* balls_;
  float clearance_;
  float near_squared_;
  float before_squared_;
};

}  // namespace beespace::motion
