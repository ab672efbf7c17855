// A scene in metres set down on the Earth, for globes and maps: distances stay what they are.
#pragma once

#include "analysis/scene/scene.hpp"
#include "report/placement.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::analysis {

// Of scenes that are no wider than this: farther out a plane is no picture of the ground.
inline constexpr double kFarthestPlaced_m = 100'000.0;

// "placed on the Earth at longitude 19.06, ...", with where x and y point.
std::string placement_text(const report::Placement& placement);

// Turns x and y into east and north along the ground, and z into heights. Errors:
// kInvalidArgument for scenes in degrees, kOutsideDomain for those that reach too far, or whose
// obstacles do, and those of to_ecef for the origin.
Status place_on_earth(Scene& scene, const report::Placement& placement);

}  // namespace beespace::analysis
