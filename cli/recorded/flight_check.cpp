#include "cli/recorded/flight_check.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/encounters/bluesky_scenario.hpp"

namespace beespace::cli {

Status check_flight(const io::Recording& recording, const std::string& path) {
  if (recording.format_description != io::kBlueSkyScenario) return std::monostate{};
  return Error{ErrorCode::kUnsupportedFormat,
               "this BlueSky scenario says where aircraft begin, and not where they fly; ask "
               "'beespace predict' about it, or replay the log that BlueSky writes (CRELOG)",
               {io::source_name(path)}};
}

}  // namespace beespace::cli
