#include "io/tracks/track_refusals.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/column_overrides.hpp"

#include <cstddef>
#include <string>

namespace beespace::io {

Error goes_back(const TrackRecord& record, const TimeChoice& time) {
  Error error{ErrorCode::kTimeOrder,
              "the times of day of bee " + excerpt(record.id) +
                  " go back here, as if another day had begun; add a column with the date, or the "
                  "date to the time, or, if all are of one day, sort the records by time",
              {}};
  error.location.column = time.column + 1;
  return error;
}

Error set_back(const TrackRecord& record, double back_s, const TimeChoice& time) {
  Error error{ErrorCode::kTimeOrder,
              "the times of bee " + excerpt(record.id) + " go back by " + time_span(back_s) +
                  " here, as where clocks are set back at night, and name no zone; say it with "
                  "--time-zone, of a place as Europe/Madrid, or UTC, in which clocks are never set "
                  "back and the records only have to be brought into order" +
                  std::string(kOrLeaveOut),
              {}};
  error.location.column = time.column + 1;
  return error;
}

std::optional<Error> joined_problem(const TrackRecord& record, const TrackLayout& layout) {
  if (!layout.time) return std::nullopt;
  if (!layout.table.choice.id) {
    return Error{ErrorCode::kMissingColumn,
                 "the header comes again before this record, as where tables were joined, and no "
                 "column says whose records they are: give the files as they were, each of which "
                 "is taken for one bee, or add a column 'id'; if all are of one bee, take the line "
                 "of the header out",
                 {}};
  }
  const TimeChoice& time = *layout.time;
  if (!time.since_start && !(time.begins_at_zero && record.time_s == 0.0)) return std::nullopt;
  Error error{ErrorCode::kInvalidArgument,
              "the header comes again before this record, as where tables were joined, and times " +
                  std::string(time.since_start ? "count from a zero of each vehicle's own"
                                               : "begin at 0 again") +
                  ", which may be another moment, as of another trial: then they cannot be "
                  "compared; read the tables each for itself, or, if all have one clock, say so "
                  "with --one-clock",
              {}};
  error.location.column = time.column + 1;
  return error;
}

Error own_zeros(std::string_view one, std::string_view other, const TrackLayout& layout) {
  const TimeChoice& time = *layout.time;
  Error error{ErrorCode::kInvalidArgument,
              "times are read from " + column_text(layout.table, time.column) +
                  ", which counts from when each vehicle was switched on, but here are several (" +
                  excerpt(one) + ", " + excerpt(other) +
                  "): then they cannot be compared; use a time of one clock, or, if these have "
                  "one, say so with --one-clock",
              {}};
  error.location.column = time.column + 1;
  return error;
}

Error height_after_all(std::string_view text, std::size_t column) {
  Error error{ErrorCode::kMalformedRecord,
              "a height, " + excerpt(text) +
                  ", comes here, but in none of the records of the beginning, so that there were "
                  "taken to be none; leave --memory out, or say with --columns whether there is a "
                  "height column",
              {}};
  error.location.column = column + 1;
  return error;
}

}  // namespace beespace::io
