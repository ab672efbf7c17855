// Why a report of an aircraft becomes no fix, the same for all formats.
#pragma once

#include "io/problems/left_out.hpp"

namespace beespace::io {

inline constexpr LeftOutReason kNoPosition = {"without a position"};
inline constexpr LeftOutReason kNoTime = {"without the time of the position"};
inline constexpr LeftOutReason kOnGround = {"of aircraft on the ground",
                                            "--grounded keeps those that tell a height", true};
inline constexpr LeftOutReason kNoHeight = {"without a height"};
inline constexpr LeftOutReason kNoEllipsoidHeight = {
    "without a height above the ellipsoid",
    "--heights pressure takes heights by pressure instead, for all"};
inline constexpr LeftOutReason kNoPressureHeight = {"without a height by pressure"};

}  // namespace beespace::io
