// Tables that QTM of Qualisys exports, with tabs: lines that begin with words in capitals, then
// rigid bodies (6D),
//
//   Frame  Time  robot1 X  Y  Z  Roll  Pitch  Yaw  Residual  Rot[0] ... robot2 X  Y  Z ...
//
// or markers (3D), which a line MARKER_NAMES names, with or without a line of columns:
//
//   Frame  Time  m1 X  m1 Y  m1 Z  m2 X  m2 Y  m2 Z
//
// Frame and Time may be missing: then each line is a picture, of FREQUENCY a second. Lengths are in
// millimetres; a body that was not seen has a residual of -1.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether it has positions of rigid bodies and their times. `text` has no byte-order mark.
bool is_qtm_table(std::string_view text);

// Into the source that `assembly` has begun. Errors have the line, and say the coordinate;
// kInvalidArgument beside other inputs, as each recording has a clock of its own.
std::optional<Error> read_qtm_table(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
