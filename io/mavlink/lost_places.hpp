// Which vehicles say beside their places that they have lost them: their satellites have no fix any
// more, or their estimator does not know where they are. The places that they tell then are
// guesses.
//
// A vehicle that never had a fix may know its place otherwise, as by motion capture. One that has
// lost it may, too, where its estimator says so (ESTIMATOR_STATUS).
// Source: mavlink.io, GPS_RAW_INT (24), GPS2_RAW (124), ESTIMATOR_STATUS (230).
#pragma once

#include "io/mavlink/mavlink_frame.hpp"
#include "io/mavlink/mavlink_position.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace beespace::io {

class LostPlaces {
 public:
  // In the order in which they came, at `stamp` in microseconds.
  void take(const MavlinkFrame& frame, std::int64_t stamp);

  // Of a place that this system tells then, after what was taken so far.
  [[nodiscard]] bool is_lost(std::uint8_t system, PlaceBy by, std::int64_t stamp) const;

 private:
  static constexpr std::size_t kSystems = 256;
  static constexpr std::size_t kReceivers = 2;

  struct Receiver {
    bool has_had_fix = false;
    bool has_fix = false;
  };
  struct Estimator {
    std::int64_t stamp = 0;
    bool is_lost = false;
    bool is_sure = false;  // of its place on the Earth
  };

  struct Vehicle {
    std::array<Receiver, kReceivers> receivers = {};
    std::optional<Estimator> estimator = {};
  };

  std::array<Vehicle, kSystems> vehicles_ = {};
};

}  // namespace beespace::io
