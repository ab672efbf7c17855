// What is behind beespace_movers.
#pragma once

#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_movers {
  beespace::c::Column<std::int64_t> ids;
  beespace::c::Column<double> positions;
  beespace::c::Column<double> velocities;
  beespace::c::Column<double> heard_s;
  beespace::c::Column<double> heard_at;
  beespace::c::Column<std::uint8_t> stale;
  beespace::c::Column<std::uint8_t> move;
  beespace::c::Column<double> unknown_s;

  void resize(std::size_t size);
};

namespace beespace::c {

// Both in ascending order of ids; silences are of some of the movers.
void write_movers(std::span<const LiveMover> movers, std::span<const Silence> silences,
                  beespace_movers& into);

}  // namespace beespace::c
