#include "io/aircraft/state_vector.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

// The places, by the documentation of OpenSky's REST interface.
namespace place {
constexpr std::size_t kAddress = 0;
constexpr std::size_t kCallsign = 1;
constexpr std::size_t kTimePosition = 3;
constexpr std::size_t kLongitude = 5;
constexpr std::size_t kLatitude = 6;
constexpr std::size_t kPressureHeight = 7;
constexpr std::size_t kOnGround = 8;
constexpr std::size_t kSpeed = 9;
constexpr std::size_t kTrack = 10;
constexpr std::size_t kClimb = 11;
constexpr std::size_t kEllipsoidHeight = 13;
}  // namespace place
// Of those who ask for more (extended=1): rotorcraft, lighter than air, parachutists, unmanned.
constexpr std::size_t kCategory = 17;
constexpr std::array<double, 4> kHoveringKinds = {8.0, 10.0, 11.0, 14.0};
constexpr std::size_t kPlaces = 14;  // as many as are needed; there may be more

}  // namespace

std::optional<Error> read_state_vector(JsonElement state, AircraftReport& report) {
  report = AircraftReport();
  JsonArray items;
  if (!state.get(items) || items.size() < kPlaces) {
    return Error{ErrorCode::kColumnCount,
                 "it is " + std::string(json_kind(state)) +
                     " where a state vector of 17 or 18 values should be; correct it",
                 {}};
  }
  std::array<JsonElement, kPlaces> values;
  std::size_t place = 0;
  for (const JsonElement item : items) {
    double category = 0.0;
    if (place < kPlaces) values[place] = item;
    if (place == kCategory && read_json(item, category)) {
      report.may_hover = std::count(kHoveringKinds.begin(), kHoveringKinds.end(), category) > 0;
    }
    ++place;
  }
  std::string_view text;
  if (!values[place::kAddress].get(text) || text.empty()) {
    return Error{ErrorCode::kMalformedRecord,
                 "its first value is no address; give it as a text such as \"4b1814\"",
                 {}};
  }
  report.id = normal_address(text);
  if (values[place::kCallsign].get(text)) report.label = without_padding(text);
  if (bool on_ground = false; values[place::kOnGround].get(on_ground)) {
    report.on_ground = on_ground;
  }
  struct Wanted {
    std::size_t place;
    double* value;
    const char* name;
  };
  for (const Wanted& wanted :
       {Wanted{place::kTimePosition, &report.time_s, "time_position"},
        {place::kLongitude, &report.longitude_deg, "longitude"},
        {place::kLatitude, &report.latitude_deg, "latitude"},
        {place::kPressureHeight, &report.pressure_height, "baro_altitude"},
        {place::kSpeed, &report.ground_speed_mps, "velocity"},
        {place::kTrack, &report.track_deg, "true_track"},
        {place::kClimb, &report.pressure_climb_mps, "vertical_rate"},
        {place::kEllipsoidHeight, &report.ellipsoid_height, "geo_altitude"}}) {
    const JsonElement value = values[wanted.place];
    if (value.is_null() || read_json(value, *wanted.value)) continue;
    return json_number_problem(value, excerpt(wanted.name));
  }
  return std::nullopt;
}

}  // namespace beespace::io
