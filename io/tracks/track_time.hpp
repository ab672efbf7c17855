// Which column of a table of fixes holds the time, in which unit, and whether it counts from 1970.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// The unit in which a number is a time since 1970 of these decades (1985 to 2128): the ranges of
// the units are a thousand times each other, and do not meet. kUnstated where there is none.
Unit unit_since_1970(double value);

// Nothing where there is no time. `text` are records of the table. Errors: kInvalidArgument where
// the unit must be said (with column), kUnsupportedFormat for one that is not read, kMissingColumn
// where two columns may be it.
Result<std::optional<TimeChoice>> choose_time(std::string_view text, const Header& header,
                                              Unit asked);

// What was chosen, for the notes.
std::string time_note(const TableLayout& table, const TimeChoice& time, bool asked);

}  // namespace beespace::io
