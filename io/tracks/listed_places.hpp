// JSON whose objects are moments, each with a list of all that was somewhere then: what to type
// that makes an object of each.
#pragma once

#include "io/json/json_value.hpp"

#include <optional>
#include <string>

namespace beespace::io {

// The program of jq for objects like this one, {"t": 0, "agents": [{"id": 1, "pos": [1, 2, 3]}]},
// or the poses of Gazebo; nothing where it holds no such list.
struct ListedPlaces {
  std::string program;
  std::string what;  // "'agents' is a list of all that is somewhere at one time"
  std::string more;  // what else is to be said, or nothing
};
std::optional<ListedPlaces> listed_places(JsonMap moment);

}  // namespace beespace::io
