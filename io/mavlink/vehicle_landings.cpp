#include "io/mavlink/vehicle_landings.hpp"

#include "io/mavlink/mavlink_payload.hpp"

namespace beespace::io {
namespace {

// MAV_LANDED_STATE.
constexpr std::uint8_t kUndefined = 0;
constexpr std::uint8_t kOnTheGround = 1;

constexpr std::uint8_t kNoAutopilot = 8;
constexpr unsigned kArmed = 128;      // MAV_MODE_FLAG_SAFETY_ARMED
constexpr std::uint8_t kStandby = 3;  // MAV_STATE_STANDBY

// Whether an autopilot keeps its motors off.
bool is_disarmed(const MavlinkPayload& heartbeat) {
  return heartbeat.byte(5) != kNoAutopilot && (heartbeat.byte(6) & kArmed) == 0;
}

// Whether it says that it waits on the ground, too. What is disarmed and says to be active, or in a
// failsafe, is hardly elsewhere, but that is less sure.
bool stands_by(const MavlinkPayload& heartbeat) {
  return heartbeat.byte(7) == kStandby;
}

}  // namespace

void VehicleLandings::take(const MavlinkFrame& frame, std::int64_t stamp) {
  if (frame.message != kHeartbeat && frame.message != kExtendedSysState) return;
  Said& said = said_[{frame.system, frame.component}];
  const MavlinkPayload payload(frame.payload);
  if (frame.message == kHeartbeat) {
    said.never_lands = said.never_lands || never_lands(payload.byte(4));
    said.on_surface = said.on_surface || stays_on_surface(payload.byte(4));
    said.heartbeats.take(stamp, is_disarmed(payload), stands_by(payload));
    return;
  }
  const std::uint8_t state = payload.byte(1);
  said.has_state = said.has_state || state != kUndefined;
  said.state.take(stamp, state == kOnTheGround);
}

const LandedReports* VehicleLandings::of(std::uint8_t system, std::uint8_t component) const {
  const auto found = said_.find({system, component});
  if (found == said_.end() || found->second.never_lands) return nullptr;
  return found->second.has_state ? &found->second.state : &found->second.heartbeats;
}

bool VehicleLandings::on_surface(std::uint8_t system, std::uint8_t component) const {
  const auto found = said_.find({system, component});
  return found != said_.end() && found->second.on_surface;
}

}  // namespace beespace::io
