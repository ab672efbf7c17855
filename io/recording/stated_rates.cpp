#include "io/recording/stated_rates.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kFarApart_s = 60.0;
constexpr double kRatesLag_s = 1.0;

// Two steps of 100 ft.
constexpr double kHeightSteps_m = 61.0;
// 4,000 ft/min.
constexpr double kClimbsDiffer_mps = 20.0;
constexpr double kOfClimb = 0.5;
// No aircraft climbs or dives faster, whatever it says or does not say.
constexpr double kMostClimb_mps = 350.0;

// The places of some receivers are whole hundredths of a degree, or some seconds old.
constexpr double kPlacesDiffer_m = 500.0;
constexpr double kSpeedsDiffer_mps = 15.0;
// Within so many seconds none turns round.
constexpr double kHardlyTurns_s = 15.0;
constexpr double kOfSpeed = 1.0;
constexpr double kOfSpeedTurned = 2.0;

struct Rates {
  double least = 0.0;
  double most = 0.0;
  bool known = false;

  void take(double rate) {
    if (!std::isfinite(rate)) return;
    known = true;
    least = std::min(least, rate);
    most = std::max(most, rate);
  }
};

bool says_speed(const Velocity* velocity) {
  return velocity != nullptr && std::isfinite(velocity->x) && std::isfinite(velocity->y) &&
         std::hypot(velocity->x, velocity->y) > 0.0;  // 0 may mean that it is not known
}

}  // namespace

bool contradicts_stated_climb(const Fix& from, const Velocity* from_velocity, const Fix& to,
                              const Velocity* to_velocity) {
  const double lasts_s = to.time_s - from.time_s;
  const double most_s = lasts_s + kRatesLag_s;
  const double climbs_m = to.position.z - from.position.z;
  if (std::abs(climbs_m) > kHeightSteps_m + kMostClimb_mps * most_s) return true;
  if (lasts_s > kFarApart_s) return false;
  Rates rates;
  if (from_velocity != nullptr) rates.take(from_velocity->z);
  if (to_velocity != nullptr) rates.take(to_velocity->z);
  if (!rates.known) return false;
  const double steepest_mps = std::max(rates.most, -rates.least);
  const double off_m = kHeightSteps_m + (kClimbsDiffer_mps + kOfClimb * steepest_mps) * most_s;
  return climbs_m > rates.most * lasts_s + off_m || climbs_m < rates.least * lasts_s - off_m;
}

bool contradicts_stated_speed(const Fix& from, const Velocity* from_velocity, const Fix& to,
                              const Velocity* to_velocity) {
  const double lasts_s = to.time_s - from.time_s;
  if (lasts_s > kFarApart_s || !says_speed(from_velocity) || !says_speed(to_velocity)) return false;
  const Point way = flat_offset_m(to.position, from.position, Frame::kWgs84);
  const double x_mps = (from_velocity->x + to_velocity->x) / 2.0;
  const double y_mps = (from_velocity->y + to_velocity->y) / 2.0;
  const double off_m = std::hypot(way.x - x_mps * lasts_s, way.y - y_mps * lasts_s);
  const double fastest_mps = std::max(std::hypot(from_velocity->x, from_velocity->y),
                                      std::hypot(to_velocity->x, to_velocity->y));
  const double of_speed = lasts_s <= kHardlyTurns_s ? kOfSpeed : kOfSpeedTurned;
  return off_m >
         kPlacesDiffer_m + (kSpeedsDiffer_mps + of_speed * fastest_mps) * (lasts_s + kRatesLag_s);
}

}  // namespace beespace::io
