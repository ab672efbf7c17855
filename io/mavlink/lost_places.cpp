#include "io/mavlink/lost_places.hpp"

#include "io/mavlink/mavlink_payload.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

constexpr std::uint8_t kFixWithHeight = 3;  // GPS_FIX_TYPE_3D_FIX, and better ones
constexpr double kMostOff_m = 10.0;         // what an estimator with satellites says is less
constexpr std::int64_t kMostOldMicros = 5'000'000;  // what an estimator has said holds so long

}  // namespace

void LostPlaces::take(const MavlinkFrame& frame, std::int64_t stamp) {
  Vehicle& vehicle = vehicles_[frame.system];
  const MavlinkPayload payload(frame.payload);
  if (frame.message == kGpsRawInt || frame.message == kGps2Raw) {
    Receiver& receiver = vehicle.receivers[frame.message == kGpsRawInt ? 0 : 1];
    receiver.has_fix = payload.byte(frame.message == kGpsRawInt ? 28 : 32) >= kFixWithHeight;
    receiver.has_had_fix = receiver.has_had_fix || receiver.has_fix;
  } else if (frame.message == kEstimatorStatus) {
    constexpr unsigned kOnTheEarth = 16;  // ESTIMATOR_POS_HORIZ_ABS
    constexpr unsigned kHeld = 128;       // ESTIMATOR_CONST_POS_MODE
    const unsigned flags = payload.unsigned16(40);
    const bool off = payload.float32(32) > kMostOff_m || payload.float32(36) > kMostOff_m;
    const bool is_lost = off || (flags & kHeld) != 0;
    vehicle.estimator = {stamp, is_lost, !is_lost && (flags & kOnTheEarth) != 0};
  }
}

bool LostPlaces::is_lost(std::uint8_t system, PlaceBy by, std::int64_t stamp) const {
  if (by == PlaceBy::kOfAnother || by == PlaceBy::kSatellite) return false;
  const Vehicle& vehicle = vehicles_[system];
  if (const auto& said = vehicle.estimator; said && stamp - said->stamp <= kMostOldMicros) {
    if (said->is_lost || said->is_sure) return said->is_lost;
  }
  // Metres from an origin of its own are not those of satellites alone.
  if (by == PlaceBy::kLocal) return false;
  const auto& receivers = vehicle.receivers;
  return std::any_of(receivers.begin(), receivers.end(),
                     [](const Receiver& receiver) { return receiver.has_had_fix; }) &&
         std::none_of(receivers.begin(), receivers.end(),
                      [](const Receiver& receiver) { return receiver.has_fix; });
}

}  // namespace beespace::io
