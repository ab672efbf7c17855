#include "io/tracks/known_tables.hpp"

#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/tracks/track_columns.hpp"
#include "io/tracks/track_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

// Whether a first column that goes on by so much may count seconds, or the pictures of an
// animation: each, every fifth or tenth, or one a second of 24, 25, 30, 48 or 60. No tool samples a
// show more often than each 20 ms, or writes it in such steps.
bool may_count_pictures(double step) {
  constexpr double kShortestStep_ms = 20.0;
  return step < kShortestStep_ms || step == 24.0 || step == 25.0 || step == 30.0 || step == 48.0 ||
         step == 60.0;
}

// Positions of a show are written some times a second.
constexpr double kLongestStep_s = 2.0;

bool is_whole(double value) {
  return value == std::floor(value);
}

// Milliseconds, unless the options say otherwise, or they are no whole numbers, and seconds.
Result<TimeChoice> time_of_skybrush(const TableLayout& table, std::string_view text,
                                    const RecordingOptions& options) {
  TimeChoice time;
  const bool said = options.time_unit != Unit::kUnstated;
  if (options.frames_per_second && said) {
    return Error{ErrorCode::kInvalidArgument,
                 "--fps says that the first column counts pictures, and --time-unit another unit; "
                 "leave one of them out",
                 {}};
  }
  if (options.frames_per_second) {
    time.form = TimeForm::kFrames;
    time.frames_per_second = *options.frames_per_second;
    return time;
  }
  const FirstFields times = first_fields(text, table, 0);
  double first = 0.0;
  double second = 0.0;
  const bool numbers = times.texts.size() > 1 &&
                       parse_number(times.texts[0], first) == NumberKind::kNumber &&
                       parse_number(times.texts[1], second) == NumberKind::kNumber;
  // Milliseconds and pictures are whole, and no two of them so close.
  if (!said && numbers && second - first < kLongestStep_s &&
      (!is_whole(first) || !is_whole(second))) {
    time.unit = Unit::kSecond;
    time.named = true;
    return time;
  }
  if (!said && options.format != RecordingFormat::kSkybrushCsv && numbers &&
      may_count_pictures(second - first)) {
    return Error{ErrorCode::kInvalidArgument,
                 "without a header, the first column, which begins with " +
                     excerpt(times.texts[0]) + ", " + excerpt(times.texts[1]) +
                     ", may count pictures, seconds or milliseconds; say --fps 24 for so many "
                     "pictures a second, --time-unit s, or --time-unit ms",
                 times.first};
  }
  time.unit = said ? options.time_unit : Unit::kMillisecond;
  time.named = !said;
  return time;
}

// Seconds, but for times since 1970 whose size says another unit: as ROS has them, nanoseconds.
Unit unit_of_stamps(std::string_view text, const TableLayout& table) {
  double first = 0.0;
  const FirstFields stamps = first_fields(text, table, 0);
  if (stamps.empty() ||
      parse_number(without_padding(stamps.front()), first) != NumberKind::kNumber) {
    return Unit::kSecond;
  }
  const Unit by_size = unit_since_1970(first);
  return by_size == Unit::kUnstated ? Unit::kSecond : by_size;
}

// The format says the unit, and whether there is one clock.
void settle_clock(TimeChoice& time) {
  time.unit_is_asked = time.is_small = time.begins_at_zero = time.zero_unsaid = false;
}

// Places are measured with some noise. Two robots of one frame cannot both stand there.
constexpr double kNearZero_m = 0.1;
constexpr double kHardlyTurned = 0.02;  // by numbers of a quaternion

// Whether the first place of a table is 0, 0, 0, or near it, as where a robot was switched on.
bool begins_at_zero(std::string_view text, const TableLayout& table) {
  const auto& axes = table.choice.axes;
  return std::all_of(axes.begin(), axes.end(), [&](std::size_t column) {
    const FirstFields fields = first_fields(text, table, column);
    double number = 0.0;
    return !fields.empty() &&
           parse_number(without_padding(fields.front()), number) == NumberKind::kNumber &&
           std::abs(number) <= kNearZero_m;
  });
}

