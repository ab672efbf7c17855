#include "io/recording/local_topics.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <string>

namespace beespace::io {

bool is_local_to_its_vehicle(std::string_view topic) {
  std::string name = lower_case(topic);
  std::replace(name.begin(), name.end(), '/', '_');  // as files are called after them
  for (const std::string_view part :
       {"mavros_local_position", "mavros_odometry", "vehicle_local_position", "vehicle_odometry"}) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

std::optional<LocalTopics> several_local_topics(const TrackGathering& tracks) {
  std::optional<std::size_t> first;
  std::size_t fix = 0;
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    const std::size_t of_bee = fix;
    fix += tracks.recorded(bee).fixes.size();
    if (!is_local_to_its_vehicle(tracks.id(bee))) continue;
    if (!first) {
      first = bee;
      continue;
    }
    return LocalTopics{
        {ErrorCode::kUnknownFrame,
         "positions of " + excerpt(tracks.id(bee)) + " and of " + excerpt(tracks.id(*first)) +
             " are local ones of autopilots (MAVROS, PX4), which begin where each vehicle was "
             "switched on or has its home: if these have one origin and direction, say so with "
             "--crs metres; else bring all into one frame, such as longitude and latitude",
         {}},
        of_bee};
  }
  return std::nullopt;
}

}  // namespace beespace::io
