// A text table of fixes, whole -> the bees of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct TrackTable {
  std::string_view bytes = {};  // unpacked
  std::string stem = {};        // of the file's name: the bee, where there is no id column
  bool bare_skybrush = false;   // without a header it is a Skybrush CSV
  SeenRecords seen = SeenRecords::kSome;
};

// How errors name the place of a record.
enum class RecordPlace : std::uint8_t {
  kLineAndColumn,  // of a text table
  kLineAndName,    // of objects, one a line: the column is a key
  kRecordAndName,  // of other JSON, whose lines say nothing
};

// Facts of a layout that `description` says the form of.
SourceFacts facts_of(const TrackLayout& layout, std::string description);

// What of a table has been read before.
struct RecordsBefore {
  std::uint64_t rows = 0;
  std::uint64_t headers = 0;  // that came again
  bool joined = false;        // the last line but blanks and comments was such a header
  std::string vehicle = {};   // the first, where times count since it was switched on
};

// All records of `text`, some lines behind the header and behind others, into the source that
// `assembly` has begun; counts them. `stem` is the bee where there is no id column.
std::optional<Error> read_track_records(std::string_view text, const TrackLayout& layout,
                                        const std::string& stem, RecordPlace place,
                                        RecordsBefore& before, RecordingAssembly& assembly);

// A table whose lines come some at a time, into the source that `assembly` has begun; it must
// outlive this.
class TrackTableReader {
 public:
  // `beginning` is all of the table, or its first lines. Errors have line and column.
  static Result<TrackTableReader> begin(const TrackTable& beginning, RecordingAssembly& assembly);

  // Where in the beginning the first line behind the header begins.
  [[nodiscard]] std::size_t data_offset() const { return data_offset_; }
  [[nodiscard]] char line_end() const { return layout_->table.line_end; }
  // How many lines came before those that are read next.
  [[nodiscard]] std::uint64_t lines_before() const { return layout_->table.lines_before; }

  // What is wrong if every id of the table comes once; nothing where that is known to be right.
  [[nodiscard]] const std::optional<Error>& perhaps_numbers() const {
    return layout_->perhaps_numbers;
  }

  // The next lines, whole ones. Errors have line and column.
  std::optional<Error> read(std::string_view lines);

 private:
  TrackTableReader(TrackLayout layout, std::string stem, RecordingAssembly& assembly);

  std::unique_ptr<TrackLayout> layout_;  // of the lines that come next
  std::unique_ptr<std::string> header_;  // which it views
  std::size_t data_offset_;
  std::string stem_;
  RecordsBefore before_ = {};
  RecordingAssembly* assembly_;
};

// Into the source that `assembly` has begun. Errors have line and column, and the source where it
// is not that one.
std::optional<Error> read_track_table(const TrackTable& table, RecordingAssembly& assembly);

}  // namespace beespace::io
