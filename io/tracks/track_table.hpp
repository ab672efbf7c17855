// A text table of fixes, whole -> the bees of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct TrackTable {
  std::string_view bytes = {};  // unpacked
  std::string stem = {};        // of the file's name: the bee, where there is no id column
  bool bare_skybrush = false;   // without a header it is a Skybrush CSV
};

// How errors name the place of a record.
enum class RecordPlace : std::uint8_t {
  kLineAndColumn,  // of a text table
  kLineAndName,    // of objects, one a line: the column is a key
  kRecordAndName,  // of other JSON, whose lines say nothing
};

// Facts of a layout that `description` says the form of.
SourceFacts facts_of(const TrackLayout& layout, std::string description);

// All records of `text` behind the header, into the source that `assembly` has begun. `stem` is the
// bee where there is no id column.
std::optional<Error> read_track_records(std::string_view text, const TrackLayout& layout,
                                        const std::string& stem, RecordPlace place,
                                        RecordingAssembly& assembly);

// Into the source that `assembly` has begun. Errors have line and column, and the source where it
// is not that one.
std::optional<Error> read_track_table(const TrackTable& table, RecordingAssembly& assembly);

}  // namespace beespace::io
