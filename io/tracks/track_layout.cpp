#include "io/tracks/track_layout.hpp"

#include "io/bytes/characters.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_wishes.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/table_sources.hpp"
#include "io/table/unit_choice.hpp"
#include "io/tracks/track_velocity.hpp"
#include "io/tracks/track_wishes.hpp"
#include "io/tracks/track_words.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace beespace::io {
namespace {

Error missing(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

Error at_column(ErrorCode code, std::string message, std::size_t column) {
  Error error{code, std::move(message), {}};
  error.place.column = column + 1;
  return error;
}

std::string column_text(const ColumnsSeen& seen, std::size_t column) {
  std::string text = "column " + std::to_string(column + 1);
  if (column < seen.names.size()) text.append(" ").append(excerpt(seen.names[column]));
  return text;
}

// What a known source has in a column.
void take_known(const KnownColumn* known, TrackWord& word) {
  if (known == nullptr) return;
  switch (known->holds) {
    case SourceColumn::kGroundSpeed:
      word.role = TrackRole::kGroundSpeed;
      break;
    case SourceColumn::kTrack:
      word.role = TrackRole::kTrack;
      break;
    case SourceColumn::kClimb:
      word.role = TrackRole::kClimb;
      break;
    case SourceColumn::kUnixSeconds:
      word.role = TrackRole::kTime;
      word.unit = TimeUnit::kSeconds;
      word.since_1970 = true;
      break;
    case SourceColumn::kHeight:
      break;
  }
}

// The header's words, but none for columns that the caller claims for something.
std::vector<TrackWord> read_words(const ColumnsSeen& seen, const TrackWishes& wishes) {
  std::vector<TrackWord> words;
  for (const std::string& name : seen.names) words.push_back(read_track_word(name));
  if (const TableSource* const source = source_of(seen.names)) {
    for (std::size_t i = 0; i < words.size(); ++i)
      take_known(source->find(seen.names[i]), words[i]);
  }
  const auto claim = [&words](const std::optional<std::size_t>& column) {
    if (column && *column < words.size()) words[*column].role = TrackRole::kNone;
  };
  claim(wishes.id);
  claim(wishes.time);
  for (const auto& column : wishes.velocity) claim(column);
  return words;
}

// ---- Whose record it is --------------------------------------------------------------------

std::optional<std::size_t> choose_id(const ColumnsSeen& seen, const TrackWishes& wishes,
                                     const std::vector<TrackWord>& words,
                                     std::vector<std::string>& notes) {
  if (wishes.id) return wishes.id;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].role == TrackRole::kId) found.push_back(i);
  }
  if (found.empty()) return std::nullopt;
  const std::size_t chosen = io::choose_id(seen, found);
  for (const std::size_t other : found) {
    if (other == chosen) continue;
    notes.push_back("ids are read from " + column_text(seen, chosen) + ", not from " +
                    column_text(seen, other) + "; --columns id=" + std::to_string(other + 1) +
                    " would change that");
  }
  return chosen;
}

// ---- Time ----------------------------------------------------------------------------------

// Whether the first time of the table is a date.
bool holds_dates(std::string_view text, const TableLayout& table, std::size_t column) {
  constexpr int kLookedAt = 16;
  std::size_t offset = table.data_offset;
  for (int i = 0; i < kLookedAt && offset < text.size(); ++i) {
    const Line line = line_at(text, offset, table.line_end);
    offset = line.next;
    if (line.text.size() > kLongestLine) continue;
    const auto time = without_padding(field_at(line.text, table.delimiter, column).text);
    if (!time.empty()) return looks_like_iso_time(time);
  }
  return false;
}

Result<TimeChoice> choose_unit(TimeChoice time, const TrackWord& word, const ColumnsSeen& seen,
                               const RecordingOptions& options) {
  if (time.iso) {
    time.since_1970 = true;
    return time;
  }
  time.since_1970 = word.since_1970;
  time.unit = options.time_unit != TimeUnit::kAuto ? options.time_unit : word.unit;
  if (options.time_unit == TimeUnit::kAuto && !word.foreign_unit.empty()) {
    return at_column(ErrorCode::kUnsupportedFormat,
                     column_text(seen, time.column) + " is in '" + word.foreign_unit +
                         "'; convert it first: beespace reads s, ms, us, ns and dates of ISO 8601",
                     time.column);
  }
  if (time.unit == TimeUnit::kAuto) {
    return at_column(ErrorCode::kInvalidArgument,
                     column_text(seen, time.column) +
                         " holds the time, but in which unit? Say it with --time-unit s, ms, us "
                         "or ns, or in the header: time_s",
                     time.column);
  }
  return time;
}

