// Names of the same bees in two files that call them otherwise: "Drone 3" of a show and "3" of a
// table, or "drone03_00000042" of a folder of logs.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace beespace::analysis {

// Of each of `names` which of `others` has the same number; nothing for those of which none has.
// The number of a name is the one that differs from name to name, where one alone does. Empty where
// that does not tell all names of one of both lists apart.
std::vector<std::optional<std::size_t>> match_by_numbers(std::span<const std::string> names,
                                                         std::span<const std::string> others);

}  // namespace beespace::analysis
