#include "io/px4/flight_reading.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/frames/map_projection.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/px4/flight_log.hpp"
#include "io/recording/recording_sources.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace beespace::io {
namespace {

constexpr LeftOutReason kNoReference = {
    "of local positions whose place on the Earth is not known yet",
    "--crs metres takes local positions as they are"};
constexpr LeftOutReason kNoEllipsoid = {"without a height above the ellipsoid"};
constexpr LeftOutReason kNoTimeOfIt = {"with a time that cannot be"};

std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

// Where positions are taken from.
enum class Source : std::uint8_t { kGlobal, kReferred, kLocal };

class FlightReading {
 public:
  // `unused`: which of the options are not for logs.
  FlightReading(Px4FlightLog log, std::optional<Error> unused, RecordingAssembly& assembly)
      : log_(std::move(log)), unused_(std::move(unused)), assembly_(assembly) {}

  std::optional<Error> read(std::string_view path) {
    id_ = assembly_.name_of_source(stem_of(path));
    if (auto error = choose_source()) return error;
    if (auto error = clock_problem()) return error;
    if (auto error = assembly_.agree(facts())) return error;
    assembly_.tracks().round_times(0.0);
    say_choice();
    if (source_ == Source::kGlobal) gather_velocities();
    const std::vector<Px4Place>& places = source_ == Source::kGlobal ? log_.global : log_.local;
    const std::vector<bool> landed = landed_at(places);
    if (log_.on_surface) assembly_.stays_on_surface(id_);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (auto error = take(places[i], landed[i])) return error;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool by_ellipsoid() const {
    return assembly_.options().heights == HeightSource::kGeometric;
  }

  // Why a message cannot be taken from there; nothing where it can.
  [[nodiscard]] const LeftOutReason* lacks(const Px4Place& place, Source source) const {
    const Point& at = source == Source::kReferred ? place.origin : place.position;
    if (place.micros == 0 || place.micros >= std::uint64_t{1} << 53u) return &kNoTimeOfIt;
    if (!place.known) return &kDoubtedPlace;
    if (!place.height_known) return &kDoubtedHeight;
    if (place.guessed || place.height_guessed) return &kGuessedPlace;
    // Metres from an origin of its own are not those of satellites alone.
    if (source != Source::kLocal && log_.fixes.lost_at(place.micros)) return &kGuessedPlace;
    if (!std::isfinite(place.position.x + place.position.y + place.position.z))
      return &kDoubtedPlace;
    if (source == Source::kGlobal && at.x == 0.0 && at.y == 0.0) return &kDoubtedPlace;
    if (source == Source::kGlobal && by_ellipsoid() && !std::isfinite(place.ellipsoid_height)) {
      return &kNoEllipsoid;
    }
    const bool somewhere = std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
    if (source == Source::kReferred && !somewhere) return &kNoReference;
    return nullptr;
  }

  [[nodiscard]] bool tells(Source source) const {
    const auto& places = source == Source::kGlobal ? log_.global : log_.local;
    return std::any_of(places.begin(), places.end(),
                       [&](const Px4Place& place) { return lacks(place, source) == nullptr; });
  }

  std::optional<Error> choose_source() {
    const RecordingOptions& options = assembly_.options();
    if (options.heights == HeightSource::kPressure) {
      return Error{
          ErrorCode::kInvalidArgument,
          "a PX4 log tells heights above mean sea level, or with --heights geometric above "
          "the ellipsoid, but none by pressure; leave --heights out",
          {}};
    }
    if (options.frame != Frame::kMetres) {
      for (const Source source : {Source::kGlobal, Source::kReferred}) {
        if (!tells(source) || (source == Source::kReferred && by_ellipsoid())) continue;
        source_ = source;
        return std::nullopt;
      }
    }
    if (options.frame != Frame::kWgs84 && !by_ellipsoid() && tells(Source::kLocal)) {
      source_ = Source::kLocal;
      return own_origin_problem();
    }
    return no_position();
  }

  // Each drone counts metres from where it was switched on, or from what it was told.
  [[nodiscard]] std::optional<Error> own_origin_problem() const {
    if (assembly_.options().frame == Frame::kMetres || !assembly_.has_several()) {
      return std::nullopt;
    }
    // Which is asked first.
    if (!log_.clock && !assembly_.options().one_clock) return std::nullopt;
    return Error{ErrorCode::kUnknownFrame,
                 "this PX4 log tells metres from the drone's own origin only, and not where on the "
                 "Earth that is; say --crs metres if all drones have the same origin, as with "
                 "motion capture, or read it alone",
                 {}};
  }

  [[nodiscard]] Error no_position() const {
    const Frame asked = assembly_.options().frame;
    std::string message = "this PX4 log tells no position";
    if (asked == Frame::kWgs84) message += " in degrees";
    if (asked == Frame::kMetres) message += " in metres";
    if (by_ellipsoid()) message += " with a height above the ellipsoid";
    message += ": it has " + counted(log_.global.size(), "message") +
               " of vehicle_global_position and " + std::to_string(log_.local.size()) +
               " of vehicle_local_position";
    if (!log_.global.empty() || !log_.local.empty()) message += ", none of which can be taken";
    message += words_of(log_.losses);
    if (asked != Frame::kAuto || by_ellipsoid()) {
      message += std::string("; leave ") + (by_ellipsoid() ? "--heights" : "--crs") + " out";
    }
    return {ErrorCode::kNoPoints, std::move(message), {}};
  }

  // Logs of several drones have one clock only by GPS, or where it is said.
  [[nodiscard]] std::optional<Error> clock_problem() const {
    if (!assembly_.has_several()) return std::nullopt;
    if (!log_.clock && assembly_.options().one_clock) return std::nullopt;
    if (!log_.clock) {
      const std::string topic =
          source_ == Source::kGlobal ? "vehicle_global_position" : "vehicle_local_position";
      return Error{
          ErrorCode::kInvalidArgument,
          "this PX4 log has no time of GPS (vehicle_gps_position, sensor_gps), only one since the "
          "drone was switched on, so that it shares no clock with other inputs; if all have one "
          "clock, as vehicles of one simulator may, say so with --one-clock; else read it alone, "
          "leave it out, or, if you know how far the clocks are apart, make tables with a common "
          "time: ulog2csv -m " +
              topic +
              " FILE (pip install pyulog), and of each, with what its "
              "clock is ahead, awk -F, -v OFS=, -v ahead_s=SECONDS "
              "'NR==1{for(i=1;i<=NF;i++)if($i==\"timestamp\")c=i}"
              "NR>1{$c=sprintf(\"%.0f\",$c-1e6*ahead_s)}1' NAME_" +
              topic + "_0.csv > NAME.csv (NAME: that of the log), and name these with --one-clock" +
              (source_ == Source::kLocal ? " (all must count metres from one place)" : ""),
          {}};
    }
    return contradiction(*log_.clock, "PX4 log");
  }

  [[nodiscard]] SourceFacts facts() const {
    SourceFacts facts;
    facts.of_drones = true;
    const bool degrees = source_ != Source::kLocal;
    facts.frame = degrees ? Frame::kWgs84 : Frame::kMetres;
    facts.frame_reason = source_ == Source::kGlobal
                             ? "vehicle_global_position tells longitude and latitude"
                         : degrees ? "vehicle_local_position tells where its metres count from"
                                   : "vehicle_local_position tells metres";
    facts.since_1970 = log_.clock.has_value();
    facts.heights = !degrees         ? HeightDatum::kHome
                    : by_ellipsoid() ? HeightDatum::kEllipsoid
                                     : HeightDatum::kMeanSeaLevel;
    const bool has_both = std::any_of(log_.global.begin(), log_.global.end(), [](const auto& at) {
      return std::isfinite(at.ellipsoid_height);
    });
    if (source_ == Source::kGlobal && has_both && !by_ellipsoid()) {
      facts.other_heights =
          ", or take those of PX4 logs above the ellipsoid, too, with --heights geometric";
    }
    facts.units = {{degrees ? "heights" : "x, y and z", Unit::kMetre, UnitEvidence::kNamed,
                    "PX4 logs have them so"}};
    facts.description = "PX4 log (ULog)";
    facts.unused_options = unused_;
    return facts;
  }

  void say_choice() {
    say_positions();
    tell_clock(log_.clock, assembly_);
    say_losses();
    for (const std::string& other : log_.other_instances) {
      assembly_.note("in " + assembly_.source_name() + " " + other +
                     " is another instance of the same topic, and is left out");
    }
  }

  void say_positions() {
    if (source_ == Source::kGlobal) {
      assembly_.note(std::string("positions are those of vehicle_global_position, heights above ") +
                     (by_ellipsoid() ? "the ellipsoid (alt_ellipsoid)" : "mean sea level (alt)"));
    } else if (source_ == Source::kReferred) {
      assembly_.note(
          "positions are those of vehicle_local_position, brought to longitude and latitude from "
          "their reference as PX4 does, heights above mean sea level");
    } else {
      assembly_.note(
          "positions are those of vehicle_local_position, metres east, north and up of each "
          "drone's own origin: they can be compared only if all drones have the same one");
    }
  }

  void say_losses() {
    const UlogLosses& losses = log_.losses;
    if (losses.dropouts > 0) {
      assembly_.note("in " + assembly_.source_name() +
                     " the drone could not write all: " + counted(losses.dropouts, "dropout") +
                     ", " + std::to_string(losses.dropped_ms) + " ms in all");
    }
    tell_losses(losses, id_, assembly_);
  }

  // Messages of both topics that were made of the same measurement belong together.
  static std::uint64_t moment_of(const Px4Place& place) {
    return place.sample_micros != 0 ? place.sample_micros : place.micros;
  }

  void gather_velocities() {
    for (const Px4Place& place : log_.local) velocities_[moment_of(place)] = place.velocity;
  }

  // Its own, or that of the local position of the same moment.
  [[nodiscard]] Velocity velocity_of(const Px4Place& place) const {
    const Velocity& own = place.velocity;
    if (source_ != Source::kGlobal || std::isfinite(own.x + own.y + own.z)) return own;
    const auto found = velocities_.find(moment_of(place));
    return found != velocities_.end() ? found->second : own;
  }

  [[nodiscard]] Point position_of(const Px4Place& place) const {
    Point at = place.position;
    if (source_ == Source::kGlobal && by_ellipsoid()) at.z = place.ellipsoid_height;
    if (source_ != Source::kReferred) return at;
    const LongitudeLatitude there = px4_reprojected({place.origin.x, place.origin.y}, at.y, at.x);
    return {there.longitude_deg, there.latitude_deg, without_dust(place.origin.z + at.z)};
  }

  // Of each of them whether the drone had landed.
  [[nodiscard]] std::vector<bool> landed_at(const std::vector<Px4Place>& places) const {
    if (assembly_.options().grounded || !log_.landed.any_landed()) {
      return std::vector<bool>(places.size());
    }
    std::vector<LandedReports::Place> at;
    at.reserve(places.size());
    for (const Px4Place& place : places) {
      at.push_back(
          {static_cast<std::int64_t>(place.micros), position_of(place), velocity_of(place)});
    }
    return log_.landed.on_ground(at, source_ == Source::kLocal ? Frame::kMetres : Frame::kWgs84);
  }

  std::optional<Error> take(const Px4Place& place, bool landed) {
    if (const LeftOutReason* const reason = lacks(place, source_)) {
      assembly_.leave_out(*reason, id_);
      return std::nullopt;
    }
    const Point at = position_of(place);
    if (auto error = position_problem(at)) {
      error->location.record = place.message;
      return assembly_.bad(*std::move(error), id_);
    }
    constexpr double kMicrosPerSecond = 1e6;
    const auto own = static_cast<std::int64_t>(place.micros);
    const std::int64_t micros = own + (log_.clock ? log_.clock->ahead_micros : 0);
    const Fix fix{static_cast<double>(micros) / kMicrosPerSecond, at};
    if (landed) {
      assembly_.has_landed(id_, fix);
    } else if (log_.landed.any_landed()) {
      assembly_.flies_at(id_, fix);
    }
    const Velocity velocity = velocity_of(place);
    Origin origin;
    origin.source = assembly_.source() & 0xFF'FFFFu;
    origin.line = (place.message + 1) & 0xFF'FFFF'FFFFu;
    assembly_.tracks().add(id_, fix, &velocity, origin);
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Error> position_problem(const Point& at) const {
    if (source_ != Source::kLocal) return impossible_place(at);
    if (in_motion_domain(at.x) && in_motion_domain(at.y) && in_motion_domain(at.z)) {
      return std::nullopt;
    }
    return Error{ErrorCode::kOutsideDomain,
                 "its position cannot be computed with exactly; use 0, or a size of " +
                     std::string(kMotionDomain) + " m" + std::string(kOrLeaveOut),
                 {}};
  }

  Px4FlightLog log_;
  std::optional<Error> unused_;
  RecordingAssembly& assembly_;
  std::string id_;
  Source source_ = Source::kGlobal;
  std::unordered_map<std::uint64_t, Velocity> velocities_;  // by moment_of()
};

}  // namespace

std::optional<Error> read_flight(std::string_view bytes, std::string_view path,
                                 RecordingAssembly& assembly) {
  // Of several inputs, what is said may be of the tables among them.
  auto unused = fixed_layout_problem(assembly.options(), "a PX4 log");
  if (unused && !assembly.has_several()) return unused;
  auto log = read_flight_log(bytes);
  if (!log) return std::move(log).error();
  return FlightReading(*std::move(log), std::move(unused), assembly).read(path);
}

}  // namespace beespace::io
