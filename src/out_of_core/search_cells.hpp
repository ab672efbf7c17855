// One question of all points: cut, distribute, and search cell after cell.
#pragma once

#include "out_of_core/cell_walk.hpp"
#include "out_of_core/cut.hpp"
#include "out_of_core/plan.hpp"
#include "out_of_core/stored_points.hpp"

#include <beespace/crew.hpp>
#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <functional>
#include <stop_token>
#include <string>

namespace beespace::out_of_core {

// Where and with what.
struct Workplace {
  const Plan& plan;
  const std::string& folder;
  Crew& crew;
  const std::stop_token& stop;
  const std::function<void(const OutOfCoreProgress&)>& progress;  // may be empty
};

// The halos of a search with valid options, of points with heights apart from their positions, or
// without. Who is closer than the threshold is so along each axis; heights apart are no axis, and
// only take pairs away.
Reach reach_of(const SearchOptions& options, bool heights);

// Halos that are wide enough for the closest pair: as wide as that of a sample. Errors: those of
// the files; kStopped.
Result<Reach> reach_of_closest_pair(StoredPoints& points, const RunOptions& run,
                                    const Workplace& at);

// Halos that have the k nearest ones of most points. Errors: as reach_of_closest_pair().
Result<Reach> reach_of_nearest(StoredPoints& points, std::size_t k, const RunOptions& run,
                               const Workplace& at);

// Errors: those of the points, the files and the question; kStopped.
Status search_cells(StoredPoints& points, const Reach& reach, const Workplace& at,
                    CellQuestion& question, OutOfCoreFacts& facts);

}  // namespace beespace::out_of_core
