// Live input of one JSON object a line, whose keys are the words that tables have as columns.
//
// The keys become the columns of a TrackLayout: each key that is new makes the layout be chosen
// again, so that "vx" may come later than "x".
#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"
#include "io/frames/to_metres.hpp"
#include "io/frames/track_domain.hpp"
#include "io/json/json_line.hpp"
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/address_names.hpp"
#include "io/recording/ros_frames.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/tracks/known_tables.hpp"
#include "io/tracks/listed_places.hpp"
#include "io/tracks/places_in_one.hpp"
#include "io/tracks/ros_table.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_marks.hpp"
#include "io/tracks/track_time.hpp"
#include "io/tracks/track_velocity.hpp"
#include "io/tracks/wall_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kMostKeys = 64;

ColumnContent content_of(JsonElement value) {
  if (value.is_null()) return ColumnContent::kUnknown;
  return value.is_number() ? ColumnContent::kNumber : ColumnContent::kText;
}

// What a field of a table would hold of it: enough to tell dates from numbers.
std::string field_text(JsonElement value) {
  std::string_view text;
  if (double number = 0.0; value.get(number)) return exact(number);
  if (!value.get(text)) return value.is_null() ? "" : std::string(json_kind(value));
  std::string field(text.substr(0, 40));
  for (char& c : field) {
    if (c == '"' || static_cast<unsigned char>(c) < ' ') c = '?';
  }
  return field;
}

class JsonLines final : public LineReader {
 public:
  explicit JsonLines(const RecordingOptions& options) : options_(options) {}

  Result<std::optional<ReportLine>> read(std::string_view line) override {
    last_id_.clear();
    hides_ = false;
    if (unit_problem_) return *unit_problem_;
    const auto object = line_.parse(line);
    if (!object) return object.error();
    if (object->size() == 0) {
      return Error{ErrorCode::kMissingColumn, "this object is empty; leave it out", {}};
    }
    if (auto error = sort_values(*object)) return *std::move(error);
    return read_report();
  }

  [[nodiscard]] bool settled() const override { return chosen_; }
  [[nodiscard]] std::string_view last_id() const override { return last_id_; }
  [[nodiscard]] bool hides() const override { return hides_; }
  [[nodiscard]] bool of_aircraft() const override { return of_aircraft_; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts;
    facts.description = "JSON, an object a line";
    if (!chosen_) return facts;
    facts.notes = layout_.notes;
    for (std::string& note : left_out_.notes()) facts.notes.push_back(std::move(note));
    facts.units = layout_.units;
    facts.heights = layout_.table.choice.datum;
    return facts;
  }

 private:
  // Puts each value where it belongs; learns the keys that are new.
  std::optional<Error> sort_values(JsonMap object) {
    for (int attempt = 0;; ++attempt) {
      values_ = {};
      bool new_keys = false;
      std::size_t expected = 0;
      for (const auto [key, value] : object) {
        std::size_t column = expected;
        if (column >= names_.size() || names_[column] != key) {
          column = static_cast<std::size_t>(std::find(names_.begin(), names_.end(), key) -
                                            names_.begin());
        }
        if (column == names_.size()) {
          new_keys = new_keys || names_.size() < kMostKeys;
          continue;
        }
        expected = column + 1;
        values_[slots_[column]] = value;
      }
      if (!new_keys || attempt > 0) return std::nullopt;
      learn(object);
      auto error = choose(object);
      if (error && chosen_ && error->code == ErrorCode::kInvalidArgument) {
        // What came before was taken for metres in good faith; what comes now is doubtful.
        unit_problem_ = error;
        return error;
      }
      if (error && !chosen_) {
        // What this object lacks or has too much of is no matter of the next one.
        names_.clear();
        said_.clear();
        slots_.clear();
        return error;
      }
    }
  }

  void learn(JsonMap object) {
    for (const auto [key, value] : object) {
      if (names_.size() == kMostKeys) break;
      if (std::find(names_.begin(), names_.end(), key) != names_.end()) continue;
      names_.emplace_back(key);
      said_.emplace_back();
      slots_.push_back(TrackSlot::kNothing);
    }
  }

