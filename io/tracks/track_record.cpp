#include "io/tracks/track_record.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/bytes/number_text.hpp"
#include "io/frames/to_metres.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/joined_place.hpp"
#include "io/tracks/scaled_degrees.hpp"
#include "io/tracks/short_number.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_time.hpp"
#include "io/tracks/track_velocity.hpp"
#include "io/tracks/wall_times.hpp"

#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace beespace::io {
namespace {

// Heights by pressure may be written as flight levels, and those of which it is not said by what.
bool may_be_levels(const TrackLayout& layout) {
  const HeightDatum datum = layout.table.choice.datum;
  return layout.of_aircraft && layout.frame == Frame::kWgs84 &&
         (datum == HeightDatum::kPressure || datum == HeightDatum::kUnstated);
}

// "FL350": the number of hundreds of feet.
std::optional<double> flight_level_in(std::string_view text) {
  if (text.size() < 3 || lower_case(text.substr(0, 2)) != "fl") return std::nullopt;
  const auto level = parse_whole(without_padding(text.substr(2)));
  constexpr std::uint64_t kHighest = 999;
  if (!level || *level > kHighest) return std::nullopt;
  return static_cast<double>(*level);
}

// Flight levels in the unit of a column of heights.
double in_unit_of(const ColumnChoice& choice, double level) {
  constexpr double kFeet = 100.0;
  if (choice.units[2] == Unit::kFoot) return kFeet * level;
  if (choice.units[2] == Unit::kFlightLevel) return level;
  return from_metric(in_metric(kFeet * level, Unit::kFoot), choice.units[2]);
}

Error outside_domain(std::string_view text, std::string_view name, std::string_view unit,
                     std::size_t column) {
  return at_column(ErrorCode::kOutsideDomain,
                   excerpt(text) + " cannot be computed with exactly (" + std::string(name) +
                       "); use 0, or a size of " + std::string(kMotionDomain) + std::string(unit),
                   column);
}

std::string_view coordinate_name(const TrackLayout& layout, std::size_t axis) {
  constexpr std::array<std::string_view, 3> kGeographic = {"longitude", "latitude", "height"};
  constexpr std::array<std::string_view, 3> kMetres = {"x", "y", "z"};
  return layout.frame == Frame::kWgs84 ? kGeographic[axis] : kMetres[axis];
}

bool is_of_argos(std::string_view sensor) {
  return lower_case(without_padding(sensor)).starts_with("argos");
}

}  // namespace

TrackRecordReader::TrackRecordReader(const TrackLayout& layout)
    : layout_(layout),
      names_aircraft_(tells_of_aircraft(layout)),
      takes_flight_levels_(may_be_levels(layout)),
      slots_(slots_of(layout)) {
}

std::optional<Error> TrackRecordReader::read_id(TrackRecord& record) {
  const ColumnChoice& choice = layout_.table.choice;
  if (!choice.id) return std::nullopt;
  const Field& field = fields_[TrackSlot::kId];
  if (layout_.without_id != nullptr && is_unknown(field.text)) {
    record.left_out = layout_.without_id;
    return std::nullopt;
  }
  if (is_named_by_file_where_empty(layout_) && field.text.empty()) return std::nullopt;
  if (field.text.empty()) {
    return at_column(ErrorCode::kMalformedRecord,
                     "the id is empty; fill it in" + std::string(kOrLeaveOut), *choice.id);
  }
  // All of whom it is not known who they are would become one.
  if (is_unknown(field.text)) {
    return at_column(ErrorCode::kMalformedRecord,
                     "the id " + excerpt(field.text) +
                         " says that it is not known; fill it in, or write another name" +
                         std::string(kOrLeaveOut),
                     *choice.id);
  }
  record.id = field.text;
  if (field.doubled_quotes) {
    unquoted_id_ = unquoted(field);
    record.id = unquoted_id_;
  }
  return std::nullopt;
}

void TrackRecordReader::read_label(TrackRecord& record) {
  record.label = {};
  if (!layout_.label) return;
  const Field& field = fields_[TrackSlot::kLabel];
  record.label = without_padding(field.text);
  if (is_unknown(record.label)) record.label = {};
  if (!field.doubled_quotes) return;
  unquoted_label_ = unquoted(field);
  record.label = unquoted_label_;
}

