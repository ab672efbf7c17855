// Which columns hold the position: as the caller says, as the header says, or plainly in order.
// Where none of these decides, that is an error: nothing is guessed.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {

// What the first records hold in a column. An empty field, or "N/A", is unknown: a number may
// follow.
enum class ColumnContent : std::uint8_t { kUnknown, kNumber, kText };

struct ColumnsSeen {
  std::size_t count = 0;
  std::vector<std::string> names = {};  // empty when there is no header
  std::vector<ColumnContent> contents = {};
  std::vector<bool> taken = {};  // columns that are known to hold no coordinate; may be empty
};

// Of columns that could all be the id, the one that is: "id" before "frame_id".
std::size_t choose_id(const ColumnsSeen& seen, const std::vector<std::size_t>& candidates);

// Errors: kInvalidArgument for wishes that make no sense, or for units that must be said (with
// column), kMissingColumn, kUnsupportedFormat for a unit that is not read.
Result<ColumnChoice> choose_columns(const ColumnsSeen& seen, const ColumnOptions& options);

}  // namespace beespace::io
