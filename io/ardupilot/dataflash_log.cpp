#include "io/ardupilot/dataflash_log.hpp"

#include "io/ardupilot/dataflash_walk.hpp"
#include "io/frames/track_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace beespace::io {
namespace {

// A double holds every microsecond until then: the year 2255.
constexpr double kLatestMicros = 9'007'199'254'740'992.0;

// Numbers of EV.
constexpr double kArmed = 10.0;
constexpr double kLandComplete = 18.0;
constexpr double kNotLanded = 28.0;

// What an estimator says of itself holds so long.
constexpr std::uint64_t kMostOldMicros = 5'000'000;

class DataflashGathering {
 public:
  explicit DataflashGathering(std::string_view bytes) : walk_(bytes) {}

  Result<DataflashLog> read() {
    while (walk_.next()) {
      const std::string& name = walk_.layout().name;
      if (name == "POS") {
        if (!add_place()) return bad_place();
      } else if (name == "GPS" || name == "GPS2") {
        add_satellites(name == "GPS2");
      } else if (name == "XKF1") {
        add_velocity(newer_);
      } else if (name == "NKF1") {
        add_velocity(older_);
      } else if (name == "XKF4") {
        add_status(newer_);
      } else if (name == "NKF4") {
        add_status(older_);
      } else if (name == "EV") {
        add_event();
      } else if (name == "STAT") {
        add_flying();
      } else if (name == "MSG") {
        take_vehicle();
      }
    }
    log_.by_gps = log_.places.empty();
    if (log_.by_gps) {
      log_.places = std::move(by_gps_);
    } else {
      settle_velocities(estimator());
    }
    fixes_.settle();
    log_.fixes = std::move(fixes_);
    log_.clock = satellite_clock(std::move(ahead_));
    log_.landings = landings();
    log_.losses = walk_.losses();
    return std::move(log_);
  }

 private:
  // Of one core of an estimator.
  struct Status {
    std::uint64_t micros = 0;
    bool lost = false;
  };
  struct Moving {
    std::uint64_t micros = 0;
    std::size_t core = 0;
    Velocity velocity = {};
  };
  struct Estimator {
    std::array<std::optional<Status>, 256> cores = {};
    std::size_t primary = 0;
    bool speaks = false;
    std::vector<Moving> moving = {};
  };
  struct Event {
    std::uint64_t micros;
    double number;
  };

  [[nodiscard]] double number(std::string_view label, double otherwise) const {
    const DataflashField* const field = walk_.layout().field(label);
    return field != nullptr ? dataflash_number(walk_.message(), *field).value_or(otherwise)
                            : otherwise;
  }
  // A small whole one, as a number of a core.
  [[nodiscard]] std::size_t index(std::string_view label) const {
    const double value = number(label, 0.0);
    return value >= 0.0 && value < 256.0 ? static_cast<std::size_t>(value) : 0;
  }
  [[nodiscard]] std::optional<std::uint64_t> micros() const {
    const double value = number("TimeUS", -1.0);
    if (!(value >= 0.0 && value < kLatestMicros)) return std::nullopt;
    return static_cast<std::uint64_t>(value);
  }

  bool add_place() {
    constexpr double kNone = DataflashPlace::kUnknown;
    for (const std::string_view label : {"TimeUS", "Lat", "Lng", "Alt"}) {
      if (walk_.layout().field(label) == nullptr) return false;
    }
    DataflashPlace place;
    place.micros = micros().value_or(0);
    place.position = {number("Lng", kNone), number("Lat", kNone),
                      without_dust(number("Alt", kNone))};
    place.above_home_m = number("RelHomeAlt", kNone);
    place.core = estimator().primary;
    place.guessed = is_lost(estimator(), place.micros);
    log_.places.push_back(place);
    return true;
  }

  [[nodiscard]] const Estimator& estimator() const { return newer_.speaks ? newer_ : older_; }

  static bool is_lost(const Estimator& estimator, std::uint64_t micros) {
    const auto& status = estimator.cores[estimator.primary];
    if (!status || micros > status->micros + kMostOldMicros) return false;
    return status->lost;
  }

  static Error bad_place() {
    return {ErrorCode::kCorrupt,
            "this DataFlash log of ArduPilot has POS, but its definition is damaged, or names no "
            "time and place; copy the log from the vehicle again",
            {}};
  }

  void add_satellites(bool second) {
    constexpr double kFixWithHeight = 3.0;  // GPS_OK_FIX_3D, and better ones
    const auto own = micros();
    if (!own || walk_.layout().field("Status") == nullptr) return;
    const bool has_fix = number("Status", 0.0) >= kFixWithHeight;
    const std::size_t receiver = second ? 1 : index("I");
    fixes_.take(static_cast<std::uint8_t>(receiver), *own, has_fix);
    if (!has_fix || receiver != 0) return;
    add_gps_place(*own);
    if (const auto utc = utc_of_gps(number("GWk", -1.0), number("GMS", -1.0))) {
      ahead_.push_back(*utc - static_cast<std::int64_t>(*own));
    }
  }

