#include "io/px4/flight_log.hpp"

#include "io/frames/track_domain.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kGlobalTopic = "vehicle_global_position";
constexpr std::string_view kLocalTopic = "vehicle_local_position";
constexpr std::string_view kLandTopic = "vehicle_land_detected";
constexpr std::string_view kGpsTopic = "vehicle_gps_position";
// What a receiver says, which is the same before it is blended: logs may have it alone.
constexpr std::string_view kReceiverTopic = "sensor_gps";
constexpr std::string_view kStatusTopic = "vehicle_status";

// PX4's own failsafe of a lost position begins at less, by default.
constexpr double kMostUncertain_m = 10.0;

// A double holds every microsecond until then: the year 2255.
constexpr std::uint64_t kLatestMicros = std::uint64_t{1} << 53u;

// The numbers of one message, by their names; what is not there is not known.
class Numbers {
 public:
  Numbers(const UlogLayout& layout, std::string_view message)
      : layout_(layout), message_(message) {}

  [[nodiscard]] double of(std::string_view name, double otherwise = Px4Place::kUnknown) const {
    const UlogField* const field = layout_.number(name);
    return field != nullptr ? ulog_number(message_, *field) : otherwise;
  }
  [[nodiscard]] bool flag(std::string_view name) const { return of(name, 1.0) != 0.0; }
  // Whether it goes on from its last place by its inertia alone, or says that it may be anywhere.
  [[nodiscard]] bool is_guessed() const {
    return of("dead_reckoning", 0.0) != 0.0 || of("eph", 0.0) > kMostUncertain_m;
  }
  [[nodiscard]] bool is_height_guessed() const { return of("epv", 0.0) > kMostUncertain_m; }
  [[nodiscard]] std::uint64_t micros(std::string_view name) const {
    const UlogField* const field = layout_.number(name);
    return field != nullptr ? ulog_unsigned(message_, *field).value_or(0) : 0;
  }
  // Of logs of old, degrees are whole numbers of 1e-7, and heights of millimetres.
  [[nodiscard]] double scaled(std::string_view name, double of_whole) const {
    const UlogField* const field = layout_.number(name);
    if (field == nullptr) return Px4Place::kUnknown;
    const double value = ulog_number(message_, *field);
    const bool whole = field->type != UlogType::kDouble && field->type != UlogType::kFloat;
    return whole ? value / of_whole : value;
  }
  [[nodiscard]] double degrees(std::string_view name) const { return scaled(name, 1e7); }
  [[nodiscard]] double metres(std::string_view name) const { return scaled(name, 1e3); }

 private:
  const UlogLayout& layout_;
  std::string_view message_;
};

double known_speed(double value, bool known) {
  value = without_dust(value);
  return known && std::isfinite(value) && in_motion_domain(value) ? value : Px4Place::kUnknown;
}

// Turned from north, east, down; -0 is avoided where there is no climb.
Velocity east_north_up(double north, double east, double down) {
  return {east, north, std::isnan(down) ? down : 0.0 - down};
}

Px4Place global_place(const Numbers& numbers) {
  Px4Place place;
  place.position = {numbers.degrees("lon"), numbers.degrees("lat"),
                    without_dust(numbers.metres("alt"))};
  place.ellipsoid_height = without_dust(numbers.metres("alt_ellipsoid"));
  place.velocity =
      east_north_up(known_speed(numbers.of("vel_n"), true), known_speed(numbers.of("vel_e"), true),
                    known_speed(numbers.of("vel_d"), true));
  place.known = numbers.flag("lat_lon_valid");
  place.height_known = numbers.flag("alt_valid");
  place.guessed = numbers.is_guessed();
  place.height_guessed = numbers.is_height_guessed();
  return place;
}

Px4Place local_place(const Numbers& numbers) {
  Px4Place place;
  place.position = {without_dust(numbers.of("y")), without_dust(numbers.of("x")),
                    0.0 - without_dust(numbers.of("z"))};
  const bool planar = numbers.flag("v_xy_valid");
  place.velocity =
      east_north_up(known_speed(numbers.of("vx"), planar), known_speed(numbers.of("vy"), planar),
                    known_speed(numbers.of("vz"), numbers.flag("v_z_valid")));
  place.known = numbers.flag("xy_valid");
  place.height_known = numbers.flag("z_valid");
  place.guessed = numbers.is_guessed();
  place.height_guessed = numbers.is_height_guessed();
  const double longitude = numbers.degrees("ref_lon");
  const double latitude = numbers.degrees("ref_lat");
  const bool somewhere = longitude != 0.0 || latitude != 0.0;
  if (numbers.flag("xy_global") && somewhere) {
    place.origin.x = longitude;
    place.origin.y = latitude;
  }
  if (numbers.flag("z_global")) place.origin.z = numbers.metres("ref_alt");
  return place;
}

class Gathering {
 public:
  explicit Gathering(UlogWalk walk) : walk_(std::move(walk)) {}

  Result<Px4FlightLog> read() {
    while (walk_.next()) {
      const UlogTopic& topic = walk_.topic();
      if (topic.name == kGlobalTopic) {
        add(global_[topic.instance], &global_place);
      } else if (topic.name == kLocalTopic) {
        add(local_[topic.instance], &local_place);
      } else if (topic.name == kGpsTopic) {
        add_time(gps_[topic.instance]);
        add_fix(topic);
      } else if (topic.name == kReceiverTopic && has_time(topic)) {
        add_time(receivers_[topic.instance]);
      } else if (topic.name == kLandTopic) {
        add_landed(landed_[topic.instance]);
      } else if (topic.name == kStatusTopic) {
        take_type();
      }
    }
    if (auto error = bad_topic()) return *std::move(error);
    Px4FlightLog log;
    log.global = first_of(global_, kGlobalTopic, log);
    log.local = first_of(local_, kLocalTopic, log);
    log.clock = satellite_clock(first_of(gps_, kGpsTopic, log));
    if (!log.clock) log.clock = satellite_clock(first_of(receivers_, kReceiverTopic, log));
    fixes_.settle();
    log.fixes = std::move(fixes_);
    log.losses = walk_.losses();
    log.on_surface = on_surface_;
    for (const auto& [micros, landed] : first_of(landed_, kLandTopic, log)) {
      if (!never_lands_) log.landed.take(micros, landed);
    }
    return log;
  }

