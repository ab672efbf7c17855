// What TelemetryTimes tells of a whole log, while its messages come: of each what is known by then.
#pragma once

#include "io/mavlink/boot_clock.hpp"
#include "io/mavlink/mavlink_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

class LiveTelemetryTimes {
 public:
  // A frame of the component that speaks for its system.
  void take(const MavlinkFrame& frame, std::int64_t came_us);

  // When a place of a system was sent, by the clock of the log.
  std::int64_t sent_at(std::uint8_t system, const SentMessage& message);

  [[nodiscard]] bool by_own_clocks() const { return by_own_clocks_; }
  [[nodiscard]] bool by_satellites() const;
  // As those of TelemetryTimes.
  [[nodiscard]] std::vector<std::size_t> unbelieved() const;
  [[nodiscard]] std::vector<std::size_t> perhaps_late() const;

 private:
  static constexpr std::size_t kSystems = 256;

  struct Of {
    BootClock clock;
    bool tells_places = false;
    bool tells_unix = false;               // by its places themselves
    std::optional<std::int64_t> ahead_us;  // the log, of satellites
  };
  struct Links {
    std::int64_t least_us = 0;
    std::int64_t most_us = 0;
  };
  [[nodiscard]] std::optional<Links> links() const;

  std::array<Of, kSystems> of_ = {};
  bool by_own_clocks_ = false;
};

}  // namespace beespace::io
