// Logs of gliders, paragliders and balloons in the format of the IGC (FAI): a text file a flight.
//
// Of each line with a fix ("B") the time of day (UTC), the position to thousandths of a minute,
// whether there was a fix in three dimensions (A) or not (V), and two heights in whole metres: by
// the pressure of the standard atmosphere, and by satellites. The day is that of HFDTE.
// (FAI: Technical Specification for IGC-Approved GNSS Flight Recorders, appendix A.)
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// What a recording that has nothing else is described as.
inline constexpr std::string_view kIgcLog = "IGC log";

bool is_igc_log(std::string_view text);

// Into the source that `assembly` has begun; the bee is called `stem`. Errors have lines:
// kMalformedRecord, kMissingColumn without a day, and those of AircraftGathering.
std::optional<Error> read_igc_log(std::string_view text, const std::string& stem,
                                  RecordingAssembly& assembly);

}  // namespace beespace::io
