#include "io/aircraft/flightradar24_feed.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/aircraft_report.hpp"
#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"
#include "io/units/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

// Degrees, feet, knots, feet a minute, seconds since 1970.
namespace feed_place {
constexpr std::size_t kAddress = 0;
constexpr std::size_t kLatitude = 1;
constexpr std::size_t kLongitude = 2;
constexpr std::size_t kTrack = 3;
constexpr std::size_t kHeight = 4;
constexpr std::size_t kSpeed = 5;
constexpr std::size_t kTime = 10;
constexpr std::size_t kOnGround = 14;
constexpr std::size_t kClimb = 15;
constexpr std::size_t kCallsign = 16;
}  // namespace feed_place
constexpr std::size_t kFeedPlaces = 17;  // as many as are needed; there are more

using FeedValues = std::array<JsonElement, kFeedPlaces>;

bool values_of_flight(JsonElement flight, FeedValues& values) {
  JsonArray items;
  if (!flight.get(items) || items.size() < kFeedPlaces) return false;
  std::size_t place = 0;
  for (const JsonElement item : items) {
    if (place < kFeedPlaces) values[place++] = item;
  }
  return true;
}

std::optional<Error> read_flight(std::string_view key, const FeedValues& values,
                                 AircraftReport& report) {
  std::string_view text;
  const bool addressed = values[feed_place::kAddress].get(text) && !text.empty();
  report.id = addressed ? normal_address(text) : std::string(key);
  if (values[feed_place::kCallsign].get(text)) report.label = without_padding(text);
  report.height_unit = Unit::kFoot;
  double speed_kt = AircraftReport::kUnknown;
  double climb_fpm = AircraftReport::kUnknown;
  double on_ground = 0.0;
  struct Wanted {
    std::size_t place;
    double* value;
    const char* name;
  };
  for (const Wanted& wanted : {Wanted{feed_place::kLatitude, &report.latitude_deg, "latitude"},
                               {feed_place::kLongitude, &report.longitude_deg, "longitude"},
                               {feed_place::kTrack, &report.track_deg, "track"},
                               {feed_place::kHeight, &report.pressure_height, "altitude"},
                               {feed_place::kSpeed, &speed_kt, "speed"},
                               {feed_place::kTime, &report.time_s, "time"},
                               {feed_place::kOnGround, &on_ground, "on ground"},
                               {feed_place::kClimb, &climb_fpm, "vertical speed"}}) {
    const JsonElement value = values[wanted.place];
    if (value.is_null() || read_json(value, *wanted.value)) continue;
    return json_number_problem(value, excerpt(wanted.name));
  }
  report.ground_speed_mps = in_metric(speed_kt, Unit::kKnot);
  report.pressure_climb_mps = in_metric(climb_fpm, Unit::kFootPerMinute);
  report.on_ground = on_ground != 0.0;
  // Of one in the air it is no height, but that none is known.
  if (!report.on_ground && report.pressure_height == 0.0) {
    report.pressure_height = AircraftReport::kUnknown;
  }
  return std::nullopt;
}

}  // namespace

bool is_flightradar24_feed(JsonElement root) {
  JsonMap members;
  if (!json_member(root, "full_count") || !root.get(members)) return false;
  FeedValues values;
  for (const auto [key, value] : members) {
    if (values_of_flight(value, values)) return true;
  }
  return false;
}

std::optional<Error> read_flightradar24_feed(JsonElement root, RecordingAssembly& assembly) {
  AircraftGathering gathering({HeightSource::kPressure, assembly.options().grounded}, assembly);
  if (auto error = gathering.begin("feed of Flightradar24", Unit::kFoot, 0.0)) return error;
  JsonMap members;
  if (!root.get(members)) return std::nullopt;
  std::uint64_t index = 0;
  FeedValues values;
  for (const auto [key, value] : members) {
    JsonArray items;
    if (!value.get(items)) continue;  // a number of the answer
    AircraftReport report;
    std::optional<Error> error;
    if (values_of_flight(value, values)) {
      error = read_flight(key, values, report);
    } else {
      error = Error{ErrorCode::kMalformedRecord,
                    "it has fewer values than a flight of the feed has; correct it",
                    {}};
    }
    if (!error) error = gathering.add(report, index + 1);
    ++index;
    if (!error) continue;
    error->message.insert(0, excerpt(key) + ": ");
    error->location.record = index - 1;
    if (auto fatal = assembly.bad(*std::move(error), report.id)) return fatal;
  }
  return std::nullopt;
}

}  // namespace beespace::io
