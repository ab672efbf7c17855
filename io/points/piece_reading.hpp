// A piece of a text table, from one line start to another, -> points, counts, errors.
//
// Pieces know nothing of each other: lines, rows and records are counted from the piece's start.
#pragma once

#include "io/frames/frame_decision.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

struct PieceOptions {
  Frame frame = Frame::kAuto;  // kAuto: not known yet, points stay as they were read
  bool skip_bad = false;
  bool fast_path = true;  // off: every line goes through read_record(); for tests
};

struct PieceContent {
  std::vector<Point> points = {};  // in metres when the frame is known
  Extent extent = {};              // of the points as they were read
  std::uint64_t lines = 0;
  std::uint64_t rows = 0;
  std::uint64_t headers = 0;  // lines that are the header again
  SkippedRecords skipped = {};
  std::optional<Error> error = {};  // of the lowest line that has one; location.line is 1-based

  void clear();  // keeps the memory
};

// `readable_end`: where the bytes behind the piece stop being readable.
void read_piece(std::string_view piece, const char* readable_end, const TableLayout& layout,
                const PieceOptions& options, PieceContent& content);

// The error for the point at data row `row` of `text`, with its line (1-based from the start of
// `text`), column and the number as it stands there.
Error range_error_in_text(std::string_view text, const TableLayout& layout, std::uint64_t row,
                          const Point& point, std::size_t axis, ErrorCode code);

}  // namespace beespace::io
