#include "cli/recorded/flight_check.hpp"

#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"
#include "io/encounters/bluesky_scenario.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace beespace::cli {
namespace {

// Each by one fix, so that it is not known where it flies.
bool is_one_moment(const io::Recording& recording) {
  return recording.of_aircraft && recording.bees.size() > 1 &&
         std::all_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return bee.fixes.size() == 1; });
}

std::string moment_question(const io::Recording& recording, const MovingRequest& request) {
  std::string text = "each of the ";
  text.append(io::grouped(recording.bees.size())).append(" aircraft has one fix only");
  text.append(", so that this is one moment, and not where they fly; ask 'beespace predict");
  if (request.inputs.front() != "-") {
    for (const std::string& input : request.inputs) text.append(" ").append(printable(input));
  }
  text.append(separation_typed(request));
  text.append("', which brings them to one time and looks ahead, or give several such files");
  return text;
}

}  // namespace

Status check_flight(const io::Recording& recording, const MovingRequest& request) {
  const std::string source = io::source_name(request.inputs.front());
  if (recording.format_description == io::kBlueSkyScenario) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this BlueSky scenario says where aircraft begin, and not where they fly; ask "
                 "'beespace predict' about it, or replay the log that BlueSky writes (CRELOG)",
                 {source}};
  }
  if (is_one_moment(recording)) {
    return Error{ErrorCode::kUnsupportedFormat, moment_question(recording, request), {source}};
  }
  return std::monostate{};
}

}  // namespace beespace::cli
