// A table of fixes that comes line by line: the header, then one record a line.
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_record.hpp"

#include <utility>

namespace beespace::io {
namespace {

class TableLines final : public LineReader {
 public:
  TableLines(const RecordingOptions& options, std::uint64_t first_line)
      : options_(options), first_line_(first_line) {
    options_.skip_bad = false;
  }

  Result<std::optional<ReportLine>> read(std::string_view line) override {
    if (!reader_) return read_first(line);
    return read_record(line);
  }

  [[nodiscard]] bool settled() const override { return layout_found_; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts;
    facts.description = "text";
    if (!reader_) return facts;
    facts.description += ", " + std::string(delimiter_name(layout_.table.delimiter)) + "-separated";
    facts.notes = layout_.notes;
    facts.units = layout_.units;
    facts.heights = layout_.table.choice.datum;
    return facts;
  }

 private:
  // The layout takes a record beside the header, so the header waits for one that can be read.
  Result<std::optional<ReportLine>> read_first(std::string_view line) {
    const bool headed = !header_.empty();
    text_ = headed ? header_ + "\n" + std::string(line) : std::string(line);
    auto layout = find_track_layout(text_, options_, false);
    if (layout) {
      if (auto problem = live_problem(*layout)) {
        problem->place.line = first_line_;
        return *std::move(problem);
      }
    } else if (!headed && layout.error().code == ErrorCode::kNoPoints) {
      header_ = std::string(line);
      return std::optional<ReportLine>();
    } else {
      Error error = without_advice(std::move(layout).error());
      if (error.place.line) *error.place.line += first_line_ - 1;
      return error;
    }
    layout_found_ = true;
    layout_ = std::move(layout).value();
    reader_.emplace(layout_);
    auto report = read_record(line);
    // A bad record may have misled the layout: the next one is asked again.
    if (!report) reader_.reset();
    return report;
  }

  Result<std::optional<ReportLine>> read_record(std::string_view line) {
    if (auto error = reader_->read(line, record_)) return without_advice(*std::move(error));
    ReportLine report;
    report.id = record_.id;
    report.time_s = record_.time_s;
    report.position = record_.position;
    report.frame = layout_.frame;
    report.stated_height = record_.stated_height;
    report.height_unit = layout_.table.choice.height_unit();
    report.since_1970 = layout_.time->since_1970;
    if (layout_.velocity) report.velocity = known(record_.velocity);
    return std::optional<ReportLine>(report);
  }

  RecordingOptions options_;
  std::uint64_t first_line_;
  std::string header_;
  std::string text_;  // what the layout was found from: it holds views of it
  TrackLayout layout_;
  bool layout_found_ = false;
  std::optional<TrackRecordReader> reader_;
  TrackRecord record_;
};

}  // namespace

std::unique_ptr<LineReader> make_table_lines(const RecordingOptions& options,
                                             std::uint64_t first_line) {
  return std::make_unique<TableLines>(options, first_line);
}

}  // namespace beespace::io
