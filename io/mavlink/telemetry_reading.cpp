#include "io/mavlink/telemetry_reading.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/frames/track_domain.hpp"
#include "io/mavlink/mavlink_position.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/recording/recording_sources.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr LeftOutReason kNoSatellites = {"of drones that know no position yet (0, 0)"};
constexpr LeftOutReason kOtherComponent = {"of another component of the same system", {}, true};
constexpr LeftOutReason kOtherFrame = {
    "of drones that tell local positions only, beside others that tell longitude and latitude",
    "--crs metres takes local positions"};
constexpr LeftOutReason kNotLocal = {"of drones that tell no local positions (--crs metres)"};

struct Heard {
  std::uint64_t stamp = 0;
  std::uint64_t frame = 0;
  std::uint8_t system = 0;
  std::uint8_t component = 0;
  MavlinkPosition at = {};
};

std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

class TelemetryReading {
 public:
  TelemetryReading(std::string_view bytes, RecordingAssembly& assembly)
      : walk_(bytes), assembly_(assembly) {}

  std::optional<Error> read(std::string_view path) {
    if (auto error = fixed_layout_problem(assembly_.options(), "MAVLink telemetry")) return error;
    gather();
    if (auto error = choose_kind()) return error;
    if (auto error = assembly_.agree(facts())) return error;
    assembly_.tracks().round_times(0.0);
    say_aloud();
    const std::string before =
        assembly_.has_several() ? assembly_.name_of_source(stem_of(path)) + ":" : std::string();
    for (const Heard& heard : heard_) {
      if (auto error = take(heard, before)) return error;
    }
    return std::nullopt;
  }

 private:
  void gather() {
    while (walk_.next()) {
      const auto position = read_mavlink_position(walk_.frame());
      if (!position) continue;
      heard_.push_back(
          {walk_.stamp(), walk_.index(), walk_.frame().system, walk_.frame().component, *position});
      (position->global ? any_global_ : any_local_) = true;
    }
  }

  std::optional<Error> choose_kind() {
    const Frame asked = assembly_.options().frame;
    global_ = asked == Frame::kWgs84 || (asked == Frame::kAuto && any_global_);
    if (global_ ? any_global_ : any_local_) return std::nullopt;
    const std::string wanted = asked == Frame::kWgs84    ? "GLOBAL_POSITION_INT (33)"
                               : asked == Frame::kMetres ? "LOCAL_POSITION_NED (32)"
                                                         : "GLOBAL_POSITION_INT (33) or "
                                                           "LOCAL_POSITION_NED (32)";
    std::string message = "this telemetry log tells no position: there is no " + wanted;
    if (any_global_ || any_local_) message += "; leave --crs out";
    return Error{ErrorCode::kNoPoints, std::move(message), {}};
  }

  [[nodiscard]] SourceFacts facts() const {
    SourceFacts facts;
    facts.frame = global_ ? Frame::kWgs84 : Frame::kMetres;
    facts.frame_reason = global_ ? "MAVLink message 33 tells longitude and latitude"
                                 : "MAVLink message 32 tells metres";
    facts.since_1970 = true;
    facts.heights = global_ ? HeightDatum::kMeanSeaLevel : HeightDatum::kHome;
    facts.units = {global_ ? UnitTaken{"heights", Unit::kMillimetre, UnitEvidence::kNamed,
                                       "MAVLink message 33 has them so"}
                           : UnitTaken{"x, y and z", Unit::kMetre, UnitEvidence::kNamed,
                                       "MAVLink message 32 has them so"}};
    facts.description = "MAVLink telemetry log";
    return facts;
  }

