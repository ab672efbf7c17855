// Topics of autopilots, as "/uav1/mavros/local_position/pose" and
// "/px4_1/fmu/out/vehicle_local_position", whose positions count from where each vehicle was
// switched on or has its home, whatever their frame is called, and also where a table names none.
#pragma once

#include "io/recording/track_gathering.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

bool is_local_to_its_vehicle(std::string_view topic);

// Of bees that are called by such topics, or by files of that name, in metres: why they cannot be
// compared, and a fix of the second one, as TrackGathering::origin() counts them; nothing where
// fewer than two are. Errors: kUnknownFrame, without location.
struct LocalTopics {
  Error error;
  std::size_t fix;
};
std::optional<LocalTopics> several_local_topics(const TrackGathering& tracks);

}  // namespace beespace::io
