// Units as JSON: which were taken and why, and how the vertical threshold was compared.
#pragma once

#include "io/json/json_writer.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <optional>
#include <vector>

namespace beespace::cli {

// [{"of": "heights", "unit": "ft", "reason": "..."}]
void write_units(io::JsonWriter& json, const std::vector<io::UnitTaken>& units);

// {"value": 1000, "unit": "ft", "compared_in": "ft"}, or null.
void write_vertical(io::JsonWriter& json, const std::optional<io::StatedLength>& vertical,
                    io::Unit height_unit);

}  // namespace beespace::cli