void TrackRecordReader::read_sets(TrackRecord& record) {
  record.set = {};
  record.trial = {};
  if (layout_.sets.empty()) return;
  const auto append = [this](std::string& text, std::size_t i, bool first) {
    if (!first) text += ", ";
    text.append(without_padding(fields_[TrackSlot::kSets + i].text));
  };
  joined_sets_.clear();
  for (std::size_t i = 0; i < layout_.sets.size(); ++i) append(joined_sets_, i, i == 0);
  record.set = joined_sets_;
  joined_trials_.clear();
  for (const std::size_t i : layout_.trials) {
    append(joined_trials_, i, i == layout_.trials.front());
  }
  record.trial = joined_trials_;
}

void TrackRecordReader::read_scenes(TrackRecord& record) {
  record.scene = {};
  if (layout_.scenes.empty()) return;
  joined_scenes_.clear();
  for (const std::size_t column : layout_.scenes) {
    if (!joined_scenes_.empty()) joined_scenes_ += ", ";
    joined_scenes_.append(without_padding(fields_[slots_[column]].text));
  }
  record.scene = joined_scenes_;
}

std::optional<Error> TrackRecordReader::read_time(TrackRecord& record) {
  if (!layout_.time) return std::nullopt;
  const TimeChoice& time = *layout_.time;
  const std::string_view text = without_padding(fields_[TrackSlot::kTime].text);
  if (time.form == TimeForm::kDatesAndTimes || time.form == TimeForm::kClock) {
    const std::string_view day = without_padding(fields_[TrackSlot::kDate].text);
    double again_after_s = 0.0;
    record.is_bare_midnight = time.bare_midnights && is_day_alone(text, time.dates);
    record.is_midnight = time.bare_midnights && says_midnight(text);
    const std::string problem = record.is_bare_midnight
                                    ? read_wall_time(time, std::string(text) + " 00:00:00", day,
                                                     record.time_s, again_after_s)
                                    : read_wall_time(time, text, day, record.time_s, again_after_s);
    if (problem.empty()) return std::nullopt;
    Error error = at_column(ErrorCode::kNotANumber,
                            excerpt(text) + " is not a time: " + problem + std::string(kOrLeaveOut),
                            time.column);
    if (!takes_doubled_ || again_after_s == 0.0) return error;
    record.doubled = TrackRecord::Doubled{again_after_s, std::move(error)};
    return std::nullopt;
  }
  if (time.nanoseconds) return read_stamp(text, record);
  double value = 0.0;
  const NumberKind kind = read_number(text, value);
  if (kind == NumberKind::kNotFinite) {
    return at_column(ErrorCode::kNotFinite,
                     excerpt(text) + " is no time; correct it" + std::string(kOrLeaveOut),
                     time.column);
  }
  if (kind != NumberKind::kNumber) {
    return number_problem(kind, text, "time", std::string(kMotionDomain) + " s", time.column);
  }
  if (time.by_size && unit_since_1970(value) != time.unit) {
    return at_column(ErrorCode::kOutsideDomain,
                     excerpt(text) + " is no time since 1970 in " +
                         std::string(symbol_of(time.unit)) +
                         ", as the first times are; say the unit of all with --time-unit, or "
                         "correct it" +
                         std::string(kOrLeaveOut),
                     time.column);
  }
  record.time_s =
      without_dust(time.form == TimeForm::kFrames ? value / time.frames_per_second
                                                  : in_metric(value, time.unit) + time.zero_s);
  if (in_motion_domain(record.time_s)) return std::nullopt;
  return outside_domain(text, "time", " s", time.column);
}

// Whole seconds, and what of the next one has passed in nanoseconds.
std::optional<Error> TrackRecordReader::read_stamp(std::string_view text, TrackRecord& record) {
  constexpr double kNanosecondsPerSecond = 1e9;
  const TimeChoice& time = *layout_.time;
  const auto whole = [](std::string_view number, double& value) {
    return read_number(number, value) == NumberKind::kNumber && value == std::floor(value);
  };
  double seconds = 0.0;
  if (!whole(text, seconds)) {
    return at_column(ErrorCode::kNotANumber,
                     excerpt(text) +
                         " is no number of whole seconds, beside nanoseconds; correct "
                         "it" +
                         std::string(kOrLeaveOut),
                     time.column);
  }
  const std::string_view rest = without_padding(fields_[TrackSlot::kNanoseconds].text);
  double nanoseconds = 0.0;
  if (!whole(rest, nanoseconds) || nanoseconds < 0.0 || nanoseconds >= kNanosecondsPerSecond) {
    return at_column(ErrorCode::kNotANumber,
                     excerpt(rest) +
                         " is no number of nanoseconds, 0 to 999999999, beside whole "
                         "seconds; correct it" +
                         std::string(kOrLeaveOut),
                     *time.nanoseconds);
  }
  record.time_s = without_dust(seconds + nanoseconds / kNanosecondsPerSecond);
  if (in_motion_domain(record.time_s)) return std::nullopt;
  return outside_domain(text, "time", " s", time.column);
}