// Whether a trajectory begins at 0, 0, 0, or near it, without a turn, as where a robot was switched
// on.
bool begins_at_its_own_origin(std::string_view text, const TableLayout& table) {
  for (std::size_t column = 1; column < 8; ++column) {
    const FirstFields fields = first_fields(text, table, column);
    double number = 0.0;
    if (fields.empty() || parse_number(fields.front(), number) != NumberKind::kNumber) return false;
    const bool within = column < 4    ? std::abs(number) <= kNearZero_m
                        : column == 7 ? std::abs(number) >= 1.0 - kHardlyTurned
                                      : std::abs(number) <= kHardlyTurned;
    if (!within) return false;
  }
  return true;
}

// By how much the stamps of the header are later than the times of recording: of the message that
// was recorded fastest. Nothing where one of them does not count from 1970.
std::optional<double> stamps_ahead(std::string_view text, const TrackLayout& layout,
                                   std::size_t recorded) {
  const TimeChoice& time = *layout.time;
  if (!time.since_1970 || time.form != TimeForm::kNumbers || time.column == recorded) {
    return std::nullopt;
  }
  const FirstFields stamps = first_fields(text, layout.table, time.column);
  const FirstFields times = first_fields(text, layout.table, recorded);
  if (stamps.texts.size() != times.texts.size()) return std::nullopt;
  FirstFields rests;
  if (time.nanoseconds) rests = first_fields(text, layout.table, *time.nanoseconds);
  std::optional<double> ahead_s;
  for (std::size_t i = 0; i < stamps.texts.size(); ++i) {
    double stamp = 0.0;
    double rest = 0.0;
    double recorded_at = 0.0;
    if (parse_number(stamps.texts[i], stamp) != NumberKind::kNumber ||
        parse_number(times.texts[i], recorded_at) != NumberKind::kNumber) {
      return std::nullopt;
    }
    if (i < rests.texts.size()) parse_number(rests.texts[i], rest);
    const Unit unit = unit_since_1970(recorded_at);
    if (unit == Unit::kUnstated) return std::nullopt;
    const double by_s = in_metric(stamp, time.unit) + in_metric(rest, Unit::kNanosecond) -
                        in_metric(recorded_at, unit);
    ahead_s = std::max(ahead_s.value_or(by_s), by_s);
  }
  return ahead_s;
}

bool counts_from_1970(std::string_view text, const TableLayout& table, std::size_t column) {
  const FirstFields times = first_fields(text, table, column);
  double first = 0.0;
  return !times.empty() && parse_number(times.front(), first) == NumberKind::kNumber &&
         unit_since_1970(first) != Unit::kUnstated;
}

// Units that no header names are those of the format.
void name_units(TrackLayout& layout, std::string_view reason) {
  for (UnitTaken& taken : layout.units) {
    if (taken.evidence != UnitEvidence::kUsual) continue;
    taken.evidence = UnitEvidence::kNamed;
    taken.reason = reason;
  }
}

}  // namespace

// Whether a table without a header can hardly be anything else: times that ascend, from 0 where
// they are not whole, three numbers, and three whole ones up to 255.
bool is_path_with_colours(std::string_view text, const TableLayout& table) {
  constexpr std::size_t kColumns = 7;
  constexpr std::uint64_t kRows = 100;
  if (!table.names.empty() || table.columns != kColumns) return false;
  RecordWalk walk(text, table.data_offset, table);
  std::optional<double> before;
  double first = 0.0;
  while (walk.next() && walk.row() < kRows) {
    FieldCursor cursor(walk.record(), table.delimiter);
    Field field;
    for (std::size_t column = 0; column < kColumns; ++column) {
      if (!cursor.next(field)) return false;
      if (column >= 1 && column <= 3) continue;
      if (column == 0) {
        const auto time = parse_number(field.text);
        if (!time || !(*time >= 0.0) || (before && !(*time > *before))) return false;
        if (!before) first = *time;
        if (!is_whole(*time) && first != 0.0) return false;
        before = time;
        continue;
      }
      const auto whole = parse_whole(field.text);
      if (!whole || *whole > 255) return false;
    }
  }
  return true;
}

