#include "io/tracks/planar_poses.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

bool names_planar_poses(const TableLayout& table) {
  const auto names = [&table](std::string_view words) {
    return std::any_of(table.names.begin(), table.names.end(), [words](const std::string& name) {
      const std::vector<std::string> parts = split_words(name);
      return std::any_of(parts.begin(), parts.end(),
                         [words](const std::string& part) { return is_one_of(words, part); });
    });
  };
  return names("robot robots robotid roboter") && names("theta yaw");
}

}  // namespace beespace::io