Result<std::optional<TimeChoice>> choose_time(std::string_view text, const TableLayout& table,
                                              const ColumnsSeen& seen, const TrackWishes& wishes,
                                              const std::vector<TrackWord>& words,
                                              const RecordingOptions& options) {
  std::optional<std::size_t> column = wishes.time;
  for (std::size_t i = 0; i < words.size() && !wishes.time; ++i) {
    if (words[i].role != TrackRole::kTime) continue;
    if (column) {
      return missing("both " + column_text(seen, *column) + " and " + column_text(seen, i) +
                     " look like the time; say which with --columns time=" +
                     std::to_string(*column + 1) + " or time=" + std::to_string(i + 1));
    }
    column = i;
  }
  if (!column) return std::optional<TimeChoice>();
  TrackWord word;
  if (*column < words.size()) {
    word = wishes.time ? read_track_word(seen.names[*column]) : words[*column];
  }
  TimeChoice time;
  time.column = *column;
  time.iso = holds_dates(text, table, *column);
  auto chosen = choose_unit(time, word, seen, options);
  if (!chosen) return chosen.error();
  return std::optional<TimeChoice>(chosen.value());
}

std::string time_note(const ColumnsSeen& seen, const TimeChoice& time, bool asked) {
  std::string text = "times are read from " + column_text(seen, time.column);
  if (time.iso) return text + " as dates and times (ISO 8601)";
  text += " in " + std::string(unit_name(time.unit));
  if (asked) text += ", as asked for";
  return text + (time.since_1970 ? ", since 1970" : "");
}

// ---- Position ------------------------------------------------------------------------------

// Whether the header names a position at all: it is not taken from the order of the columns.
bool names_position(const ColumnsSeen& seen) {
  bool first = false;
  bool second = false;
  bool lon = false;
  bool lat = false;
  for (std::size_t i = 0; i < seen.names.size(); ++i) {
    if (seen.taken[i]) continue;
    const Role role = read_header_word(seen.names[i]).role;
    first = first || role == Role::kX;
    second = second || role == Role::kY;
    lon = lon || role == Role::kLongitude;
    lat = lat || role == Role::kLatitude;
  }
  return (first && second) || (lon && lat);
}

Result<ColumnChoice> choose_position(const ColumnsSeen& seen, const TrackWishes& wishes,
                                     const RecordingOptions& options) {
  if (wishes.position.empty() && !names_position(seen)) {
    return missing((seen.names.empty()
                        ? std::string("there is no header that tells the columns")
                        : std::string("the header names no position (x and y, or longitude "
                                      "and latitude)")) +
                   (seen.count >= 5 ? "; say which is which, for example with --columns "
                                      "id=1,time=2,x=3,y=4,z=5 ("
                                    : "; needed are columns of numbers for the time, for x and y "
                                      "or longitude and latitude, and perhaps for an id and the "
                                      "height; name them in a header or with --columns (") +
                   list_columns(seen) + ")");
  }
  ColumnOptions points;
  points.frame = options.frame;
  points.columns = wishes.position;
  points.units = options.units;
  points.heights = options.heights;
  return choose_columns(seen, points);
}

std::string position_note(const ColumnsSeen& seen, const ColumnChoice& choice, Frame frame) {
  const bool geographic = frame == Frame::kWgs84;
  std::string text = geographic ? "longitude, latitude" : "x, y";
  if (choice.dimensions == 3) text += geographic ? ", height" : ", z";
  text += " are read from";
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    text.append(axis == 0 ? " " : ", ").append(column_text(seen, choice.axes[axis]));
  }
  if (choice.dimensions == 3) return text;
  return text + (geographic ? "; there is no height: every height is taken as 0 m"
                            : "; there is no z: every z is taken as 0 m");
}

// ---- All together --------------------------------------------------------------------------

std::optional<Error> doubly_used(const TrackLayout& layout) {
  std::vector<std::pair<std::size_t, std::string_view>> used;
  const ColumnChoice& position = layout.table.choice;
  for (std::size_t i = 0; i < position.dimensions; ++i) {
    used.emplace_back(position.axes[i], "position");
  }
  if (layout.time) used.emplace_back(layout.time->column, "time");
  for (std::size_t i = 0; layout.velocity && i < layout.velocity->dimensions; ++i) {
    used.emplace_back(layout.velocity->columns[i], "velocity");
  }
  std::sort(used.begin(), used.end());
  for (std::size_t i = 1; i < used.size(); ++i) {
    if (used[i].first != used[i - 1].first) continue;
    return Error{ErrorCode::kInvalidArgument,
                 "--columns: column " + std::to_string(used[i].first + 1) + " cannot be both " +
                     std::string(used[i - 1].second) + " and " + std::string(used[i].second),
                 {}};
  }
  return std::nullopt;
}

// A column that may hold the time is offered only if its name sounds like it.
std::string no_time(const ColumnsSeen& seen, const std::vector<TrackWord>& words) {
  constexpr std::string_view kStems[] = {"time", "date", "stamp", "clock", "epoch",
                                         "zeit", "hora", "temps", "utc"};
  std::string which = "N";
  for (std::size_t i = 0; i < seen.names.size() && which == "N"; ++i) {
    const std::string name = lower_case(seen.names[i]);
    const bool free =
        words[i].role == TrackRole::kNone && (i >= seen.taken.size() || !seen.taken[i]);
    const auto sounds = [&name](std::string_view stem) {
      return name.find(stem) != std::string::npos;
    };
    if (free && std::any_of(std::begin(kStems), std::end(kStems), sounds)) {
      which = std::to_string(i + 1);
    }
  }
  return "there is neither a time nor a velocity; name the column of the time with --columns "
         "time=" +
         which +
         ", or those of the velocity, with which 'beespace predict' needs no time, with vx=N,vy=N; "
         "where everybody is at one time, ask 'beespace detect' (" +
         list_columns(seen) + ")";
}

