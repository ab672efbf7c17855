// A table of fixes that comes line by line: the header, then one record a line.
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/text_check.hpp"
#include "io/recording/address_names.hpp"
#include "io/recording/ros_frames.hpp"
#include "io/recording/set_names.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_record.hpp"
#include "io/tracks/utm_zone.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kDelimiters = "\t;, ";

class TableLines final : public LineReader {
 public:
  TableLines(const RecordingOptions& options, std::uint64_t first_line)
      : options_(options), first_line_(first_line) {
    options_.skip_bad = false;
  }

  Result<std::optional<ReportLine>> read(std::string_view line) override {
    record_.id = {};
    hides_ = false;
    if (passes_over(line)) return std::optional<ReportLine>();
    if (!reader_) {
      if (auto header = take_header(line)) return *std::move(header);
      return read_first(line);
    }
    auto report = read_record(line);
    if (report) return report;
    // What can be read as a record is no header.
    if (auto header = take_header(line)) return *std::move(header);
    return report;
  }

  [[nodiscard]] std::string_view last_id() const override { return record_.id; }
  [[nodiscard]] bool hides() const override { return hides_; }
  [[nodiscard]] bool of_aircraft() const override { return of_aircraft_; }
  [[nodiscard]] bool ended() const override { return ended_; }

  [[nodiscard]] bool settled() const override { return layout_found_; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts;
    facts.description = "text";
    if (!reader_) return facts;
    facts.description += ", " + std::string(delimiter_name(layout_.table.delimiter)) + "-separated";
    facts.notes = layout_.notes;
    if (set_names_.told_apart() > 0) {
      facts.notes.push_back(
          "bees of one name in several studies, trials, videos or days are told apart, as in " +
          excerpt(set_names_.example()));
    }
    for (std::string& note : left_out_.notes()) facts.notes.push_back(std::move(note));
    facts.units = layout_.units;
    facts.heights = layout_.table.choice.datum;
    return facts;
  }

 private:
  // Of a comment. The first one may be the header.
  [[nodiscard]] bool passes_over(std::string_view line) const {
    if (!has_comment_sign(line)) return false;
    if (layout_found_) return is_comment(line, layout_.table);
    if (!header_.empty()) return true;
    return std::none_of(kDelimiters.begin(), kDelimiters.end(), [line](char delimiter) {
      return header_names(line, delimiter).has_value();
    });
  }

  // What becomes of a line that is a header again; nothing where it is none.
  std::optional<Result<std::optional<ReportLine>>> take_header(std::string_view line) {
    const auto again = repeats_header(line);
    ended_ = !again;
    if (!again) return again.error();
    if (!*again) return std::nullopt;
    return Result<std::optional<ReportLine>>(std::optional<ReportLine>());
  }

  // Whether the line is the header again, as where files are joined. One with other names, or one
  // where there was none before, makes something else of the lines to come.
  Result<bool> repeats_header(std::string_view line) {
    if (!layout_found_ && header_.empty()) return false;
    for (const char delimiter : kDelimiters) {
      if (layout_found_ && delimiter != layout_.table.delimiter) continue;
      const auto names = header_names(line, delimiter);
      if (!names) continue;
      const auto before =
          layout_found_ ? trimmed(layout_.table.names) : header_names(header_, delimiter);
      if (before == names) return true;
      return Error{ErrorCode::kMalformedRecord,
                   "another header, " + excerpt(line) +
                       (before && !before->empty() ? ", than in line " : ", and none in line ") +
                       std::to_string(first_line_) +
                       "; read inputs of different columns each for itself",
                   {}};
    }
    return false;
  }

  static std::optional<std::vector<std::string>> trimmed(const std::vector<std::string>& names) {
    std::vector<std::string> some;
    some.reserve(names.size());
    for (const std::string& name : names) some.emplace_back(without_padding(name));
    return some;
  }

