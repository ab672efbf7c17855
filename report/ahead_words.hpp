// What lies ahead of a snapshot, as a sentence: for pictures, pages and the summary of the command.
#pragma once

#include "report/facts.hpp"

#include <cstddef>
#include <string>

namespace beespace::report {

// "flying straight on, 1 conflict within 300 s: AFR123 and BAW456 in 21.9 s, 2.37 NM across, 200 ft
// in height"; of several at most so many, the worst first. Empty of a snapshot of which it is not
// known when it is.
inline constexpr std::size_t kNamedAhead = 3;
std::string ahead_words(const SnapshotFacts& facts, std::size_t most = kNamedAhead);

}  // namespace beespace::report
