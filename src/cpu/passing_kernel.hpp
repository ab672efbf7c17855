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
  float clearance;  // with its own radius
  float reach;      // the clearance and how far it gets itself
  PointId id;
};

// Others in the grid, and their moves.
struct Passers {
  Positions at;
  Moves moves;
};

// One bit for each of the next 16 others whose ball around all of its step meets the asker's.
inline std::uint32_t meeting_lanes(const Asker& asker, const Passers& others, std::uint32_t from) {
  const std::int32_t* const x = others.at.x + from;
  const std::int32_t* const y = others.at.y + from;
  const std::int32_t* const z = others.at.z + from;
  const float* const other_reach = others.moves.reach + from;
  std::uint32_t meeting = 0;
  for (std::uint32_t lane = 0; lane < kPassingLanes; ++lane) {
    const auto rx = static_cast<float>(x[lane] - asker.x);
    const auto ry = static_cast<float>(y[lane] - asker.y);
    const auto rz = static_cast<float>(z[lane] - asker.z);
    const float reach = asker.reach + other_reach[lane];
    const bool meets = rx * rx + ry * ry + rz * rz <= reach * reach;
    meeting |= meets ? 1U << lane : 0U;
  }
  return meeting;
}

// One bit for each of the next 16 others that may come closer than the clearance.
//
// Relative to the asking one, another is at r + w t for t from -1 to 1, closest at t = -(r w) / (w
// w) or at an end. The distance is taken of the difference of positions at that time, not by way of
// a polynomial, so that it is wrong by no more than positions and moves are: some 2^-21 of them.
inline std::uint32_t near_lanes(const Asker& asker, const Passers& others, std::uint32_t from) {
  const std::int32_t* const x = others.at.x + from;
  const std::int32_t* const y = others.at.y + from;
  const std::int32_t* const z = others.at.z + from;
  const float* const move_x = others.moves.x + from;
  const float* const move_y = others.moves.y + from;
  const float* const move_z = others.moves.z + from;
  const float* const radius = others.moves.radius + from;
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

// Collects from among the others [from, end), as far as their x is below end_x.
inline bool collect_from(const Passers& others, const Asker& asker, std::uint32_t from,
                         std::uint32_t end, std::int32_t end_x, PairSink& pairs) {
  for (; from < end && others.at.x[from] < end_x; from += kPassingLanes) {
    std::uint32_t near = meeting_lanes(asker, others, from);
    if (end - from < kPassingLanes) near &= (1U << (end - from)) - 1U;
    if (near == 0) continue;
    near &= near_lanes(asker, others, from);
    for (; near != 0; near &= near - 1U) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(near));
      pairs.first[pairs.size] = asker.id;
      pairs.second[pairs.size] = others.at.id[from + lane];
      ++pairs.size;
    }
    if (pairs.capacity - pairs.size < PairSink::kMostAtOnce && !pairs.make_room(pairs.context)) {
      return false;
    }
  }
  return true;
}

// Which sides of its row a point is within `near` units of.
inline unsigned sides_near(std::int32_t y, std::int32_t z, std::int32_t near, std::int32_t row) {
  const std::int32_t in_row_y = y & (row - 1);
  const std::int32_t in_row_z = z & (row - 1);
  return (in_row_y <= near ? kLowY : 0U) | (in_row_y >= row - near ? kHighY : 0U) |
         (in_row_z <= near ? kLowZ : 0U) | (in_row_z >= row - near ? kHighZ : 0U);
}

// How far apart in units, at most the reach of the sweep, the asker and those it may meet are; two
// more than they are for what is cut to whole units.
inline std::int32_t units_around(const Asker& asker, const Clearance& clearance,
                                 const Reach& reach) {
  const float units = asker.reach + clearance.farthest_other + 2.0F;
  return units < static_cast<float>(reach.units) ? static_cast<std::int32_t>(units) : reach.units;
}

inline bool sweep_passing(const Sweep& given, const Moves& asked, const Moves& other_moves,
                          const Clearance& clearance, PairSink& pairs) {
  // Copies, so that no store can be suspected of changing them.
  const Sweep sweep = given;
  const Passers others{sweep.others, other_moves};
  const Reach reach(sweep);
  const std::int32_t row = 1 << (sweep.fraction_bits + sweep.row_shift);
  std::uint32_t windows[9];
  for (unsigned k = 0; k < sweep.target_count; ++k) {
    windows[k] = window_start(others.at.x, sweep.targets[k].points,
                              reach.first_x(sweep.asked.x[sweep.points.begin]));
  }
  for (std::uint32_t i = sweep.points.begin; i < sweep.points.end; ++i) {
    const Asker asker{sweep.asked.x[i],
                      sweep.asked.y[i],
                      sweep.asked.z[i],
                      asked.x[i],
                      asked.y[i],
                      asked.z[i],
                      clearance.clearance + asked.radius[i],
                      clearance.clearance + asked.reach[i],
                      sweep.asked.id[i]};
    const std::int32_t around = units_around(asker, clearance, reach);
    const std::int32_t end_x = ((asker.x + around + 1) & reach.slice) - reach.slice;
    if (i + 1 < sweep.own.end && !collect_from(others, asker, i + 1, sweep.own.end, end_x, pairs)) {
      return false;
    }
    const unsigned sides = sides_near(asker.y, asker.z, around + 1, row);
    const std::int32_t first_x = reach.first_x(asker.x);
    const std::int32_t own_first_x = (asker.x - around - 1) & reach.slice;
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      const Target& target = sweep.targets[k];
      if ((target.sides & ~sides) != 0) continue;
      // Windows only move forward, so they begin where the farthest reach does; who reaches less
      // far passes over their beginning.
      std::uint32_t from = windows[k];
      while (from < target.points.end && others.at.x[from] < first_x) ++from;
      windows[k] = from;
      while (from + kPassingLanes < target.points.end &&
             others.at.x[from + kPassingLanes] < own_first_x) {
        from += kPassingLanes;
      }
      if (!collect_from(others, asker, from, target.points.end, end_x, pairs)) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace beespace::cpu
