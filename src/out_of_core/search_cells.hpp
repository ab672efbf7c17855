// One question of all points: cut, distribute, and search cell after cell.
#pragma once

#include "out_of_core/cell_walk.hpp"
#include "out_of_core/plan.hpp"
#include "out_of_core/stored_points.hpp"

#include <beespace/crew.hpp>
#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <string>

namespace beespace::out_of_core {

// Where and with what.
struct Workplace {
  const Plan& plan;
  const std::string& folder;
  Crew& crew;
  const std::function<void(const OutOfCoreProgress&)>& progress;  // may be empty
};

// The options are valid. Errors: those of the points, the files and the question; kStopped.
Status search_cells(StoredPoints& points, const SearchOptions& options, const Workplace& at,
                    CellQuestion& question, OutOfCoreFacts& facts);

}  // namespace beespace::out_of_core
