// What vehicles of a log say of whether they stand on the ground: EXTENDED_SYS_STATE (245), or
// where one never tells it there, its HEARTBEAT (0): disarmed and standing by, or with less
// certainty disarmed alone (see LandedReports). Source: mavlink.io.
#pragma once

#include "io/mavlink/mavlink_frame.hpp"
#include "io/recording/landed_reports.hpp"

#include <cstdint>
#include <map>
#include <utility>

namespace beespace::io {

class VehicleLandings {
 public:
  // That came at `stamp`, in microseconds.
  void take(const MavlinkFrame& frame, std::int64_t stamp);

  // Of what that component says of its system; null where it says nothing of the kind, or is a
  // rover or a boat, which never lands.
  [[nodiscard]] const LandedReports* of(std::uint8_t system, std::uint8_t component) const;
  // Whether it is a rover or a boat.
  [[nodiscard]] bool on_surface(std::uint8_t system, std::uint8_t component) const;

 private:
  struct Said {
    LandedReports state;
    LandedReports heartbeats;
    bool has_state = false;
    bool never_lands = false;
    bool on_surface = false;
  };

  std::map<std::pair<std::uint8_t, std::uint8_t>, Said> said_;  // by system and component
};

}  // namespace beespace::io
