// The at-risk search behind find_at_risk, with its choices open to tests and benchmarks.
//
//   points --> crowded? --yes--> prove by cells --> rest? --few--> look around each of them
//                  |                                  |
//                  no                                many
//                  v                                  v
//              sort into a grid --> sweep all pairs of adjacent cells --> ids, ascending
#pragma once

#include "core/bounds.hpp"
#include "core/cell_proof.hpp"
#include <beespace/crew.hpp>
#include "core/lattice.hpp"
#include "core/sorted_grid.hpp"
#include "cpu/sweep.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

// What is chosen from the data unless a test or a benchmark forces it.
struct Choices {
  enum class Method : std::uint8_t { kAutomatic, kSweep, kProveThenSweep, kProveThenLook };

  Method method = Method::kAutomatic;
  core::CellTable cell_table = core::CellTable::kAutomatic;
  cpu::InstructionSet instruction_set = cpu::best_instruction_set();
  std::uint64_t fold_beyond_cells = core::Lattice::kFoldBeyondCells;
};

// `points` and `options` must be valid and `bounds` those of the points.
std::vector<PointId> at_risk_ids(const PointsView& points, const core::Bounds& bounds,
                                 const SearchOptions& options, Crew& crew,
                                 const Choices& choices = {});

}  // namespace beespace::search