 private:
  template <typename Rows>
  Rows first_of(std::map<std::uint8_t, Rows>& instances, std::string_view topic,
                Px4FlightLog& log) {
    Rows first;
    bool taken = false;
    for (auto& [instance, rows] : instances) {
      if (rows.empty()) continue;
      if (!taken) {
        first = std::move(rows);
        taken = true;
      } else {
        log.other_instances.push_back(std::string(topic) + " " + std::to_string(instance));
      }
    }
    return first;
  }

  void add(std::vector<Px4Place>& places, Px4Place (*place_of)(const Numbers&)) {
    const Numbers numbers(*walk_.topic().layout, walk_.message());
    Px4Place place = place_of(numbers);
    place.micros = numbers.micros("timestamp");
    place.sample_micros = numbers.micros("timestamp_sample");
    place.message = places.size();
    places.push_back(place);
  }

  static bool has_time(const UlogTopic& topic) {
    return topic.layout && topic.layout->number("timestamp") != nullptr &&
           topic.layout->number("time_utc_usec") != nullptr;
  }

  // GPS says what UTC was at an instant that may lie beside that of the message.
  void add_time(std::vector<std::int64_t>& ahead) {
    constexpr std::uint64_t kEarliestMicros = 1'000'000'000'000'000;  // the year 2001
    const Numbers numbers(*walk_.topic().layout, walk_.message());
    const std::uint64_t utc = numbers.micros("time_utc_usec");
    const std::uint64_t own = numbers.micros("timestamp");
    if (utc < kEarliestMicros || utc >= kLatestMicros || own >= kLatestMicros) return;
    const auto beside = static_cast<std::int64_t>(numbers.of("timestamp_time_relative", 0.0));
    ahead.push_back(static_cast<std::int64_t>(utc) - static_cast<std::int64_t>(own) - beside);
  }

  void add_fix(const UlogTopic& topic) {
    constexpr double kFixWithHeight = 3.0;  // FIX_TYPE_3D, and better ones
    if (!topic.layout || topic.layout->number("fix_type") == nullptr) return;
    const Numbers numbers(*topic.layout, walk_.message());
    fixes_.take(topic.instance, numbers.micros("timestamp"),
                numbers.of("fix_type") >= kFixWithHeight);
  }

  void add_landed(std::vector<std::pair<std::int64_t, bool>>& reports) {
    const UlogTopic& topic = walk_.topic();
    if (topic.layout->number("timestamp") == nullptr || topic.layout->number("landed") == nullptr) {
      return;
    }
    const Numbers numbers(*topic.layout, walk_.message());
    const std::uint64_t micros = numbers.micros("timestamp");
    if (micros >= kLatestMicros) return;
    reports.emplace_back(static_cast<std::int64_t>(micros), numbers.flag("landed"));
  }

  void take_type() {
    constexpr double kVehicleRover = 3.0;  // VEHICLE_TYPE_ROVER
    if (!walk_.topic().layout) return;
    const Numbers numbers(*walk_.topic().layout, walk_.message());
    const double type = numbers.of("system_type");
    const bool rover = numbers.of("vehicle_type") == kVehicleRover;
    never_lands_ = never_lands_ || rover || never_lands(type);
    on_surface_ = on_surface_ || rover || stays_on_surface(type);
  }

  // A topic that should tell places, or the time, and cannot be understood.
  [[nodiscard]] std::optional<Error> bad_topic() const {
    const auto lacks = [](const UlogTopic& topic, std::initializer_list<std::string_view> names) {
      return !topic.layout || std::any_of(names.begin(), names.end(), [&](std::string_view name) {
        return topic.layout->number(name) == nullptr;
      });
    };
    for (const auto& [number, topic] : walk_.topics()) {
      const bool bad =
          (topic.name == kGlobalTopic && lacks(topic, {"timestamp", "lat", "lon", "alt"})) ||
          (topic.name == kLocalTopic && lacks(topic, {"timestamp", "x", "y", "z"})) ||
          (topic.name == kGpsTopic && lacks(topic, {"timestamp", "time_utc_usec"}));
      if (!bad) continue;
      return Error{ErrorCode::kCorrupt,
                   "this PX4 log has " + topic.name +
                       ", but its definition is missing, damaged, or names no time and place; "
                       "copy the log from the drone again",
                   {}};
    }
    return std::nullopt;
  }

  UlogWalk walk_;
  std::map<std::uint8_t, std::vector<Px4Place>> global_;
  std::map<std::uint8_t, std::vector<Px4Place>> local_;
  std::map<std::uint8_t, std::vector<std::int64_t>> gps_;
  std::map<std::uint8_t, std::vector<std::int64_t>> receivers_;
  std::map<std::uint8_t, std::vector<std::pair<std::int64_t, bool>>> landed_;
  SatelliteFixes fixes_;
  bool never_lands_ = false;
  bool on_surface_ = false;
};

}  // namespace

Result<Px4FlightLog> read_flight_log(std::string_view bytes) {
  auto walk = UlogWalk::begin(bytes);
  if (!walk) return std::move(walk).error();
  return Gathering(*std::move(walk)).read();
}

}  // namespace beespace::io
