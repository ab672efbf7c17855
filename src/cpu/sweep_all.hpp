// Runs a sweep kernel over a whole grid, shared by a crew.
#pragma once

#include <beespace/crew.hpp>
#include "core/exact_distance.hpp"
#include "core/sorted_grid.hpp"
#include "cpu/sweep.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::cpu {

// Sets at_risk[id] to 1 for every point of the grid that has another one of the grid within the
// test's threshold, which must be at most the reach of the grid's lattice. Other entries are left
// alone. Working memory: 1 byte a point, and 1 for
// each point of the layer behind a worker's part.
void sweep_all(const core::SortedGrid& grid, const PointsView& points,
               const core::ProximityTest& closer, double threshold, SweepKernel kernel,
               Crew& crew, std::uint8_t* at_risk);

}  // namespace beespace::cpu
