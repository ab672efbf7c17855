// Aircraft that may be there twice: under their address, and under that with "~" before it, as
// readsb and dump1090 mark what is no address of the sender's own, but of TIS-B or ADS-R, by which
// the ground tells what it sees.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

// To be told; nothing where there is none.
std::optional<std::string> relayed_ids_note(const std::vector<RecordedBee>& bees);

}  // namespace beespace::io
