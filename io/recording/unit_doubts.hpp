// Times in another unit than the header says, as "time[ms]" over microseconds, and positions in
// another one than is usual: the speeds that follow show it. What is doubtful is asked.
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/unit_taken.hpp"
#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <vector>

namespace beespace::io {

// Doubts where distances and times make speeds that contradict the velocities of the input a
// thousandfold; or, without velocities, where times in milliseconds make them slower than anything
// that is followed so, and microseconds would make them usual. Errors: kInvalidArgument, without
// source.
std::optional<Error> doubt_of_time_unit(const Recording& recording, Unit named);

// Nothing is faster, as half of all its steps: in a show, of drones that are followed in a plane of
// their own, before cameras, and below space but for jets and what is shot.
inline constexpr double kFastestShow_mps = 20.0;
inline constexpr double kFastestDrone_mps = 30.0;
inline constexpr double kFastestFilmed_mps = 100.0;
inline constexpr double kFastestUsual_mps = 340.0;

// Heights in feet and speeds in knots that only the names of a known source tell, which others have
// in metres: doubts them where no height or speed, and no way from record to record, bears them
// out. `highest_m` is the greatest height. Errors: kInvalidArgument, without source.
std::optional<Error> doubt_of_feet(const Recording& recording, double highest_m);

// Doubts that positions, whose unit nothing names, are in metres, where these make them faster than
// that. Errors: kInvalidArgument, without source.
std::optional<Error> doubt_of_metres(const Recording& recording, double fastest_mps);

// What is asked then.
Error too_fast_in_metres(double speed_mps);

// Heights of positions in degrees, whose greatest is that, in a unit that is not said, or that only
// the words of a known source tell: higher than anything flies, they may be feet. Errors:
// kInvalidArgument, without source.
std::optional<Error> doubt_of_heights(const std::vector<UnitTaken>& units, double highest_m);

}  // namespace beespace::io