  void say_aloud() {
    assembly_.note(global_
                       ? "positions are those of MAVLink message 33 (GLOBAL_POSITION_INT), heights "
                         "above mean sea level"
                       : "positions are those of MAVLink message 32 (LOCAL_POSITION_NED), metres "
                         "east, north and up of each drone's own origin: they can be compared only "
                         "if all drones have the same one");
    assembly_.note("times are those at which the log was written");
    if (walk_.damaged_places() > 0) {
      assembly_.note(assembly_.source_name() + ": " + counted(walk_.damaged_bytes(), "byte") +
                     " in " + counted(walk_.damaged_places(), "place") +
                     " are no frame of MAVLink, or a damaged one, and are passed over");
      assembly_.miss(walk_.damaged_places(), {});
    }
    if (walk_.cut_short()) {
      assembly_.note(assembly_.source_name() + ": the last frame is cut short and left out");
    }
  }

  std::optional<Error> take(const Heard& heard, const std::string& before) {
    const std::string id = before + std::to_string(heard.system);
    if (heard.at.global != global_) {
      // A drone that tells both is taken by the better one; of local positions that are asked for
      // there may be none.
      if (global_ && !tells(heard.system, true)) assembly_.leave_out(kOtherFrame, id);
      if (!global_ && !tells(heard.system, false)) assembly_.leave_out(kNotLocal, id);
      return std::nullopt;
    }
    if (global_ && heard.at.position.x == 0.0 && heard.at.position.y == 0.0) {
      assembly_.leave_out(kNoSatellites, id);
      return std::nullopt;
    }
    auto& component = components_[heard.system];
    if (!component) component = heard.component;
    if (*component != heard.component) {
      assembly_.leave_out(kOtherComponent, id);
      return std::nullopt;
    }
    if (auto error = position_problem(heard)) {
      error->location.record = heard.frame;
      return assembly_.bad(*std::move(error), id);
    }
    constexpr double kMicrosPerSecond = 1e6;
    const double time_s = static_cast<double>(heard.stamp) / kMicrosPerSecond;
    Origin origin;
    origin.source = assembly_.source() & 0xFF'FFFFu;
    origin.line = (heard.frame + 1) & 0xFF'FFFF'FFFFu;
    assembly_.tracks().add(id, {time_s, heard.at.position}, &heard.at.velocity, origin);
    return std::nullopt;
  }

  // Whether that system tells positions of that kind at all.
  bool tells(std::uint8_t system, bool global) {
    if (!systems_known_) {
      for (const Heard& heard : heard_) {
        (heard.at.global ? tells_global_ : tells_local_)[heard.system] = true;
      }
      systems_known_ = true;
    }
    return (global ? tells_global_ : tells_local_)[system];
  }

  [[nodiscard]] std::optional<Error> position_problem(const Heard& heard) const {
    const Point& at = heard.at.position;
    std::optional<Error> error;
    if (global_) {
      error = impossible_place(at);
    } else if (!std::isfinite(at.x + at.y + at.z)) {
      error = Error{
          ErrorCode::kNotFinite, "its position is not a number" + std::string(kOrLeaveOut), {}};
    } else if (!in_motion_domain(at.x) || !in_motion_domain(at.y) || !in_motion_domain(at.z)) {
      error = Error{ErrorCode::kOutsideDomain,
                    "its position cannot be computed with exactly; use 0, or a size of " +
                        std::string(kMotionDomain) + " m" + std::string(kOrLeaveOut),
                    {}};
    }
    if (error) {
      std::string whose = "system ";
      error->message.insert(0, whose.append(std::to_string(heard.system)).append(": "));
    }
    return error;
  }

  TelemetryWalk walk_;
  RecordingAssembly& assembly_;
  std::vector<Heard> heard_;
  bool any_global_ = false;
  bool any_local_ = false;
  bool global_ = false;
  bool systems_known_ = false;
  std::array<bool, 256> tells_global_ = {};
  std::array<bool, 256> tells_local_ = {};
  std::array<std::optional<std::uint8_t>, 256> components_ = {};  // by system: who speaks for it
};

}  // namespace

std::optional<Error> read_telemetry(std::string_view bytes, std::string_view path,
                                    RecordingAssembly& assembly) {
  return TelemetryReading(bytes, assembly).read(path);
}

}  // namespace beespace::io
