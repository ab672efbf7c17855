// A text table of fixes, whole -> the bees of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct TrackTable {
  std::string_view bytes = {};  // unpacked
  std::string stem = {};        // of the file's name: the bee, where there is no id column
  bool bare_skybrush = false;   // without a header it is a Skybrush CSV
};

// Into the source that `assembly` has begun. Errors have line and column, and the source where it
// is not that one.
std::optional<Error> read_track_table(const TrackTable& table, RecordingAssembly& assembly);

}  // namespace beespace::io
