// What is behind beespace_events.
#pragma once

#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_events {
  beespace::c::Column<std::int32_t> kinds;
  beespace::c::Column<double> times_s;
  beespace::c::Column<std::int64_t> first;
  beespace::c::Column<std::int64_t> second;
  beespace::c::Column<double> distances_m;
  beespace::c::Column<double> closest_s;
  beespace::c::Column<double> since_s;
  beespace::c::Column<std::int64_t> left_out;
  beespace::c::Column<std::int32_t> bounds;

  void resize(std::size_t size);
};

namespace beespace::c {

void write_events(std::span<const SwarmEvent> from, beespace_events& into);

}  // namespace beespace::c
