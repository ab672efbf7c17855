// Records that were put together from a table of a tool's own layout, in which what was followed
// stands beside each other, or under headers of several lines.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

struct LongRecords {
  std::string text = {};                // kUnitSeparator between fields, a line a record
  std::vector<std::string> names = {};  // of the columns; texts are those of "id" alone
  std::uint64_t lines_before = 0;       // of the file, before the first record
  std::size_t per_line = 1;             // how many records are of one line of the file
  // Where the names of columns are not those of the file: why its lengths are in their unit. Then
  // notes do not name them.
  std::string unit_reason = {};
  std::string note = {};         // what was made of the table
  std::string description = {};  // "text, poses"
  bool of_animals = false;       // SourceFacts::of_animals
  std::string animal = {};       // whose they all are, where the file says so
  std::string trial = {};        // SourceFacts::trial
  std::string arena = {};        // SourceFacts::arena
};

// Into the source that `assembly` has begun; `stem` of its name is the bee where no column is
// called "id". Errors have the line, and say the column by its name.
std::optional<Error> read_long_records(const LongRecords& records, const std::string& stem,
                                       RecordingAssembly& assembly);

}  // namespace beespace::io
