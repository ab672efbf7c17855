// What must be said of how an input was read: units, vertical thresholds, ids.
#pragma once

#include "io/points/repeated_ids.hpp"
#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/unit_taken.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::analysis {

// "heights in ft: the header names it: 'alt_ft'".
std::string text_of(const io::UnitTaken& taken);

// "3 records have the id of another one before: the first is 'a', of data rows 0 and 5".
std::string text_of(const io::RepeatedIds& repeated);

// What heights are counted from; empty where that is not said.
std::string_view datum_text(io::HeightDatum datum);

// For those who see it: which units were taken, what is drawn the other way round, and how the
// vertical threshold is compared, where that is not in metres.
void note_units(const std::vector<io::UnitTaken>& units,
                const std::optional<io::StatedLength>& vertical, io::Unit height_unit,
                std::vector<std::string>& notes);

}  // namespace beespace::analysis
