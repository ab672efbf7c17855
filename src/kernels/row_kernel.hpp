// One query point past others that stand in an order of their own, which its row keeps.
//
// Included by the sweep_<instruction set>.cpp files only, through sweep_kernel.hpp; the rules of
// sweep_lanes.hpp hold.
#pragma once

#include "kernels/sweep_lanes.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

template <class Lanes>
std::uint32_t pick_around(const Positions& from, std::uint32_t size, const PositionBox& given,
                          const Limits& limits, const PositionsOut& to) {
  const PositionBox box = given;  // a copy that no store can be suspected of changing
  const float far = limits.far;
  std::uint32_t picked = 0;
  for (std::uint32_t i = 0; i < size; i += Lanes::kLanes) {
    unsigned chosen = Lanes::around(from.x + i, from.y + i, from.z + i, box, far);
    const std::uint32_t left = size - i;
    if (left < Lanes::kLanes) chosen &= (1U << left) - 1;
    Lanes::pack(from.x + i, chosen, to.x + picked);
    Lanes::pack(from.y + i, chosen, to.y + picked);
    Lanes::pack(from.z + i, chosen, to.z + picked);
    Lanes::store(from.id + i, chosen, to.id + picked);
    picked += static_cast<std::uint32_t>(__builtin_popcount(chosen));
  }
  return picked;
}

// Calls take(near, from) for the points of the query's range, kLanes at a time.
template <class Lanes, class Take>
[[gnu::always_inline]] inline void look_along(const RowQuery& query, Take&& take) {
  Lanes lanes(query.limits);
  lanes.select(query.x, query.y, query.z, 0);
  const Positions at = query.others;
  const std::uint32_t end = query.range.end;
  for (std::uint32_t from = query.range.begin; from < end; from += Lanes::kLanes) {
    auto seen = lanes.look(at.x + from, at.y + from, at.z + from, end - from);
    if (seen.within != seen.near) [[unlikely]] {
      Lanes::add_near(seen, decided_near(
                                query.unsure, seen.within & ~seen.near,
                                [&query](unsigned) { return query.asked; },
                                [from](unsigned lane) { return from + lane; }));
    }
    take(seen.near, from);
  }
}

template <class Lanes>
std::uint32_t count_row(const RowQuery& query) {
  std::uint32_t count = 0;
  look_along<Lanes>(query, [&](unsigned near, std::uint32_t) {
    count += static_cast<std::uint32_t>(__builtin_popcount(near));
  });
  return count;
}

template <class Lanes>
std::uint32_t write_row(const RowQuery& query, PointId* ids) {
  const PointId* const others = query.others.id;
  std::uint32_t size = 0;
  look_along<Lanes>(query, [&](unsigned near, std::uint32_t from) {
    Lanes::store(others + from, near, ids + size);
    size += static_cast<std::uint32_t>(__builtin_popcount(near));
  });
  return size;
}

}  // namespace
}  // namespace beespace::cpu
