#include "io/aircraft/aircraft_trace.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/units/units.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>

namespace beespace::io {
namespace {

// By the documentation of readsb (README-json.md): seconds, latitude, longitude, height by
// pressure or "ground", speed, track, flags, climb, the aircraft, source, height by satellites,
// its climb.
namespace readsb_place {
constexpr std::size_t kTime = 0;
constexpr std::size_t kLatitude = 1;
constexpr std::size_t kLongitude = 2;
constexpr std::size_t kHeight = 3;
constexpr std::size_t kSpeed = 4;
constexpr std::size_t kTrack = 5;
constexpr std::size_t kFlags = 6;
constexpr std::size_t kClimb = 7;
constexpr std::size_t kAircraft = 8;
constexpr std::size_t kEllipsoidHeight = 10;
constexpr std::size_t kEllipsoidClimb = 11;
constexpr unsigned kClimbIsGeometric = 4;
constexpr unsigned kHeightIsGeometric = 8;
constexpr std::size_t kFewest = 4;
}  // namespace readsb_place

// By the documentation of OpenSky's REST interface: time, latitude, longitude, height by pressure,
// track, on the ground.
namespace opensky_place {
constexpr std::size_t kTime = 0;
constexpr std::size_t kLatitude = 1;
constexpr std::size_t kLongitude = 2;
constexpr std::size_t kHeight = 3;
constexpr std::size_t kTrack = 4;
constexpr std::size_t kOnGround = 5;
constexpr std::size_t kFewest = 6;
}  // namespace opensky_place

constexpr std::size_t kMostValues = 12;  // that are looked at

// The values of a place, null where there are no more.
class PlaceValues {
 public:
  explicit PlaceValues(const JsonArray& items) {
    for (const JsonElement item : items) {
      if (count_ == kMostValues) break;
      values_[count_++] = item;
    }
  }

  [[nodiscard]] std::optional<JsonElement> at(std::size_t place) const {
    if (place >= count_ || values_[place].is_null()) return std::nullopt;
    return values_[place];
  }
  // Leaves it as it is where there is none.
  std::optional<Error> number(std::size_t place, const char* name, double& value) const {
    const auto element = at(place);
    if (!element || read_json(*element, value)) return std::nullopt;
    return json_number_problem(*element, excerpt(name));
  }

