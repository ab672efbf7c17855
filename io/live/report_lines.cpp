#include "io/live/report_lines.hpp"

#include "io/aircraft/base_station.hpp"
#include "io/bytes/characters.hpp"
#include "io/json/json_line.hpp"
#include "io/live/line_reader.hpp"
#include "io/problems/text_check.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"

#include <utility>

namespace beespace::io {
namespace {

std::string_view without_line_end(std::string_view line) {
  if (!line.empty() && line.back() == '\n') line.remove_suffix(1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

// By what the first line begins with.
std::unique_ptr<LineReader> reader_for(std::string_view line, const RecordingOptions& options,
                                       std::uint64_t number) {
  if (without_padding(line).front() == '{') {
    return is_aircraft_line(line) ? make_aircraft_lines(options) : make_json_lines(options);
  }
  if (is_base_station_line(line)) return make_base_station_lines(options);
  return make_table_lines(options, number);
}

}  // namespace

ReportLines::ReportLines(RecordingOptions options, std::string source)
    : options_(std::move(options)), source_(std::move(source)) {
}
ReportLines::ReportLines(ReportLines&&) noexcept = default;
ReportLines& ReportLines::operator=(ReportLines&&) noexcept = default;
ReportLines::~ReportLines() = default;

Result<std::optional<ReportLine>> ReportLines::read(std::string_view line) {
  if (is_blank_line(line)) return std::optional<ReportLine>();
  if (line.size() > kLongestLine) return long_line(line);
  line = lines_ == 1 ? without_byte_order_mark(line) : line;
  if (is_blank_line(line)) return std::optional<ReportLine>();
  if (auto left = leave(line); !left || *left) return left;
  return read_report(line);
}

Result<std::optional<ReportLine>> ReportLines::read_report(std::string_view line) {
  if (understood_) return reader_->read(line);
  // What came before, if anything, may have been damaged: then a later line is the header, or tells
  // the kind.
  std::optional<Error> first;
  for (auto* known : {&reader_, &later_}) {
    if (!*known) continue;
    auto report = (*known)->read(line);
    if (report || (*known)->settled()) {
      if (known == &later_) reader_ = std::move(later_);
      later_.reset();
      understood_ = reader_->settled();
      return report;
    }
    if (!first) first = std::move(report).error();
  }
  if (without_padding(line).front() != '{') {
    if (auto problem = text_problem(line)) return first ? *std::move(first) : *std::move(problem);
  }
  auto reader = reader_for(line, options_, lines_);
  auto report = reader->read(line);
  understood_ = reader->settled();
  if (!first || understood_) {
    reader_ = std::move(reader);
    return report;
  }
  if (report) later_ = std::move(reader);
  return *std::move(first);
}

// What the line says if it says that a bee leaves.
Result<std::optional<ReportLine>> ReportLines::leave(std::string_view line) {
  const std::optional<ReportLine> none;
  if (without_padding(line).front() != '{') return none;
  if (line.find("\"leave\"") == std::string_view::npos) return none;
  if (!leave_) leave_ = std::make_unique<JsonLine>();
  const auto object = leave_->parse(line);
  if (!object) return none;
  JsonElement event;
  JsonElement id;
  std::string_view text;
  if (!object->get("event", event) || !event.get(text) || text != "leave") return none;
  ReportLine report;
  report.leaves = true;
  if (object->get("id", id) && leave_->read_text(id, report.id) && !report.id.empty()) {
    return std::optional<ReportLine>(report);
  }
  return Error{ErrorCode::kMissingColumn,
               "this does not say who leaves; give an id: {\"event\": \"leave\", \"id\": \"a\"}",
               {}};
}

Result<std::optional<ReportLine>> ReportLines::take(std::string_view line) {
  ++lines_;
  bad_id_ = {};
  hidden_id_ = {};
  auto report = read(without_line_end(line));
  if (report && *report) {
    if (auto doubt = height_doubt(**report)) {
      doubted_ = true;
      report = *std::move(doubt);
    }
  }
  if (report) {
    if (!*report && understood_ && reader_->hides()) hidden_id_ = reader_->last_id();
    return report;
  }
  bad_id_ = understood_ ? reader_->last_id() : std::string_view();
  Error& error = report.error();
  if (error.location.source.empty()) error.location.source = source_;
  if (!error.location.line) error.location.line = lines_;
  return report;
}

Result<std::optional<ReportLine>> ReportLines::take_frame(std::string_view logged) {
  if (!reader_) reader_ = make_telemetry_frames(options_);
  in_frames_ = true;
  ++lines_;
  bad_id_ = {};
  hidden_id_ = {};
  auto report = reader_->read(logged);
  understood_ = understood_ || reader_->settled();
  if (report) {
    if (!*report && reader_->hides()) hidden_id_ = reader_->last_id();
    return report;
  }
  bad_id_ = reader_->last_id();
  Error& error = report.error();
  error.location.source = source_;
  error.location.record = lines_ - 1;
  return report;
}

std::optional<Error> ReportLines::height_doubt(const ReportLine& report) const {
  if (report.frame != Frame::kWgs84 || report.leaves || !reader_) return std::nullopt;
  constexpr double kUsual_m = 15'000.0;  // so that facts are not asked for each report
  if (!(report.position.z > kUsual_m)) return std::nullopt;
  return doubt_of_heights(reader_->facts().units, report.position.z);
}

bool ReportLines::ended() const {
  return doubted_ || (reader_ && reader_->ended());
}

std::string ReportLines::description() const {
  return reader_ ? reader_->facts().description : "nothing yet";
}

HeightDatum ReportLines::heights() const {
  return reader_ ? reader_->facts().heights : HeightDatum::kUnstated;
}

bool ReportLines::of_aircraft() const {
  return reader_ && reader_->of_aircraft();
}

std::vector<UnitTaken> ReportLines::units() const {
  return reader_ ? reader_->facts().units : std::vector<UnitTaken>();
}

std::vector<std::string> ReportLines::notes() const {
  return reader_ ? reader_->facts().notes : std::vector<std::string>();
}

std::uint64_t ReportLines::untimed() const {
  return reader_ ? reader_->facts().untimed : 0;
}

}  // namespace beespace::io
