// Reports of aircraft -> fixes of a recording, whatever the format they came in.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::io {

class AircraftGathering {
 public:
  AircraftGathering(const AircraftChoice& choice, RecordingAssembly& assembly)
      : choice_(choice), assembly_(assembly) {}

  // Says what the input is. A position that comes again within `repeat_s` was heard once. Errors:
  // kInvalidArgument for options that do not go with it, and those of RecordingAssembly::agree().
  std::optional<Error> begin(std::string description, Unit height_unit, double repeat_s,
                             bool tells_speeds = true);

  // `line` is that of the input (1-based), or the number of the report in it. Errors: those of
  // AircraftChoice::choose(), without place.
  std::optional<Error> add(const AircraftReport& report, std::uint64_t line);

 private:
  AircraftChoice choice_;
  RecordingAssembly& assembly_;
};

}  // namespace beespace::io
