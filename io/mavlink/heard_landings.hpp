// Which places of a telemetry log are of drones that have landed, by their own word.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/mavlink/heard_place.hpp"
#include "io/mavlink/vehicle_landings.hpp"

#include <vector>

namespace beespace::io {

// Sets Heard::landed of those that are taken: by when they came, as what vehicles say of it has no
// other time.
void find_landed(const VehicleLandings& landings, Frame frame, std::vector<Heard>& heard);

}  // namespace beespace::io
