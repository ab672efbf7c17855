// What lies ahead of a snapshot, as a sentence: for pictures, pages and the summary of the command.
#pragma once

#include "report/facts.hpp"

#include <string>

namespace beespace::report {

// "flying straight on, 1 conflict within 300 s: AFR123 and BAW456 in 21.9 s, 2.37 NM across, 200 ft
// in height"; empty of a snapshot of which it is not known when it is.
std::string ahead_words(const SnapshotFacts& facts);

}  // namespace beespace::report
