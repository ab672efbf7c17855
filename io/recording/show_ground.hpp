// The time on the ground of drone shows: before take-off and after landing drones stand, as close
// to each other as their grid has them, and are compared with those that fly then.
#pragma once

#include "io/recording/recording.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

// What is said of so many drones: they stand for a while, or never take off.
std::string standing_note(std::uint64_t drones);
std::string grounded_note(std::uint64_t drones);

// Of tables of shows, as of shows that are curves: fixes at the same place on the ground are left
// out at the beginning and at the end, but for the last and the first of them; a drone that has no
// others stands all the time, if its table lasts as long as others fly. Nothing where all do. Says
// it in the notes.
void leave_ground_time_out(Recording& recording);

}  // namespace beespace::io
