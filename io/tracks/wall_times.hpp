// Dates and times, or times of day, in a table of fixes: how they are written, and what they are
// counted from.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/column_choice.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/units/iso_time.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether a column of times says that they are of the clocks of a place: "study-local-timestamp",
// which tables of Movebank may have beside the time in UTC, "LMT".
bool names_local_time(std::string_view column);

// Whether they are dates, the first of them or a later one with a time of day.
bool is_date_with_time(const FirstFields& fields);

// Of several columns of times that which has the dates with the times, if the others only have the
// same again, or the times of day.
std::optional<std::size_t> only_dated(std::string_view text, const TableLayout& table,
                                      const std::vector<std::size_t>& columns);

// Of `times`, the first fields of time.column: its form, and all that belongs to it where they are
// no numbers. Errors have line and column.
std::optional<Error> choose_wall_times(std::string_view text, const Header& header,
                                       const FirstFields& times, const RecordingOptions& options,
                                       TimeChoice& time);

// A field of the time, and of the day where that has a column of its own, as seconds. What is
// wrong, as a sentence; nothing when all is well. Where clocks show it twice `seconds` is the first
// time, and the other one is `again_after_s` later; otherwise that is 0.
std::string read_wall_time(const TimeChoice& time, std::string_view text, std::string_view day,
                           double& seconds, double& again_after_s);

// Whether it is a day alone, without a time.
bool is_day_alone(std::string_view text, DateOrder order);
// Whether its time is midnight: "2015-09-10 00:00:00", "2015-09-10T00:00:00.000Z".
bool says_midnight(std::string_view text);

// The column that says in which zone, or how far ahead of UTC, each time is.
std::optional<std::size_t> find_clock_zone(const TableLayout& table);

// How dates are read, for the notes.
std::string dates_note(const TimeChoice& time);

}  // namespace beespace::io
