// Places of a drone in the air that are said again and again, bit by bit, as a ground station does
// that goes on to write the last line when it hears nothing more. A drone that is lost so need not
// jump when it is heard again, as it does by frozen_places.hpp: it may hover, or fly slowly.
//
// In a simulation one hovers so. They are told apart by what that drone does in the air otherwise:
// - where it hovers, its places waver from record to record, and it stops at once from that, or
// - on the Earth, its height swings by centimetres as it goes level, and is still at once, or
// - it stops at once, and goes on twice as fast as it came and as it goes then.
// Of places that are repeated now and then anyway, as rounded ones are, nothing is told.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/problems/left_out.hpp"

#include <beespace/track.hpp>

#include <vector>

namespace beespace::io {

inline constexpr LeftOutReason kFrozenInAir = {
    "of drones that repeat a place exactly in the air, where their places change from record to "
    "record otherwise,",
    "where such a drone was is not known, as where the last place is said again after the link was "
    "lost"};

// All but the first fix at each such place; empty where there is none. Of all fixes of a drone, in
// the order of time, with heights; what is no more than 3 m above its lowest place is on the
// ground.
std::vector<bool> frozen_in_air(const std::vector<Fix>& fixes, Frame frame);

}  // namespace beespace::io