// t [ms], x, y, z, and perhaps red, green and blue.
Result<TrackLayout> skybrush_layout(TrackLayout layout, const ColumnsSeen& seen,
                                    const RecordingOptions& options) {
  if (seen.count != 4 && seen.count != 7) {
    return missing(
        "a Skybrush CSV has the columns t [ms], x, y, z, and perhaps red, green, blue; " +
        list_columns(seen));
  }
  ColumnChoice& choice = layout.table.choice;
  choice.axes = {1, 2, 3};
  choice.evidence = Frame::kMetres;
  if (options.units.any()) {
    return Error{ErrorCode::kInvalidArgument,
                 "a Skybrush CSV is in metres, but --units is given; leave it out, or name the "
                 "columns with --columns",
                 {}};
  }
  choice.units_taken = {
      {"x, y and z", Unit::kMetre, UnitEvidence::kNamed, "a Skybrush CSV is in metres"}};
  layout.units = choice.units_taken;
  const FrameDecision frame =
      frame_before_values(options.frame, {Frame::kMetres, "a Skybrush CSV is in metres"});
  layout.frame = frame.frame;
  layout.frame_reason = frame.reason;
  TimeChoice time;
  time.unit = options.time_unit != TimeUnit::kAuto ? options.time_unit : TimeUnit::kMilliseconds;
  layout.time = time;
  layout.notes.push_back("without a header, this is taken for a Skybrush CSV: t in " +
                         std::string(unit_name(time.unit)) + ", then x, y, z in metres" +
                         (seen.count == 7 ? " and a colour" : ""));
  return layout;
}

Result<TrackLayout> choose_all(TrackLayout layout, std::string_view text, ColumnsSeen& seen,
                               const RecordingOptions& options) {
  const auto wishes = read_track_wishes(options.columns, seen);
  if (!wishes) return wishes.error();
  const std::vector<TrackWord> words = read_words(seen, *wishes);
  auto time = choose_time(text, layout.table, seen, *wishes, words, options);
  if (!time) return time.error();
  layout.time = time.value();
  const auto id = choose_id(seen, *wishes, words, layout.notes);

  seen.taken.assign(seen.count, false);
  for (std::size_t i = 0; i < words.size(); ++i) {
    seen.taken[i] =
        words[i].role != TrackRole::kNone || i == id || i == wishes->time ||
        std::find(wishes->velocity.begin(), wishes->velocity.end(), i) != wishes->velocity.end();
  }
  auto position = choose_position(seen, *wishes, options);
  if (!position) return position.error();
  layout.table.choice = std::move(position).value();
  ColumnChoice& choice = layout.table.choice;
  choice.id = id;
  const FrameDecision frame = frame_before_values(options.frame, {choice.evidence, choice.reason});
  layout.frame = frame.frame;
  layout.frame_reason = frame.reason;
  layout.units = choice.units_taken;
  UnitChoice units(seen.names, options.units);
  auto velocity = choose_velocity({seen, *wishes, words, choice, layout.frame, units}, layout.notes,
                                  layout.units);
  if (!velocity) return velocity.error();
  layout.velocity = *velocity;
  if (!layout.time && !layout.velocity) {
    return missing(no_time(seen, words));
  }
  if (auto error = doubly_used(layout)) return *std::move(error);
  if (layout.time) {
    layout.notes.push_back(time_note(seen, *layout.time, options.time_unit != TimeUnit::kAuto));
  }
  layout.notes.push_back(position_note(seen, choice, layout.frame));
  return layout;
}

}  // namespace

Result<TrackLayout> choose_track_layout(TableLayout table, std::string_view text, ColumnsSeen& seen,
                                        const RecordingOptions& options) {
  TrackLayout layout;
  layout.table = std::move(table);
  return choose_all(std::move(layout), text, seen, options);
}

Result<TrackLayout> find_track_layout(std::string_view text, const RecordingOptions& options,
                                      bool bare_skybrush) {
  ColumnsSeen seen;
  auto table = find_table(text, options.skip_bad, seen);
  if (!table) return table.error();
  TrackLayout layout;
  layout.table = std::move(table).value();
  const std::uint64_t line = first_line(layout.table);
  if (auto error = no_record_problem(text, layout.table)) return *std::move(error);
  auto chosen = bare_skybrush && seen.names.empty() && options.columns.empty()
                    ? skybrush_layout(std::move(layout), seen, options)
                    : choose_all(std::move(layout), text, seen, options);
  if (chosen) return chosen;
  Error error = chosen.error();
  // What is wrong with --columns as such is no matter of a line.
  if (error.code != ErrorCode::kInvalidArgument || error.place.column) error.place.line = line;
  return error;
}

}  // namespace beespace::io
