// What is behind beespace_guidance: columns that are read in place.
#pragma once

#include "c/advice/findings.hpp"
#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/guide.hpp>

#include <array>
#include <cstdint>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_guidance {
  std::int64_t tick = 0;
  beespace::c::Column<std::int64_t> agents;
  beespace::c::Column<std::int32_t> contracts;
  beespace::c::Column<std::int32_t> reasons;
  beespace::c::Column<std::uint8_t> certified;
  beespace::c::Column<std::uint8_t> keeps_apart;
  beespace::c::Column<std::uint8_t> clear_of_intruders;
  beespace::c::Column<std::int32_t> kinds;
  beespace::c::Column<std::uint8_t> commanded;
  beespace::c::Column<std::int32_t> branches;
  beespace::c::Column<double> positions;
  beespace::c::Column<double> velocities;
  beespace::c::Column<double> tubes_m;
  beespace::c::Column<double> deviations_m;
  std::array<beespace::c::Findings, 4> findings;  // by BEESPACE_TOO_CLOSE, ...
  std::vector<beespace_command> commands;
  beespace::Guidance given;  // of C++, whose memory is kept

  void clear();
  // All that was given.
  void write();

 private:
  void resize(std::size_t size);
};
