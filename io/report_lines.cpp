#include "io/report_lines.hpp"

#include "io/base_station.hpp"
#include "io/fields.hpp"
#include "io/line_reader.hpp"
#include "io/record_problems.hpp"
#include "io/text_check.hpp"

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
  if (!reader_) {
    line = without_byte_order_mark(line);
    if (is_blank_line(line)) return std::optional<ReportLine>();
    if (without_padding(line).front() != '{') {
      if (auto problem = text_problem(line)) return *std::move(problem);
    }
    reader_ = reader_for(line, options_, lines_);
  }
  auto report = reader_->read(line);
  understood_ = understood_ || reader_->settled();
  return report;
}

Result<std::optional<ReportLine>> ReportLines::take(std::string_view line) {
  ++lines_;
  auto report = read(without_line_end(line));
  if (report) return report;
  Error& error = report.error();
  if (error.place.source.empty()) error.place.source = source_;
  if (!error.place.line) error.place.line = lines_;
  return report;
}

std::string ReportLines::description() const {
  return reader_ ? reader_->facts().description : "nothing yet";
}

HeightDatum ReportLines::heights() const {
  return reader_ ? reader_->facts().heights : HeightDatum::kUnstated;
}

std::vector<std::string> ReportLines::notes() const {
  return reader_ ? reader_->facts().notes : std::vector<std::string>();
}

}  // namespace beespace::io
