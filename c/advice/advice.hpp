// What is behind beespace_advice: columns that are read in place.
#pragma once

#include "c/advice/findings.hpp"
#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/advise.hpp>
#include <beespace/mover.hpp>

#include <array>
#include <cstdint>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_advice {
  beespace::c::Column<double> velocities;
  beespace::c::Column<std::int32_t> kinds;
  beespace::c::Column<std::uint8_t> certified;
  beespace::c::Column<std::uint8_t> keeps_apart;
  beespace::c::Column<std::uint8_t> clear_of_intruders;
  beespace::c::Column<std::uint8_t> clear_of_unknown;
  beespace::c::Column<double> clear_of_unknown_s;
  std::array<beespace::c::Findings, 5> findings;  // by BEESPACE_TOO_CLOSE, ...
  std::vector<beespace::Refused> refused;

  void clear();
  void write(const beespace::Advised& advised, const beespace::MoversView& movers);
};

namespace beespace::c {

// C++ may number its kinds anew; C may not.
std::int32_t kind_of(AdviceKind kind);

}  // namespace beespace::c
