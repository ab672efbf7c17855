// Live input of readsb's JSON port: one aircraft a line.
#include "io/aircraft/aircraft_object.hpp"
#include "io/aircraft/aircraft_report.hpp"
#include "io/json/json_line.hpp"
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"

#include <cstdint>
#include <utility>

namespace beespace::io {
namespace {

class AircraftLines final : public LineReader {
 public:
  explicit AircraftLines(const RecordingOptions& options)
      : options_(options), choice_(options.heights, options.grounded) {}

  Result<std::optional<ReportLine>> read(std::string_view line) override {
    if (auto problem = aircraft_problem(options_, "readsb JSON")) return *std::move(problem);
    last_id_.clear();
    const std::uint64_t hidden = left_out_.hiding();
    hides_ = false;
    const auto object = line_.parse(line);
    if (!object) return object.error();
    auto error = read_aircraft_object(*object, AircraftReport::kUnknown, report_);
    last_id_ = report_.id;
    if (error) return *std::move(error);
    auto line_of_it = report_line(report_, choice_, left_out_);
    hides_ = left_out_.hiding() > hidden;
    return line_of_it;
  }

  [[nodiscard]] bool settled() const override { return !report_.id.empty(); }
  [[nodiscard]] std::string_view last_id() const override { return last_id_; }

  [[nodiscard]] bool hides() const override { return hides_; }
  [[nodiscard]] bool of_aircraft() const override { return true; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts{"readsb JSON", choice_.datum(), left_out_.notes()};
    facts.notes.insert(facts.notes.begin(), choice_.note());
    facts.units = AircraftChoice::units(Unit::kFoot, facts.description);
    return facts;
  }

 private:
  RecordingOptions options_;
  AircraftChoice choice_;
  JsonLine line_;
  LeftOut left_out_;
  AircraftReport report_;
  std::string last_id_;
  bool hides_ = false;
};

}  // namespace

bool is_aircraft_line(std::string_view line) {
  JsonLine json;
  const auto object = json.parse(line);
  return object && is_aircraft_object(*object);
}

std::unique_ptr<LineReader> make_aircraft_lines(const RecordingOptions& options) {
  return std::make_unique<AircraftLines>(options);
}

}  // namespace beespace::io
