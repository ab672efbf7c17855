// Which systems of a log are vehicles: by their heartbeats, and where there is none by who speaks.
// Ground stations, cameras, gimbals, radios and computers on board are none; nor is who only hands
// on what it has heard of others.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

namespace beespace::io {

class VehicleCensus {
 public:
  void take(const MavlinkFrame& frame);

  // By all that was taken: a heartbeat that says what the sender is may come late.
  [[nodiscard]] bool is_vehicle(std::uint8_t system) const {
    return flies_[system] || unexplained_[system] > 0;
  }
  // Whether it is a ground station, an antenna tracker or a charging station, and no vehicle: where
  // it says to be, none flies.
  [[nodiscard]] bool is_station(std::uint8_t system) const {
    return stations_[system] && !is_vehicle(system);
  }

 private:
  static constexpr std::size_t kSystems = 256;

  std::array<bool, kSystems> flies_ = {};     // as a heartbeat of it says
  std::array<bool, kSystems> stations_ = {};  // the same
  // How many components that may be an autopilot were heard without saying what they are.
  std::array<std::uint16_t, kSystems> unexplained_ = {};
  std::bitset<kSystems * kSystems> heard_;    // by system and component
  std::bitset<kSystems * kSystems> is_none_;  // as their heartbeat says
};

// Of a remote identification that the sender has heard from another drone: what to call that.
// Nothing of other messages, and where it is its own.
std::optional<std::string> remote_drone(const MavlinkFrame& frame);

}  // namespace beespace::io
