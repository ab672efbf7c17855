// What must stay free around an agent, as it is typed: sphere, ellipsoid:3, cylinder:3ft.
#pragma once

#include "cli/command_line/option_values.hpp"

#include <beespace/result.hpp>
#include <beespace/separation.hpp>

namespace beespace::cli {

inline constexpr const char* kShapes = "sphere|ellipsoid:FACTOR|cylinder:HALF_HEIGHT";

// Errors show all that was typed.
Result<Separation> read_shape(const Typed& typed);

}  // namespace beespace::cli
