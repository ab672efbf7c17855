// How a snapshot is to be read.
#pragma once

#include "io/bytes/progress.hpp"
#include "io/table/column_options.hpp"

#include <cstdint>

namespace beespace::io {

enum class Format : std::uint8_t { kAuto, kText, kNpy, kRawFloat64 };

struct LoadOptions : ColumnOptions {
  Format format = Format::kAuto;
  bool format_can_be_said = false;  // whether an error may advise to say --format
  bool part_of_more = false;        // what only all points could tell is not asked
  unsigned threads = 1;
  Progress* progress = nullptr;  // optional; must outlive the call
};

}  // namespace beespace::io
