#include "io/tracks/track_wishes.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_wishes.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, "--columns: " + std::move(message), {}};
}

bool is_position(std::string_view role) {
  constexpr std::array<std::string_view, 6> kPosition = {"lon", "lat", "height", "x", "y", "z"};
  return std::find(kPosition.begin(), kPosition.end(), role) != kPosition.end();
}

// Where the column of that role is kept.
std::optional<std::size_t>* slot_of(std::string_view role, TrackWishes& wishes) {
  if (role == "id") return &wishes.id;
  if (role == "time") return &wishes.time;
  if (role == "vx" || role == "ve") return &wishes.velocity[0];
  if (role == "vy" || role == "vn") return &wishes.velocity[1];
  if (role == "vz" || role == "vu") return &wishes.velocity[2];
  return nullptr;
}

}  // namespace

Result<TrackWishes> read_track_wishes(std::string_view text, const ColumnsSeen& seen) {
  TrackWishes wishes;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item.find('=');
    const std::string_view role = without_padding(item.substr(0, equals));
    if (equals != std::string_view::npos && is_position(role)) {
      wishes.position.append(wishes.position.empty() ? "" : ",").append(item);
    } else {
      auto* const slot = slot_of(role, wishes);
      const std::string column(
          without_padding(equals == std::string_view::npos ? "" : item.substr(equals + 1)));
      if (slot == nullptr || column.empty()) {
        return invalid(excerpt(item) +
                       " is not understood; write role=column, where the role is id, time, lon, "
                       "lat, height, x, y, z, vx, vy, vz, ve, vn or vu and the column a number "
                       "(from 1) or a name");
      }
      if (*slot) return invalid(std::string(role) + " is given twice; keep one");
      const auto found = find_wished_column(role, column, seen);
      if (!found) return found.error();
      *slot = found.value();
    }
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
    if (text.empty()) return invalid("a comma at the end; remove it");
  }
  if (wishes.velocity[0].has_value() != wishes.velocity[1].has_value() ||
      (wishes.velocity[2] && !wishes.velocity[0])) {
    return invalid("a velocity needs vx and vy (or ve and vn), and vz (vu) where bees climb");
  }
  return wishes;
}

}  // namespace beespace::io
