// How those who made an input speak of its heights.
#pragma once

#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/units.hpp"
#include "report/facts.hpp"

#include <optional>

namespace beespace::analysis {

// `unit` is that in which the input states them, `datum` what they are counted from.
report::HeightWords height_words(io::Unit unit, io::HeightDatum datum);

// Whether feet or nautical miles are the unit of the heights, or of what is too close.
bool speaks_of_feet(const report::HeightWords& heights, io::Unit threshold,
                    const std::optional<io::StatedLength>& vertical);

}  // namespace beespace::analysis
