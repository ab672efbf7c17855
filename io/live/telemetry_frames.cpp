// Live input of MAVLink telemetry: the frames of a log as they come, each behind its time.
#include "io/aircraft/aircraft_report.hpp"
#include "io/frames/track_domain.hpp"
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/mavlink/mavlink_position.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/problems/skipped_records.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

constexpr LeftOutReason kNoSatellites = {"of drones that know no position yet (0, 0)"};
constexpr LeftOutReason kOtherComponent = {"of another component of the same system", {}, true};
constexpr LeftOutReason kLocalOnly = {"of drones that tell local positions (message 32)",
                                      "--crs metres takes these"};

class TelemetryFrames final : public LineReader {
 public:
  explicit TelemetryFrames(const RecordingOptions& options) : options_(options) {}

  Result<std::optional<ReportLine>> read(std::string_view logged) override {
    if (auto problem = fixed_layout_problem(options_, "MAVLink telemetry")) {
      return *std::move(problem);
    }
    id_.clear();
    hides_ = false;
    TelemetryWalk walk(logged);
    if (!walk.next() || walk.damaged_places() > 0) return damaged(logged.size());
    const MavlinkFrame& frame = walk.frame();
    const auto at = read_mavlink_position(frame);
    if (!at) return std::optional<ReportLine>();
    id_ = std::to_string(frame.system);
    if (at->global == metres()) return of_other_kind(frame.system, at->global);
    settled_ = true;
    tells_[frame.system] = true;
    if (at->global && at->position.x == 0.0 && at->position.y == 0.0) {
      return left_out(kNoSatellites);
    }
    auto& component = components_[frame.system];
    if (!component) component = frame.component;
    if (*component != frame.component) return left_out(kOtherComponent);
    return report(*at, walk.stamp());
  }

  [[nodiscard]] bool settled() const override { return settled_; }
  [[nodiscard]] std::string_view last_id() const override { return id_; }
  [[nodiscard]] bool hides() const override { return hides_; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts;
    facts.description = "MAVLink telemetry";
    facts.heights = metres() ? HeightDatum::kHome : HeightDatum::kMeanSeaLevel;
    facts.notes = {metres() ? "positions are those of MAVLink message 32 (LOCAL_POSITION_NED), "
                              "metres east, north and up of each drone's own origin: they can be "
                              "compared only if all drones have the same one"
                            : "positions are those of MAVLink message 33 (GLOBAL_POSITION_INT), "
                              "heights above mean sea level",
                   "times are those at which the log was written"};
    facts.units = {metres() ? UnitTaken{"x, y and z", Unit::kMetre, UnitEvidence::kNamed,
                                        "MAVLink message 32 has them so"}
                            : UnitTaken{"heights", Unit::kMillimetre, UnitEvidence::kNamed,
                                        "MAVLink message 33 has them so"}};
    for (std::string& note : left_out_.notes()) facts.notes.push_back(std::move(note));
    return facts;
  }

 private:
  [[nodiscard]] bool metres() const { return options_.frame == Frame::kMetres; }

  static Error damaged(std::size_t bytes) {
    return {ErrorCode::kCorrupt,
            std::to_string(bytes) + (bytes == 1 ? " byte is" : " bytes are") +
                " no frame of MAVLink, or a damaged one",
            {}};
  }

  std::optional<ReportLine> left_out(const LeftOutReason& reason) {
    left_out_.add(reason);
    hides_ = !reason.harmless;
    return std::nullopt;
  }

  // A drone that tells both kinds is known by the one that is taken; of another it is not known
  // where it is, until it tells that one.
  std::optional<ReportLine> of_other_kind(std::uint8_t system, bool global) {
    if (global || tells_[system]) return std::nullopt;
    return left_out(kLocalOnly);
  }

  Result<std::optional<ReportLine>> report(const MavlinkPosition& at, std::uint64_t stamp) {
    constexpr double kMicrosPerSecond = 1e6;
    if (auto problem = position_problem(at)) return without_advice(*std::move(problem));
    ReportLine line;
    line.id = id_;
    line.time_s = static_cast<double>(stamp) / kMicrosPerSecond;
    line.position = at.position;
    line.stated_height = at.position.z;
    line.frame = at.global ? Frame::kWgs84 : Frame::kMetres;
    line.velocity = known(at.velocity);
    line.since_1970 = true;
    return std::optional<ReportLine>(line);
  }

  static std::optional<Error> position_problem(const MavlinkPosition& at) {
    if (at.global) return impossible_place(at.position);
    const Point& place = at.position;
    if (std::isfinite(place.x + place.y + place.z) && in_motion_domain(place.x) &&
        in_motion_domain(place.y) && in_motion_domain(place.z)) {
      return std::nullopt;
    }
    return Error{
        ErrorCode::kNotFinite, "its position is not a number that can be computed with", {}};
  }

  RecordingOptions options_;
  LeftOut left_out_;
  std::string id_;
  bool settled_ = false;
  bool hides_ = false;
  std::array<bool, 256> tells_ = {};  // by system: a position of the kind that is taken
  std::array<std::optional<std::uint8_t>, 256> components_ = {};  // who speaks for it
};

}  // namespace

std::unique_ptr<LineReader> make_telemetry_frames(const RecordingOptions& options) {
  return std::make_unique<TelemetryFrames>(options);
}

}  // namespace beespace::io
