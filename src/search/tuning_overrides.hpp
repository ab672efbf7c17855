// Chosen from the data unless a test or a benchmark forces it.
#pragma once

#include "grid/cell_proof.hpp"
#include "grid/lattice.hpp"
#include "kernels/sweep.hpp"

#include <cstdint>
#include <optional>

namespace beespace::search {

struct TuningOverrides {
  // How points at risk are found in one swarm.
  enum class Method : std::uint8_t { kAutomatic, kSweep, kProveThenSweep, kProveThenLook };

  // Whether whole boxes of points are counted and joined at once, and pairs found row by row; or
  // pairs one by one.
  enum class Crowds : std::uint8_t { kAutomatic, kNever, kAlways };

  Method method = Method::kAutomatic;
  Crowds crowds = Crowds::kAutomatic;
  core::CellTable cell_table = core::CellTable::kAutomatic;
  cpu::InstructionSet instruction_set = cpu::best_instruction_set();
  std::optional<unsigned> row_shift = {};  // lowered where positions do not have the bits
  std::uint64_t fold_beyond_cells = core::Lattice::kFoldBeyondCells;
};

}  // namespace beespace::search
