// Ids of a snapshot that come again: two records that say the same of themselves.
#pragma once

#include "io/points/loaded_points.hpp"

#include <beespace/point.hpp>

#include <cstdint>
#include <string>

namespace beespace::io {

struct RepeatedIds {
  std::uint64_t count = 0;  // of records whose id is that of one before
  // Of the first of these.
  std::string id = {};
  std::uint64_t first_row = 0;  // 0-based data rows
  std::uint64_t second_row = 0;
};

// Nothing without an id column. Empty ids are none. One walk over the input; memory: some sixty
// bytes a record.
RepeatedIds find_repeated_ids(const LoadedPoints& loaded);

}  // namespace beespace::io
