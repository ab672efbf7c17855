// Live input of MAVLink telemetry: the frames of a log as they come, each behind its time.
#include "io/aircraft/aircraft_report.hpp"
#include "io/frames/track_domain.hpp"
#include "io/live/line_reader.hpp"
#include "io/live/report_layout.hpp"
#include "io/mavlink/live_telemetry_times.hpp"
#include "io/mavlink/lost_places.hpp"
#include "io/mavlink/mavlink_position.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/mavlink/telemetry_words.hpp"
#include "io/mavlink/vehicle_census.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr LeftOutReason kLocalOnly = {"of drones that tell local positions (message 32)",
                                      "--crs metres takes these"};
// So long a drone that tells the place of its satellites may still tell that of its estimator.
constexpr std::uint64_t kPatienceMicros = 2'000'000;

class TelemetryFrames final : public LineReader {
 public:
  explicit TelemetryFrames(const RecordingOptions& options) : options_(options) {}

  Result<std::optional<ReportLine>> read(std::string_view logged) override {
    if (auto problem = fixed_layout_problem(options_, "MAVLink telemetry")) {
      return *std::move(problem);
    }
    id_.clear();
    label_.clear();
    hides_ = false;
    TelemetryWalk walk(logged);
    if (!walk.next() || walk.damaged_places() > 0) return damaged(logged.size());
    const MavlinkFrame& frame = walk.frame();
    census_.take(frame);
    if (auto drone = remote_drone(frame)) {
      id_ = *std::move(drone);
      return left_out(kRemoteDrone);
    }
    lost_.take(frame, static_cast<std::int64_t>(walk.stamp()));
    const auto at = read_mavlink_position(frame);
    if (components_[frame.system] == frame.component) {
      times_.take(frame, static_cast<std::int64_t>(walk.stamp()));
    }
    if (at && at->by == PlaceBy::kOfAnother) return of_another(*at, walk.stamp());
    id_ = std::to_string(frame.system);
    if (census_.is_station(frame.system)) return of_station(frame.system, at.has_value());
    return at ? of_vehicle(frame, *at, walk.stamp()) : of_silent(frame.system);
  }

  [[nodiscard]] bool settled() const override { return settled_; }
  [[nodiscard]] std::string_view last_id() const override { return id_; }
  [[nodiscard]] bool hides() const override { return hides_; }

