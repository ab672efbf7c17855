// Telemetry logs that come one after the other with the same systems in them, as where a ground
// station was started again: each system is a drone of its own in each, until they are joined.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

// What joins them, where no two of the logs are of one time; `sources` are all inputs.
std::optional<std::string> continued_logs_note(const std::vector<RecordedBee>& bees,
                                               const std::vector<std::string>& sources);

}  // namespace beespace::io