  // The layout takes a record beside the header, so the header waits for one that can be read.
  Result<std::optional<ReportLine>> read_first(std::string_view line) {
    const bool headed = !header_.empty();
    text_ = headed ? header_ + "\n" + std::string(line) : std::string(line);
    auto layout = find_track_layout(text_, options_, false);
    if (layout) {
      if (auto problem = live_problem(*layout, options_.frame)) {
        problem->location.line = first_line_;
        return *std::move(problem);
      }
    } else if (!headed && layout.error().code == ErrorCode::kNoPoints) {
      header_ = std::string(line);
      return std::optional<ReportLine>();
    } else {
      Error error = without_advice(std::move(layout).error());
      // Of a value, not of the header: that of this line.
      if (error.location.record) error.location.line.reset();
      error.location.record.reset();
      if (error.location.line) *error.location.line += first_line_ - 1;
      return error;
    }
    layout_found_ = true;
    layout_ = std::move(layout).value();
    const std::vector<std::string>& names = layout_.table.names;
    const std::size_t time = layout_.time->column;
    own_clock_ = time < names.size() ? names[time] : "column " + std::to_string(time + 1);
    of_aircraft_ = tells_of_aircraft(layout_);
    layout_.places_may_be_unknown = false;  // who reports one does not know where it is
    reader_.emplace(layout_);
    auto report = read_record(line);
    // A bad record may have misled the layout: the next one is asked again.
    if (!report) reader_.reset();
    return report;
  }

  Result<std::optional<ReportLine>> read_record(std::string_view line) {
    if (auto error = reader_->read(line, record_)) {
      if (record_.id.empty()) record_.id = id_of(line);
      return without_advice(*std::move(error));
    }
    if (layout_.ids_are_addresses) record_.id = address_names_.name_of(record_.id);
    if (!layout_.sets.empty() && !record_.id.empty()) {
      record_.id = set_names_.name_of(record_.id, record_.set);
    }
    hides_ = record_.left_out != nullptr && !record_.left_out->harmless;
    if (record_.left_out != nullptr) {
      left_out_.add(*record_.left_out);
      return std::optional<ReportLine>();
    }
    if (layout_.zone) {
      const std::string zone = utm_zone_of(record_.zone);
      if (!zone_) zone_ = zone;
      if (*zone_ != zone) {
        return Error{ErrorCode::kUnknownFrame,
                     "this easting and northing are of another UTM zone, " + excerpt(record_.zone) +
                         ", than those before",
                     {}};
      }
    }
    if (layout_.axes_name) {
      if (auto error = ros_frames_.agree(record_.axes_name, record_.id, {}, options_.frame)) {
        return *std::move(error);
      }
    }
    ReportLine report;
    report.id = record_.id;
    report.label = record_.label;
    report.time_s = record_.time_s;
    report.position = record_.position;
    report.frame = layout_.frame;
    report.stated_height = record_.stated_height;
    report.height_unit = layout_.table.choice.height_unit();
    report.since_1970 = layout_.time->since_1970;
    if (layout_.time->since_start) report.own_clock = own_clock_;
    if (layout_.velocity) set_velocity(report, record_.velocity);
    return std::optional<ReportLine>(report);
  }

  // Of a line that has too many fields, or too few, the id before the others, if it is text.
  [[nodiscard]] std::string_view id_of(std::string_view line) const {
    if (text_problem(line)) return {};
    const std::size_t column = layout_.table.choice.id.value_or(0);
    FieldCursor cursor(line, layout_.table.delimiter);
    std::string_view id;
    std::size_t count = 0;
    for (Field field; cursor.next(field); ++count) {
      if (count == column) id = field.text;
    }
    // The last one may be cut off.
    return column + 1 < count ? id : std::string_view();
  }

  RecordingOptions options_;
  std::uint64_t first_line_;
  std::string header_;
  std::string text_;  // what the layout was found from: it holds views of it
  TrackLayout layout_;
  bool layout_found_ = false;
  bool of_aircraft_ = false;
  bool ended_ = false;
  LeftOut left_out_;
  SetNames set_names_;
  AddressNames address_names_;
  bool hides_ = false;
  std::optional<TrackRecordReader> reader_;
  TrackRecord record_;
  std::optional<std::string> zone_;  // of UTM
  RosFrames ros_frames_;
  std::string own_clock_;  // what the column of the time is called
};

}  // namespace

std::unique_ptr<LineReader> make_table_lines(const RecordingOptions& options,
                                             std::uint64_t first_line) {
  return std::make_unique<TableLines>(options, first_line);
}

}  // namespace beespace::io
