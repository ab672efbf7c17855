// How those who made an input speak of its heights.
#pragma once

#include "io/units/heights.hpp"
#include "io/units/units.hpp"
#include "report/facts.hpp"

namespace beespace::analysis {

// `unit` is that in which the input states them, `datum` what they are counted from.
report::HeightWords height_words(io::Unit unit, io::HeightDatum datum);

}  // namespace beespace::analysis