 private:
  std::array<JsonElement, kMostValues> values_;
  std::size_t count_ = 0;
};

std::optional<Error> read_readsb(const PlaceValues& values, TraceHead& head,
                                 AircraftReport& report) {
  namespace at = readsb_place;
  report.height_unit = Unit::kFoot;
  double after_s = AircraftReport::kUnknown;
  double height_ft = AircraftReport::kUnknown;
  double speed_kt = AircraftReport::kUnknown;
  double climb = AircraftReport::kUnknown;
  double ellipsoid_climb = AircraftReport::kUnknown;
  double flags = 0.0;
  std::string_view text;
  const auto height = values.at(at::kHeight);
  report.on_ground = height && height->get(text) && text == "ground";
  for (const auto& [place, name, value] :
       {std::tuple(at::kTime, "seconds", &after_s),
        {at::kLatitude, "latitude", &report.latitude_deg},
        {at::kLongitude, "longitude", &report.longitude_deg},
        {at::kSpeed, "speed", &speed_kt},
        {at::kTrack, "track", &report.track_deg},
        {at::kFlags, "flags", &flags},
        {at::kClimb, "climb", &climb},
        {at::kEllipsoidHeight, "height", &report.ellipsoid_height},
        {at::kEllipsoidClimb, "climb", &ellipsoid_climb}}) {
    if (auto error = values.number(place, name, *value)) return error;
  }
  if (!report.on_ground) {
    if (auto error = values.number(at::kHeight, "height", height_ft)) return error;
  }
  const auto bits = static_cast<unsigned>(flags >= 0.0 && flags < 256.0 ? flags : 0.0);
  const bool geometric = (bits & at::kHeightIsGeometric) != 0;
  if (!geometric) report.pressure_height = height_ft;
  if (geometric && std::isnan(report.ellipsoid_height)) report.ellipsoid_height = height_ft;
  report.time_s = head.begins_s + after_s;
  report.ground_speed_mps = in_metric(speed_kt, Unit::kKnot);
  report.geometric_climb_mps = in_metric(ellipsoid_climb, Unit::kFootPerMinute);
  double& climb_mps =
      (bits & at::kClimbIsGeometric) != 0 ? report.geometric_climb_mps : report.pressure_climb_mps;
  if (!std::isnan(climb)) climb_mps = in_metric(climb, Unit::kFootPerMinute);
  if (const auto aircraft = values.at(at::kAircraft)) {
    const auto flight = json_member(*aircraft, "flight");
    if (flight && flight->get(text)) head.report.label = without_padding(text);
  }
  report.label = head.report.label;
  return std::nullopt;
}

std::optional<Error> read_opensky(const PlaceValues& values, AircraftReport& report) {
  namespace at = opensky_place;
  for (const auto& [place, name, value] : {std::tuple(at::kTime, "time", &report.time_s),
                                           {at::kLatitude, "latitude", &report.latitude_deg},
                                           {at::kLongitude, "longitude", &report.longitude_deg},
                                           {at::kHeight, "baro_altitude", &report.pressure_height},
                                           {at::kTrack, "true_track", &report.track_deg}}) {
    if (auto error = values.number(place, name, *value)) return error;
  }
  bool on_ground = false;
  const auto ground = values.at(at::kOnGround);
  report.on_ground = ground && ground->get(on_ground) && on_ground;
  return std::nullopt;
}

}  // namespace

std::string_view trace_key(TraceKind kind) {
  return kind == TraceKind::kReadsb ? "trace" : "path";
}

std::optional<TraceKind> trace_kind(JsonElement root) {
  for (const auto& [kind, address] :
       {std::pair(TraceKind::kReadsb, "icao"), {TraceKind::kOpenSky, "icao24"}}) {
    const auto list = json_member(root, trace_key(kind));
    JsonArray items;
    if (list && list->get(items) && json_member(root, address)) return kind;
  }
  return std::nullopt;
}

Result<TraceHead> read_trace_head(JsonElement root, TraceKind kind) {
  const bool readsb = kind == TraceKind::kReadsb;
  const std::string_view address = readsb ? "icao" : "icao24";
  TraceHead head;
  std::string_view text;
  const auto id = json_member(root, address);
  if (!id || !id->get(text) || text.empty()) {
    return Error{ErrorCode::kMalformedRecord,
                 excerpt(address) + " is no address; give it as a text such as \"4b1814\"",
                 {}};
  }
  head.report.id = normal_address(text);
  if (const auto flight = json_member(root, "callsign"); flight && flight->get(text)) {
    head.report.label = without_padding(text);
  }
  if (!readsb) return head;
  const auto begins = json_member(root, "timestamp");
  if (!begins) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no 'timestamp', from which the times of the trace count; correct it",
                 {}};
  }
  if (!read_json(*begins, head.begins_s)) return json_number_problem(*begins, "'timestamp'");
  return head;
}

std::optional<Error> read_trace_place(JsonElement place, TraceKind kind, TraceHead& head,
                                      AircraftReport& report) {
  report = head.report;
  const bool readsb = kind == TraceKind::kReadsb;
  JsonArray items;
  if (!place.get(items) ||
      items.size() < (readsb ? readsb_place::kFewest : opensky_place::kFewest)) {
    return Error{
        ErrorCode::kColumnCount,
        "it is " + std::string(json_kind(place)) +
            " where a list of a time, a latitude, a longitude and more should be; correct it",
        {}};
  }
  const PlaceValues values(items);
  return readsb ? read_readsb(values, head, report) : read_opensky(values, report);
}

}  // namespace beespace::io
