// Live input of BaseStation messages: those that complete a position are reports.
#include "io/aircraft/base_station.hpp"
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/problems/skipped_records.hpp"

#include <cstdint>
#include <utility>

namespace beespace::io {
namespace {

class BaseStationLines final : public LineReader {
 public:
  explicit BaseStationLines(const RecordingOptions& options)
      : options_(options),
        choice_(HeightSource::kPressure, options.grounded),
        station_(options.time_zone) {}

  Result<std::optional<ReportLine>> read(std::string_view line) override {
    if (auto problem = base_station_problem(options_)) return *std::move(problem);
    const AircraftReport* report = nullptr;
    const std::uint64_t hidden = left_out_.hiding();
    hides_ = false;
    if (auto error = station_.take(line, report)) return without_advice(*std::move(error));
    settled_ = true;
    if (report == nullptr) {
      hides_ = true;
      return std::optional<ReportLine>();
    }
    auto line_of_it = report_line(*report, choice_, left_out_);
    hides_ = left_out_.hiding() > hidden;
    return line_of_it;
  }

  [[nodiscard]] bool settled() const override { return settled_; }

  [[nodiscard]] std::string_view last_id() const override { return station_.address(); }
  [[nodiscard]] bool hides() const override { return hides_; }
  [[nodiscard]] bool of_aircraft() const override { return true; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts{"BaseStation messages", choice_.datum(), {choice_.note()}};
    facts.notes.push_back(station_.note());
    facts.units = AircraftChoice::units(Unit::kFoot, facts.description);
    for (std::string& note : left_out_.notes()) facts.notes.push_back(std::move(note));
    return facts;
  }

 private:
  RecordingOptions options_;
  AircraftChoice choice_;
  BaseStation station_;
  LeftOut left_out_;
  bool settled_ = false;
  bool hides_ = false;
};

}  // namespace

std::unique_ptr<LineReader> make_base_station_lines(const RecordingOptions& options) {
  return std::make_unique<BaseStationLines>(options);
}

}  // namespace beespace::io
