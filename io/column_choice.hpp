// Which columns hold the position: as the caller says, as the header says, or plainly in order.
// Where none of these decides, that is an error: nothing is guessed.
#pragma once

#include "io/table_layout.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::io {

struct ColumnsSeen {
  std::size_t count = 0;
  std::vector<std::string> names = {};  // empty when there is no header
  std::vector<bool> numeric = {};       // whether the first record holds a number there
};

// Errors: kInvalidArgument for wishes that make no sense, kMissingColumn, kUnsupportedFormat for a
// unit that is not read.
Result<ColumnChoice> choose_columns(const ColumnsSeen& seen, const LoadOptions& options);

}  // namespace beespace::io
