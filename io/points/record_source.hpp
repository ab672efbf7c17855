// What is kept of the input beside the points: enough to write original records out again.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/points/array_layout.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/table_layout.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// Of the two layouts, the one that was read is set; their views point into `bytes`.
class RecordSource {
 public:
  Bytes bytes = {};            // unpacked
  std::string_view text = {};  // of a table, without its byte-order mark
  std::optional<TableLayout> table = {};
  std::optional<ArrayLayout> array = {};
  SkippedRecords skipped = {};
};

}  // namespace beespace::io
