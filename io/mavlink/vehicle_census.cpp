#include "io/mavlink/vehicle_census.hpp"

#include "io/mavlink/mavlink_payload.hpp"

#include <cstddef>

namespace beespace::io {
namespace {

// MAV_COMPONENT: cameras, servos, gimbals, receivers, computers beside the autopilot; and the radio
// of the ground station, which has a system of its own.
bool is_autopilot_never(std::uint8_t component) {
  constexpr std::uint8_t kRadio = 68;
  constexpr std::uint8_t kFirst = 100;
  return component == kRadio || component >= kFirst;
}

// MAV_TYPE of what is no vehicle.
bool is_no_vehicle(std::uint8_t type, std::uint8_t autopilot) {
  constexpr std::uint8_t kNoAutopilot = 8;
  switch (type) {
    case 0:  // generic
      return autopilot == kNoAutopilot;
    case 5:   // antenna tracker
    case 6:   // ground station
    case 18:  // computer on board
    case 26:  // gimbal
    case 27:  // receiver of ADS-B
    case 30:  // camera
    case 31:  // charging station
    case 32:  // FLARM
    case 33:  // servo
    case 34:  // remote identification
    case 36:  // battery
    case 37:  // parachute
    case 38:  // log
    case 39:  // display
    case 40:  // inertial sensor
    case 41:  // receiver of satellites
    case 42:  // winch
    case 44:  // lamp
    case 48:  // gripper
      return true;
    default:
      return false;
  }
}

// MAV_TYPE of what is on the ground, and in a system of its own: antenna tracker, ground station,
// charging station. What else is no vehicle may be aboard one.
bool is_station_type(std::uint8_t type) {
  return type == 5 || type == 6 || type == 31;
}

// Whether the message says nothing of its sender.
bool is_of_others(const MavlinkFrame& frame) {
  return frame.message == kAdsbVehicle || frame.message == kRadioStatus ||
         remote_drone(frame).has_value();
}

}  // namespace

void VehicleCensus::take(const MavlinkFrame& frame) {
  if (is_of_others(frame)) return;
  const std::size_t who = kSystems * frame.system + frame.component;
  if (frame.message == kHeartbeat) {
    const MavlinkPayload payload(frame.payload);
    if (is_station_type(payload.byte(4))) stations_[frame.system] = true;
    if (!is_no_vehicle(payload.byte(4), payload.byte(5))) {
      flies_[frame.system] = true;
    } else if (!is_none_[who]) {
      is_none_[who] = true;
      if (heard_[who]) --unexplained_[frame.system];
    }
    return;
  }
  if (heard_[who] || is_none_[who] || is_autopilot_never(frame.component)) return;
  heard_[who] = true;
  ++unexplained_[frame.system];
}

std::optional<std::string> remote_drone(const MavlinkFrame& frame) {
  constexpr std::size_t kAt = 32;
  constexpr std::size_t kLength = 20;
  if (frame.message != kRemoteIdLocation) return std::nullopt;
  const std::string name = MavlinkPayload(frame.payload).name(kAt, kLength);
  if (name.empty()) return std::nullopt;
  return "remote id " + name;
}

}  // namespace beespace::io
