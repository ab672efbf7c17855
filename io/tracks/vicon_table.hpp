// Tables that Vicon's programs (Nexus, Tracker) export: sections under headers of several lines, a
// line for each picture.
//
//   Objects                             (or Segments; markers: Trajectories)
//   100                                 (pictures a second)
//   ,,robot1:robot1,,,,,,robot2:...     (whose the columns from here on are)
//   Frame,Sub Frame,RX,RY,RZ,TX,TY,TZ,...
//   ,,rad,rad,rad,mm,mm,mm,...
//
// The places of objects and segments are TX, TY, TZ; those of markers X, Y, Z.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether it has places of objects, segments or markers. `text` has no byte-order mark.
bool is_vicon_table(std::string_view text);

// Into the source that `assembly` has begun: the objects, else the segments, else the markers.
// Errors have the line, and say the coordinate; kInvalidArgument where several segments or markers
// are of one body, and beside other inputs, as each recording has a clock of its own.
std::optional<Error> read_vicon_table(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
