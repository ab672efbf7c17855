// When the vehicles of a log were where they say: by the clock of each (boot_clock.hpp), set to
// that of the log, and to each other by the time of their satellites where they tell it
// (satellite_time.hpp).
#pragma once

#include "io/mavlink/boot_clock.hpp"
#include "io/mavlink/mavlink_frame.hpp"
#include "io/mavlink/satellite_time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

// From here on a place, or a link, is said to be late.
inline constexpr std::int64_t kLateMicros = 1'000'000;
// What differs by more is not how long messages took.
inline constexpr std::int64_t kMostApartMicros = 60'000'000;

class TelemetryTimes {
 public:
  static constexpr std::size_t kSystems = 256;

  // A frame that is number `index`, and came at `came_us` by the clock of the log.
  void take(const MavlinkFrame& frame, std::uint64_t index, std::int64_t came_us);

  // A place of a system, in the order in which they came, that says when it was sent.
  void add_place(std::uint8_t system, std::uint8_t component, std::uint64_t index,
                 const SentMessage& message);

  // Once all are there.
  void settle();

  // Of the places of a system, in their order, by the clock of the log; empty where its clock is
  // not believed.
  [[nodiscard]] const std::vector<std::int64_t>& at_us(std::size_t system) const {
    return of_[system].at_us;
  }
  [[nodiscard]] bool by_own_clocks() const { return by_own_clocks_; }
  [[nodiscard]] bool by_satellites() const { return by_satellites_; }
  // Whether what satellites say of the links cannot be.
  [[nodiscard]] bool satellites_differ() const { return satellites_differ_; }
  // By how much the clock of the log is ahead of that of satellites, with what the quickest link
  // takes; nothing where no vehicle tells it, or some contradict each other.
  [[nodiscard]] std::optional<std::int64_t> log_ahead_us() const { return log_ahead_us_; }
  // How late the latest place came.
  [[nodiscard]] std::int64_t latest_us() const { return latest_us_; }
  // Systems whose clocks do not go on with that of the log.
  [[nodiscard]] const std::vector<std::size_t>& unbelieved() const { return unbelieved_; }
  // Systems that do not tell how late they always are, where others are.
  [[nodiscard]] const std::vector<std::size_t>& perhaps_late() const { return perhaps_late_; }

 private:
  struct Told {
    std::uint64_t index = 0;
    std::uint8_t component = 0;
    std::int64_t came_us = 0;
    SatelliteTime time = {};
  };
  struct Place {
    std::uint64_t index = 0;
    SentMessage message = {};
  };
  struct Of {
    std::uint8_t component = 0;
    std::vector<Told> told;
    std::vector<Place> places;
    std::vector<std::int64_t> at_us;
    std::optional<std::int64_t> ahead_us;  // the log, of satellites
  };

  bool settle(Of& of);
  void compare_links();

  std::array<Of, kSystems> of_ = {};
  bool by_own_clocks_ = false;
  bool by_satellites_ = false;
  bool satellites_differ_ = false;
  std::optional<std::int64_t> log_ahead_us_;
  std::int64_t latest_us_ = 0;
  std::vector<std::size_t> unbelieved_;
  std::vector<std::size_t> perhaps_late_;
};

}  // namespace beespace::io
