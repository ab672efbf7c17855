// How figures and files for maps tell how far two are apart: in metres, or in nautical miles and
// feet where those who made the input, or set the limits, speak so; horizontally and in height
// where both have a limit.
#pragma once

#include "report/facts.hpp"

#include <optional>
#include <string>

namespace beespace::report {

// A unit of an axis.
struct AxisUnit {
  double metres = 1.0;
  const char* name = "m";
};

// That of distances beside the threshold, and of heights beside the vertical one: of aviation
// nautical miles for a threshold of a mile and more, otherwise feet; elsewhere metres, and
// millimetres where so little is too close.
AxisUnit distance_unit(const SwarmFacts& swarm);
AxisUnit height_unit(const SwarmFacts& swarm);
// Of an axis of places that is so long: these, and where it is longer kilometres or miles.
AxisUnit axis_unit(const SwarmFacts& swarm, double length_m);

// A distance, or a difference in height: never as great as the limit where it is below it.
std::string distance_words(const SwarmFacts& swarm, double metres);
std::string height_words(const SwarmFacts& swarm, double metres);

// "57.3 m"; with a vertical threshold "3.19 NM across, 800 ft in height", where that is known. Of
// two that keep apart what rounding has made a little less than a limit is the limit.
std::string apart_words(const SwarmFacts& swarm, double metres, const std::optional<Apart>& apart,
                        bool keep_apart = false);
// Behind them, where one of the two stands.
const char* with_one_standing(const SwarmFacts& swarm);
// Of the closest two of which none does: "closest in the air".
const char* closest_of_moving(const SwarmFacts& swarm);
// The same for lists: with more digits; "3.19 NM, 800 ft".
std::string listed_apart(const SwarmFacts& swarm, double metres, const std::optional<Apart>& apart);

}  // namespace beespace::report
