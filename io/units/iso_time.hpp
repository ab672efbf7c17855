// Times as ISO 8601 writes them: "2024-05-01T12:00:00.25Z", "2024-05-01 14:00:00,25+02:00".
#pragma once

#include <string_view>

namespace beespace::io {

// Whether the text begins as a date does, so that it is no number.
bool looks_like_iso_time(std::string_view text);

// Seconds since 1970-01-01T00:00:00Z, of which each day has 86,400: the nearest double. Date, time
// with seconds, and "Z" or an offset must all be there; the fraction may have any length, of which
// nine digits are read. Returns what is wrong, as a sentence; nothing when all is well.
std::string_view parse_iso_time(std::string_view text, double& seconds);

}  // namespace beespace::io
