#include "analysis/geometry/ground_places.hpp"

#include <beespace/geodesy.hpp>

#include <numeric>

namespace beespace::analysis {

GroundPlaces ground_places(const io::LoadedPoints& loaded,
                           const std::optional<io::StatedLength>& vertical, io::Unit height_unit) {
  GroundPlaces places;
  if (!vertical) return places;
  const io::Unit compared = compared_in(vertical, height_unit);
  const bool as_stated = compared != io::Unit::kMetre;
  const bool geographic = loaded.frame == io::Frame::kWgs84;
  places.vertical_m = as_stated ? exactly_in(*vertical, compared) : vertical->metric;
  if (!as_stated && !geographic) return places;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    const double in_metres =
        geographic ? record.geographic.height_m : loaded.points[record.point].z;
    const double stated = height_unit == io::Unit::kMetre ? in_metres : record.height;
    places.heights_m.push_back(as_stated ? io::as_compared(stated, height_unit) : in_metres);
    if (!geographic) {
      const Point& point = loaded.points[record.point];
      places.ground.push_back({point.x, point.y, 0.0});
      return;
    }
    GeographicPosition place = record.geographic;
    place.height_m = 0.0;
    places.ground.push_back(*to_ecef(place));  // was read before, so it is valid
  });
  return places;
}

}  // namespace beespace::analysis
