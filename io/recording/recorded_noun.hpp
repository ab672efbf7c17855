// What a recording is of, as people call it.
#pragma once

#include "io/recording/recording.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

// An aircraft, a drone, an animal; where nothing tells, a bee.
struct RecordedNoun {
  std::string one = "bee";
  std::string several = "bees";

  // "1 drone", "1,234 drones".
  [[nodiscard]] std::string counted(std::uint64_t count) const;
};

// By what wrote it: drones of shows, of autopilots and of columns called so, aircraft, animals; or
// else bees.
RecordedNoun noun_of(const Recording& recording);

}  // namespace beespace::io
