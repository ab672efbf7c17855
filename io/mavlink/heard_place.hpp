// A place of a drone that a frame of a telemetry log tells, and whether it can be one.
#pragma once

#include "io/mavlink/mavlink_position.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>

namespace beespace::io {

// One message with a place.
struct Heard {
  std::uint64_t stamp = 0;
  std::uint64_t frame = 0;
  std::uint8_t system = 0;
  std::uint8_t component = 0;
  MavlinkPosition at = {};
  bool is_taken = false;
  bool is_lost = false;             // its drone says beside it that it has lost its place
  std::optional<bool> landed = {};  // nothing where its drone says nothing of the kind
  double time_s = 0.0;              // since 1970, once it is taken
};

// What is wrong with the position. Without place: kOutsideDomain, kNotFinite, and those of
// impossible_place().
std::optional<Error> position_problem(const Heard& heard);

}  // namespace beespace::io
