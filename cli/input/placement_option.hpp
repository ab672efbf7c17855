// --origin: where on the Earth positions in metres lie.
#pragma once

#include "cli/command_line/command.hpp"
#include "report/placement.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// "19.06,47.48,110,90": longitude, latitude, height and the heading of x.
Result<report::Placement> read_placement(const Typed& typed);

}  // namespace beespace::cli