std::optional<Error> TrackRecordReader::read_position(TrackRecord& record) {
  const ColumnChoice& choice = layout_.table.choice;
  std::array<double, 3> values = {};
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    const std::string_view text = without_padding(fields_[TrackSlot::kPosition + axis].text);
    NumberKind kind = read_number(text, values[axis]);
    if (kind != NumberKind::kNumber && axis == 2 && takes_flight_levels_) {
      if (const auto level = flight_level_in(text)) {
        values[axis] = in_unit_of(choice, *level);
        kind = NumberKind::kNumber;
      }
    }
    if (kind != NumberKind::kNumber) {
      return number_problem(kind, text, coordinate_name(layout_, axis),
                            std::string(kMotionDomain) + " m", choice.axes[axis]);
    }
    if (layout_.scaled_degrees && axis < 2) {
      if (values[axis] != std::floor(values[axis])) {
        return at_column(ErrorCode::kMalformedRecord,
                         excerpt(text) +
                             " is no whole number of 1e-7 degrees, as the first are; correct it" +
                             std::string(kOrLeaveOut),
                         choice.axes[axis]);
      }
      values[axis] /= kScaledPerDegree;
    }
    if (axis < layout_.sides.size() && layout_.sides[axis]) {
      const std::string problem =
          take_side(axis, fields_[TrackSlot::kSide + axis].text, values[axis]);
      if (!problem.empty()) {
        return at_column(ErrorCode::kMalformedRecord, problem + std::string(kOrLeaveOut),
                         *layout_.sides[axis]);
      }
    }
    values[axis] = without_dust(values[axis]);
    if (!in_motion_domain(values[axis])) {
      return outside_domain(text, coordinate_name(layout_, axis), " m", choice.axes[axis]);
    }
  }
  record.stated_height = layout_.z_is_down ? without_dust(-values[2]) : values[2];
  record.position = {values[0], values[1], values[2]};
  if (!choice.is_metric()) {
    const Point metric = without_dust(in_metric(record.position, choice));
    record.position = metric;
    for (const auto& [axis, value] :
         {std::pair{0, metric.x}, std::pair{1, metric.y}, std::pair{2, metric.z}}) {
      if (in_motion_domain(value)) continue;
      const auto place = static_cast<std::size_t>(axis);
      return outside_domain(without_padding(fields_[TrackSlot::kPosition + place].text),
                            coordinate_name(layout_, place), " m", choice.axes[place]);
    }
  }
  if (layout_.z_is_down) record.position.z = without_dust(-record.position.z);
  if (layout_.frame != Frame::kWgs84 || layout_.local_origin) return std::nullopt;
  const auto problem =
      find_out_of_range(std::span<const Point>(&record.position, 1), 0, Frame::kWgs84);
  if (!problem) return std::nullopt;
  Error error =
      range_error(*problem, record.position,
                  std::string(without_padding(fields_[TrackSlot::kPosition + problem->axis].text)),
                  symbol_of(choice.units[problem->axis]));
  error.location.column = choice.axes[problem->axis] + 1;
  return error;
}

std::optional<Error> TrackRecordReader::read_velocity(TrackRecord& record) {
  if (!layout_.velocity) return std::nullopt;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const VelocityChoice& velocity = *layout_.velocity;
  // Bees that have no height do not climb; of others it is not known.
  std::array<double, 3> values = {0.0, 0.0, layout_.table.choice.dimensions == 2 ? 0.0 : kUnknown};
  for (std::size_t i = 0; i < velocity.dimensions; ++i) {
    const std::string_view text = without_padding(fields_[TrackSlot::kVelocity + i].text);
    const NumberKind kind =
        is_unknown(text) ? NumberKind::kNotFinite : read_number(text, values[i]);
    values[i] = without_dust(values[i]);
    if (kind == NumberKind::kNotFinite) {
      values[i] = kUnknown;
    } else if (kind != NumberKind::kNumber) {
      return number_problem(kind, text, "velocity", std::string(kMotionDomain) + " m/s",
                            velocity.columns[i]);
    } else if (!in_motion_domain(values[i])) {
      return outside_domain(text, "velocity", " m/s", velocity.columns[i]);
    }
  }
  record.velocity = in_metric(values, velocity);
  if (names_aircraft_ && velocity.over_ground && layout_.table.choice.dimensions == 3 &&
      stands_in_air(in_metric(values[0], velocity.units[0]), record.position.z)) {
    record.doubts_standing = true;
    record.velocity.x = record.velocity.y = kUnknown;
  }
  for (const double value : {record.velocity.x, record.velocity.y, record.velocity.z}) {
    if (std::isnan(value) || in_motion_domain(value)) continue;
    return outside_domain(without_padding(fields_[TrackSlot::kVelocity].text), "velocity", " m/s",
                          velocity.columns[0]);
  }
  return std::nullopt;
}

