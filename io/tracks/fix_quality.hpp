// Columns in which a receiver says whether it had a fix: where it had none, what it writes for a
// place is none.
#pragma once

#include "io/table/table_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::io {

// What becomes of words that are not known.
enum class Unclear : std::uint8_t {
  kTaken,  // for a fix
  kAsked,
};

struct FixQuality {
  std::size_t column = 0;
  double least = 0.0;  // of numbers: below that there was no fix
  Unclear unclear = Unclear::kTaken;
  bool of_eobs = false;  // A, B, C or D
};

// Nothing where no column is known to say so. What some of its first fields say tells whether a
// "Status" does.
std::optional<FixQuality> find_fix_quality(std::string_view text, const TableLayout& table);

// Whether a field of that column says that there was none; what is not understood does not.
bool says_no_fix(const FixQuality& quality, std::string_view text);

// Whether it says what is neither, and must be asked about.
bool is_unclear(const FixQuality& quality, std::string_view text);

}  // namespace beespace::io
