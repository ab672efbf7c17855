// Which column of a table of fixes holds the time, in which unit, and whether it counts from 1970.
#pragma once

#include "io/recording/recording_options.hpp"
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

// Nothing where there is no time. `text` are records of the table. Of frames it is left open how
// many there are in a second, where the caller does not say. Errors: kInvalidArgument where the
// unit must be said (with column), kUnsupportedFormat for one that is not read, kMissingColumn
// where two columns may be it.
Result<std::optional<TimeChoice>> choose_time(std::string_view text, const Header& header,
                                              const RecordingOptions& options);

// Whether the name says that numbers count since the vehicle was switched on: "time_boot_ms".
bool counts_from_start(const TableLayout& table, const TimeChoice& time);

// Whether the first of them is 0, as where numbers count from the start of what is in the table.
bool times_begin_at_zero(std::string_view text, const TableLayout& table, const TimeChoice& time);

// Whether the first time is less than a hundred days: it may count from where something was
// switched on.
bool times_are_small(std::string_view text, const TableLayout& table, const TimeChoice& time);

// What was chosen, for the notes.
std::string time_note(const TableLayout& table, const TimeChoice& time, bool asked);

// What to say where there is neither a time nor a velocity. A column that may hold the time is
// offered only if its name sounds like it; one of days with one of times of day.
std::string no_time_text(std::string_view text, const Header& header);

}  // namespace beespace::io