// Where and when an aircraft says that it is on the ground. A mistake there is none in the answer.
void TrackRecordReader::read_claim(TrackRecord& record) {
  record.claim_is_placed = !read_time(record) && !read_position(record);
}

// What cannot be read is not said.
void TrackRecordReader::read_accuracy(TrackRecord& record) const {
  record.off_m = 0.0;
  if (!layout_.accuracy) return;
  double value = 0.0;
  const std::string_view text = without_padding(fields_[TrackSlot::kAccuracy].text);
  if (is_unknown(text) || read_number(text, value) != NumberKind::kNumber) return;
  record.off_m = in_metric(value, layout_.accuracy->unit);
}

std::optional<Error> TrackRecordReader::read(std::string_view line, TrackRecord& record) {
  record.late_height = {};
  record.is_timed = false;
  record.doubts_standing = false;
  if (line.size() > kLongestLine) return long_line(line);
  std::size_t count = 0;
  FieldCursor cursor(line, layout_.table.delimiter);
  const std::size_t columns = slots_.size();
  for (Field field; cursor.next(field); ++count) {
    if (count < columns) fields_[slots_[count]] = field;
  }
  if (layout_.joined_place) {
    const JoinedPlace place = split_place(fields_[TrackSlot::kJoinedPlace].text);
    fields_[TrackSlot::kPosition].text = place.longitude;
    fields_[TrackSlot::kPosition + 1].text = place.latitude;
  }
  if (layout_.time && layout_.time->due &&
      is_unknown(without_padding(fields_[TrackSlot::kTime].text))) {
    fields_[TrackSlot::kTime] = fields_[TrackSlot::kDue];
  }
  if (layout_.no_height_yet && *layout_.no_height_yet < count) {
    const std::string_view height = without_padding(fields_[TrackSlot::kLateHeight].text);
    if (!is_unknown(height)) record.late_height = height;
  }
  if (auto problem = record_problem(line, layout_.table, count, cursor.problem())) return problem;
  record.left_out = nullptr;
  record.doubled.reset();
  record.is_rough = layout_.sensor && is_of_argos(fields_[TrackSlot::kSensor].text);
  read_sets(record);
  read_scenes(record);
  if (auto problem = read_id(record)) return problem;
  if (record.left_out != nullptr) return std::nullopt;
  read_label(record);
  record.tag = {};
  if (layout_.tag) record.tag = without_padding(fields_[TrackSlot::kTag].text);
  if (layout_.zone) record.zone = without_padding(fields_[TrackSlot::kZone].text);
  if (layout_.clock_zone) {
    record.clock_zone = without_padding(fields_[TrackSlot::kClockZone].text);
  }
  if (layout_.axes_name) {
    const bool is_id = layout_.axes_name == layout_.table.choice.id;
    record.axes_name = without_padding(fields_[is_id ? TrackSlot::kId : TrackSlot::kAxesName].text);
  }
  record.left_out = reason_to_leave_out();
  if (record.left_out == nullptr) {
    if (auto problem = unclear_mark(layout_, text_in_slot())) return problem;
  }
  record.flies_on_ground = record.left_out == nullptr && layout_.on_ground &&
                           says_yes(fields_[TrackSlot::kOnGround].text);
  if (record.left_out == &kOnGround) read_claim(record);
  record.is_timed = record.left_out != nullptr &&
                    (has_no_place(*record.left_out) || record.left_out == &kNoPosition) &&
                    layout_.time && !read_time(record);
  if (record.left_out != nullptr) return std::nullopt;
  if (auto problem = read_time(record)) return problem;
  record.is_timed = layout_.time.has_value();
  if (auto problem = read_position(record)) return problem;
  if (auto problem = read_velocity(record)) return problem;
  if (layout_.take_off.any()) {
    record.take_off =
        take_off_said(layout_.take_off, without_padding(fields_[TrackSlot::kAboveTakeOff].text),
                      without_padding(fields_[TrackSlot::kStanding].text), record.position.z);
  }
  record.is_timed = false;
  read_accuracy(record);
  return std::nullopt;
}

}  // namespace beespace::io
