// Which format an output is in, by how its name ends.
#pragma once

#include <string>

namespace beespace::cli {

// "svg" of "out/Bees.SVG"; nothing where there is no ending.
std::string ending_of(const std::string& path);

}  // namespace beespace::cli
