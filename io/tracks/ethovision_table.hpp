// Raw data as EthoVision XT exports them, a file for each animal and trial, often in UTF-16:
//
//   "Number of header lines:";"12"
//   "Trial name";"Trial 1"
//   "Arena name";"Arena 1"
//   ...
//   "Trial time";"Recording time";"X center";"Y center";...
//   "s";"s";"cm";"cm";...
//
// Times count from the beginning of the trial; a place that is not known is "-".
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// Whether it is such a table, with the lines above its columns or without them. `text` has no
// byte-order mark.
bool is_ethovision_table(std::string_view text);

// Into the source that `assembly` has begun; the animal is called by `stem`. Files of one trial
// have one clock. Errors have the line.
std::optional<Error> read_ethovision_table(std::string_view text, const std::string& stem,
                                           RecordingAssembly& assembly);

}  // namespace beespace::io
