// Whether what is taken for the id numbers the records, as rows of data bases and of Fiji's table
// of results are numbered: then every record would be a bee of its own, and none would meet
// another.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// Of fewer records it is not said.
inline constexpr std::size_t kFewestNumbered = 3;

// The question which column is the id, where every id of `text` comes once and there is more than
// one time; nothing where the caller says the id. `layout` is chosen, and `text` are its records.
// Errors: kMissingColumn.
std::optional<Error> numbered_records(std::string_view text, const Header& header,
                                      const TrackLayout& layout);

}  // namespace beespace::io
