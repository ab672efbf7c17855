// What the values of options of `guide` mean that are no plain numbers.
#pragma once

#include "cli/command_line/command.hpp"

#include <beespace/advise.hpp>
#include <beespace/result.hpp>

#include <vector>

namespace beespace::cli {

// "0,0,1,10;0,0,-1,-120", or a file with such planes, one a line; directions of any length.
Result<std::vector<Fence>> read_fences(const Typed& typed);

}  // namespace beespace::cli