  [[nodiscard]] LineFacts facts() const override {
    LineFacts facts;
    facts.description = "MAVLink telemetry";
    facts.heights = metres() ? HeightDatum::kHome : HeightDatum::kMeanSeaLevel;
    facts.notes = {std::string(metres() ? kLocalNote : kGlobalNote)};
    for (std::string& note : clock_notes()) facts.notes.push_back(std::move(note));
    facts.untimed = times_.unbelieved().size() + times_.perhaps_late().size();
    if (!lesser_.empty()) {
      facts.notes.push_back("of drones that tell nothing better, positions are those of message " +
                            lesser_);
    }
    if (any_other_) facts.notes.emplace_back(kReportedNote);
    for (const std::uint8_t system : stations_) {
      facts.notes.push_back(std::string(kStationNote) + std::to_string(system));
    }
    if (std::string note = silent_note(); !note.empty()) facts.notes.push_back(std::move(note));
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

  // A ground station is no bee; one that was taken for it before it said what it is leaves.
  std::optional<ReportLine> of_station(std::uint8_t system, bool placed) {
    if (placed || told_[system]) stations_.insert(system);
    const bool known = told_[system] || silent_[system] > 0;
    told_[system] = false;
    silent_[system] = 0;
    taken_[system].reset();
    if (!known) return std::nullopt;
    ReportLine line;
    line.id = id_;
    line.leaves = true;
    return line;
  }

  // Of another message: a vehicle is known nowhere until it tells a place, and is none where a
  // heartbeat says so later.
  std::optional<ReportLine> of_silent(std::uint8_t system) {
    if (taken_[system]) return std::nullopt;
    if (census_.is_vehicle(system)) {
      ++silent_[system];
      hides_ = true;
      return std::nullopt;
    }
    if (silent_[system] == 0) return std::nullopt;
    silent_[system] = 0;
    ReportLine line;
    line.id = id_;
    line.leaves = true;
    return line;
  }

  // Whether a drone that tells places of several kinds is taken by this one.
  bool takes(std::uint8_t system, PlaceBy by, std::uint64_t stamp) {
    auto& taken = taken_[system];
    if ((by == PlaceBy::kLocal) != metres() || (taken && by > *taken)) return false;
    if (taken == by || by == PlaceBy::kGlobal || by == PlaceBy::kLocal || taken) {
      taken = by;
      return true;
    }
    if (!first_[system]) first_[system] = stamp;
    if (stamp < *first_[system] + kPatienceMicros) return false;
    taken = by;
    lesser_ = by == PlaceBy::kUtm ? "340 (UTM_GLOBAL_POSITION)" : "24 (GPS_RAW_INT)";
    return true;
  }

  // The first that a system tells by message 340 is its own.
  bool is_handed_on(std::uint8_t system, const MavlinkPosition& at) {
    if (at.by != PlaceBy::kUtm) return false;
    auto& own = own_names_[system];
    if (!own) own = at.name;
    return *own != at.name;
  }

  Result<std::optional<ReportLine>> of_vehicle(const MavlinkFrame& frame, const MavlinkPosition& at,
                                               std::uint64_t stamp) {
    told_[frame.system] = true;
    if (is_handed_on(frame.system, at)) {
      id_ = "UTM " + at.name;
      return left_out(kHandedOn);
    }
    if (!at.known && (at.by == PlaceBy::kGlobal || !taken_[frame.system])) {
      return left_out(kNoSatellites);
    }
    if (!takes(frame.system, at.by, stamp)) {
      if (taken_[frame.system]) return std::optional<ReportLine>();
      if (metres()) return left_out(kNotLocal);
      if (at.by == PlaceBy::kLocal) return left_out(kLocalOnly);
      hides_ = true;
      return std::optional<ReportLine>();
    }
    settled_ = true;
    if (!at.known) return left_out(kNoSatellites);
    if (lost_.is_lost(frame.system, at.by, static_cast<std::int64_t>(stamp))) {
      return left_out(kGuessedPlace);
    }
    auto& component = components_[frame.system];
    if (!component) component = frame.component;
    if (*component != frame.component) return left_out(kOtherComponent);
    return report(at, sent_at(frame.system, at, stamp));
  }

  // By the clock of the drone, where that can be believed, else by when the message came.
  std::uint64_t sent_at(std::uint8_t system, const MavlinkPosition& at, std::uint64_t stamp) {
    if (!at.sent_us) return stamp;
    return static_cast<std::uint64_t>(
        times_.sent_at(system, {*at.sent_us, static_cast<std::int64_t>(stamp)}));
  }

  // Bounded by the aircraft that there can be: of more, all places count as new.
  Result<std::optional<ReportLine>> of_another(const MavlinkPosition& at, std::uint64_t stamp) {
    constexpr std::size_t kMost = 65'536;
    id_ = address_text(at.address);
    if (metres() || !at.known) return left_out(metres() ? kNotLocal : kNoSatellites);
    any_other_ = true;
    settled_ = true;
    if (places_.size() >= kMost && !places_.contains(at.address)) places_.clear();
    const auto [last, first] = places_.try_emplace(at.address, at.position);
    const bool again = !first && at.age_s > 0.0 && last->second == at.position;
    last->second = at.position;
    if (again) return left_out(kHeardAgain);
    label_ = at.name;
    return report(at, stamp);
  }

  [[nodiscard]] std::vector<std::string> clock_notes() const {
    std::vector<std::string> notes = {
        std::string(times_.by_own_clocks() ? kOwnClockNote : kArrivalNote)};
    if (times_.by_satellites()) notes.emplace_back(kSatelliteTimeNote);
    for (const auto& [systems, why] : {std::pair(times_.unbelieved(), kNoClockNote),
                                       std::pair(times_.perhaps_late(), kNoSatelliteTimeNote)}) {
      std::string names;
      for (const std::size_t system : systems) {
        names.append(names.empty() ? "" : ", ").append(std::to_string(system));
      }
      if (!names.empty()) notes.push_back(std::string(why) + names);
    }
    return notes;
  }

  [[nodiscard]] std::string silent_note() const {
    std::string names;
    std::uint64_t frames = 0;
    for (std::size_t system = 0; system < kSystems; ++system) {
      if (told_[system] || silent_[system] == 0) continue;
      names.append(names.empty() ? "" : ", ").append(std::to_string(system));
      frames += silent_[system];
    }
    if (frames == 0) return {};
    return std::to_string(frames) + (frames == 1 ? " record " : " records ") +
           std::string(kNoPlaceRead.which) + (frames == 1 ? " is" : " are") + " left out: " + names;
  }

  Result<std::optional<ReportLine>> report(const MavlinkPosition& at, std::uint64_t stamp) {
    constexpr double kMicrosPerSecond = 1e6;
    if (auto problem = position_problem(at)) return without_advice(*std::move(problem));
    ReportLine line;
    line.id = id_;
    line.label = label_;
    line.time_s = static_cast<double>(stamp) / kMicrosPerSecond - at.age_s;
    line.position = at.position;
    line.stated_height = at.position.z;
    line.frame = at.global() ? Frame::kWgs84 : Frame::kMetres;
    set_velocity(line, at.velocity);
    line.since_1970 = true;
    return std::optional<ReportLine>(line);
  }

  static std::optional<Error> position_problem(const MavlinkPosition& at) {
    if (at.global()) return impossible_place(at.position);
    const Point& place = at.position;
    if (std::isfinite(place.x + place.y + place.z) && in_motion_domain(place.x) &&
        in_motion_domain(place.y) && in_motion_domain(place.z)) {
      return std::nullopt;
    }
    return Error{
        ErrorCode::kNotFinite, "its position is not a number that can be computed with", {}};
  }

  static constexpr std::size_t kSystems = 256;

  RecordingOptions options_;
  LeftOut left_out_;
  VehicleCensus census_;
  LostPlaces lost_;
  std::string id_;
  std::string label_;
  std::string lesser_;  // by which message drones were taken that tell nothing better
  bool settled_ = false;
  bool hides_ = false;
  bool any_other_ = false;
  // By system: how its places are taken, how often it spoke before, since when it tells a worse one
  // than it may, which component speaks for it, whose places of message 340 are its own.
  std::array<std::optional<PlaceBy>, kSystems> taken_ = {};
  std::array<std::uint64_t, kSystems> silent_ = {};
  std::array<bool, kSystems> told_ = {};  // a place, if only one that is not taken
  std::array<std::optional<std::uint64_t>, kSystems> first_ = {};
  std::array<std::optional<std::uint8_t>, kSystems> components_ = {};
  std::array<std::optional<std::string>, kSystems> own_names_ = {};
  std::set<std::uint8_t> stations_;  // those that told a place of their own
  LiveTelemetryTimes times_;
  std::unordered_map<std::uint32_t, Point> places_;  // of aircraft by address: the last
};

}  // namespace

std::unique_ptr<LineReader> make_telemetry_frames(const RecordingOptions& options) {
  return std::make_unique<TelemetryFrames>(options);
}

}  // namespace beespace::io
