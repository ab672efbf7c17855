#include "io/mavlink/telemetry_reading.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/mavlink/heard_landings.hpp"
#include "io/mavlink/heard_place.hpp"
#include "io/mavlink/lost_places.hpp"
#include "io/mavlink/mavlink_position.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/mavlink/telemetry_times.hpp"
#include "io/mavlink/telemetry_words.hpp"
#include "io/mavlink/vehicle_census.hpp"
#include "io/mavlink/vehicle_landings.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/recording_sources.hpp"
#include "io/recording/take_offs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kMicrosPerSecond = 1e6;

std::string counted(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

class TelemetryReading {
 public:
  TelemetryReading(std::string_view bytes, RecordingAssembly& assembly)
      : walk_(bytes), assembly_(assembly) {}

  std::optional<Error> read(std::string_view path) {
    // Of several inputs, what is said may be of the tables among them.
    unused_ = fixed_layout_problem(assembly_.options(), "MAVLink telemetry");
    if (unused_ && !assembly_.has_several()) return unused_;
    gather();
    if (auto error = choose_kind()) return error;
    if (auto error = assembly_.agree(facts())) return error;
    assembly_.tracks().round_times(0.0);
    assembly_.count_records();
    before_ =
        assembly_.has_several() ? assembly_.name_of_source(stem_of(path)) + ":" : std::string();
    choose_places();
    for (Heard& heard : heard_) heard.is_taken = takes(heard);
    time_places();
    if (!assembly_.options().grounded) {
      find_landed(landings_, global_ ? Frame::kWgs84 : Frame::kMetres, heard_);
    }
    leave_out_early();
    say_choice();
    for (const Heard& heard : heard_) {
      if (!heard.is_taken) continue;
      if (auto error = add(heard)) return error;
    }
    leave_out_silent();
    return std::nullopt;
  }

 private:
  void gather() {
    while (walk_.next()) {
      const MavlinkFrame& frame = walk_.frame();
      census_.take(frame);
      landings_.take(frame, static_cast<std::int64_t>(walk_.stamp()));
      times_.take(frame, walk_.index(), static_cast<std::int64_t>(walk_.stamp()));
      if (auto drone = remote_drone(frame)) ++remote_[*std::move(drone)];
      lost_.take(frame, static_cast<std::int64_t>(walk_.stamp()));
      auto position = read_mavlink_position(frame);
      if (!position || position->by != PlaceBy::kOfAnother) ++frames_of_[frame.system];
      if (!position) continue;
      heard_.push_back(
          {walk_.stamp(), walk_.index(), frame.system, frame.component, *std::move(position)});
      heard_.back().is_lost = lost_.is_lost(frame.system, heard_.back().at.by,
                                            static_cast<std::int64_t>(walk_.stamp()));
    }
    leave_out_stations();
    for (const Heard& heard : heard_) {
      const auto by = static_cast<std::size_t>(heard.at.by);
      if (heard.at.known) tells_[heard.system][by] = true;
      any_[by] = true;
    }
  }

  // By all that was said, as heartbeats may come late.
  void leave_out_stations() {
    std::set<std::uint8_t> stations;
    std::erase_if(heard_, [&](const Heard& heard) {
      const bool own = heard.at.by != PlaceBy::kOfAnother && census_.is_station(heard.system);
      if (own) stations.insert(heard.system);
      return own;
    });
    for (const std::uint8_t system : stations) {
      assembly_.note(std::string(kStationNote) +
                     (assembly_.has_several() ? assembly_.source_name() + ", " : "") +
                     std::to_string(system));
    }
  }

  [[nodiscard]] bool any(PlaceBy by) const { return any_[static_cast<std::size_t>(by)]; }
  [[nodiscard]] bool any_global() const {
    return any(PlaceBy::kGlobal) || any(PlaceBy::kUtm) || any(PlaceBy::kSatellite) ||
           any(PlaceBy::kOfAnother);
  }
  [[nodiscard]] bool tells(std::size_t system, PlaceBy by) const {
    return tells_[system][static_cast<std::size_t>(by)];
  }

  // Whether every drone with a place has a local one: what satellites tell is worse.
  [[nodiscard]] bool all_local() const {
    for (std::size_t system = 0; system < kSystems; ++system) {
      const bool elsewhere = tells(system, PlaceBy::kUtm) || tells(system, PlaceBy::kSatellite);
      if (elsewhere && !tells(system, PlaceBy::kLocal)) return false;
    }
    return any(PlaceBy::kLocal);
  }

  std::optional<Error> choose_kind() {
    const Frame asked = assembly_.options().frame;
    global_ = asked == Frame::kWgs84 ||
              (asked == Frame::kAuto && (any(PlaceBy::kGlobal) || (any_global() && !all_local())));
    if (global_ ? any_global() : any(PlaceBy::kLocal)) {
      return global_ || asked == Frame::kMetres ? std::nullopt : own_origins_problem();
    }
    const std::string wanted = asked == Frame::kWgs84    ? "GLOBAL_POSITION_INT (33)"
                               : asked == Frame::kMetres ? "LOCAL_POSITION_NED (32)"
                                                         : "GLOBAL_POSITION_INT (33) or "
                                                           "LOCAL_POSITION_NED (32)";
    std::string message = "this telemetry log tells no position: there is no " + wanted;
    if (any_global() || any(PlaceBy::kLocal)) message += "; leave --crs out";
    return Error{ErrorCode::kNoPoints, std::move(message), {}};
  }

  // Each local position begins where its drone was switched on.
  [[nodiscard]] std::optional<Error> own_origins_problem() const {
    std::size_t local = 0;
    for (std::size_t system = 0; system < kSystems; ++system) {
      if (tells(system, PlaceBy::kLocal)) ++local;
    }
    if (local < 2 && !assembly_.has_several()) return std::nullopt;
    std::string message =
        "this telemetry log tells metres from each drone's own origin (message 32), and not where "
        "on the Earth that is; say --crs metres if all drones have the same origin, as with motion "
        "capture";
    if (any_global()) message += ", or --crs wgs84 to take what their satellites alone tell";
    return Error{ErrorCode::kUnknownFrame, std::move(message), {}};
  }

  // The best that each drone tells: of its estimator before that of its satellites alone.
  void choose_places() {
    for (std::size_t system = 0; system < kSystems; ++system) {
      for (const PlaceBy by : {PlaceBy::kGlobal, PlaceBy::kUtm, PlaceBy::kSatellite}) {
        if (global_ && !taken_[system] && tells(system, by)) taken_[system] = by;
      }
      if (!global_ && tells(system, PlaceBy::kLocal)) taken_[system] = PlaceBy::kLocal;
    }
  }

  [[nodiscard]] SourceFacts facts() const {
    SourceFacts facts;
    facts.of_drones = true;
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
    facts.unused_options = unused_;
    return facts;
  }

  // "3, 7"
  [[nodiscard]] std::string placed_by(PlaceBy by) const {
    std::string names;
    for (std::size_t system = 0; system < kSystems; ++system) {
      if (taken_[system] != by) continue;
      names.append(names.empty() ? "" : ", ").append(before_).append(std::to_string(system));
    }
    return names;
  }

  void say_choice() {
    const bool only_worse = global_ && placed_by(PlaceBy::kGlobal).empty();
    assembly_.note(std::string(!global_     ? kLocalNote
                               : only_worse ? "heights are above mean sea level"
                                            : kGlobalNote));
    for (const auto& [by, message] : {std::pair(PlaceBy::kUtm, "340 (UTM_GLOBAL_POSITION)"),
                                      std::pair(PlaceBy::kSatellite, "24 (GPS_RAW_INT)")}) {
      const std::string names = placed_by(by);
      if (names.empty()) continue;
      assembly_.note("of drones that tell nothing better, positions are those of message " +
                     std::string(message) + ": " + names);
    }
    if (global_ && any(PlaceBy::kOfAnother)) assembly_.note(std::string(kReportedNote));
    say_times();
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

  void say_times() {
    if (times_.by_own_clocks()) assembly_.note(std::string(kOwnClockNote));
    if (!times_.by_own_clocks() && times_.unbelieved().empty()) {
      assembly_.note(std::string(kArrivalNote));
    }
    if (times_.by_satellites()) assembly_.note(std::string(kSatelliteTimeNote));
    if (times_.satellites_differ()) assembly_.note(std::string(kSatelliteTimesDifferNote));
    if (assembly_.has_several()) say_clock_of_log();
    if (times_.latest_us() > kLateMicros) {
      assembly_.note(assembly_.source_name() + ": the latest position came " +
                     seconds_text(times_.latest_us()) + " after the moment that it tells of");
    }
    if (!assembly_.has_several() || times_.log_ahead_us()) doubt(times_.unbelieved(), kNoClockNote);
    doubt(times_.perhaps_late(), kNoSatelliteTimeNote);
  }

  // Each log has the clock of the computer that wrote it.
  void say_clock_of_log() {
    const std::string& name = assembly_.source_name();
    if (const auto ahead_us = times_.log_ahead_us()) {
      assembly_.note("the clock of " + name +
                     " is set to the time of satellites (message 2), from which it is " +
                     seconds_text(std::abs(*ahead_us)) + " away");
      return;
    }
    std::array<bool, kSystems> placed = {};
    for (const Heard& heard : heard_) {
      if (heard.is_taken) placed[heard.system] = true;
    }
    std::vector<std::size_t> systems;
    for (std::size_t system = 0; system < kSystems; ++system) {
      if (placed[system]) systems.push_back(system);
    }
    doubt(systems, kNoClockOfLogNote);
  }

  void doubt(const std::vector<std::size_t>& systems, std::string_view why) {
    std::string names;
    for (const std::size_t system : systems) {
      names.append(names.empty() ? "" : ", ").append(before_).append(std::to_string(system));
    }
    if (names.empty()) return;
    assembly_.note(std::string(why) + names);
    assembly_.doubt_times(systems.size());
  }

  [[nodiscard]] std::string id_of(const Heard& heard) const {
    return heard.at.by == PlaceBy::kOfAnother ? address_text(heard.at.address)
                                              : before_ + std::to_string(heard.system);
  }

  // What is not taken is counted.
  bool takes(const Heard& heard) {
    if (heard.at.by == PlaceBy::kOfAnother) return takes_another(heard);
    const auto leave_out = [&](const LeftOutReason& reason, const std::string& id) {
      assembly_.leave_out(reason, id);
      return false;
    };
    const auto& taken = taken_[heard.system];
    if (taken && heard.at.by != *taken) {
      return is_handed_on(heard) && leave_out(kHandedOn, handed_on_id(heard));
    }
    const std::string id = id_of(heard);
    if (!taken) {
      const bool other = heard.at.global() != global_;
      return leave_out(!other ? kNoSatellites : global_ ? kOtherFrame : kNotLocal, id);
    }
    if (is_handed_on(heard)) return leave_out(kHandedOn, handed_on_id(heard));
    if (!heard.at.known) {
      if (!components_[heard.system]) {
        ++early_[heard.system];
        return false;
      }
      return leave_out(kNoSatellites, id);
    }
    if (heard.is_lost) return leave_out(kGuessedPlace, id);
    auto& component = components_[heard.system];
    if (!component) component = heard.component;
    return *component == heard.component || leave_out(kOtherComponent, id);
  }

  // By the clock of each drone, where that can be believed, else by when its messages came.
  void time_places() {
    std::vector<std::vector<Heard*>> places(kSystems);
    for (Heard& heard : heard_) {
      if (!heard.is_taken || !heard.at.sent_us) continue;
      places[heard.system].push_back(&heard);
      times_.add_place(heard.system, heard.component, heard.frame,
                       {*heard.at.sent_us, static_cast<std::int64_t>(heard.stamp)});
    }
    times_.settle();
    const std::int64_t ahead_us = assembly_.has_several() ? times_.log_ahead_us().value_or(0) : 0;
    const auto seconds = [ahead_us](std::int64_t at_us) {
      return static_cast<double>(at_us - ahead_us) / kMicrosPerSecond;
    };
    for (Heard& heard : heard_) {
      heard.time_s = seconds(static_cast<std::int64_t>(heard.stamp)) - heard.at.age_s;
    }
    for (std::size_t system = 0; system < kSystems; ++system) {
      const std::vector<std::int64_t>& at_us = times_.at_us(system);
      for (std::size_t i = 0; i < at_us.size(); ++i) {
        places[system][i]->time_s = seconds(at_us[i]);
      }
    }
  }

  // What drones told before they knew a place, as from when they were switched on: where they were
  // is told by the first place that they knew, if they stand on the ground there.
  void leave_out_early() {
    std::array<const Heard*, kSystems> first{};
    for (const Heard& heard : heard_) {
      if (!heard.is_taken || heard.at.by == PlaceBy::kOfAnother) continue;
      if (first[heard.system] == nullptr) first[heard.system] = &heard;
    }
    for (std::size_t system = 0; system < kSystems; ++system) {
      const bool stands = first[system] != nullptr && first[system]->landed.value_or(false);
      const std::string id = before_ + std::to_string(system);
      for (std::uint64_t i = 0; i < early_[system]; ++i) {
        assembly_.leave_out(stands ? kNotYetOnGround : kNoSatellites, id);
      }
    }
  }

  // The first that a system tells by message 340 is its own.
  bool is_handed_on(const Heard& heard) {
    if (heard.at.by != PlaceBy::kUtm) return false;
    auto& own = own_names_[heard.system];
    if (!own) own = heard.at.name;
    return *own != heard.at.name;
  }

  [[nodiscard]] std::string handed_on_id(const Heard& heard) const {
    return before_ + "UTM " + heard.at.name;
  }

  // An aircraft has one address, whichever station hears it.
  bool takes_another(const Heard& heard) {
    const std::string id = id_of(heard);
    if (!global_ || !heard.at.known) {
      assembly_.leave_out(global_ ? kNoSatellites : kNotLocal, id);
      return false;
    }
    const auto [last, first] = places_.try_emplace(heard.at.address, heard.at.position);
    const bool again = !first && heard.at.age_s > 0.0 && last->second == heard.at.position;
    last->second = heard.at.position;
    if (again) assembly_.leave_out(kHeardAgain, id);
    return !again;
  }

  std::optional<Error> add(const Heard& heard) {
    const std::string id = id_of(heard);
    if (auto error = position_problem(heard)) {
      error->location.record = heard.frame;
      return assembly_.bad(*std::move(error), id);
    }
    if (heard.landed.value_or(false)) {
      assembly_.has_landed(id, {heard.time_s, heard.at.position});
    } else if (heard.landed) {
      assembly_.flies_at(id, {heard.time_s, heard.at.position});
    }
    take_take_off(id, heard);
    Origin origin;
    origin.source = assembly_.source() & 0xFF'FFFFu;
    origin.line = (heard.frame + 1) & 0xFF'FFFF'FFFFu;
    assembly_.tracks().add(id, {heard.time_s, heard.at.position}, &heard.at.velocity, origin);
    const bool is_other = heard.at.by == PlaceBy::kOfAnother;
    if (!is_other && landings_.on_surface(heard.system, heard.component)) {
      assembly_.stays_on_surface(id);
    }
    if (is_other) assembly_.told_by_others(id);
    if (is_other && !heard.at.name.empty()) {
      assembly_.tracks().label(id, heard.at.name, heard.time_s);
    }
    return std::nullopt;
  }

  // From which height it took off: message 33 says beside its height how far that is above there.
  void take_take_off(const std::string& id, const Heard& heard) {
    if (!std::isfinite(heard.at.above_home_m)) return;
    const double above_m = heard.at.above_home_m;
    assembly_.take_offs().take(id, heard.time_s,
                               {heard.at.position.z - above_m, above_m > kFliesAboveTakeOff_m});
  }

  // Who is there by other messages only.
  void leave_out_silent() {
    std::array<bool, kSystems> said = {};
    for (const Heard& heard : heard_) {
      if (heard.at.by != PlaceBy::kOfAnother) said[heard.system] = true;
    }
    for (std::size_t system = 0; system < kSystems; ++system) {
      if (said[system] || !census_.is_vehicle(static_cast<std::uint8_t>(system))) continue;
      const std::string id = before_ + std::to_string(system);
      for (std::uint64_t i = 0; i < frames_of_[system]; ++i) assembly_.leave_out(kNoPlaceRead, id);
    }
    for (const auto& [id, records] : remote_) {
      for (std::uint64_t i = 0; i < records; ++i) assembly_.leave_out(kRemoteDrone, id);
    }
  }

  static constexpr std::size_t kSystems = TelemetryTimes::kSystems;

  TelemetryWalk walk_;
  RecordingAssembly& assembly_;
  std::optional<Error> unused_ = {};  // which of the options are not for logs
  std::vector<Heard> heard_;
  VehicleCensus census_;
  VehicleLandings landings_;
  LostPlaces lost_;
  std::string before_;  // ids of systems
  bool global_ = false;
  std::array<bool, kPlacesBy> any_ = {};
  std::array<std::array<bool, kPlacesBy>, kSystems> tells_ = {};  // a place that it knows
  std::array<std::optional<PlaceBy>, kSystems> taken_ = {};
  std::array<std::uint64_t, kSystems> frames_of_ = {};
  std::array<std::optional<std::uint8_t>, kSystems> components_ = {};  // who speaks for it
  std::array<std::uint64_t, kSystems> early_ = {};  // messages before it knew a place
  std::array<std::optional<std::string>, kSystems> own_names_ = {};
  std::unordered_map<std::uint32_t, Point> places_;  // by address: the last
  std::map<std::string, std::uint64_t> remote_;      // how many records of whom
  TelemetryTimes times_;
};

}  // namespace

std::optional<Error> read_telemetry(std::string_view bytes, std::string_view path,
                                    RecordingAssembly& assembly) {
  return TelemetryReading(bytes, assembly).read(path);
}

}  // namespace beespace::io
