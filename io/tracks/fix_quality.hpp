// Columns in which a receiver says whether it had a fix: where it had none, what it writes for a
// place is none.
#pragma once

#include "io/table/table_layout.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

struct FixQuality {
  std::size_t column = 0;
  double least = 0.0;  // of numbers: below that there was no fix
};

// Nothing where no column is known to say so.
std::optional<FixQuality> find_fix_quality(const TableLayout& table);

// Whether a field of that column says that there was none; what is not understood does not.
bool says_no_fix(const FixQuality& quality, std::string_view text);

}  // namespace beespace::io
