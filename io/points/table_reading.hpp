// All records of a text table -> points, on one thread or several.
//
// The bytes are handed out in pieces of whole lines; threads read pieces at the same time and
// append their points in the pieces' order. Points, ids, lines and the first error are therefore
// the same for every number of threads. Memory: 24 bytes a point, and a piece a thread.
#pragma once

#include "io/bytes/progress.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace beespace::io {

struct TableOptions {
  Frame frame = Frame::kAuto;  // kAuto: not known yet, points stay as they were read
  bool skip_bad = false;
  unsigned threads = 1;
  bool fast_path = true;
  std::size_t piece_bytes = std::size_t{1} << 18;  // about; pieces are whole lines
  Progress* progress = nullptr;
};

struct TableContent {
  std::vector<Point> points = {};  // in metres when the frame is known
  Extent extent = {};              // of the points as they were read
  SkippedRecords skipped = {};
  std::uint64_t headers = 0;  // lines that are the header again
};

// Errors have line, column and record, but no source.
Result<TableContent> read_table(std::string_view text, const TableLayout& layout,
                                const TableOptions& options);

}  // namespace beespace::io
