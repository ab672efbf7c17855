// Exports of motion capture, in which bodies or markers stand beside each other under headers of
// several lines: Motive (OptiTrack), QTM (Qualisys), Nexus (Vicon). They are not read.
#pragma once

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// What to write instead; nothing where the text is no such. Errors: kUnsupportedFormat.
std::optional<Error> motion_capture_problem(std::string_view text);

}  // namespace beespace::io
