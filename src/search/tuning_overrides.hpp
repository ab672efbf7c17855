// Chosen from the data unless a test or a benchmark forces it.
#pragma once

#include "grid/cell_proof.hpp"
#include "grid/lattice.hpp"
#include "kernels/sweep.hpp"

#include <cstdint>
#include <optional>

namespace beespace::search {

struct TuningOverrides {
  // How points at risk are found in one swarm; between two, kBoxes or a sweep.
  enum class Method : std::uint8_t { kAutomatic, kSweep, kProveThenSweep, kProveThenLook, kBoxes };

  // Whether whole boxes of points are counted and joined at once, and pairs found row by row; or
  // pairs one by one.
  enum class Crowds : std::uint8_t { kAutomatic, kNever, kAlways };

  // Where the nearest are looked for: in grids of growing cells, in a tree, or in a tree what grids
  // would be too much work for; and there, between two sets, as if the others lay on a shell.
  enum class Nearest : std::uint8_t { kAutomatic, kGrids, kTree, kShells };

  Method method = Method::kAutomatic;
  Crowds crowds = Crowds::kAutomatic;
  // In crowds: how many pairs that floats leave open are decided one by one, for each point, before
  // boxes of doubles are asked. Ordinary crowds have few.
  std::uint64_t crowd_decisions = 2;
  Nearest nearest = Nearest::kAutomatic;
  core::CellTable cell_table = core::CellTable::kAutomatic;
  cpu::InstructionSet instruction_set = cpu::best_instruction_set();
  std::optional<unsigned> row_shift = {};  // lowered where positions do not have the bits
  std::uint64_t fold_beyond_cells = core::Lattice::kFoldBeyondCells;
};

}  // namespace beespace::search
