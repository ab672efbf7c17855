#include "io/tracks/local_positions.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/frames/map_projection.hpp"
#include "io/frames/track_domain.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

std::optional<std::size_t> column_called(std::string_view name,
                                         const std::vector<std::string>& names) {
  const auto found = std::find_if(names.begin(), names.end(), [name](const std::string& other) {
    return plain_name(other) == name;
  });
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

void settle_known_places(TrackLayout& layout) {
  const bool geographic = layout.frame == Frame::kWgs84;
  const std::string place = geographic ? "lat_lon_valid" : "xy_valid";
  const std::string height = geographic ? "alt_valid" : "z_valid";
  const std::vector<std::string>& names = layout.table.names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = plain_name(names[i]);
    const auto is = [&name](const std::string& wanted) {  // behind the name of the topic, perhaps
      return name == wanted || name.ends_with("position_" + wanted);
    };
    if (is(place)) layout.place_known = i;
    if (is(height) && layout.table.choice.dimensions == 3) layout.height_known = i;
    if (is_one_of("dead_reckoning tracking_lost lost is_lost", name)) layout.lost = i;
  }
  for (std::size_t i = 0; i < names.size() && !layout.place_known; ++i) {
    if (is_one_of("position_valid pos_valid pose_valid tracking_valid tracked is_tracked",
                  plain_name(names[i]))) {
      layout.place_known = i;
    }
  }
  // Elsewhere they may be a dilution of precision, or in centimetres.
  if (column_called("dead_reckoning", names)) {
    layout.off_m = {column_called("eph", names), column_called("epv", names)};
  }
}

std::optional<LocalOrigin> local_origin_of(const TrackLayout& layout) {
  const std::vector<std::string>& names = layout.table.names;
  const ColumnChoice& choice = layout.table.choice;
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  if (choice.dimensions != kAxes.size()) return std::nullopt;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (column_called(kAxes[axis], names) != choice.axes[axis]) return std::nullopt;
  }
  const auto latitude = column_called("ref_lat", names);
  const auto longitude = column_called("ref_lon", names);
  const auto height = column_called("ref_alt", names);
  if (!latitude || !longitude || !height) return std::nullopt;
  LocalOrigin origin{*latitude, *longitude, *height};
  for (const std::string_view name : {"xy_global", "z_global"}) {
    if (const auto column = column_called(name, names)) origin.known.push_back(*column);
  }
  return origin;
}

void settle_local_origin(const RecordingOptions& options, TrackLayout& layout) {
  if (options.frame != Frame::kAuto) return;
  auto origin = local_origin_of(layout);
  if (!origin) return;
  ColumnChoice& choice = layout.table.choice;
  layout.local_origin = std::move(origin);
  layout.frame = Frame::kWgs84;
  layout.frame_reason = "x, y, z are counted from ref_lat, ref_lon, ref_alt";
  choice.naming = Naming::kSure;
  choice.datum = HeightDatum::kMeanSeaLevel;
  layout.notes.emplace_back(
      "positions are metres north, east and down of ref_lat, ref_lon, ref_alt, as PX4 has them: "
      "they are brought to longitude, latitude and height");
  if (!layout.velocity) return;
  // Theirs too; velocities beside degrees are those to the east, north and up.
  VelocityChoice& velocity = *layout.velocity;
  std::swap(velocity.columns[0], velocity.columns[1]);
  std::swap(velocity.units[0], velocity.units[1]);
  velocity.down = !velocity.down;
}

void bring_to_degrees(std::string_view line, const TrackLayout& layout, TrackRecord& record) {
  const LocalOrigin& origin = *layout.local_origin;
  const char delimiter = layout.table.delimiter;
  const auto text = [&](std::size_t column) {
    return without_padding(field_at(line, delimiter, column).text);
  };
  const auto number = [&](std::size_t column, double& value) {
    return parse_number(text(column), value) == NumberKind::kNumber && std::isfinite(value);
  };
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height_m = 0.0;
  const bool known =
      std::none_of(
          origin.known.begin(), origin.known.end(),
          [&](std::size_t column) { return is_one_of("0 false", lower_case(text(column))); }) &&
      number(origin.latitude, latitude_deg) && number(origin.longitude, longitude_deg) &&
      number(origin.height, height_m) && std::abs(latitude_deg) <= 90.0 &&
      std::abs(longitude_deg) <= 180.0 && in_motion_domain(height_m);
  if (!known) {
    record.left_out = &kNoReference;
    record.is_timed = layout.time.has_value();
    return;
  }
  const Point at = record.position;
  const LongitudeLatitude there = px4_reprojected({longitude_deg, latitude_deg}, at.x, at.y);
  record.position = {there.longitude_deg, there.latitude_deg, without_dust(height_m - at.z)};
  record.stated_height = record.position.z;
}

}  // namespace beespace::io
