// Units as JSON: which were taken and why, and how the vertical threshold was compared.
#pragma once

#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// [{"of": "heights", "unit": "ft", "reason": "..."}]
std::string json_units(const std::vector<io::UnitTaken>& units);

// {"value": 1000, "unit": "ft", "compared_in": "ft"}, or null.
std::string json_vertical(const std::optional<io::StatedLength>& vertical, io::Unit height_unit);

}  // namespace beespace::cli
