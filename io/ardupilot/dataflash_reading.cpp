#include "io/ardupilot/dataflash_reading.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/ardupilot/dataflash_log.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/landed_reports.hpp"
#include "io/recording/recording_sources.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr LeftOutReason kNoTimeSinceStart = {"with a time that cannot be"};
constexpr std::string_view kLogName = "DataFlash log of ArduPilot";

class DataflashReading {
 public:
  // `unused`: which of the options are not for logs.
  DataflashReading(DataflashLog log, std::optional<Error> unused, RecordingAssembly& assembly)
      : log_(std::move(log)), unused_(std::move(unused)), assembly_(assembly) {}

  std::optional<Error> read(std::string_view path) {
    id_ = assembly_.name_of_source(stem_of(path));
    if (auto error = position_choice_problem()) return error;
    if (auto error = clock_problem()) return error;
    if (auto error = assembly_.agree(facts())) return error;
    assembly_.tracks().round_times(0.0);
    assembly_.note(
        log_.by_gps
            ? std::string("positions and velocities are those of GPS, as there is no POS, heights "
                          "above mean sea level")
            : std::string("positions are those of POS, heights above mean sea level") +
                  (has_velocities() ? ", velocities those of XKF1 or NKF1" : ""));
    tell_clock(log_.clock, assembly_);
    tell_losses(log_.losses, id_, assembly_);
    const std::vector<bool> landed = landed_at_places();
    if (log_.on_surface) assembly_.stays_on_surface(id_);
    for (std::size_t i = 0; i < log_.places.size(); ++i) {
      if (auto error = take(i, landed[i])) return error;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool has_velocities() const {
    return std::any_of(log_.places.begin(), log_.places.end(), [](const DataflashPlace& place) {
      return std::isfinite(place.velocity.x + place.velocity.y + place.velocity.z);
    });
  }

  [[nodiscard]] const LeftOutReason* lacks(const DataflashPlace& place) const {
    const Point& at = place.position;
    if (place.micros == 0) return &kNoTimeSinceStart;
    if (!std::isfinite(at.x + at.y + at.z) || (at.x == 0.0 && at.y == 0.0)) return &kDoubtedPlace;
    if (place.guessed || log_.fixes.lost_at(place.micros)) return &kGuessedPlace;
    return nullptr;
  }

  [[nodiscard]] std::optional<Error> position_choice_problem() const {
    const RecordingOptions& options = assembly_.options();
    if (options.heights == HeightSource::kPressure || options.heights == HeightSource::kGeometric) {
      return Error{ErrorCode::kInvalidArgument,
                   "a DataFlash log of ArduPilot tells heights above mean sea level, and none by "
                   "pressure or above the ellipsoid; leave --heights out",
                   {}};
    }
    if (options.frame == Frame::kMetres) {
      return Error{ErrorCode::kInvalidArgument,
                   "a DataFlash log of ArduPilot tells longitude and latitude; leave --crs out",
                   {}};
    }
    if (std::any_of(log_.places.begin(), log_.places.end(),
                    [this](const DataflashPlace& place) { return lacks(place) == nullptr; })) {
      return std::nullopt;
    }
    const std::string count = std::to_string(log_.places.size());
    return Error{ErrorCode::kNoPoints,
                 "this DataFlash log of ArduPilot tells no position: it has " + count +
                     (log_.places.size() == 1 ? " message" : " messages") + " of POS or GPS" +
                     (log_.places.empty() ? "" : ", none of which can be taken") +
                     words_of(log_.losses),
                 {}};
  }

  // Logs of several drones have one clock only by GPS, or where it is said.
  [[nodiscard]] std::optional<Error> clock_problem() const {
    if (!assembly_.has_several()) return std::nullopt;
    if (log_.clock) return contradiction(*log_.clock, kLogName);
    if (assembly_.options().one_clock) return std::nullopt;
    return Error{ErrorCode::kInvalidArgument,
                 "this DataFlash log of ArduPilot has no time of GPS, only one since the vehicle "
                 "was switched on, so that it shares no clock with other inputs; if all have one "
                 "clock, as vehicles of one simulator may, say so with --one-clock; else read it "
                 "alone, or leave it out",
                 {}};
  }

  [[nodiscard]] SourceFacts facts() const {
    SourceFacts facts;
    facts.of_drones = true;
    facts.frame = Frame::kWgs84;
    facts.frame_reason = std::string(log_.by_gps ? "GPS" : "POS") + " tells longitude and latitude";
    facts.since_1970 = log_.clock.has_value();
    facts.heights = HeightDatum::kMeanSeaLevel;
    facts.units = {
        {"heights", Unit::kMetre, UnitEvidence::kNamed, "logs of ArduPilot have them so"}};
    facts.description = kLogName;
    facts.unused_options = unused_;
    return facts;
  }

  // Of each of the places whether the drone had landed. It says so when that changes: so between
  // two changes it is said of each place.
  std::vector<bool> landed_at_places() {
    const auto& changes = log_.landings;
    if (assembly_.options().grounded || changes.empty()) {
      return std::vector<bool>(log_.places.size());
    }
    LandedReports reports;
    std::vector<LandedReports::Place> at;
    at.reserve(log_.places.size());
    for (const DataflashPlace& place : log_.places) {
      const auto behind = std::upper_bound(
          changes.begin(), changes.end(), place.micros,
          [](std::uint64_t micros, const auto& change) { return micros < change.micros; });
      const bool landed = behind != changes.begin() && std::prev(behind)->landed;
      const auto micros = static_cast<std::int64_t>(place.micros);
      reports.take(micros, landed);
      at.push_back({micros, place.position, place.velocity, place.above_home_m});
    }
    says_landed_ = reports.any_landed();
    return reports.on_ground(at, Frame::kWgs84);
  }

  std::optional<Error> take(std::size_t index, bool landed) {
    const DataflashPlace& place = log_.places[index];
    if (const LeftOutReason* const reason = lacks(place)) {
      assembly_.leave_out(*reason, id_);
      return std::nullopt;
    }
    if (auto error = impossible_place(place.position)) {
      error->location.record = index;
      return assembly_.bad(*std::move(error), id_);
    }
    constexpr double kMicrosPerSecond = 1e6;
    const std::int64_t micros =
        static_cast<std::int64_t>(place.micros) + (log_.clock ? log_.clock->ahead_micros : 0);
    const Fix fix{static_cast<double>(micros) / kMicrosPerSecond, place.position};
    if (landed) {
      assembly_.has_landed(id_, fix);
    } else if (says_landed_) {
      assembly_.flies_at(id_, fix);
    }
    Origin origin;
    origin.source = assembly_.source() & 0xFF'FFFFu;
    origin.line = (index + 1) & 0xFF'FFFF'FFFFu;
    assembly_.tracks().add(id_, fix, &place.velocity, origin);
    return std::nullopt;
  }

  DataflashLog log_;
  std::optional<Error> unused_;
  RecordingAssembly& assembly_;
  std::string id_;
  bool says_landed_ = false;
};

}  // namespace

std::optional<Error> read_dataflash(std::string_view bytes, std::string_view path,
                                    RecordingAssembly& assembly) {
  // Of several inputs, what is said may be of the tables among them.
  auto unused = fixed_layout_problem(assembly.options(), "a DataFlash log");
  if (unused && !assembly.has_several()) return unused;
  auto log = read_dataflash_log(bytes);
  if (!log) return std::move(log).error();
  return DataflashReading(*std::move(log), std::move(unused), assembly).read(path);
}

}  // namespace beespace::io
