// Positions that may not be in metres, as the threshold shows.
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::analysis {

// A threshold in millimetres or less beside places, whose unit nothing names, that are spread so
// much farther: pixels of a picture, perhaps, of which none would come close. Errors:
// kInvalidArgument, with what to type.
std::optional<Error> doubt_of_scale(const io::Recording& recording,
                                    const std::optional<io::StatedLength>& threshold);

}  // namespace beespace::analysis
