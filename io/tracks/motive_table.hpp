// Takes as Motive (OptiTrack) exports them: rigid bodies beside each other under a header of
// several lines, a line for each picture.
//
//   Format Version,1.23,Take Name,...,Length Units,Meters,Coordinate Space,Global
//
//   ,,Rigid Body,Rigid Body,...        (what it is)
//   ,,uav1,uav1,...                    (how it is called)
//   ,,1F3A...,1F3A...,...              (its number; newer ones have a line for its parent, too)
//   ,,Rotation,Rotation,...,Position,...
//   Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,...
//
// Markers, of which several make a body, and bones are left out. Times count from the beginning of
// the take, and y is upwards.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether it has positions of rigid bodies. `text` has no byte-order mark.
bool is_motive_table(std::string_view text);

// Into the source that `assembly` has begun. Errors have the line, and say the coordinate;
// kInvalidArgument for a length unit or a name that cannot be told, and beside other inputs, as
// each take has a clock of its own.
std::optional<Error> read_motive_table(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
