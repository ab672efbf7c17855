// Titles above the header of a table, which are no part of it.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace beespace::io {

struct TitleLines {
  std::uint64_t lines = 0;      // how many, with blank ones and comments between them; often none
  std::size_t offset = 0;       // where the line behind them begins
  std::string_view first = {};  // the first of them
  bool says_utc = false;        // "Time Zone,UTC"
};

// Of lines above a header of which one says in which line of the file that is, as reports of
// Telonics have them; none otherwise.
TitleLines titles_by_their_word(std::string_view text, std::size_t offset,
                                const TableLayout& layout);

// Of the lines of `text` from `offset` on, where something stands. `layout` says how they are
// split, and by its contents how many columns the records have. Titles are only seen where a header
// of so many known names comes behind them. Errors: kMalformedRecord, with the line counted from
// 1 at `offset`, for a line above that header that may be more than a title.
Result<TitleLines> titles_above(std::string_view text, std::size_t offset,
                                const TableLayout& layout);

}  // namespace beespace::io