  // The layout of all keys known so far. A former one stays where there is an error.
  std::optional<Error> choose(JsonMap object) {
    TableLayout table;
    table.delimiter = kUnitSeparator;
    table.columns = names_.size();
    table.names = names_;
    std::string record;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      JsonElement value;
      const bool says = object.get(names_[i], value) && !value.is_null();
      // One without it, as a message of another kind, takes back nothing of what others have said.
      if (says) said_[i] = {content_of(value), field_text(value)};
      table.contents.push_back(said_[i].content);
      if (i > 0) record += kUnitSeparator;
      record += said_[i].text;
    }
    if (auto problem = place_within(object, record, table)) return problem;
    auto ros = names_columns_of_ros(options_)
                   ? find_ros_table(record, table, !names_position(options_))
                   : std::nullopt;
    prefer_own_id(table, ros);
    auto layout = ros ? ros_layout(*ros, std::move(table), record, options_, SeenRecords::kSome)
                      : choose_track_layout(std::move(table), record, options_);
    if (!layout && is_look(object)) {
      return Error{ErrorCode::kUnsupportedFormat,
                   "this is a look at many aircraft in one line (aircraft.json), and an aircraft a "
                   "line is taken; make that of it: jq -c --unbuffered '.now as $now | .aircraft[] "
                   "| .now = $now'; what is recorded is for 'beespace replay'",
                   {}};
    }
    if (!layout) return of_keys(std::move(layout).error());
    if (auto problem = live_problem(*layout, options_.frame)) return problem;
    if (chosen_ && !goes_on(*layout)) return std::nullopt;
    layout_ = std::move(layout).value();
    of_aircraft_ = tells_of_aircraft(layout_);
    chosen_ = true;
    slots_ = slots_of(layout_);
    return std::nullopt;
  }

  // What is wrong with an object whose place is in an array, or in an object within it.
  [[nodiscard]] std::optional<Error> place_within(JsonMap object, std::string_view record,
                                                  const TableLayout& table) const {
    const auto has = [object](std::string_view key) {
      JsonElement value;
      return object.get(key, value);
    };
    const std::vector<std::string_view> keys(names_.begin(), names_.end());
    const bool of_messages = has("msg") || has("meta");  // of rosbridge, of mavlogdump
    if (!options_.columns.empty() || of_messages || is_look(object) || keys_name_position(keys)) {
      return std::nullopt;
    }
    if (auto problem = place_in_one_value(record, table, JsonFrom::kLines)) {
      problem->location.column.reset();
      return problem;
    }
    if (const auto listed = listed_places(object)) {
      return places_in_list(*listed, JsonFrom::kLines);
    }
    for (const auto [key, value] : object) {
      if (value.is_object()) return places_within_objects(JsonFrom::kLines);
    }
    return std::nullopt;
  }

  // Whether positions are read as before: no key that comes later puts heights of another kind, or
  // in another unit, beside those that were read.
  [[nodiscard]] bool goes_on(const TrackLayout& layout) const {
    const ColumnChoice& before = layout_.table.choice;
    const ColumnChoice& now = layout.table.choice;
    return layout.frame == layout_.frame && layout.scaled_degrees == layout_.scaled_degrees &&
           now.axes == before.axes && now.units == before.units &&
           now.dimensions == before.dimensions && now.datum == before.datum;
  }

  // Whether it is all that readsb knows at a moment.
  static bool is_look(JsonMap object) {
    JsonElement aircraft;
    JsonArray list;
    return object.get("aircraft", aircraft) && aircraft.get(list);
  }

  // The layout counts columns; here they are keys.
  static Error of_keys(Error problem) {
    Error error = without_advice(std::move(problem));
    error.location.column.reset();
    if (error.code == ErrorCode::kMissingColumn) {
      error.message.insert(0,
                           "the keys of this object (as the header of a table) say too little: ");
    }
    return error;
  }

  [[nodiscard]] std::string name_of(std::size_t column) const { return excerpt(names_[column]); }

  [[nodiscard]] Error missing(std::size_t column) const {
    return {ErrorCode::kMissingColumn,
            "there is no " + name_of(column) + " in this object; add it",
            {}};
  }

  Result<std::optional<ReportLine>> read_report() {
    ReportLine report;
    report.frame = layout_.frame;
    report.since_1970 = layout_.time->since_1970;
    if (layout_.time->since_start) report.own_clock = names_[layout_.time->column];
    if (auto error = read_id(report)) return *std::move(error);
    if (layout_.ids_are_addresses) report.id = address_names_.name_of(report.id);
    last_id_ = report.id;
    if (const LeftOutReason* const reason = reason_to_leave_out()) {
      left_out_.add(*reason);
      hides_ = !reason->harmless;
      return std::optional<ReportLine>();
    }
    if (auto error = unclear_mark(layout_, text_in_slot())) return of_keys(*std::move(error));
    read_label(report);
    if (auto error = check_axes(report)) return *std::move(error);
    if (auto error = read_time(report)) return *std::move(error);
    if (auto error = read_position(report)) return *std::move(error);
    if (auto error = read_velocity(report)) return *std::move(error);
    return std::optional<ReportLine>(report);
  }

  std::optional<Error> read_id(ReportLine& report) {
    const std::size_t column = *layout_.table.choice.id;
    const auto& value = values_[TrackSlot::kId];
    if (!value || value->is_null()) return missing(column);
    if (line_.read_text(*value, report.id) && !report.id.empty()) return std::nullopt;
    return Error{ErrorCode::kMalformedRecord,
                 name_of(column) + " is no id; give a text or a whole number",
                 {}};
  }

  void read_label(ReportLine& report) {
    const auto& value = values_[TrackSlot::kLabel];
    if (!layout_.label || !value || !value->get(report.label)) return;
    report.label = without_padding(report.label);
  }

  // Of a position in a frame of ROS, that it can be compared with those before.
  std::optional<Error> check_axes(const ReportLine& report) {
    const auto& value = values_[TrackSlot::kAxesName];
    std::string_view name;
    if (!layout_.axes_name || !value || !line_.read_text(*value, name)) return std::nullopt;
    return ros_frames_.agree(name, report.id, {}, options_.frame);
  }

  // Of what aircraft say of themselves: what is not known is no mistake.
  [[nodiscard]] const LeftOutReason* reason_to_leave_out() const {
    if (const LeftOutReason* const reason = reason_by_marks(layout_, text_in_slot())) return reason;
    if (!layout_.of_aircraft) return nullptr;
    const auto unknown = [this](std::size_t slot) {
      return !values_[slot] || values_[slot]->is_null();
    };
    bool on_ground = false;
    if (const auto& value = values_[TrackSlot::kOnGround]; layout_.on_ground && value) {
      if (value->get(on_ground) && on_ground) return &kOnGround;
    }
    if (unknown(TrackSlot::kPosition) || unknown(TrackSlot::kPosition + 1)) return &kNoPosition;
    if (unknown(TrackSlot::kTime)) return &kNoTime;
    const bool height = layout_.table.choice.dimensions == 3;
    return height && unknown(TrackSlot::kPosition + 2) ? layout_.no_height : nullptr;
  }

  [[nodiscard]] TextInSlot text_in_slot() const {
    return [this](std::size_t slot) -> std::string {
      const auto& value = values_[slot];
      bool says = false;
      if (!value) return {};
      if (value->get(says)) return says ? "true" : "false";
      return field_text(*value);
    };
  }

  std::optional<Error> read_time(ReportLine& report) {
    const TimeChoice& time = *layout_.time;
    const auto& value = values_[TrackSlot::kTime];
    if (!value || value->is_null()) return missing(time.column);
    if (time.form == TimeForm::kDatesAndTimes || time.form == TimeForm::kClock) {
      std::string_view text;
      std::string_view day;
      if (const auto& date = values_[TrackSlot::kDate]; date) std::ignore = date->get(day);
      if (!value->get(text)) {
        return Error{ErrorCode::kNotANumber,
                     name_of(time.column) + " is " + std::string(json_kind(*value)) +
                         " where a date and time should be, as in the lines before; correct it",
                     {}};
      }
      double again_after_s = 0.0;
      const std::string problem = read_wall_time(time, text, day, report.time_s, again_after_s);
      if (problem.empty()) return std::nullopt;
      return Error{ErrorCode::kNotANumber, excerpt(text) + " is not a time: " + problem, {}};
    }
    double number = 0.0;
    if (value->get(number)) {
      if (time.by_size && unit_since_1970(number) != time.unit) {
        return Error{ErrorCode::kOutsideDomain,
                     name_of(time.column) + " is no time since 1970 in " +
                         std::string(symbol_of(time.unit)) +
                         ", as the first one is; say the unit of all with --time-unit, or correct "
                         "it",
                     {}};
      }
      double seconds = time.form == TimeForm::kFrames ? number / time.frames_per_second
                                                      : in_metric(number, time.unit);
      if (time.nanoseconds) {
        double more = 0.0;
        if (auto error = read_nanoseconds(*time.nanoseconds, more)) return error;
        seconds += in_metric(more, Unit::kNanosecond);
      }
      report.time_s = without_dust(seconds);
      if (in_motion_domain(report.time_s)) return std::nullopt;
    }
    return json_number_problem(*value, name_of(time.column));
  }

  // Of whole seconds, as ROS has them: what is to be added.
  std::optional<Error> read_nanoseconds(std::size_t column, double& number) {
    const auto& value = values_[TrackSlot::kNanoseconds];
    if (!value || value->is_null()) return missing(column);
    if (!read_json(*value, number)) return json_number_problem(*value, name_of(column));
    if (number >= 0.0 && number < 1e9) return std::nullopt;
    return Error{ErrorCode::kOutsideDomain,
                 name_of(column) + " is " + exact(number) +
                     ", no number of nanoseconds beside whole seconds; correct it",
                 {}};
  }

  std::optional<Error> read_position(ReportLine& report) {
    const ColumnChoice& choice = layout_.table.choice;
    std::array<double, 3> position = {};
    for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
      const auto& value = values_[TrackSlot::kPosition + axis];
      if (!value) return missing(choice.axes[axis]);
      if (!read_json(*value, position[axis])) {
        return json_number_problem(*value, name_of(choice.axes[axis]));
      }
      if (!layout_.scaled_degrees || axis == 2) continue;
      if (position[axis] != std::floor(position[axis])) {
        return Error{ErrorCode::kMalformedRecord,
                     name_of(choice.axes[axis]) + " is " + exact(position[axis]) +
                         ", no whole number of 1e-7 degrees, as the first is; correct it",
                     {}};
      }
      position[axis] /= kScaledPerDegree;
    }
    report.stated_height = position[2];
    report.height_unit = choice.height_unit();
    report.position = in_metric(Point{position[0], position[1], position[2]}, choice);
    return out_of_range(report.position, layout_.frame);
  }

  std::optional<Error> read_velocity(ReportLine& report) {
    if (!layout_.velocity) return std::nullopt;
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const VelocityChoice& choice = *layout_.velocity;
    std::array<double, 3> velocity = {kUnknown, kUnknown,
                                      layout_.table.choice.dimensions == 2 ? 0.0 : kUnknown};
    for (std::size_t i = 0; i < choice.dimensions; ++i) {
      const auto& value = values_[TrackSlot::kVelocity + i];
      if (!value || value->is_null()) continue;
      if (!read_json(*value, velocity[i])) {
        return json_number_problem(*value, name_of(choice.columns[i]));
      }
    }
    set_velocity(report, in_metric(velocity, choice));
    return std::nullopt;
  }

  RecordingOptions options_;
  JsonLine line_;
  std::string last_id_;
  std::vector<std::string> names_;  // the keys, in the order in which they came first
  struct Said {
    ColumnContent content = ColumnContent::kUnknown;
    std::string text = {};
  };
  std::vector<Said> said_;           // by key: what it held when the layout was last chosen
  std::vector<std::uint8_t> slots_;  // by key: which value it is
  TrackLayout layout_;
  bool chosen_ = false;
  bool of_aircraft_ = false;  // by its keys
  LeftOut left_out_;
  AddressNames address_names_;
  RosFrames ros_frames_;
  bool hides_ = false;
  std::optional<Error> unit_problem_;  // that a later key has brought
  std::array<std::optional<JsonElement>, TrackSlot::kNothing + 1> values_ = {};
};

}  // namespace

std::unique_ptr<LineReader> make_json_lines(const RecordingOptions& options) {
  return std::make_unique<JsonLines>(options);
}

}  // namespace beespace::io
