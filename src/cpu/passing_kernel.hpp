// The kernel of passing.hpp: plain loops over 16 others at a time, which the compiler turns into
// the instructions of the set that the file is compiled for.
//
// Included by the passing_<instruction set>.cpp files only; the rule of sweep_lanes.hpp holds:
// everything is in an unnamed namespace, and no inline function of a library header is called.
#pragma once

#include "cpu/passing.hpp"
#include "cpu/sweep_lanes.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

constexpr std::uint32_t kPassingLanes = 16;  // NOLINT(misc-definitions-in-headers)

// The one who asks.
struct Asker {
  std::int32_t x, y, z;
  float move_x, move_y, move_z;
  float clearance;
};

// One bit for each of the next 16 others that may come closer than the clearance.
//
// Relative to the asking one, another is at r + w t for t from -1 to 1, closest at t = -(r w) / (w w)
// or at an end. The distance is taken of the difference of positions at that time, not by way of a
// polynomial, so that it is wrong by no more than positions and moves are: some 2^-21 of them.
inline std::uint32_t near_lanes(const Asker& asker, const Positions& others, const Moves& moves,
                                std::uint32_t from) {
  const std::int32_t* const x = others.x + from;
  const std::int32_t* const y = others.y + from;
  const std::int32_t* const z = others.z + from;
  const float* const move_x = moves.x + from;
  const float* const move_y = moves.y + from;
  const float* const move_z = moves.z + from;
  const float* const radius = moves.radius + from;
  std::uint32_t near = 0;
  for (std::uint32_t lane = 0; lane < kPassingLanes; ++lane) {
    const auto rx = static_cast<float>(x[lane] - asker.x);
    const auto ry = static_cast<float>(y[lane] - asker.y);
    const auto rz = static_cast<float>(z[lane] - asker.z);
    const float wx = move_x[lane] - asker.move_x;
    const float wy = move_y[lane] - asker.move_y;
    const float wz = move_z[lane] - asker.move_z;
    constexpr float kHardlyMoving = 1e-20F;  // a time of 0 / 0 is none
    const float squared_speed = wx * wx + wy * wy + wz * wz + kHardlyMoving;
    float t = -(rx * wx + ry * wy + rz * wz) / squared_speed;
    t = t < -1.0F ? -1.0F : t;
    t = t > 1.0F ? 1.0F : t;
    const float dx = rx + wx * t;
    const float dy = ry + wy * t;
    const float dz = rz + wz * t;
    const float clearance = asker.clearance + radius[lane];
    const bool is_near = dx * dx + dy * dy + dz * dz <= clearance * clearance;
    near |= is_near ? 1U << lane : 0U;
  }
  return near;
}

// Collects from among the others [from, end), as far as they lie within the reach of the asker.
inline bool collect_from(const Sweep& sweep, const Asker& asker, PointId id, const Moves& moves,
                         std::uint32_t from, std::uint32_t end, std::int32_t end_x,
                         PairSink& pairs) {
  for (; from < end && sweep.others.x[from] < end_x; from += kPassingLanes) {
    std::uint32_t near = near_lanes(asker, sweep.others, moves, from);
    if (end - from < kPassingLanes) near &= (1U << (end - from)) - 1U;
    for (; near != 0; near &= near - 1U) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(near));
      pairs.first[pairs.size] = id;
      pairs.second[pairs.size] = sweep.others.id[from + lane];
      ++pairs.size;
    }
    if (pairs.capacity - pairs.size < PairSink::kMostAtOnce && !pairs.make_room(pairs.context)) {
      return false;
    }
  }
  return true;
}

// Which sides of its row a point is within the reach of.
inline unsigned sides_of(const Sweep& sweep, const Reach& reach, std::int32_t y, std::int32_t z) {
  const std::int32_t row = 1 << (sweep.fraction_bits + sweep.row_shift);
  const std::int32_t in_row_y = y & (row - 1);
  const std::int32_t in_row_z = z & (row - 1);
  const std::int32_t near = reach.units + 1;
  return (in_row_y <= near ? kLowY : 0U) | (in_row_y >= row - near ? kHighY : 0U) |
         (in_row_z <= near ? kLowZ : 0U) | (in_row_z >= row - near ? kHighZ : 0U);
}

inline bool sweep_passing(const Sweep& sweep, const Moves& asked, const Moves& others,
                          float clearance, PairSink& pairs) {
  const Reach reach(sweep);
  const std::int32_t* const other_x = sweep.others.x;
  std::uint32_t windows[9];
  for (unsigned k = 0; k < sweep.target_count; ++k) {
    windows[k] = window_start(other_x, sweep.targets[k].points,
                              reach.first_x(sweep.asked.x[sweep.points.begin]));
  }
  for (std::uint32_t i = sweep.points.begin; i < sweep.points.end; ++i) {
    const Asker asker{sweep.asked.x[i], sweep.asked.y[i], sweep.asked.z[i],
                      asked.x[i],       asked.y[i],       asked.z[i],
                      clearance + asked.radius[i]};
    const PointId id = sweep.asked.id[i];
    const std::int32_t end_x = reach.end_x(asker.x);
    if (i + 1 < sweep.own.end &&
        !collect_from(sweep, asker, id, others, i + 1, sweep.own.end, end_x, pairs)) {
      return false;
    }
    const unsigned sides = sides_of(sweep, reach, asker.y, asker.z);
    const std::int32_t first_x = reach.first_x(asker.x);
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      const Target& target = sweep.targets[k];
      if ((target.sides & ~sides) != 0) continue;
      std::uint32_t from = windows[k];
      while (from < target.points.end && other_x[from] < first_x) ++from;
      windows[k] = from;
      if (!collect_from(sweep, asker, id, others, from, target.points.end, end_x, pairs)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace
}  // namespace beespace::cpu