// t [ms], x, y, z, and perhaps red, green and blue.
Result<TrackLayout> skybrush_layout(TableLayout table, std::string_view text,
                                    const RecordingOptions& options) {
  TrackLayout layout;
  layout.table = std::move(table);
  const std::size_t columns = layout.table.columns;
  if (columns != 4 && columns != 7) {
    return missing_column(
        "a Skybrush CSV has the columns t [ms], x, y, z, and perhaps red, green, blue; " +
        list_columns(layout.table));
  }
  ColumnChoice& choice = layout.table.choice;
  choice.axes = {1, 2, 3};
  choice.evidence = Frame::kMetres;
  UnitOverrides others = options.units;
  const Unit said = std::exchange(others.position, Unit::kUnstated);
  if (others.any()) {
    return Error{ErrorCode::kInvalidArgument,
                 "a Skybrush CSV has positions alone; say their unit with --units position=cm, and "
                 "leave other units out, or name the columns with --columns",
                 {}};
  }
  const bool supposed = said == Unit::kUnstated;
  if (supposed) layout.doubted_above_mps = kFastestShow_mps;
  const Unit unit = supposed ? Unit::kMetre : said;
  choice.units = {unit, unit, unit};
  choice.units_taken = {{"x, y and z", unit, UnitEvidence::kNamed,
                         supposed ? "a Skybrush CSV is in metres" : "--units says so"}};
  layout.units = choice.units_taken;
  const FrameDecision frame =
      frame_before_values(options.frame, {Frame::kMetres, "a Skybrush CSV is in metres"});
  layout.frame = frame.frame;
  layout.frame_reason = frame.reason;
  layout.show = true;
  auto time = time_of_skybrush(layout.table, text, options);
  if (!time) return time.error();
  layout.time = *time;
  const bool frames = time->form == TimeForm::kFrames;
  layout.notes.push_back("without a header, this is taken for a Skybrush CSV: t in " +
                         (frames ? "frames, " + exact(time->frames_per_second) + " a second"
                                 : std::string(symbol_of(time->unit))) +
                         ", then x, y, z in " +
                         (unit == Unit::kMetre ? "metres" : std::string(symbol_of(unit))) +
                         (columns == 7 ? " and a colour" : ""));
  return layout;
}

namespace {

bool names_role(const RecordingOptions& options, Role role) {
  const auto said = read_column_overrides(track_columns(), options.columns, options.frame);
  return said && std::any_of(said->begin(), said->end(),
                             [role](const ColumnOverride& one) { return one.role == role; });
}

}  // namespace

bool names_columns_of_ros(const RecordingOptions& options) {
  const auto said = read_column_overrides(track_columns(), options.columns, options.frame);
  return said && std::all_of(said->begin(), said->end(), [](const ColumnOverride& one) {
           return one.role == Role::kTime || one.role == Role::kId || one.role == Role::kX ||
                  one.role == Role::kY || one.role == Role::kZ;
         });
}

bool names_position(const RecordingOptions& options) {
  return names_role(options, Role::kX);
}

Result<TrackLayout> ros_layout(const RosTable& ros, TableLayout table, std::string_view text,
                               RecordingOptions options, SeenRecords seen) {
  const bool time_is_said = names_role(options, Role::kTime);
  const bool each_child = ros.child && !names_role(options, Role::kId);
  if (!names_position(options)) {
    options.columns.insert(0, ros.columns + (options.columns.empty() ? "" : ","));
  }
  if (each_child) options.columns += ",id=" + std::to_string(*ros.child + 1);
  table.names = ros.names;
  auto layout = choose_track_layout(table, text, options, seen);
  // Stamps that count from where a robot was switched on are not those of another one.
  if (layout && layout->time && !layout->time->since_1970 &&
      layout->time->form == TimeForm::kNumbers && !time_is_said && ros.recorded &&
      counts_from_1970(text, table, *ros.recorded)) {
    options.columns += ",time=" + std::to_string(*ros.recorded + 1);
    layout = choose_track_layout(table, text, options, seen);
    if (layout) {
      layout->notes.push_back(
          "the stamps of the header do not count from 1970: times are those of "
          "recording, " +
          column_text(table, *ros.recorded));
    }
  }
  if (!layout) return layout;
  if (layout->time && ros.recorded)
    layout->stamps_ahead_s = stamps_ahead(text, *layout, *ros.recorded);
  if (layout->time && layout->time->form == TimeForm::kNumbers && !layout->time->since_1970) {
    layout->time->since_start = !options.one_clock;
    settle_clock(*layout->time);
  }
  if (options.frame == Frame::kAuto && layout->frame == Frame::kMetres) {
    layout->frame_reason = "positions of ROS are in metres";
  } else if (options.frame == Frame::kAuto && ros.columns.starts_with("lon=")) {
    layout->frame_reason = "NavSatFix tells longitude, latitude and height";
  }
  layout->doubted_above_mps = std::nullopt;
  name_units(*layout, "messages of ROS have them so");
  layout->own_origin = options.frame == Frame::kAuto && layout->frame == Frame::kMetres &&
                       begins_at_zero(text, layout->table);
  layout->axes_name = ros.axes_name;
  if (ros.axes_name) {
    const FirstFields axes = first_fields(text, layout->table, *ros.axes_name);
    if (!axes.empty()) layout->first_axes = without_padding(axes.front());
  }
  layout->ids_within_file = each_child;
  layout->notes.push_back(ros.note);
  if (each_child) {
    layout->notes.push_back("each " + table.names[*ros.child] +
                            " is taken for a bee; of several files, for one of that file");
  }
  return layout;
}