  void add_gps_place(std::uint64_t micros) {
    constexpr double kNone = DataflashPlace::kUnknown;
    constexpr double kDegree = 0.017453292519943295;
    DataflashPlace place;
    place.micros = micros;
    place.position = {number("Lng", kNone), number("Lat", kNone),
                      without_dust(number("Alt", kNone))};
    const double speed = number("Spd", kNone);
    const double course = number("GCrs", kNone) * kDegree;
    const double down = number("VZ", kNone);
    const Velocity velocity = {without_dust(speed * std::sin(course)),
                               without_dust(speed * std::cos(course)), without_dust(0.0 - down)};
    if (in_motion_domain(velocity.x) && in_motion_domain(velocity.y) &&
        in_motion_domain(velocity.z)) {
      place.velocity = velocity;
    }
    by_gps_.push_back(place);
  }

  // SS are the flags of the solution, PI is the core that the vehicle heeds.
  void add_status(Estimator& estimator) {
    constexpr unsigned kOnTheEarth = 1u << 4u;  // a place
    constexpr unsigned kHeld = 1u << 7u;        // that stands still, for want of anything better
    constexpr unsigned kBadGps = 1u << 14u;     // that is off as its GPS is
    constexpr unsigned kDeadReckoning = 1u << 18u;
    const auto at = micros();
    const double flags = number("SS", -1.0);
    if (!at || !(flags >= 0.0 && flags < 4'294'967'296.0)) return;
    const auto bits = static_cast<unsigned>(flags);
    const bool lost = (bits & kOnTheEarth) == 0 || (bits & (kHeld | kBadGps | kDeadReckoning)) != 0;
    estimator.speaks = true;
    estimator.cores[index("C")] = Status{*at, lost};
    estimator.primary = index("PI");
  }

  void add_velocity(Estimator& estimator) {
    const auto at = micros();
    const auto part = [this](std::string_view label) {
      const double speed = without_dust(number(label, DataflashPlace::kUnknown));
      return in_motion_domain(speed) ? speed : DataflashPlace::kUnknown;
    };
    const double down = part("VD");
    const Velocity velocity = {part("VE"), part("VN"), std::isnan(down) ? down : 0.0 - down};
    if (!at) return;
    estimator.speaks = true;
    estimator.moving.push_back({*at, index("C"), velocity});
  }

  // That of the same turn of the vehicle's loop, of the core that it heeds.
  void settle_velocities(const Estimator& estimator) {
    constexpr std::uint64_t kSameTurnMicros = 20'000;
    constexpr std::ptrdiff_t kMostLookedAt = 256;  // a clock that stands still must not take long
    auto from = estimator.moving.begin();
    for (DataflashPlace& place : log_.places) {
      while (from != estimator.moving.end() && from->micros + kSameTurnMicros < place.micros)
        ++from;
      std::uint64_t least = kSameTurnMicros + 1;
      const auto end = from + std::min(kMostLookedAt, estimator.moving.end() - from);
      for (auto one = from; one != end; ++one) {
        if (one->micros > place.micros + kSameTurnMicros) break;
        const std::uint64_t apart =
            std::max(one->micros, place.micros) - std::min(one->micros, place.micros);
        if (one->core != place.core || apart >= least) continue;
        least = apart;
        place.velocity = one->velocity;
      }
    }
  }

  void add_event() {
    const auto at = micros();
    const double event = number("Id", 0.0);
    if (!at || (event != kArmed && event != kLandComplete && event != kNotLanded)) return;
    says_landings_ = says_landings_ || event != kArmed;
    events_.push_back({*at, event});
  }

  void add_flying() {
    const auto at = micros();
    const double flying = number("isFlying", -1.0);
    if (!at || flying < 0.0) return;
    const bool landed = flying == 0.0;
    if (flying_.empty() || flying_.back().landed != landed) flying_.push_back({*at, landed});
  }

  void take_vehicle() {
    const DataflashField* const field = walk_.layout().field("Message");
    if (field == nullptr) return;
    const std::string_view text = dataflash_text(walk_.message(), *field);
    const auto begins = [text](std::string_view name) { return text.starts_with(name); };
    const bool rover = begins("ArduRover") || begins("APM:Rover") || begins("Rover V");
    is_copter_ = is_copter_ || begins("ArduCopter") || begins("APM:Copter");
    log_.on_surface = log_.on_surface || rover;
    never_lands_ = never_lands_ || rover || begins("ArduSub");
  }

  // Who is switched on stands, and says when that changes. Of who is armed in flight, as after a
  // crash of its computer, LandedReports sees the height.
  [[nodiscard]] std::vector<DataflashLanding> landings() const {
    if (never_lands_) return {};
    if (!says_landings_ && !is_copter_) return flying_;
    std::vector<DataflashLanding> changes;
    for (const Event& event : events_) {
      if (changes.empty()) changes.push_back({0, event.number != kLandComplete});
      const bool landed =
          event.number == kArmed ? changes.back().landed : event.number == kLandComplete;
      if (landed != changes.back().landed) changes.push_back({event.micros, landed});
    }
    return changes;
  }

  DataflashWalk walk_;
  DataflashLog log_;
  SatelliteFixes fixes_;
  std::vector<std::int64_t> ahead_;
  std::vector<DataflashPlace> by_gps_;
  Estimator newer_;
  Estimator older_;
  std::vector<Event> events_;
  std::vector<DataflashLanding> flying_;  // by STAT, of who flies on wings
  bool says_landings_ = false;
  bool is_copter_ = false;
  bool never_lands_ = false;
};

}  // namespace

Result<DataflashLog> read_dataflash_log(std::string_view bytes) {
  return DataflashGathering(bytes).read();
}

}  // namespace beespace::io
