// What to call files of one name in several folders: what differs in their paths.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace beespace::io {

// Of those of `sources` whose stem is that of another one: "MAV0" for "euroc/MAV0/mav0/data.csv"
// beside "euroc/MAV1/mav0/data.csv". Not of those in which nothing differs.
std::unordered_map<std::string, std::string> names_apart(const std::vector<std::string>& sources);

}  // namespace beespace::io