// Trajectories as the TUM RGB-D benchmark has them, and evo and ORB-SLAM write them: no header but
// perhaps a comment, a time, a place, and the turn as a quaternion, whose length is 1.
bool is_trajectory_of_poses(std::string_view text, const TableLayout& table) {
  constexpr std::size_t kColumns = 8;
  constexpr std::uint64_t kRows = 100;
  // The comment that it may begin with is one of its own.
  const bool named = !table.names.empty() && (table.names.size() < 2 || table.names[1] != "tx");
  if (named || table.columns != kColumns) return false;
  RecordWalk walk(text, table.data_offset, table);
  std::optional<double> before_s;
  bool any_placed = false;
  while (walk.next() && walk.row() < kRows) {
    FieldCursor cursor(walk.record(), table.delimiter);
    double length = 0.0;
    bool is_placed = true;
    for (std::size_t column = 0; column < kColumns; ++column) {
      Field field;
      if (!cursor.next(field)) return false;
      double number = 0.0;
      const NumberKind kind = parse_number(without_padding(field.text), number);
      // Where the place is not known, all of the pose may be not-a-numbers.
      const bool unknown = kind == NumberKind::kNotFinite && column > 0;
      if (kind != NumberKind::kNumber && !unknown) return false;
      is_placed = is_placed && !unknown;
      if (column == 0 && before_s && number <= *before_s) return false;
      if (column == 0) before_s = number;
      if (column > 3) length += number * number;
    }
    if (!is_placed) continue;
    if (!(length > 0.98 && length < 1.02)) return false;
    any_placed = true;
  }
  return any_placed;
}

Result<TrackLayout> layout_of_poses(TableLayout table, std::string_view text,
                                    RecordingOptions options, SeenRecords seen) {
  const bool unit_is_said = options.time_unit != Unit::kUnstated;
  options.columns = "time=1,x=2,y=3,z=4";
  if (!unit_is_said) options.time_unit = unit_of_stamps(text, table);
  const bool asked = options.frame == Frame::kMetres;
  if (options.frame == Frame::kAuto) options.frame = Frame::kMetres;
  const bool own_origin = !asked && begins_at_its_own_origin(text, table);
  auto layout = choose_track_layout(std::move(table), text, options, seen);
  if (!layout) return layout;
  layout->own_origin = own_origin;
  layout->doubted_above_mps = std::nullopt;
  if (!asked) layout->frame_reason = "trajectories as of TUM are in metres";
  name_units(*layout, "trajectories as of TUM have them so");
  TimeChoice& time = *layout->time;
  const std::string told = time_note(layout->table, time, true);
  time.by_size = !unit_is_said && time.since_1970;
  time.since_start = !time.since_1970 && !options.one_clock;
  settle_clock(time);
  if (!unit_is_said) {
    std::replace(layout->notes.begin(), layout->notes.end(), told,
                 time_note(layout->table, time, false));
  }
  layout->notes.emplace_back("this is taken for a trajectory as of TUM: time [" +
                             std::string(symbol_of(time.unit)) + "], x, y, z [m] and a quaternion");
  return layout;
}

}  // namespace beespace::io
