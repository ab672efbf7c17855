// Scenarios of BlueSky (.scn): where its aircraft begin.
//
//   00:00:00.00>CRE KL204,B744,52.3,4.7,90,FL250,280
//
// An aircraft is where CRE or the last MOVE puts it, and flies as it does then: its calibrated
// speed or Mach number in the standard atmosphere, without wind. Where it is told to fly from there
// (HDG, ALT, ADDWPT, DEST, ...) is for the simulator to say, whose logs are tables: that is said,
// and not followed, and such an aircraft has no velocity. Commands that are not known, and those
// that create aircraft in other ways, are records that are left out.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

bool is_bluesky_scenario(std::string_view text);

// What a recording is called that a scenario was read into: it says where aircraft begin, and
// nothing of where they fly.
inline constexpr std::string_view kBlueSkyScenario = "BlueSky scenario";

// Into the source that `assembly` has begun. Errors have the line; kInvalidArgument where there are
// other inputs.
std::optional<Error> read_bluesky_scenario(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
