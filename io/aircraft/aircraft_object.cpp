#include "io/aircraft/aircraft_object.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/fields.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

enum class Key : std::uint8_t {
  kHex,
  kFlight,
  kNow,
  kSeenPos,
  kLongitude,
  kLatitude,
  kAltGeom,
  kAltBaro,
  kSpeed,
  kTrack,
  kGeomRate,
  kBaroRate,
  // Of dump1090-mutability: these are what others call alt_baro, gs and baro_rate.
  kAltitude,
  kOldSpeed,
  kOldRate,
  // What a decoder has counted: without them such words may be of any sender, in any unit.
  kMessages,
  kSeen,
  kCategory,
  kCount
};

constexpr std::size_t kKeys = static_cast<std::size_t>(Key::kCount);

constexpr std::array<std::string_view, kKeys> kNames = {
    "hex",      "flight",   "now",       "seen_pos", "lon",       "lat",
    "alt_geom", "alt_baro", "gs",        "track",    "geom_rate", "baro_rate",
    "altitude", "speed",    "vert_rate", "messages", "seen",      "category"};

// Emitter categories of ADS-B: rotorcraft, lighter than air, parachutists, unmanned.
constexpr std::string_view kMayHover = "a7 b2 b3 b6";

using Values = std::array<std::optional<JsonElement>, kKeys>;

// One walk: such an object has dozens of other keys. `twice` becomes the first of ours that is
// there twice.
Values values_of(JsonMap object, std::string_view& twice) {
  Values values;
  std::array<bool, kKeys> met = {};
  for (const auto [key, value] : object) {
    for (std::size_t i = 0; i < kKeys; ++i) {
      if (key != kNames[i]) continue;
      if (met[i] && twice.empty()) twice = kNames[i];
      met[i] = true;
      if (!value.is_null()) values[i] = value;
      break;
    }
  }
  return values;
}

class ObjectReading {
 public:
  ObjectReading(const Values& values, AircraftReport& report) : values_(values), report_(report) {}

  std::optional<Error> read(double now_s) {
    if (auto error = read_names()) return error;
    if (auto error = read_time(now_s)) return error;
    if (auto error = number(Key::kLongitude, report_.longitude_deg)) return error;
    if (auto error = number(Key::kLatitude, report_.latitude_deg)) return error;
    if (auto error = read_heights()) return error;
    double speed = AircraftReport::kUnknown;
    double geometric = AircraftReport::kUnknown;
    double pressure = AircraftReport::kUnknown;
    if (auto error = number(or_old(Key::kSpeed, Key::kOldSpeed), speed)) return error;
    if (auto error = number(Key::kTrack, report_.track_deg)) return error;
    if (auto error = number(Key::kGeomRate, geometric)) return error;
    if (auto error = number(or_old(Key::kBaroRate, Key::kOldRate), pressure)) return error;
    report_.ground_speed_mps = in_metric(speed, Unit::kKnot);
    report_.geometric_climb_mps = in_metric(geometric, Unit::kFootPerMinute);
    report_.pressure_climb_mps = in_metric(pressure, Unit::kFootPerMinute);
    return std::nullopt;
  }

 private:
  [[nodiscard]] const std::optional<JsonElement>& at(Key key) const {
    return values_[static_cast<std::size_t>(key)];
  }
  // The key of dump1090-mutability where the other one is not there.
  [[nodiscard]] Key or_old(Key key, Key old) const {
    const bool of_decoder = at(Key::kMessages) && at(Key::kSeen);
    return !at(key) && at(old) && of_decoder ? old : key;
  }
  static std::string name_of(Key key) { return excerpt(kNames[static_cast<std::size_t>(key)]); }

  // Leaves `value` as it is where there is none.
  std::optional<Error> number(Key key, double& value) {
    const auto& element = at(key);
    if (!element || read_json(*element, value)) return std::nullopt;
    value = AircraftReport::kUnknown;
    return json_number_problem(*element, name_of(key));
  }

  std::optional<Error> read_names() {
    std::string_view text;
    const auto& hex = at(Key::kHex);
    if (!hex) {
      return Error{ErrorCode::kMissingColumn,
                   "there is no 'hex', the address of the aircraft; "
                   "correct it",
                   {}};
    }
    if (!hex->get(text) || text.empty()) {
      return Error{ErrorCode::kMalformedRecord,
                   "'hex' is no address; give it as a text such as \"4b1814\"",
                   {}};
    }
    report_.id = normal_address(text);
    const auto& flight = at(Key::kFlight);
    if (flight && flight->get(text)) report_.label = without_padding(text);
    const auto& category = at(Key::kCategory);
    report_.may_hover = category && category->get(text) && is_one_of(kMayHover, lower_case(text));
    return std::nullopt;
  }

  std::optional<Error> read_time(double now_s) {
    double ago_s = AircraftReport::kUnknown;
    if (std::isnan(now_s)) {
      if (!at(Key::kNow)) {
        return Error{ErrorCode::kMissingColumn,
                     "there is no 'now', so that the time of the position is not known; let the "
                     "sender add it",
                     {}};
      }
      if (auto error = number(Key::kNow, now_s)) return error;
    }
    if (auto error = number(Key::kSeenPos, ago_s)) return error;
    report_.time_s = now_s - ago_s;
    return std::nullopt;
  }

  std::optional<Error> read_heights() {
    report_.height_unit = Unit::kFoot;
    if (auto error = number(Key::kAltGeom, report_.ellipsoid_height)) return error;
    const Key pressure = or_old(Key::kAltBaro, Key::kAltitude);
    const auto& baro = at(pressure);
    std::string_view text;
    if (baro && baro->get(text) && text == "ground") {
      report_.on_ground = true;
      return std::nullopt;
    }
    return number(pressure, report_.pressure_height);
  }

  const Values& values_;
  AircraftReport& report_;
};

}  // namespace

bool is_aircraft_object(JsonMap object) {
  bool hex = false;
  bool sure = false;
  for (const auto [key, value] : object) {
    hex = hex || key == "hex";
    for (const std::string_view word :
         {"now", "seen", "seen_pos", "alt_geom", "alt_baro", "messages", "rssi", "flight"}) {
      sure = sure || key == word;
    }
  }
  return hex && sure;
}

std::optional<Error> read_aircraft_object(JsonMap object, double now_s, AircraftReport& report) {
  report = AircraftReport();
  std::string_view twice;
  const Values values = values_of(object, twice);
  auto error = ObjectReading(values, report).read(now_s);
  if (error || twice.empty()) return error;
  return Error{ErrorCode::kMalformedRecord,
               excerpt(twice) + " is there twice; keep one" + std::string(kOrLeaveOut),
               {}};
}

}  // namespace beespace::io
